//! The oriented box, slide 51: three slabs along directions of its own.

use glam::{DMat3, DVec3, Vec3};

use super::{Outline, Volume, corners, slack, span};
use crate::bvh::Spans;
use crate::{Aabb, Axes, Corner, Interval, Obb, Observer, Place, PrimId, Primitives, Ray, Visit};

impl Volume for Obb {
    type Draft = Spans;

    fn fit<P: Primitives>(prims: &P, ids: impl Iterator<Item = PrimId>, bounds: &Aabb, axes: Axes) -> Obb {
        let corners = corners(prims, ids);
        let center = bounds.center();
        // The principal axes and the world's, each turned until no small turn makes the box smaller.
        let few = outermost(&corners, center);
        let frames = [principal(&few, center, axes), DMat3::IDENTITY];
        let (_, frame) = frames
            .map(|frame| refined(&few, center, axes, frame))
            .into_iter()
            .reduce(|best, next| if next.0 < best.0 { next } else { best })
            .unwrap_or((0.0, DMat3::IDENTITY));
        Obb::along(&corners, center, [frame.x_axis.as_vec3(), frame.y_axis.as_vec3(), frame.z_axis.as_vec3()])
    }

    fn meet(&self, ray: &Ray, within: Interval, place: Place, watch: &mut impl Observer<Visit>) -> Interval {
        let slack = slack(ray.o - self.center, self.half.length());
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
    fn along(corners: &[Corner], near: Vec3, axes: [Vec3; 3]) -> Obb {
        let middle = axes.iter().fold(near.as_dvec3(), |middle, axis| {
            let [low, high] = span(corners, near, axis.as_dvec3());
            middle + axis.as_dvec3() * ((low + high) * 0.5)
        });
        let center = middle.as_vec3();
        let half = axes.map(|axis| {
            let [low, high] = span(corners, center, axis.as_dvec3());
            (high.max(-low) as f32).next_up()
        });
        Obb { center, axes, half: Vec3::from(half) }
    }
}

/// The corners that lie furthest along a few dozen directions: enough to choose the box's directions by
/// (Larsson and Källberg, "Fast computation of tight-fitting oriented bounding boxes", 2011).
fn outermost(corners: &[Corner], center: Vec3) -> Vec<Corner> {
    const FEW: usize = 64;
    if corners.len() <= FEW {
        return corners.to_vec();
    }
    let step = |i: i32| [-2, -1, 0, 1, 2].map(move |j| [f64::from(i), f64::from(j)]);
    let directions = [-2, -1, 0, 1, 2]
        .into_iter()
        .flat_map(step)
        .flat_map(|[x, y]| [DVec3::new(x, y, 2.0), DVec3::new(y, 2.0, x), DVec3::new(2.0, x, y)]);
    let far = |corner: &Corner, n: DVec3| {
        n.dot(corner.at.as_dvec3() - center.as_dvec3()) + f64::from(corner.radius) * n.length()
    };
    directions
        .flat_map(|n| [n, -n])
        .filter_map(|n| corners.iter().max_by(|a, b| far(a, n).total_cmp(&far(b, n))).copied())
        .collect()
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

/// Turns a frame by smaller and smaller angles as long as the box along it shrinks; its surface, and the frame.
fn refined(corners: &[Corner], center: Vec3, axes: Axes, start: DMat3) -> (f64, DMat3) {
    let size = |frame: DMat3| {
        let side = |i: usize| {
            let [low, high] = span(corners, center, frame.col(i));
            high - low
        };
        let (u, v, w) = (side(0), side(1), side(2));
        // The sum of the sides decides between boxes without a surface.
        u * v + v * w + w * u + 1e-9 * (u + v + w) * (u + v + w)
    };
    let pairs: &[(usize, usize)] = if axes == Axes::Xy { &[(0, 1)] } else { &[(0, 1), (0, 2), (1, 2)] };
    let (mut frame, mut least) = (start, size(start));
    let mut tangent = 0.5;
    while tangent > 1e-4 {
        let turns = pairs.iter().flat_map(|&(i, j)| [turned(frame, i, j, tangent), turned(frame, i, j, -tangent)]);
        let best = turns.map(|turn| (size(turn), turn)).reduce(|a, b| if b.0 < a.0 { b } else { a });
        match best {
            Some((size, turn)) if size < least => (least, frame) = (size, turn),
            _ => tangent *= 0.5,
        }
    }
    (least, frame)
}
