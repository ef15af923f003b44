//! However fast a kd-tree is built, it is the same tree: each builder's whole story, boiled down to a number.

use std::fmt::Write;

use glam::Vec3;
use raystep_accel::*;

/// Triangles of all sizes: some lie in one plane, some on top of each other, one lies under all of them.
fn mesh() -> Mesh {
    let mut random = Random::new(7);
    let mut mesh = Mesh::default();
    for i in 0..600_u32 {
        let mut point =
            |size: f32| Vec3::new(random.range(-size, size), random.range(-size, size), random.range(-size, size));
        let (center, size) = (point(5.0), [0.3, 0.1, 2.0, 0.3][i as usize % 4]);
        let mut corners = [center + point(size), center + point(size), center + point(size)];
        if i % 5 == 0 {
            corners = corners.map(|p| p.with_z(1.0));
        }
        mesh.corners.extend(corners);
        mesh.triangles.push([3 * i, 3 * i + 1, 3 * i + 2]);
    }
    mesh.triangles.extend_from_within(..40);
    mesh.corners.extend([Vec3::new(-20.0, -20.0, -5.0), Vec3::new(20.0, -20.0, -5.0), Vec3::new(0.0, 30.0, -5.0)]);
    mesh.triangles.push([1800, 1801, 1802]);
    mesh
}

/// A number that no two stories share (FNV-1a, over the events as text).
fn boiled_down(events: &[Grow]) -> u64 {
    let mut text = String::new();
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for event in events {
        text.clear();
        write!(text, "{event:?}").unwrap();
        hash = text.bytes().fold(hash, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
    }
    hash
}

#[test]
fn trees_stay_what_they_were() {
    let mesh = mesh();
    let mut stories = String::new();
    for settings in [
        &[][..],
        &[("split", "middle")],
        &[("split", "median")],
        &[("max_depth", "64"), ("min_objects", "0"), ("empty_bonus", "0.5")],
        &[("traversal_cost", "0")],
    ] {
        let mut rule = Rule::default_for("kd").unwrap();
        for (key, value) in settings {
            rule.set(key, value).unwrap();
        }
        for rule in [rule, rule.flat()] {
            let mut events = Vec::new();
            let tree = Structure::build(&mesh, &rule, &mut events).unwrap();
            let (nodes, told) = (tree.node_count(), events.len());
            writeln!(stories, "{nodes} nodes, {told} events, {:016x}", boiled_down(&events)).unwrap();
        }
    }
    insta::assert_snapshot!(stories);
}
