//! The faces of solids: closed, flat, and where rays meet the solid.

use std::collections::BTreeMap;

use glam::Vec3;
use raystep_accel::{Aabb, Cone, Cylinder, Obb, Ray, Shape};
use raystep_figure::faces;

fn solids() -> [Shape<'static>; 4] {
    let axes = [Vec3::new(0.8, 0.6, 0.0), Vec3::new(-0.6, 0.8, 0.0), Vec3::Z];
    [
        Shape::Cylinder(Cylinder { from: Vec3::new(0.0, -1.0, 0.5), to: Vec3::new(1.0, 1.0, 0.0), radius: 0.7 }),
        Shape::Cone(Cone { apex: Vec3::new(0.0, 2.0, 0.5), base: Vec3::new(0.5, 0.0, 0.0), radius: 0.7 }),
        Shape::Box(Aabb::new(Vec3::new(0.0, -1.0, 0.0), Vec3::new(1.0, 2.0, 0.5))),
        Shape::Obb(Obb { center: Vec3::ONE, axes, half: Vec3::new(1.0, 0.5, 0.25) }),
    ]
}

#[test]
fn every_edge_is_shared_by_two_faces() {
    for solid in solids() {
        let mut edges: BTreeMap<[[u32; 3]; 2], u32> = BTreeMap::new();
        for face in faces(&solid) {
            for (i, &from) in face.iter().enumerate() {
                let mut edge = [from, face[(i + 1) % face.len()]].map(|corner| corner.to_array().map(f32::to_bits));
                edge.sort_unstable();
                *edges.entry(edge).or_default() += 1;
            }
        }
        assert!(edges.len() >= 12 && edges.values().all(|&faces| faces == 2), "{solid:?}");
    }
}

#[test]
fn a_ray_through_the_middle_of_a_face_meets_the_solid_there() {
    for solid in solids() {
        let own = solid.bounds();
        for face in faces(&solid) {
            let middle = face.iter().sum::<Vec3>() / face.len() as f32;
            let outward = middle - own.center();
            let ray = Ray::new(middle + outward * 3.0, -outward).unwrap();
            let t = solid.intersect(&ray).unwrap();
            // The strips of a round side lie a little inside it.
            assert!((ray.at(t) - middle).length() < 0.02, "{solid:?} {face:?} {t}");
        }
    }
}
