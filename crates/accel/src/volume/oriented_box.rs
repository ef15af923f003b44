//! The oriented box, slide 51: three slabs along directions of its own.

use glam::{DMat3, DVec3, Vec3};

use super::{Outline, Spans, Volume, corners, slack, span, spans};
use crate::common::bars_projection;
use crate::events::patiently;
use crate::{
    Aabb, Axes, Cancelled, Corner, Direction, Grow, Interval, Obb, Observer, Place, PrimId, Primitives, Ray, Visit,
};

impl Volume for Obb {
    type Draft = Spans;

    #[inline]
    fn bars(ray: &Ray) -> Option<Visit> {
        bars_projection(ray)
    }

    fn fit<P: Primitives>(
        prims: &P,
        ids: impl Iterator<Item = PrimId>,
        bounds: &Aabb,
        axes: Axes,
        watch: &impl Observer<Grow>,
    ) -> Result<Obb, Cancelled> {
        let corners = corners(prims, ids, watch)?;
        let center = bounds.center();
        // The principal axes or the world's, turned until no small turn makes the box smaller.
        let few = outermost(&corners, center, watch)?;
        let starts = [principal(&few, center, axes), DMat3::IDENTITY].map(|frame| Turned::by(&few, center, frame));
        let [principal, world] = starts;
        let start = if world.size() < principal.size() { world } else { principal };
        let frame = start.refined(&few, center, axes).frame;
        let axes = [frame.x_axis.as_vec3(), frame.y_axis.as_vec3(), frame.z_axis.as_vec3()];
        Obb::along(&corners, center, axes, watch)
    }

    fn meet(&self, ray: &Ray, within: Interval, place: Place, watch: &mut impl Observer<Visit>) -> Interval {
        let slack = slack(ray, ray.o - self.center, self.half.length());
        Obb { half: self.half + slack, ..*self }.slab(ray, within, place, watch)
    }

    fn bounds(&self) -> Aabb {
        Obb::bounds(self)
    }

    fn outline(&self) -> Outline {
        let planes = (0..3).flat_map(|i| {
            let (n, half) = (self.axes[i].as_dvec3(), f64::from(self.half[i]));
            [(n, half), (-n, half)]
        });
        Outline::of_planes(self.center, planes)
    }
}

impl Obb {
    /// The box along given directions around balls.
    fn along(corners: &[Corner], near: Vec3, axes: [Vec3; 3], watch: &impl Observer<Grow>) -> Result<Obb, Cancelled> {
        let normals = axes.map(Vec3::as_dvec3);
        let across = spans(corners, near, &normals, watch)?;
        let middle = normals
            .iter()
            .zip(across)
            .fold(near.as_dvec3(), |middle, (axis, [low, high])| middle + axis * ((low + high) * 0.5));
        // Single precision moves the centre: as large as it then must be.
        let center = middle.as_vec3();
        let across = spans(corners, center, &normals, watch)?;
        let half = [0, 1, 2].map(|i| (across[i][1].max(-across[i][0]) as f32).next_up());
        Ok(Obb { center, axes, half: Vec3::from(half) })
    }
}

/// The corners that lie furthest along the directions of a 26-DOP, or all if there are few: enough to choose the
/// box's directions by (Larsson and Källberg, "Fast computation of tight-fitting oriented bounding boxes", 2011).
fn outermost(corners: &[Corner], center: Vec3, watch: &impl Observer<Grow>) -> Result<Vec<Corner>, Cancelled> {
    const FEW: usize = 32;
    let found = if corners.len() <= FEW {
        corners.to_vec()
    } else {
        let lines = Vec3::AXES.into_iter().chain(Direction::SLANTED_VECTORS).map(|n| n.as_dvec3().normalize());
        let mut ends: Vec<_> = lines.flat_map(|n| [n, -n]).map(|n| (n, f64::NEG_INFINITY, corners[0])).collect();
        for corner in patiently(corners, watch) {
            let corner = corner?;
            let at = corner.at.as_dvec3() - center.as_dvec3();
            for (n, far, furthest) in &mut ends {
                let here = n.dot(at) + f64::from(corner.radius);
                if here > *far {
                    (*far, *furthest) = (here, *corner);
                }
            }
        }
        ends.into_iter().map(|(_, _, furthest)| furthest).collect()
    };
    // Neighbours share corners.
    let mut few: Vec<Corner> = Vec::with_capacity(found.len());
    for corner in found {
        if !few.contains(&corner) {
            few.push(corner);
        }
    }
    Ok(few)
}

/// Along which directions the corners spread most and least: the eigenvectors of their covariance.
fn principal(corners: &[Corner], center: Vec3, axes: Axes) -> DMat3 {
    let seen: Vec<DVec3> = corners.iter().map(|corner| corner.at.as_dvec3() - center.as_dvec3()).collect();
    let mean = seen.iter().sum::<DVec3>() / seen.len() as f64;
    let mut spread = DMat3::ZERO;
    for p in &seen {
        let p = *p - mean;
        spread += DMat3::from_cols(p * p.x, p * p.y, p * p.z);
    }
    // Turn about one axis after the other until nothing is left beside the diagonal (Jacobi 1846).
    let mut frame = DMat3::IDENTITY;
    for round in 0..24 {
        let (i, j) = if axes == Axes::Xy { (0, 1) } else { [(0, 1), (0, 2), (1, 2)][round % 3] };
        let beside = spread.col(i)[j];
        if beside == 0.0 {
            continue;
        }
        let slope = (spread.col(j)[j] - spread.col(i)[i]) / (2.0 * beside);
        let tangent = 1.0_f64.copysign(slope) / (slope.abs() + (1.0 + slope * slope).sqrt());
        let turn = turned(DMat3::IDENTITY, i, j, -tangent);
        spread = turn.transpose() * spread * turn;
        frame *= turn;
    }
    frame
}

/// Two directions of a frame turned towards each other by the angle with this tangent.
fn turned(frame: DMat3, i: usize, j: usize, tangent: f64) -> DMat3 {
    let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
    let sine = tangent * cosine;
    let (a, b) = (frame.col(i), frame.col(j));
    let mut next = frame;
    *next.col_mut(i) = a * cosine + b * sine;
    *next.col_mut(j) = b * cosine - a * sine;
    next
}

/// A frame, and how long the sides of the box along it are.
#[derive(Clone, Copy)]
struct Turned {
    frame: DMat3,
    sides: DVec3,
}

impl Turned {
    fn by(corners: &[Corner], center: Vec3, frame: DMat3) -> Turned {
        Turned { frame, sides: DVec3::from_array([0, 1, 2].map(|i| side(corners, center, frame.col(i)))) }
    }

    /// The surface; the sum of the sides decides between boxes without one.
    fn size(&self) -> f64 {
        let DVec3 { x, y, z } = self.sides;
        x * y + y * z + z * x + 1e-9 * (x + y + z) * (x + y + z)
    }

    /// Turned by smaller and smaller angles as long as the box shrinks.
    fn refined(mut self, corners: &[Corner], center: Vec3, axes: Axes) -> Turned {
        let pairs: &[(usize, usize)] = if axes == Axes::Xy { &[(0, 1)] } else { &[(0, 1), (0, 2), (1, 2)] };
        let mut tangent = 0.5;
        while tangent > 1e-4 {
            let turns = pairs.iter().flat_map(|&(i, j)| [(i, j, tangent), (i, j, -tangent)]);
            let tried = turns.map(|(i, j, tangent)| {
                // The third side stays as it is.
                let (frame, mut sides) = (turned(self.frame, i, j, tangent), self.sides);
                (sides[i], sides[j]) = (side(corners, center, frame.col(i)), side(corners, center, frame.col(j)));
                Turned { frame, sides }
            });
            match tried.reduce(|a, b| if b.size() < a.size() { b } else { a }) {
                Some(best) if best.size() < self.size() => self = best,
                _ => tangent *= 0.5,
            }
        }
        self
    }
}

/// How far apart the outermost corners along `n` are.
fn side(corners: &[Corner], center: Vec3, n: DVec3) -> f64 {
    let [low, high] = span(corners, center, n);
    high - low
}
