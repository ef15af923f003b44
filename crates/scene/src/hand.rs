//! Taking the shapes of a flat scene in the hand: where they can be held, and what becomes of them.

use glam::Vec2;
use raystep_accel::{Aabb, PrimId, Prims, Shape};

use crate::flat::{disc, outline, segment};
use crate::{Scene, View};

/// The part of a shape that is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Part {
    /// All of it.
    Whole,
    /// A corner of an outline, or an end of a segment. The corners of an upright rectangle take its sides along.
    Corner(usize),
    /// A side of an upright rectangle: from this corner to the next.
    Side(usize),
    /// The rim of a disc.
    Rim,
}

impl Scene {
    /// What of a flat scene can be held at a point: a corner, a rim or a side no further away than `near`, the nearest
    /// of them, else the smallest shape around the point.
    pub fn part_at(&self, at: Vec2, near: f32) -> Option<(PrimId, Part)> {
        let Prims::Few(shapes) = &self.prims else { return None };
        if !self.flat {
            return None;
        }
        let ids = (0..shapes.len() as u32).map(PrimId);
        let parts = ids.flat_map(|prim| parts(&shapes[prim.index()]).into_iter().map(move |part| (prim, part)));
        // Where a corner and a side are near, the corner is meant; of a small shape, all of it.
        let rank = |part: Part| u8::from(!matches!(part, Part::Corner(_)));
        let edge = parts.filter(|(_, part)| *part != Part::Whole).filter_map(|(prim, part)| {
            let shape = &shapes[prim.index()];
            let (away, room) = (distance(shape, part, at), smaller_side(&shape.bounds()) * 0.25);
            (away <= near.min(room.max(near * 0.3))).then_some((rank(part), away, prim, part))
        });
        let edge = edge.min_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        let inside = (0..shapes.len() as u32).map(PrimId).filter(|prim| {
            let shape = &shapes[prim.index()];
            let reach = if matches!(shape, Shape::Wall(_)) { near } else { 0.0 };
            distance(shape, Part::Whole, at) <= reach
        });
        let size = |prim: &PrimId| shapes[prim.index()].bounds().extent().truncate().length();
        let inside = inside.min_by(|a, b| size(a).total_cmp(&size(b))).map(|prim| (prim, Part::Whole));
        edge.map(|(.., prim, part)| (prim, part)).or(inside)
    }

    /// Everything that can be held, shape by shape, and where it lies. Of a scene that is not flat, nothing.
    pub fn parts(&self) -> Vec<(PrimId, Part, Vec2)> {
        let Prims::Few(shapes) = &self.prims else { return Vec::new() };
        let shapes = shapes.iter().enumerate().filter(|_| self.flat);
        let all = shapes.flat_map(|(index, shape)| {
            let prim = PrimId(index as u32);
            parts(shape).into_iter().filter_map(move |part| Some((prim, part, place(shape, part)?)))
        });
        all.collect()
    }

    /// The scene with a part of one shape, taken at `from`, moved to `to`, on the grid of [`step`](Scene::step); nothing if the shape
    /// would not be one any more.
    pub fn with_moved(&self, prim: PrimId, part: Part, from: Vec2, to: Vec2) -> Option<Scene> {
        let Prims::Few(shapes) = &self.prims else { return None };
        let step = self.step();
        let shape = moved(shapes.get(prim.index()).filter(|_| self.flat)?, part, from, to, step)?;
        let mut shapes = shapes.clone();
        shapes[prim.index()] = shape;
        let prims = Prims::Few(shapes);
        let view = View::fitting(&crate::scene::bounds(&prims), glam::Vec3::Z, glam::Vec3::Y);
        Some(Scene { prims, view, ..self.clone() })
    }

    /// The number on the grid of [`step`](Scene::step) that is nearest to this one.
    pub fn on_grid(&self, value: f32) -> f32 {
        on_grid(value.into(), self.step())
    }

    /// How far apart the places are that something held can take: a power of ten, about a pixel, so that numbers stay
    /// short.
    pub fn step(&self) -> f32 {
        let reach = self.bounds().extent().truncate().max_element() / 200.0;
        let steps = [1e3, 1e2, 1e1, 1.0, 1e-1, 1e-2];
        steps.into_iter().find(|step| *step <= reach).unwrap_or(1e-3)
    }
}

/// What of a shape can be held.
fn parts(shape: &Shape<'_>) -> Vec<Part> {
    match shape {
        Shape::Sphere(_) => vec![Part::Whole, Part::Rim],
        Shape::Wall(_) => vec![Part::Whole, Part::Corner(0), Part::Corner(1)],
        Shape::Prism(prism) => {
            let corners = prism.outline.len();
            let sides = if is_upright(prism.outline) { corners } else { 0 };
            let edges = (0..corners).map(Part::Corner).chain((0..sides).map(Part::Side));
            [Part::Whole].into_iter().chain(edges).collect()
        }
        _ => Vec::new(),
    }
}

/// Where a part lies.
fn place(shape: &Shape<'_>, part: Part) -> Option<Vec2> {
    match (shape, part) {
        (Shape::Sphere(disc), Part::Rim) => Some(disc.center.truncate() + Vec2::X * disc.radius),
        (Shape::Wall(wall), Part::Corner(index)) => [wall.from, wall.to].get(index).copied(),
        (Shape::Prism(prism), Part::Corner(index)) => prism.outline.get(index).copied(),
        (Shape::Prism(prism), Part::Side(index)) => {
            let next = (index + 1) % prism.outline.len();
            Some((*prism.outline.get(index)? + prism.outline[next]) * 0.5)
        }
        (_, Part::Whole) => Some(shape.bounds().center().truncate()),
        _ => None,
    }
}

/// How far a point lies from a part; 0 inside a shape that is held as a whole.
fn distance(shape: &Shape<'_>, part: Part, at: Vec2) -> f32 {
    match (shape, part) {
        (Shape::Sphere(disc), Part::Whole) => (at.distance(disc.center.truncate()) - disc.radius).max(0.0),
        (Shape::Sphere(disc), _) => (at.distance(disc.center.truncate()) - disc.radius).abs(),
        (Shape::Wall(wall), Part::Whole) => to_segment(at, wall.from, wall.to),
        (Shape::Prism(prism), Part::Whole) if surrounds(prism.outline, at) => 0.0,
        (Shape::Prism(prism), Part::Whole) => {
            prism.walls().map(|wall| to_segment(at, wall.from, wall.to)).fold(f32::INFINITY, f32::min)
        }
        (Shape::Prism(prism), Part::Side(index)) => {
            prism.walls().nth(index).map_or(f32::INFINITY, |wall| to_segment(at, wall.from, wall.to))
        }
        _ => place(shape, part).map_or(f32::INFINITY, |place| place.distance(at)),
    }
}

/// The shape with a part of it moved.
fn moved(shape: &Shape<'_>, part: Part, from: Vec2, to: Vec2, step: f32) -> Option<Shape<'static>> {
    if !parts(shape).contains(&part) {
        return None;
    }
    let number = |value: f32| on_grid(value.into(), step);
    let on = |at: Vec2| Vec2::new(number(at.x), number(at.y));
    let by = to - from;
    // As a whole it keeps its form.
    let shift = on(by);
    let shifted = |at: Vec2| {
        let exact = at.as_dvec2() + shift.as_dvec2();
        // A tenth of a step leaves its own digits, and no tail of others.
        Vec2::new(on_grid(exact.x, step * 0.1), on_grid(exact.y, step * 0.1))
    };
    let made = match (shape, part) {
        (Shape::Sphere(old), Part::Whole) => disc(shifted(old.center.truncate()), Some(old.radius)),
        (Shape::Sphere(old), Part::Rim) => {
            let center = old.center.truncate();
            let grown = to.distance(center) - from.distance(center);
            disc(center, Some(number(old.radius + grown).max(step)))
        }
        (Shape::Wall(wall), Part::Whole) => segment([shifted(wall.from), shifted(wall.to)]),
        (Shape::Wall(wall), Part::Corner(0)) => segment([on(wall.from + by), wall.to]),
        (Shape::Wall(wall), Part::Corner(1)) => segment([wall.from, on(wall.to + by)]),
        (Shape::Prism(prism), Part::Whole) => {
            outline(&prism.outline.iter().map(|corner| shifted(*corner)).collect::<Vec<_>>())
        }
        (Shape::Prism(prism), Part::Corner(index)) if index < prism.outline.len() => {
            let mut corners = prism.outline.to_vec();
            let (old, new) = (corners[index], on(corners[index] + by));
            if is_upright(prism.outline) {
                stretch(&mut corners, old, new, [true, true])?;
            } else {
                corners[index] = new;
            }
            outline(&corners)
        }
        (Shape::Prism(prism), Part::Side(index)) if index < prism.outline.len() => {
            let mut corners = prism.outline.to_vec();
            let (old, next) = (corners[index], corners[(index + 1) % corners.len()]);
            stretch(&mut corners, old, on(old + by), [old.x == next.x, old.y == next.y])?;
            outline(&corners)
        }
        _ => return None,
    };
    made.ok()
}

/// Moves the sides of an upright rectangle that go through `old`: those across x and those across y. Nothing if they
/// would reach the other side, or pass it.
fn stretch(corners: &mut [Vec2], old: Vec2, new: Vec2, [across_x, across_y]: [bool; 2]) -> Option<()> {
    let sizes = |corners: &[Vec2]| corners.iter().fold(Aabb::EMPTY, |all, p| all.with_point(p.extend(0.0))).extent();
    let sign = |corners: &[Vec2]| {
        let far = corners.iter().find(|p| p.x != old.x).map_or(0.0, |p| p.x);
        let high = corners.iter().find(|p| p.y != old.y).map_or(0.0, |p| p.y);
        (far, high)
    };
    let (far, high) = sign(corners);
    let turned = across_x && (old.x < far) != (new.x < far) || across_y && (old.y < high) != (new.y < high);
    for corner in corners.iter_mut() {
        if across_x && corner.x == old.x {
            corner.x = new.x;
        }
        if across_y && corner.y == old.y {
            corner.y = new.y;
        }
    }
    let size = sizes(corners);
    (!turned && size.x > 0.0 && size.y > 0.0).then_some(())
}

/// The nearest multiple of a step, which is a power of ten: spelt with as few digits.
fn on_grid(value: f64, step: f32) -> f32 {
    let step = f64::from(step);
    if step >= 1.0 {
        return ((value / step).round() * step) as f32;
    }
    let steps = (1.0 / step).round();
    ((value * steps).round() / steps) as f32
}

/// Whether an outline is a rectangle along the axes.
fn is_upright(outline: &[Vec2]) -> bool {
    let [a, b, c, d] = outline else { return false };
    let turns = |p: &Vec2, q: &Vec2| (p.x == q.x) != (p.y == q.y);
    let level = a.y == b.y && b.x == c.x && c.y == d.y && d.x == a.x;
    let steep = a.x == b.x && b.y == c.y && c.x == d.x && d.y == a.y;
    (level || steep) && turns(a, b) && turns(b, c)
}

fn smaller_side(bounds: &Aabb) -> f32 {
    let extent = bounds.extent();
    // A segment along an axis has no width.
    if extent.x.min(extent.y) > 0.0 { extent.x.min(extent.y) } else { extent.x.max(extent.y) }
}

fn to_segment(at: Vec2, from: Vec2, to: Vec2) -> f32 {
    let along = to - from;
    let share = ((at - from).dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
    at.distance(from + along * share)
}

/// Whether a point lies within an outline, by the edges that a ray to the right crosses.
fn surrounds(outline: &[Vec2], at: Vec2) -> bool {
    let edges = outline.iter().zip(outline.iter().cycle().skip(1));
    let crosses =
        |(a, b): &(&Vec2, &Vec2)| (a.y > at.y) != (b.y > at.y) && at.x < (b.x - a.x) * (at.y - a.y) / (b.y - a.y) + a.x;
    edges.filter(crosses).count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use raystep_accel::Primitives;

    use super::*;

    fn scene(shapes: &str) -> Scene {
        // The far segment makes the grid one of hundredths.
        let text = format!("title = \"t\"\nshapes = [{shapes}, {{ segment = [[0, 0], [10, 0]] }}]");
        Scene::from_toml(&text, "t").unwrap()
    }

    const DISC: &str = "{ disc = [2, 2], radius = 0.5 }";
    const BOX: &str = "{ box = [[1, 2], [3, 6]] }";
    const TRIANGLE: &str = "{ triangle = [[2, 3], [4, 3], [3, 5]] }";

    #[test]
    fn what_lies_under_the_pointer_is_held() {
        let check = |shapes: &str, at: [f32; 2], held: Option<(u32, Part)>| {
            let found = scene(shapes).part_at(at.into(), 0.1);
            assert_eq!(found.map(|(prim, part)| (prim.0, part)), held, "{shapes} at {at:?}");
        };
        check(DISC, [2.1, 2.0], Some((0, Part::Whole)));
        check(DISC, [2.0, 2.48], Some((0, Part::Rim)));
        check(DISC, [2.0, 2.7], None);
        check(DISC, [5.0, 0.05], Some((1, Part::Whole)));
        check(DISC, [9.95, 0.02], Some((1, Part::Corner(1))));
        check(BOX, [3.05, 6.02], Some((0, Part::Corner(2))));
        check(BOX, [3.05, 4.0], Some((0, Part::Side(1))));
        check(BOX, [2.0, 4.0], Some((0, Part::Whole)));
        check(TRIANGLE, [2.02, 3.02], Some((0, Part::Corner(0))));
        check(TRIANGLE, [3.0, 3.8], Some((0, Part::Whole)));
        check(TRIANGLE, [3.0, 3.02], Some((0, Part::Whole)));
        // In a large shape the small one is meant.
        check(&format!("{BOX}, {DISC}"), [2.1, 2.2], Some((1, Part::Whole)));
    }

    #[test]
    fn what_is_held_moves_on_the_grid() {
        let check = |shapes: &str, part: Part, by: [f32; 2], after: Option<&str>| {
            let scene = scene(shapes);
            let from = scene.parts().into_iter().find(|(prim, held, _)| prim.0 == 0 && *held == part);
            let from = from.map_or(Vec2::ZERO, |(.., at)| at);
            let moved = scene.with_moved(PrimId(0), part, from, from + Vec2::from(by));
            let says = moved.map(|moved| match moved.prims.shape(PrimId(0)) {
                Shape::Sphere(disc) => format!("{} {} r {}", disc.center.x, disc.center.y, disc.radius),
                Shape::Wall(wall) => format!("{} {}", wall.from, wall.to),
                Shape::Prism(prism) => prism.outline.iter().map(|p| format!("{},{} ", p.x, p.y)).collect(),
                _ => String::new(),
            });
            assert_eq!(says.as_deref().map(str::trim), after, "{shapes} {part:?} by {by:?}");
        };
        check(DISC, Part::Whole, [0.1234, -0.1], Some("2.12 1.9 r 0.5"));
        check(DISC, Part::Rim, [0.25, 0.0], Some("2 2 r 0.75"));
        check(DISC, Part::Rim, [-0.5, 0.0], Some("2 2 r 0.01"));
        check(BOX, Part::Whole, [1.0, 0.005], Some("2,2.01 4,2.01 4,6.01 2,6.01"));
        check(BOX, Part::Corner(2), [0.5, -1.0], Some("1,2 3.5,2 3.5,5 1,5"));
        check(BOX, Part::Corner(2), [-3.0, 0.0], None);
        check(BOX, Part::Side(3), [0.5, 9.0], Some("1.5,2 3,2 3,6 1.5,6"));
        check(BOX, Part::Side(0), [9.0, 4.0], None);
        check(TRIANGLE, Part::Corner(1), [0.333, 0.0], Some("2,3 4.33,3 3,5"));
        check(TRIANGLE, Part::Corner(1), [-2.0, 0.0], None);
        check(TRIANGLE, Part::Side(0), [1.0, 1.0], None);
        check("{ segment = [[1, 1], [2, 3]] }", Part::Corner(0), [0.5, 0.5], Some("[1.5, 1.5] [2, 3]"));
        check("{ segment = [[1, 1], [2, 3]] }", Part::Corner(0), [1.0, 2.0], None);
        check("{ segment = [[1, 1], [2, 3]] }", Part::Whole, [0.5, 0.0], Some("[1.5, 1] [2.5, 3]"));
    }

    #[test]
    fn every_part_of_every_shipped_flat_scene_can_be_held_where_it_is_said_to_lie() {
        for name in crate::scene_names() {
            let scene = Scene::named(&name).unwrap();
            let parts = scene.parts();
            assert_eq!(parts.is_empty(), !scene.flat, "{name}");
            for (prim, part, at) in parts {
                let moved = scene.with_moved(prim, part, at, at);
                let same =
                    |a: &Scene| (a.prims.bounds(prim).min - scene.prims.bounds(prim).min).length() < scene.step();
                assert!(moved.is_some_and(|moved| same(&moved)), "{name} {prim} {part:?}");
                assert!(scene.part_at(at, scene.step()).is_some(), "{name} {prim} {part:?}");
            }
        }
    }
}
