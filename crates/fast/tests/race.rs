//! The ladder: every rung runs or says why not, and fewer tests are made the higher it stands.

use std::cell::Cell;

use glam::Vec2;
use raystep_accel::{Mesh, Prims, Ray, pinhole};
use raystep_fast::{Race, Rung, tile_order};
use raystep_scene::Scene;

fn teapot() -> (Mesh, Vec<Ray>) {
    let scene = Scene::named("teapot:6x6").unwrap();
    let view = scene.close_view();
    let ray = |[x, y]: [u32; 2]| {
        let at = Vec2::new(x as f32 + 0.5, y as f32 + 0.5) / 32.0 - 1.0;
        pinhole(view.eye, view.target, view.up, view.fov_degrees, at, 1.0).unwrap()
    };
    let Prims::Mesh(mesh) = scene.prims else { panic!("the teapot is a mesh") };
    (mesh, tile_order(6).map(ray).collect())
}

#[test]
fn every_rung_runs_or_says_why_not() {
    let (mesh, rays) = teapot();
    // A clock that goes on by a thousandth of a second whenever somebody looks.
    let now = Cell::new(0.0);
    let clock = || now.replace(now.get() + 1e-3);
    let race = Race::new(&mesh, &rays, 0.02, &clock, &|| true).unwrap();
    let mut tests = Vec::new();
    for rung in Rung::ALL {
        let row = race.run(rung).unwrap();
        assert_eq!(row.rung, rung);
        match row.told {
            Ok(told) => {
                let [least, most] = told.spread;
                assert!(least > 0.0 && least <= told.mrays_per_s && told.mrays_per_s <= most, "{told:?}");
                assert!(told.rays > 0 && told.rays <= rays.len() && told.rounds >= 5, "{told:?}");
                assert_eq!(told.bytes == 0, rung == Rung::List, "{told:?}");
                tests.push((rung, told.tests_per_ray));
            }
            Err(why) => {
                assert!(matches!(rung, Rung::Packets | Rung::Threads | Rung::Gpu), "{rung:?}: {why}");
            }
        }
    }
    let of = |rung: Rung| tests.iter().find(|(own, _)| *own == rung).map(|(_, tests)| *tests).unwrap();
    assert_eq!(of(Rung::List), mesh.triangles.len() as f64);
    for rung in [Rung::Grid, Rung::Kd, Rung::Bvh, Rung::Bvh2, Rung::Bvh8] {
        assert!(of(rung) * 20.0 < of(Rung::List), "{rung:?}: {}", of(rung));
    }
}

#[test]
fn a_race_is_given_up() {
    let (mesh, rays) = teapot();
    assert!(Race::new(&mesh, &rays, 0.1, &|| 0.0, &|| false).is_none());
}
