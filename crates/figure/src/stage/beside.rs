//! Where there may be room for a label: beside a line, a box, a shape, a point.

use glam::{Vec2, Vec3};
use raystep_accel::{Aabb, Place};

use super::lens::Lens;
use super::spot::Spot;
use crate::theme::Role;
use crate::world::{Form, Space, contour, edges};

/// Space between a label and what it labels, in points.
pub(super) const GAP: f32 = 7.0;

/// The directions in which there may be room: the corners first.
pub(super) const AROUND: [(f32, f32); 8] =
    [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (0.0, -1.0), (0.0, 1.0), (-1.0, 0.0), (1.0, 0.0)];

/// Whether a box is a line of a flat scene: a plane seen from above.
pub(super) fn is_line(bounds: &Aabb) -> bool {
    let extent = bounds.extent();
    (extent.x == 0.0) != (extent.y == 0.0)
}

/// Whether a box is a part of a plane in space.
pub(super) fn is_sheet(bounds: &Aabb) -> bool {
    bounds.extent().to_array().into_iter().filter(|side| *side == 0.0).count() == 1
}

/// The ends of a line along an axis, beyond it, and beside it near the ends.
pub(super) fn beside_line(bounds: &Aabb, lens: &Lens, half: Vec2) -> Vec<Spot> {
    let end = |at: Vec3| lens.point(at.with_z(0.0)).map(|(at, _)| at);
    let (Some(from), Some(to)) = (end(bounds.min), end(bounds.max)) else { return Vec::new() };
    let along = (to - from).normalize_or_zero();
    let across = along.perp();
    let out = |at: Vec2, way: Vec2, gap: f32| Spot::around(at + way * (way.abs().dot(half) + gap), half);
    let mut spots = vec![out(from, -along, 4.0), out(to, along, 4.0)];
    for share in [0.0, 1.0, 0.12, 0.88, 0.3, 0.7] {
        let at = from.lerp(to, share);
        let inward = if share < 0.5 { along } else { -along } * (along.abs().dot(half) + 4.0);
        spots.extend([across, -across].map(|way| out(at + inward, way, 4.0)));
    }
    spots
}

/// The corners of a flat box, inside where there is room; around the corners of a box in space.
pub(super) fn beside_box(bounds: &Aabb, lens: &Lens, half: Vec2, flat: bool, inside: bool) -> Vec<Spot> {
    let seen: Vec<Vec2> = bounds.corners().iter().filter_map(|&corner| Some(lens.point(corner)?.0)).collect();
    let Some(outer) = Spot::over(&seen) else { return Vec::new() };
    let middle = outer.center();
    let mut spots = Vec::new();
    let room = outer.half() - half - GAP;
    if inside && room.min_element() >= 0.0 {
        spots.extend(AROUND.iter().map(|&(x, y)| Spot::around(middle + room * Vec2::new(x, y), half)));
    }
    if !flat {
        for corner in seen {
            let away = (corner - middle).signum();
            spots.push(Spot::around(corner + away * (half + 2.0), half));
        }
    }
    let beyond = outer.half() + half + 3.0;
    let inner = outer.half() - half;
    for &(x, y) in &[(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (0.0, -1.0), (0.0, 1.0)] {
        spots.push(Spot::around(middle + Vec2::new(inner.x * x, beyond.y * y), half));
    }
    for &(x, y) in &[(-1.0, 0.0), (1.0, 0.0), (-1.0, -1.0), (1.0, 1.0)] {
        spots.push(Spot::around(middle + Vec2::new(beyond.x * x, inner.y * y), half));
    }
    spots
}

/// The point on the edges of a box in space that lies nearest to its label.
pub(super) fn on_box(bounds: &Aabb, lens: &Lens, spot: Spot) -> Option<Vec2> {
    let seen = edges(bounds).into_iter().filter_map(|[from, to]| lens.segment(from, to));
    nearest(seen.map(|[(from, _), (to, _)]| (from, to)), spot)
}

/// The point on the outline of a flat shape that lies nearest to its label; nothing if the label lies in it.
pub(super) fn on_outline(shape: &[Vec2], spot: Spot) -> Option<Vec2> {
    let next = shape.iter().cycle().skip(1);
    nearest(shape.iter().zip(next).map(|(&from, &to)| (from, to)), spot).filter(|_| !spot.is_within(shape))
}

/// The point of all lines that lies nearest to a label.
pub(super) fn nearest(lines: impl Iterator<Item = (Vec2, Vec2)>, spot: Spot) -> Option<Vec2> {
    let on = |(from, to): (Vec2, Vec2)| {
        let along = to - from;
        let share = (spot.center() - from).dot(along) / along.length_squared().max(f32::MIN_POSITIVE);
        from + along * share.clamp(0.0, 1.0)
    };
    let away = |at: &Vec2| spot.nearest(*at).distance(*at);
    lines.map(on).min_by(|a, b| away(a).total_cmp(&away(b)))
}

/// All around a flat box, at some distance.
pub(super) fn further(own: Spot, half: Vec2) -> Vec<Spot> {
    let at = |gap: f32| {
        AROUND.iter().map(move |&(x, y)| Spot::around(own.center() + (own.half() + half + gap) * Vec2::new(x, y), half))
    };
    [18.0, 36.0, 60.0].into_iter().flat_map(at).collect()
}

/// Corners of what bounds a place, on the page, if that is no box along the axes; in a flat scene in order.
pub(super) fn outline(space: &Space, place: Option<Place>, lens: &Lens) -> Vec<Vec2> {
    let of_place = space.marks.iter().filter(|mark| place.is_some() && mark.place == place);
    let mut corners: Vec<Vec3> = Vec::new();
    for mark in of_place {
        match &mark.form {
            Form::Body(edges) => corners.extend(edges.iter().flatten()),
            Form::Sphere(sphere) if space.flat => {
                let away = |angle: f64| Vec3::new(libm::cos(angle) as f32, libm::sin(angle) as f32, 0.0);
                let around = (0..32).map(|i| away(f64::from(i) * std::f64::consts::TAU / 32.0));
                corners = around.map(|away| sphere.center + away * sphere.radius).collect();
            }
            Form::Sphere(sphere) => corners.extend(contour(sphere, lens.eye()).unwrap_or_default()),
            Form::Polygon(around) if space.flat => corners.clone_from(around),
            Form::Segment(from, to) if !space.flat && mark.role != Role::Live && mark.role != Role::Candidate => {
                corners.extend([*from, *to]);
            }
            _ => {}
        }
    }
    corners.into_iter().filter_map(|corner| Some(lens.point(corner)?.0)).collect()
}

/// Within a flat shape where there is room, else around what of it lies furthest out.
pub(super) fn beside_shape(shape: &[Vec2], half: Vec2, flat: bool) -> Vec<Spot> {
    let mut spots = if flat { within_shape(shape, half) } else { Vec::new() };
    spots.extend(ends(shape).into_iter().map(|(away, end)| Spot::around(end + away * (half + 3.0), half)));
    spots
}

/// Within a flat shape, near what of it lies furthest out.
pub(super) fn within_shape(shape: &[Vec2], half: Vec2) -> Vec<Spot> {
    let within = |reach: f32| {
        let spots =
            ends(shape).into_iter().map(move |(away, end)| Spot::around(end - away * (half + GAP) * reach, half));
        spots.filter(|spot| spot.is_within(shape))
    };
    [1.0, 1.5, 2.2].into_iter().flat_map(within).collect()
}

/// Anywhere within a flat shape, row by row.
pub(super) fn all_over(shape: &[Vec2], half: Vec2) -> Vec<Spot> {
    const PARTS: u32 = 6;
    let Some(Spot { min, max }) = Spot::over(shape) else { return Vec::new() };
    let share = |part: u32| part as f32 / PARTS as f32;
    let places = (1..PARTS).flat_map(|row| (1..PARTS).map(move |column| Vec2::new(share(column), share(row))));
    let spots = places.map(|at| Spot::around(min + (max - min) * at, half));
    spots.filter(|spot| spot.is_within(shape)).collect()
}

/// What of a shape lies furthest out in each direction.
fn ends(shape: &[Vec2]) -> Vec<(Vec2, Vec2)> {
    let furthest = |away: Vec2| shape.iter().copied().max_by(|a, b| a.dot(away).total_cmp(&b.dot(away)));
    AROUND.iter().filter_map(|&(x, y)| Some((Vec2::new(x, y), furthest(Vec2::new(x, y))?))).collect()
}

/// All around a point: above first.
pub(super) fn beside_point(point: Option<Vec2>, half: Vec2) -> Vec<Spot> {
    let Some(point) = point else { return Vec::new() };
    let near = half + GAP + 2.0;
    let mut spots = Vec::new();
    for reach in [1.0, 1.7, 2.6, 3.8, 5.4] {
        for (x, y) in
            [(-0.55, -1.0), (0.55, -1.0), (0.0, -1.0), (0.0, 1.0), (0.55, 1.0), (-0.55, 1.0), (1.0, 0.0), (-1.0, 0.0)]
        {
            spots.push(Spot::around(point + Vec2::new(near.x * x, near.y * y * reach), half));
        }
    }
    spots
}
