//! The oriented box, slide 51: three slabs along directions of its own.

use glam::{DMat3, DVec3, Vec3};

use super::{Outline, Spans, Volume, corners, push, slack, span, spans, spans_told, told};
use crate::common::bars_projection;
use crate::events::patiently;
use crate::{
    Aabb, Axes, Axis, Cancelled, Corner, Direction, Fit, FrameFrom, Interval, Obb, Observer, Place, PrimId, Primitives,
    Ray, Visit,
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
        watch: &mut impl Observer<Fit>,
    ) -> Result<Obb, Cancelled> {
        let corners = corners(prims, ids, watch)?;
        let center = bounds.center();
        // The principal axes or the world's, turned until no small turn makes the box smaller.
        let few = outermost(&corners, center, watch)?;
        let frames = [principal(&few, center, axes, watch), DMat3::IDENTITY];
        let [principal, world] = frames.map(|frame| Turned::by(&few, center, frame));
        principal.tell(FrameFrom::Principal, 0.0, watch);
        world.tell(FrameFrom::World, 0.0, watch);
        let start = if world.size() < principal.size() { world } else { principal };
        let other = if world.size() < principal.size() { principal } else { world };
        watch.on(Fit::Choose { surface: start.surface(), least: other.surface(), tangent: 0.0, taken: true });
        let frame = start.refined(&few, center, axes, watch).frame;
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

    fn planes(&self) -> u32 {
        6
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
    fn along(
        corners: &[Corner],
        near: Vec3,
        axes: [Vec3; 3],
        watch: &mut impl Observer<Fit>,
    ) -> Result<Obb, Cancelled> {
        let normals = axes.map(Vec3::as_dvec3);
        let across = spans(corners, near, &normals, watch)?;
        let middle = normals
            .iter()
            .zip(across)
            .fold(near.as_dvec3(), |middle, (axis, [low, high])| middle + axis * ((low + high) * 0.5));
        // Single precision moves the centre: as large as it then must be.
        let center = middle.as_vec3();
        // They are told as seen from where everything is.
        let moved = normals.map(|axis| axis.dot(center.as_dvec3() - near.as_dvec3()));
        let across = spans_told(corners, center, &normals, watch, |watch, i, span, points| {
            let span = span.map(|end| end + moved[i]);
            push(watch, Direction::Own([Axis::X, Axis::Y, Axis::Z][i]), normals[i], span, points);
        })?;
        let half = [0, 1, 2].map(|i| (across[i][1].max(-across[i][0]) as f32).next_up());
        Ok(Obb { center, axes, half: Vec3::from(half) })
    }
}

/// The corners that lie furthest along the directions of a 26-DOP, or all if there are few: enough to choose the
/// box's directions by (Larsson and Källberg, "Fast computation of tight-fitting oriented bounding boxes", 2011).
fn outermost(corners: &[Corner], center: Vec3, watch: &mut impl Observer<Fit>) -> Result<Vec<Corner>, Cancelled> {
    const FEW: usize = 32;
    let all = corners.len() <= FEW;
    let found = if all {
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
            let Vec3 { x, y, z } = corner.at;
            watch.on(Fit::Keep { point: few.len() as u32 - 1, x, y, z, few: all });
        }
    }
    Ok(few)
}

/// Along which directions the corners spread most and least: the eigenvectors of their covariance.
fn principal(corners: &[Corner], center: Vec3, axes: Axes, watch: &mut impl Observer<Fit>) -> DMat3 {
    let seen: Vec<DVec3> = corners.iter().map(|corner| corner.at.as_dvec3() - center.as_dvec3()).collect();
    let mean = seen.iter().sum::<DVec3>() / seen.len() as f64;
    let size = seen.iter().map(|at| at.length()).fold(0.0, f64::max);
    let Vec3 { x, y, z } = told(mean + center.as_dvec3(), size);
    watch.on(Fit::Mean { x, y, z, points: seen.len() as u32 });
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
        let [first, second] = [i, j].map(|index| Direction::Own([Axis::X, Axis::Y, Axis::Z][index]));
        let [along_first, along_second] = [i, j].map(|index| spread.col(index)[index] as f32);
        let (together, tangent) = (beside as f32, tangent as f32);
        // What rounding leaves turns nothing.
        if together.abs() > f32::EPSILON * (along_first + along_second) {
            watch.on(Fit::Align { first, second, along_first, along_second, together, tangent });
        }
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

/// So many turns by one angle are taken at most: along a narrow valley between two edges a box shrinks a little with each
/// of thousands.
const TURNS: u32 = 16;

/// A frame, and between which coordinates along it the box lies, seen from `center`.
#[derive(Clone, Copy)]
struct Turned {
    frame: DMat3,
    spans: [[f64; 2]; 3],
    center: Vec3,
}

impl Turned {
    fn by(corners: &[Corner], center: Vec3, frame: DMat3) -> Turned {
        Turned { frame, spans: [0, 1, 2].map(|i| span(corners, center, frame.col(i))), center }
    }

    /// How long the sides of the box are.
    fn sides(&self) -> DVec3 {
        DVec3::from_array(self.spans.map(|[low, high]| high - low))
    }

    /// The surface; the sum of the sides decides between boxes without one.
    fn size(&self) -> f64 {
        let DVec3 { x, y, z } = self.sides();
        x * y + y * z + z * x + 1e-9 * (x + y + z) * (x + y + z)
    }

    /// The surface alone.
    fn surface(&self) -> f32 {
        let DVec3 { x, y, z } = self.sides();
        (2.0 * (x * y + y * z + z * x)) as f32
    }

    /// Tells that this frame was tried.
    fn tell(&self, from: FrameFrom, tangent: f64, watch: &mut impl Observer<Fit>) {
        let middle = (0..3).fold(self.center.as_dvec3(), |middle, i| {
            middle + self.frame.col(i) * ((self.spans[i][0] + self.spans[i][1]) * 0.5)
        });
        let Vec3 { x, y, z } = told(middle, self.sides().max_element());
        let [u, v, w] = [self.frame.x_axis, self.frame.y_axis, self.frame.z_axis].map(|axis| told(axis, 1.0));
        let Vec3 { x: wide_u, y: wide_v, z: wide_w } = self.sides().as_vec3();
        watch.on(Fit::Frame {
            from,
            x,
            y,
            z,
            u_x: u.x,
            u_y: u.y,
            u_z: u.z,
            v_x: v.x,
            v_y: v.y,
            v_z: v.z,
            w_x: w.x,
            w_y: w.y,
            w_z: w.z,
            wide_u,
            wide_v,
            wide_w,
            surface: self.surface(),
            tangent: tangent as f32,
        });
    }

    /// Turned by smaller and smaller angles as long as the box shrinks, a few times each.
    fn refined(mut self, corners: &[Corner], center: Vec3, axes: Axes, watch: &mut impl Observer<Fit>) -> Turned {
        let pairs: &[(usize, usize)] = if axes == Axes::Xy { &[(0, 1)] } else { &[(0, 1), (0, 2), (1, 2)] };
        let (mut tangent, mut left) = (0.5, TURNS);
        while tangent > 1e-4 {
            let turns = pairs.iter().flat_map(|&(i, j)| [(i, j, tangent), (i, j, -tangent)]);
            let mut best: Option<Turned> = None;
            for (i, j, tangent) in turns {
                // The third side stays as it is.
                let (frame, mut spans) = (turned(self.frame, i, j, tangent), self.spans);
                (spans[i], spans[j]) = (span(corners, center, frame.col(i)), span(corners, center, frame.col(j)));
                let tried = Turned { frame, spans, center };
                tried.tell(FrameFrom::Turned, tangent, watch);
                if best.is_none_or(|best| tried.size() < best.size()) {
                    best = Some(tried);
                }
            }
            let Some(best) = best else { break };
            let (surface, least, taken) = (best.surface(), self.surface(), best.size() < self.size());
            if taken {
                self = best;
                left -= 1;
            }
            watch.on(Fit::Choose { surface, least, tangent: tangent as f32, taken });
            if !taken || left == 0 {
                (tangent, left) = (tangent * 0.5, TURNS);
            }
        }
        self
    }
}
