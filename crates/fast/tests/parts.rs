//! Trees whose nodes are split in space: rays that graze triangles of which leaves hold parts.

use glam::Vec3;
use raystep_accel::{Accel, List, Mesh, PrimId, Prims, Random, Ray};
use raystep_fast::{Fast, FastKind, Isa, Settings};

/// Long triangles across each other, as thin as `slim`, `away` from the middle of the world.
fn long(random: &mut Random, count: u32, slim: f32, away: f32) -> Mesh {
    let mut mesh = Mesh::default();
    for _ in 0..count {
        let mut point =
            |size: f32| Vec3::new(random.range(-size, size), random.range(-size, size), random.range(-size, size));
        let (at, along, across) = (point(1.0) + Vec3::splat(away), point(4.0), point(4.0 * slim));
        let first = mesh.corners.len() as u32;
        mesh.corners.extend([at, at + along, at + along * 0.4 + across]);
        mesh.triangles.push([first, first + 1, first + 2]);
    }
    mesh
}

/// Many small triangles, and every fiftieth so large that it passes most of them, as thin as `slim`: the boxes of large ones
/// hold nearly all, and their parts do not.
fn giants(random: &mut Random, count: u32, slim: f32, away: f32) -> Mesh {
    let mut mesh = Mesh::default();
    for i in 0..count {
        let mut point = |size: f32| Vec3::from([(); 3].map(|()| random.range(-size, size)));
        let size = if i % 50 == 0 { 8.0 } else { 0.2 };
        let (at, along, across) = (point(8.0) + Vec3::splat(away), point(size), point(size * slim));
        let first = mesh.corners.len() as u32;
        mesh.corners.extend([at - along, at + along, at + along * 0.4 + across]);
        mesh.triangles.push([first, first + 1, first + 2]);
    }
    mesh
}

/// A ray nearly in the plane of a triangle, past it or through it, from near or far.
fn grazing(random: &mut Random, mesh: &Mesh) -> Option<Ray> {
    let triangle = mesh.triangle(PrimId(random.below(mesh.triangles.len() as u32)));
    let (ab, ac) = (triangle.b - triangle.a, triangle.c - triangle.a);
    let n = ab.cross(ac).normalize_or_zero();
    let (u, v) = (random.unit(), random.unit());
    let at = triangle.a + (ab * u + ac * (1.0 - u)) * v;
    let along = (ab * random.range(-1.0, 1.0) + ac * random.range(-1.0, 1.0)).normalize_or_zero();
    // Off the plane by as little as single precision knows.
    let d = along + n * random.range(-1.0, 1.0) * 10f32.powi(-(random.below(9) as i32));
    let away = 10f32.powf(random.range(-4.0, 3.0)) * random.range(-1.0, 1.0);
    Ray::new(at - d * away, d * 10f32.powi(random.below(5) as i32 - 2)).ok()
}

fn check(name: &str, mesh: &Mesh, rays: u32, seed: u64) {
    let prims = Prims::Mesh(mesh.clone());
    let random = &mut Random::new(seed);
    let settings = Settings { leaf: 1, splits: 100, ..Settings::DEAR };
    let built: Vec<_> = [FastKind::Bvh2, FastKind::Bvh8, FastKind::Packets16]
        .into_iter()
        .flat_map(|kind| {
            let built = kind.build(mesh, &settings);
            Isa::all().into_iter().map(move |isa| (kind, isa, built.clone().with(isa)))
        })
        .collect();
    let rays: Vec<Ray> = (0..rays).filter_map(|_| grazing(random, mesh)).collect();
    let right: Vec<_> = rays.iter().map(|ray| List.intersect(&prims, ray, &mut ())).collect();
    for (kind, isa, structure) in &built {
        let found = structure.intersect_many(&rays);
        for ((ray, right), found) in rays.iter().zip(&right).zip(&found) {
            assert!(found == right, "{name}, {}, {isa}: {found:?} not {right:?}\n{ray:?}", kind.name());
        }
        let occluded = structure.occluded_many(&rays);
        assert!(
            right.iter().zip(occluded).all(|(right, any)| right.is_some() == any),
            "{name}, {}, {isa}",
            kind.name()
        );
    }
    let hits = right.iter().flatten().count();
    assert!(hits > rays.len() / 8, "{name}: {hits} of {}", rays.len());
}

#[test]
fn grazing_rays_agree() {
    let random = &mut Random::new(1);
    for (i, (slim, away)) in [(1.0, 0.0), (0.1, 0.0), (0.02, 0.0), (1.0, 100.0), (0.1, 1e4)].into_iter().enumerate() {
        let mesh = long(random, 300, slim, away);
        check(&format!("slim {slim}, away {away}"), &mesh, 10_000, i as u64);
        let mesh = giants(random, 500, slim.max(0.05), away);
        check(&format!("giants, slim {slim}, away {away}"), &mesh, 10_000, i as u64);
    }
}

/// Parts cost memory and save work: more leaves than without, but no more than allowed, and fewer triangles tested.
#[test]
fn parts_are_limited_and_pay() {
    let random = &mut Random::new(2);
    let mesh = giants(random, 2000, 0.5, 0.0);
    let rays: Vec<Ray> = (0..4000).filter_map(|_| grazing(random, &mesh)).collect();
    let tested = |splits| {
        let tree = raystep_fast::Bvh2::build(&mesh, &Settings { leaf: 1, splits, ..Settings::DEAR });
        let mut work = raystep_fast::Work::default();
        for ray in &rays {
            tree.walk(ray, raystep_accel::Want::Nearest, &mut work);
        }
        (tree.leaves().map(|leaf| leaf.len()).sum::<usize>(), work.triangles)
    };
    let (whole, whole_tested) = tested(0);
    assert_eq!(whole, 2000);
    for splits in [10, 50, 200] {
        let (parts, parts_tested) = tested(splits);
        assert!(parts <= whole + whole * splits as usize / 100, "{splits}: {parts}");
        if splits == 200 {
            assert!(whole < parts && parts_tested < whole_tested, "{parts}: {parts_tested} of {whole_tested}");
        }
    }
}
