//! Flat scenes: the shipped ones, and what is said of wrong ones.

use glam::{Vec3, vec3};
use raystep_accel::{Accel, List, Primitives, Ray};
use raystep_scene::{Scene, scene_names};

#[test]
fn every_shipped_scene_loads() {
    let names = scene_names();
    assert!(names.len() >= 10, "{names:?}");
    for name in names {
        let scene = Scene::named(&name).unwrap_or_else(|wrong| panic!("{wrong}"));
        let bounds = scene.bounds();
        assert!(bounds.min.is_finite() && bounds.max.is_finite(), "{name}");
        if scene.flat {
            assert!(bounds.min.z < 0.0 && bounds.max.z > 0.0, "{name} surrounds z = 0");
        }
    }
}

/// The hits that the notes of the shipped scenes promise.
#[test]
fn promised_hits() {
    let check = |scene: &str, o: Vec3, d: Vec3, prim: u32, t: f32| {
        let scene = Scene::named(scene).unwrap_or_else(|wrong| panic!("{wrong}"));
        let ray = Ray::new(o, d).expect("a ray");
        let hit = List.intersect(&scene.prims, &ray, &mut ()).expect("a hit");
        assert_eq!(hit.prim.0, prim, "{}", scene.name);
        assert!((hit.t - t).abs() < 0.005, "{}: {}", scene.name, hit.t);
    };
    check("flat-trap", vec3(0.0, 0.5, 0.0), Vec3::X, 1, 2.15);
    check("flat-trap-alone", vec3(0.0, 0.5, 0.0), Vec3::X, 0, 2.618);
    check("flat-straddle", Vec3::ZERO, Vec3::X, 1, 8.5);
    check("flat-overlap", Vec3::ZERO, Vec3::X, 1, 4.0);
    check("flat-box", vec3(5.0, 1.0, 0.0), vec3(-1.0, 1.0, 0.0), 0, 2.0);
    check("flat-wall", vec3(0.0, 3.0, 0.0), Vec3::X, 0, 2.0);
    check("flat-twelve", vec3(0.2, 0.53, 0.0), vec3(0.9135, 0.407, 0.0), 6, 4.25);
}

#[test]
fn cells_and_boxes_have_the_promised_sides() {
    let bounds = |name: &str| Scene::named(name).unwrap_or_else(|wrong| panic!("{wrong}")).bounds();
    let sides = |name: &str| {
        let b = bounds(name);
        [b.min.x, b.min.y, b.max.x, b.max.y]
    };
    assert_eq!(sides("flat-trap"), [0.0, -1.0, 5.0, 2.0]);
    assert_eq!(sides("flat-trap-alone"), [0.0, -1.0, 5.0, 2.0]);
    assert_eq!(sides("flat-straddle"), [2.0, -1.5, 14.0, 1.5]);
    assert_eq!(sides("flat-box"), [1.0, 2.0, 3.0, 6.0]);
}

#[test]
fn what_is_said_of_wrong_scenes() {
    let shape = |shape: &str| format!("title = \"t\"\nshapes = [\n  {{ disc = [0, 0], radius = 1 }},\n  {shape},\n]\n");
    let table = [
        ("unknown key", "titel = \"t\"\nshapes = []".to_owned()),
        ("no title", "shapes = [{ disc = [0, 0], radius = 1 }]".to_owned()),
        ("no shapes", "title = \"t\"".to_owned()),
        ("no shape", "title = \"t\"\nshapes = []".to_owned()),
        ("bad TOML", "title = \"t\nshapes = []".to_owned()),
        ("misspelt shape", shape("{ disk = [0, 0], radius = 1 }")),
        ("two kinds", shape("{ disc = [0, 0], box = [[0, 0], [1, 1]], radius = 1 }")),
        ("no kind", shape("{ radius = 1 }")),
        ("wrong type", shape("{ disc = \"middle\", radius = 1 }")),
        ("three coordinates", shape("{ disc = [0, 0, 0], radius = 1 }")),
        ("no radius", shape("{ disc = [0, 0] }")),
        ("radius 0", shape("{ disc = [0, 0], radius = 0 }")),
        ("radius nan", shape("{ disc = [0, 0], radius = nan }")),
        ("infinite centre", shape("{ disc = [inf, 0], radius = 1 }")),
        ("radius of a box", shape("{ box = [[0, 0], [1, 1]], radius = 1 }")),
        ("box upside down", shape("{ box = [[0, 1], [1, 0]] }")),
        ("point for a segment", shape("{ segment = [[1, 1], [1, 1]] }")),
        ("two corners", shape("{ polygon = [[1, 1], [2, 1]] }")),
        ("closed twice", shape("{ polygon = [[0, 0], [1, 0], [0, 1], [0, 0]] }")),
        ("a megabyte", format!("title = \"{}\"", "t".repeat(1 << 20))),
        ("many shapes", shape(&["{ disc = [0, 0], radius = 1 }"; 10_001].join(", "))),
        ("many corners", shape(&format!("{{ polygon = [{}] }}", "[0, 0], [1, 0], ".repeat(501)))),
        ("a long word", shape(&format!("{{ {} = 1 }}", "x".repeat(100_000)))),
        ("deep", format!("title = {}1{}", "[".repeat(1000), "]".repeat(1000))),
        ("triangle of four", shape("{ triangle = [[0, 0], [1, 0], [0, 1], [1, 1]] }")),
    ];
    let said: Vec<String> = table
        .iter()
        .map(|(name, text)| match Scene::from_toml(text, "a.toml") {
            Ok(scene) => format!("{name}: {} shapes\n", scene.prims.len()),
            Err(wrong) => format!("{name}: {}\n", wrong.to_string().trim_end()),
        })
        .collect();
    insta::assert_snapshot!(said.concat());
}

#[test]
fn what_is_said_of_unknown_names() {
    let said: Vec<String> = ["flat-twelfe", "teapot", "teapot:10x9", "teapot:0x0", "zzz"]
        .iter()
        .map(|name| Scene::named(name).expect_err("unknown").to_string())
        .collect();
    insta::assert_snapshot!(said.join("\n"));
}
