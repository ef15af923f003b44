//! Whole builds and walks through small flat scenes as text: one line an event, in the order of the algorithm.

use crate::spell::line;
use glam::{Vec2, Vec3};
use raystep_accel::*;

fn wall(from: [f32; 2], to: [f32; 2]) -> Shape<'static> {
    Shape::Wall(Wall { from: Vec2::from(from), to: Vec2::from(to), z: [-0.5, 0.5] })
}

fn disc(x: f32, y: f32, radius: f32) -> Shape<'static> {
    Shape::Sphere(Sphere { center: Vec3::new(x, y, 0.0), radius })
}

/// A slanted wall across four of six cells, a disc before it, and walls in two corners.
fn scene() -> Vec<Shape<'static>> {
    vec![
        wall([0.5, 0.2], [2.9, 1.9]),
        disc(1.55, 0.55, 0.2),
        wall([0.0, 0.0], [0.0, 0.1]),
        wall([3.0, 1.9], [3.0, 2.0]),
    ]
}

fn ray(o: [f32; 2], to: [f32; 2]) -> Ray {
    let (o, to) = (Vec2::from(o), Vec2::from(to));
    Ray::new(o.extend(0.0), (to - o).extend(0.0)).unwrap()
}

fn walked(structure: &Structure, ray: &Ray) -> String {
    let mut events: Vec<Visit> = Vec::new();
    structure.intersect(&scene().as_slice(), ray, &mut events);
    // A flat scene leaves out z and the arithmetic of its slabs.
    let coarse = events.iter().filter(|event| event.grain() != Grain::Arithmetic);
    coarse.map(|event| line(event.name(), event.fields(), |field| event.field(field)) + "\n").collect()
}

/// Cells with two primitives hold grids of two by two cells.
const NESTED: [(&str, &str); 4] = [("nx", "3"), ("ny", "2"), ("more_than", "1"), ("inner_factor", "1.6")];

fn grown(kind: &str, settings: &[(&str, &str)]) -> (Structure, String) {
    let mut rule = Rule::default_for(kind).unwrap().flat();
    for (key, value) in settings {
        rule.set(key, value).unwrap();
    }
    let mut events: Vec<Grow> = Vec::new();
    let structure = Structure::build(&scene().as_slice(), &rule, &mut events).unwrap();
    let story = events.iter().map(|event| line(event.name(), event.fields(), |field| event.field(field)) + "\n");
    (structure, story.collect())
}

#[test]
fn a_grid_is_built() {
    let (_, story) = grown("grid", &[("nx", "3"), ("ny", "2")]);
    insta::assert_snapshot!(story);
}

#[test]
fn a_grid_is_walked() {
    let (grid, _) = grown("grid", &[("nx", "3"), ("ny", "2")]);
    insta::assert_snapshot!(walked(&grid, &ray([-1.0, 0.3], [0.0, 0.46])));
}

#[test]
fn nested_grids_are_built() {
    let (_, story) = grown("nested-grid", &NESTED);
    insta::assert_snapshot!(story);
}

#[test]
fn nested_grids_are_walked() {
    let (grid, _) = grown("nested-grid", &NESTED);
    insta::assert_snapshot!(walked(&grid, &ray([-1.0, 0.3], [0.0, 0.46])));
}

#[test]
fn a_hashed_grid_is_walked() {
    let (grid, _) = grown("hashed-grid", &[("nx", "6"), ("ny", "4")]);
    insta::assert_snapshot!(walked(&grid, &ray([-1.0, 1.3], [0.0, 1.2])));
}

#[test]
fn a_hierarchy_of_boxes_is_built() {
    let (_, story) = grown("bvh", &[("split", "sweep"), ("leaf_size", "1")]);
    insta::assert_snapshot!(story);
}

#[test]
fn a_hierarchy_of_boxes_is_walked_in_order() {
    let (bvh, _) = grown("bvh", &[("split", "sweep"), ("leaf_size", "1")]);
    insta::assert_snapshot!(walked(&bvh, &ray([4.0, 0.0], [3.0, 0.22])));
}

#[test]
fn a_hierarchy_of_boxes_is_walked_as_printed() {
    let (bvh, _) = grown("bvh", &[("split", "sweep"), ("leaf_size", "1"), ("order", "printed")]);
    insta::assert_snapshot!(walked(&bvh, &ray([4.0, 0.0], [3.0, 0.22])));
}

#[test]
fn a_kd_tree_is_built() {
    let (_, story) = grown("kd", &[("split", "median"), ("min_objects", "1"), ("max_depth", "3")]);
    insta::assert_snapshot!(story);
}

#[test]
fn a_kd_tree_weighs_its_planes() {
    let (_, story) = grown("kd", &[("max_depth", "1"), ("min_objects", "1")]);
    insta::assert_snapshot!(story);
}

#[test]
fn a_kd_tree_is_walked() {
    let (tree, _) = grown("kd", &[("split", "median"), ("min_objects", "1"), ("max_depth", "3")]);
    insta::assert_snapshot!(walked(&tree, &ray([-1.0, 0.3], [0.0, 0.46])));
}

#[test]
fn a_kd_tree_is_walked_from_the_right() {
    let (tree, _) = grown("kd", &[("split", "median"), ("min_objects", "1"), ("max_depth", "3")]);
    insta::assert_snapshot!(walked(&tree, &ray([4.0, 0.0], [3.0, 0.22])));
}

#[test]
fn a_bsp_tree_is_walked() {
    let (tree, _) = grown("bsp", &[("min_objects", "1"), ("max_depth", "4"), ("traversal_cost", "0")]);
    insta::assert_snapshot!(walked(&tree, &ray([-1.0, 0.3], [0.0, 0.46])));
}

#[test]
fn hierarchies_are_put_together() {
    for builder in ["bottom-up", "ploc", "insertion"] {
        let (_, story) = grown("bvh", &[("builder", builder), ("leaf_size", "1")]);
        insta::assert_snapshot!(format!("a_hierarchy_is_built_{}", builder.replace('-', "_")), story);
    }
}

/// One test of the root's volume, with its arithmetic, then the walk.
#[test]
fn every_volume_is_walked() {
    for volume in ["sphere", "obb", "kdop14", "hull"] {
        let (bvh, _) = grown("bvh", &[("volume", volume), ("split", "sweep"), ("leaf_size", "1")]);
        let ray = ray([4.0, 0.0], [3.0, 0.22]);
        let mut events: Vec<Visit> = Vec::new();
        bvh.intersect(&scene().as_slice(), &ray, &mut events);
        let root = events.iter().take_while(|event| event.grain() == Grain::Arithmetic);
        let test: String =
            root.map(|event| line(event.name(), event.fields(), |field| event.field(field)) + "\n").collect();
        insta::assert_snapshot!(format!("a_hierarchy_of_{volume}_is_walked"), test + "\n" + &walked(&bvh, &ray));
    }
}
