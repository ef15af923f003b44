//! Why brute force and the referee differ: how little the ray has to be moved until they do not.

use glam::DVec3;
use raystep_accel::{PrimId, Primitives, Ray, Shape};

use super::referee::{is_same, nearest_moved};

/// What brute force may be where it differs, the most harmless first. A rounding is that of the largest coordinate
/// of the ray's origin and of the primitive at which the two part, in single precision.
pub(super) const CAUSES: [&str; 6] = [
    "right for the ray moved by a millionth of a rounding",
    "right for the ray moved by a thousandth of a rounding",
    "right for the ray moved by one rounding",
    "right for the ray moved by 64 roundings",
    "wrong about a primitive whose edge is within 64 roundings",
    "wrong, which is not explained",
];

/// How far the ray is moved for the first [`CAUSES`], in roundings.
const STEPS: [f64; 4] = [1e-6, 1e-3, 1.0, 64.0];

/// Which of [`CAUSES`] it is that brute force `found` something else than what is `right`.
pub(super) fn cause(
    prims: &impl Primitives,
    ray: &Ray,
    found: Option<(f64, PrimId)>,
    right: Option<(f64, PrimId)>,
) -> usize {
    const EDGE: usize = STEPS.len();
    // They part at the nearer of their hits.
    let Some((t, prim)) = found.into_iter().chain(right).min_by(|a, b| a.0.total_cmp(&b.0)) else { return 0 };
    let shape = prims.shape(prim);
    let bounds = shape.bounds();
    let largest = ray.o.abs().max(bounds.min.abs()).max(bounds.max.abs()).max_element();
    let inward = middle(&shape) - (ray.o.as_dvec3() + ray.d.as_dvec3() * t);
    // Where t lies in the smallest steps that there are, it moves the hit by as much.
    let smallest = f64::from(f32::from_bits(1));
    let rounding = (f64::from(largest) * f64::from(f32::EPSILON)).max(ray.d.as_dvec3().length().max(1.0) * smallest);
    let moved = |step: f64| {
        let far = step * rounding;
        // Along the ray, t changes by as much as the ray is moved; on a slanted primitive, by somewhat more.
        let slack = 4.0 * far / ray.d.as_dvec3().length();
        moves(ray, inward, far).map(move |by| (by, slack))
    };

    // Does the referee say the same of the moved ray?
    let agrees = |(by, slack)| is_same(ray, found, nearest_moved(prims, ray, by), slack);
    if let Some(step) = STEPS.iter().position(|&step| moved(step).any(agrees)) {
        return step;
    }
    // Where the ray touches several primitives, one move need not do for all of them.
    let alone = &[shape][..];
    let unmoved = nearest_moved(&alone, ray, DVec3::ZERO);
    let is_at_an_edge = |(by, slack)| !is_same(ray, unmoved, nearest_moved(&alone, ray, by), slack);
    let is_a_point = f64::from(bounds.extent().max_element()) <= STEPS[EDGE - 1] * rounding;
    if is_a_point || moved(STEPS[EDGE - 1]).any(is_at_an_edge) { EDGE } else { EDGE + 1 }
}

/// The middle of the shape's corners.
fn middle(shape: &Shape<'_>) -> DVec3 {
    let (mut sum, mut corners) = (DVec3::ZERO, 0);
    shape.corners(|corner| (sum, corners) = (sum + corner.at.as_dvec3(), corners + 1));
    sum / f64::from(corners.max(1))
}

/// Along the ray, inward and across both, so `far`: to and fro, and all between. Inward no further than the middle.
fn moves(ray: &Ray, inward: DVec3, far: f64) -> impl Iterator<Item = DVec3> {
    let along = ray.d.as_dvec3().normalize();
    let across = along.cross(inward).normalize_or(along.any_orthonormal_vector());
    let frame = [along * far, inward.clamp_length_max(far), across * far];
    (0..27).map(move |i| (0..3).map(|k| frame[k] * f64::from(i / [1, 3, 9][k] % 3 - 1)).sum())
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use raystep_accel::{Prims, Shape, Triangle};

    use super::super::referee::nearest;
    use super::*;

    #[test]
    fn a_miss_is_explained_at_an_edge_only() {
        let triangle = Triangle { a: Vec3::ZERO, b: Vec3::X, c: Vec3::Y };
        let prims = Prims::Few(vec![Shape::Triangle(triangle)]);
        // Shot down at a point of it, and missed.
        let cause_at = |x: f32, y: f32| {
            let ray = Ray::new(Vec3::new(x, y, 1.0), -Vec3::Z).unwrap();
            cause(&prims, &ray, None, nearest(&prims, &ray))
        };
        assert_eq!(cause_at(0.5, 0.0), 0, "on an edge");
        assert_eq!(cause_at(0.5, 0.5 * f32::EPSILON), 2, "half a rounding within");
        assert_eq!(cause_at(0.5, 50.0 * f32::EPSILON), 3, "50 roundings within");
        assert_eq!(cause_at(0.3, 0.3), 5, "in the middle");
    }
}
