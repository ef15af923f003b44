//! What bounds the nodes of a tree, as forms: boxes, spheres, bodies, cells.

use std::collections::BTreeSet;

use glam::Vec3;
use raystep_accel::{Aabb, AnyBvh, NodeId, Outline, Sphere, Structure};

use super::convex;
use super::space::Form;

/// What a node looks like; nothing if a box shows it.
pub(crate) fn node(structure: &Structure, node: NodeId, flat: bool) -> Vec<Form> {
    match structure {
        Structure::Bsp(tree) => convex::cell(&tree.cell(node), flat),
        Structure::Bvh(tree) => volume(&tree.outline(node), flat),
        _ => Vec::new(),
    }
}

/// Of a tree with more nodes than this, the picture has room for so many: the uppermost come first.
const UPPERMOST: u32 = 256;

/// The box around what is drawn of a structure: spheres and oriented boxes reach out of the box of the primitives.
pub(crate) fn reach(structure: &Structure) -> Aabb {
    let bounds = structure.bounds();
    let nodes = (0..UPPERMOST.min(structure.node_count() as u32)).map(NodeId);
    match structure {
        Structure::Bvh(AnyBvh::Sphere(tree)) => nodes.fold(bounds, |all, id| all.union(tree.volume(id).bounds())),
        Structure::Bvh(AnyBvh::Obb(tree)) => nodes.fold(bounds, |all, id| all.union(tree.volume(id).bounds())),
        _ => bounds,
    }
}

/// A volume in a solid scene.
pub fn forms_of(outline: &Outline) -> Vec<Form> {
    volume(outline, false)
}

/// A volume: in a flat scene, where it meets the plane of the drawing.
pub(crate) fn volume(outline: &Outline, flat: bool) -> Vec<Form> {
    match outline {
        Outline::Box(bounds) if bounds.is_empty() => Vec::new(),
        Outline::Box(bounds) => vec![Form::Box(*bounds)],
        Outline::Sphere(sphere) if flat => {
            let radius = (sphere.radius * sphere.radius - sphere.center.z * sphere.center.z).max(0.0).sqrt();
            vec![Form::Sphere(Sphere { center: sphere.center.with_z(0.0), radius })]
        }
        Outline::Sphere(sphere) => vec![Form::Sphere(*sphere)],
        Outline::Faces(_) if flat => {
            let corners = outline.section(0.0);
            if corners.len() > 2 { vec![Form::Polygon(corners)] } else { Vec::new() }
        }
        Outline::Faces(faces) => {
            vec![Form::Body(edges(faces, outline.bounds().extent().max_element() * NEAR))]
        }
    }
}

/// Corners that lie so near, in parts of a body's size, are one: each face was cut out by itself.
const NEAR: f32 = 1e-5;

/// The edges of a body, each once.
fn edges(faces: &[Vec<Vec3>], near: f32) -> Vec<[Vec3; 2]> {
    let mut corners: Vec<Vec3> = Vec::new();
    let mut known = |p: Vec3| {
        corners.iter().position(|q| p.distance_squared(*q) <= near * near).unwrap_or_else(|| {
            corners.push(p);
            corners.len() - 1
        })
    };
    let mut edges = BTreeSet::new();
    for face in faces {
        let around: Vec<usize> = face.iter().map(|&p| known(p)).collect();
        let next = around.iter().cycle().skip(1);
        edges.extend(around.iter().zip(next).filter(|(a, b)| a != b).map(|(&a, &b)| (a.min(b), a.max(b))));
    }
    edges.into_iter().map(|(a, b)| [corners[a], corners[b]]).collect()
}
