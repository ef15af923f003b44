//! A walk of any length: what is kept of it is bounded, what is not kept is counted, and its answer is whole.

use glam::Vec3;
use raystep_accel::{List, Mesh, PrimId, Prims, Ray, Structure, Visit};
use raystep_lesson::{Play, Tape};
use raystep_scene::Scene;
use std::sync::Arc;

/// Brute force over so many triangles, of which only the last one is met.
fn walk(triangles: usize) -> (Tape, Play) {
    let corners = vec![
        Vec3::ZERO,
        Vec3::X,
        Vec3::Y,
        Vec3::new(5.0, 5.0, 1.0),
        Vec3::new(6.0, 5.0, 1.0),
        Vec3::new(5.0, 6.0, 1.0),
    ];
    let mut all = vec![[0, 1, 2]; triangles - 1];
    all.push([3, 4, 5]);
    let prims = Prims::Mesh(Mesh { corners, triangles: all });
    let scene = Arc::new(Scene { prims, ..Scene::named("teapot:1x1").unwrap() });
    let structure = Arc::new(Structure::List(List));
    let ray = Ray::new(Vec3::new(5.2, 5.2, 9.0), Vec3::NEG_Z).unwrap();
    let tape = Tape::walk(&scene, &structure, ray);
    (tape.clone(), Play::new(scene, structure, tape, &[]))
}

#[test]
fn a_walk_of_ten_million_events_is_bounded_and_counted() {
    // One event for each triangle, one for the hit, one for the end.
    for (triangles, kept, lost) in [(1_000, 1_002, 0), (199_998, 200_000, 0), (10_000_000, 200_000, 9_800_002)] {
        let (tape, play) = walk(triangles);
        assert_eq!((tape.len(), tape.lost()), (kept, lost), "{triangles} triangles");
        let Tape::Walk(walk) = &play.tape else { panic!("a ray walks") };
        let hit = walk.hit.expect("the last triangle is met, whether or not its test is kept");
        assert_eq!((hit.t, hit.prim), (8.0, PrimId(triangles as u32 - 1)));
        assert!(
            walk.events.capacity() * size_of::<Visit>() <= 16 << 20,
            "{} bytes",
            walk.events.capacity() * size_of::<Visit>()
        );
    }
}
