//! The shapes of a flat scene as numbers: what they are moved to by hand is written down, and found again.

use glam::Vec2;
use raystep_accel::{PrimId, Prims, Shape};

use crate::flat::{disc, outline, place, segment};
use crate::{Scene, View};

impl Scene {
    /// The numbers of a shape of a flat scene, in the order x, y: the middle of a disc and its radius, the ends of a
    /// segment, the corners of a polygon. Of anything else nothing.
    pub fn numbers(&self, prim: PrimId) -> Option<Vec<f32>> {
        let Prims::Few(shapes) = &self.prims else { return None };
        let flat = |points: &[Vec2]| points.iter().flat_map(Vec2::to_array).collect();
        match shapes.get(prim.index()).filter(|_| self.flat)? {
            Shape::Sphere(disc) => Some(vec![disc.center.x, disc.center.y, disc.radius]),
            Shape::Wall(wall) => Some(flat(&[wall.from, wall.to])),
            Shape::Prism(prism) => Some(flat(prism.outline)),
            _ => None,
        }
    }

    /// The scene with one shape where these numbers say, which are as many as its own.
    ///
    /// # Errors
    /// There is no such shape, it has no such numbers, or they make none of its kind: a sentence says what is allowed.
    pub fn with_numbers(&self, prim: PrimId, numbers: &[f32]) -> Result<Scene, String> {
        let shapes = match &self.prims {
            Prims::Few(shapes) if self.flat => shapes,
            _ => return Err("only shapes of flat scenes are moved".to_owned()),
        };
        let old = shapes
            .get(prim.index())
            .ok_or_else(|| format!("there is no shape {prim}; the last one is {}", shapes.len().saturating_sub(1)))?;
        let points: Result<Vec<Vec2>, String> =
            numbers.chunks_exact(2).map(|point| place(point[0], point[1])).collect();
        let points = points?;
        let shape = match (old, points.as_slice(), numbers) {
            (Shape::Sphere(_), [middle], [_, _, radius]) => disc(*middle, Some(*radius))?,
            (Shape::Wall(_), [from, to], [_, _, _, _]) => segment([*from, *to])?,
            (Shape::Prism(prism), corners, _) if numbers.len() == 2 * prism.outline.len() => outline(corners)?,
            (Shape::Sphere(_), ..) => return Err(format!("{prim} is a disc: x and y of its middle and its radius")),
            (Shape::Wall(_), ..) => return Err(format!("{prim} is a segment: x and y of both ends")),
            (Shape::Prism(prism), ..) => {
                return Err(format!("{prim} has {} corners: x and y of each", prism.outline.len()));
            }
            _ => return Err(format!("{prim} is no shape that is moved")),
        };
        let mut shapes = shapes.clone();
        shapes[prim.index()] = shape;
        let prims = Prims::Few(shapes);
        let view = View::fitting(&crate::scene::bounds(&prims), glam::Vec3::Z, glam::Vec3::Y);
        Ok(Scene { prims, view, ..self.clone() })
    }
}

#[cfg(test)]
mod tests {
    use raystep_accel::Primitives;

    use super::*;

    #[test]
    fn what_was_moved_is_found_again_by_its_numbers() {
        let mut moved = 0;
        for name in crate::scene_names() {
            let scene = Scene::named(&name).unwrap();
            for (prim, part, at) in scene.parts() {
                let Some(by_hand) = scene.with_moved(prim, part, at, at + Vec2::new(0.21, -0.13)) else { continue };
                let again = scene.with_numbers(prim, &by_hand.numbers(prim).unwrap()).unwrap();
                assert_eq!(again.prims.shape(prim), by_hand.prims.shape(prim), "{name} {prim} {part:?}");
                assert_eq!(again.view, by_hand.view, "{name} {prim} {part:?}");
                moved += 1;
            }
        }
        assert!(moved > 100, "{moved} parts");
    }

    #[test]
    fn numbers_that_make_no_shape_get_a_sentence() {
        let shapes = "{ disc = [2, 2], radius = 0.5 }, { segment = [[0, 0], [10, 0]] }, { box = [[1, 2], [3, 6]] }";
        let scene = Scene::from_toml(&format!("title = \"t\"\nshapes = [{shapes}]"), "t").unwrap();
        let check = |prim: u32, numbers: &[f32], says: &str| {
            let wrong = scene.with_numbers(PrimId(prim), numbers).unwrap_err();
            assert!(wrong.starts_with(says), "{prim} {numbers:?}: {wrong}");
        };
        check(0, &[1.0, 2.0], "0 is a disc: x and y of its middle and its radius");
        check(0, &[1.0, 2.0, 0.0], "radius 0: a disc's radius is a number above 0");
        check(0, &[f32::NAN, 2.0, 1.0], "[NaN, 2]: coordinates are numbers from");
        check(1, &[1.0, 2.0, 3.0], "1 is a segment: x and y of both ends");
        check(1, &[1.0, 2.0, 1.0, 2.0], "the two ends of a segment differ");
        check(2, &[1.0, 2.0, 1.0, 2.0], "2 has 4 corners: x and y of each");
        check(2, &[1.0, 2.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0], "neighbouring corners differ");
        check(3, &[1.0, 2.0], "there is no shape 3; the last one is 2");
        let solid = Scene::named("teapot:3x3").unwrap();
        assert!(solid.with_numbers(PrimId(0), &[1.0]).unwrap_err().starts_with("only shapes of flat scenes"));
    }
}
