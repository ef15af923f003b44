//! The scenes that come with the program.

use glam::{DVec3, Vec3};
use include_dir::{Dir, include_dir};
use raystep_accel::{Aabb, Prims};
use thiserror::Error;

use crate::error::nearest;
use crate::outdoors::{MOST_TREES, forest, grass};
use crate::scene::bounds;
use crate::stadium::{STADIUM, stadium};
use crate::trial::{self, scenes::Case};
use crate::{MOST_STEPS, Scene, TRIANGLES_OF_A_TREE, View, Woods, teapot};

static FLAT: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/../../assets/scenes");

/// The teapot at 10×10 with its floor.
pub(crate) const TEAPOT: &str = "teapot-6321";

/// Nothing: what boards without measurements stand on.
const NOTHING: &str = "nothing";

/// An empty space, where pairs of objects are tried.
const PAIRS: &str = "pairs";

/// Some thousand trees.
const FOREST: &str = "forest";

/// How names of woods begin: `woods:50000` has so many trees of a million triangles.
pub(crate) const WOODS: &str = "woods:";

/// So many needles are drawn at most.
const MOST_NEEDLES: usize = 100_000;

/// A meadow.
const GRASS: &str = "grass";

/// No scene has this name.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("there is no scene `{name}`; {advice}")]
pub struct UnknownScene {
    /// The name that was asked for.
    pub name: String,
    /// The nearest name there is, or all of them.
    pub advice: String,
}

/// The names of the shipped scenes: the flat ones in alphabetical order, then the solid ones. `teapot:NxN`, the teapot
/// alone at another tessellation, `forest:N`, a forest of so many trees, `needles:N`, so many through one point, `woods:N`, one of trees of a million triangles, and `trial:NAME:SEED`, what structures are
/// tried on, are understood too.
pub fn scene_names() -> Vec<String> {
    let mut names: Vec<String> = FLAT
        .files()
        .filter(|file| file.path().extension().is_some_and(|e| e == "toml"))
        .filter_map(|file| Some(file.path().file_stem()?.to_str()?.to_owned()))
        .collect();
    names.sort();
    names.extend([TEAPOT, STADIUM, FOREST, GRASS].map(str::to_owned));
    names
}

/// Whether a scene of this name is shipped, or made by a name that begins so.
pub(crate) fn is_shipped(name: &str) -> bool {
    [NOTHING, PAIRS].contains(&name) || scene_names().iter().any(|shipped| shipped == name)
}

impl Scene {
    /// A shipped scene.
    ///
    /// # Errors
    /// When there is none of this name; the error knows the nearest name.
    pub fn named(name: &str) -> Result<Scene, UnknownScene> {
        if name == TEAPOT {
            return Ok(teapot_on_floor());
        }
        if name == NOTHING {
            return Ok(nothing());
        }
        if name == PAIRS {
            return Ok(empty_space());
        }
        if name == STADIUM {
            return Ok(stadium());
        }
        if name == GRASS {
            return Ok(grass());
        }
        if let Some(trees) = if name == FOREST { Some("1000") } else { name.strip_prefix("forest:") } {
            let trees: Option<u32> = trees.parse().ok().filter(|trees| (1..=MOST_TREES).contains(trees));
            return trees
                .map(forest)
                .ok_or_else(|| unknown(name, format!("write forest:N with N from 1 to {MOST_TREES}")));
        }
        if let Some(trees) = trees_of_woods(name) {
            return trees.map(|trees| woods(name, trees));
        }
        if let Some(steps) = name.strip_prefix("teapot:") {
            return tessellation(steps)
                .map(teapot_alone)
                .ok_or_else(|| unknown(name, format!("write teapot:NxN with one N from 1 to {MOST_STEPS}, twice")));
        }
        if let Some(many) = name.strip_prefix("needles:") {
            let many: Option<usize> = many.parse().ok().filter(|many| (1..=MOST_NEEDLES).contains(many));
            return many
                .map(needles)
                .ok_or_else(|| unknown(name, format!("write needles:N with N from 1 to {MOST_NEEDLES}")));
        }
        if let Some(case) = trial::named(name) {
            return Ok(on_trial(case));
        }
        let Some(text) = FLAT.get_file(format!("{name}.toml")).and_then(|file| file.contents_utf8()) else {
            let names = scene_names();
            let advice = match nearest(name, names.iter().map(String::as_str)) {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!("there are {}", names.join(", ")),
            };
            return Err(unknown(name, advice));
        };
        Scene::from_toml(text, name).map_err(|wrong| unknown(name, format!("its file is wrong: {wrong}")))
    }
}

/// How many trees the woods of that name have, if it names woods.
fn trees_of_woods(name: &str) -> Option<Result<u32, UnknownScene>> {
    let trees = name.strip_prefix(WOODS)?.parse().ok().filter(|trees| (1..=MOST_TREES).contains(trees));
    Some(trees.ok_or_else(|| unknown(name, format!("write {WOODS}N with N from 1 to {MOST_TREES}"))))
}

/// Whether a scene of this name is shipped; the largest of them are not grown to say so.
///
/// # Errors
/// There is none.
pub(crate) fn known(name: &str) -> Result<(), UnknownScene> {
    match trees_of_woods(name) {
        Some(trees) => trees.map(drop),
        None => Scene::named(name).map(drop),
    }
}

/// The forest of `raystep forest`, seen as there.
fn woods(name: &str, trees: u32) -> Scene {
    let woods = Woods::planted(trees, TRIANGLES_OF_A_TREE, &mut || ());
    let above = |x: f32, y: f32, up: f32| Vec3::new(x, y, woods.land.height(x, y) + up);
    let (eye, target) = (above(-150.0, -560.0, 22.0), above(60.0, 0.0, 4.0));
    let view = View { eye, target, up: Vec3::Z, fov_degrees: 50.0 };
    let triangles = woods.instances.triangles();
    Scene {
        name: name.to_owned(),
        title: "A forest of a million triangles to a tree".to_owned(),
        prims: Prims::Instances(woods.instances),
        flat: false,
        view,
        note: format!("{trees} trees, placed from four that are stored once: {triangles} triangles for a ray to meet."),
        origin: DVec3::ZERO,
    }
}

/// An empty page.
fn nothing() -> Scene {
    let view = View::fitting(&Aabb::EMPTY, Vec3::Z, Vec3::Y);
    let (name, title) = (NOTHING.to_owned(), "Nothing".to_owned());
    Scene { name, title, prims: Prims::Few(Vec::new()), flat: true, view, note: String::new(), origin: DVec3::ZERO }
}

/// An empty space, seen from where three sides of a box in its middle are seen.
fn empty_space() -> Scene {
    let view = View::fitting(&Aabb::new(Vec3::splat(-1.1), Vec3::splat(1.1)), Vec3::new(0.45, 0.35, 1.0), Vec3::Y);
    let (name, title) = (PAIRS.to_owned(), "Two objects".to_owned());
    Scene { name, title, prims: Prims::Few(Vec::new()), flat: false, view, note: String::new(), origin: DVec3::ZERO }
}

fn unknown(name: &str, advice: String) -> UnknownScene {
    UnknownScene { name: name.to_owned(), advice }
}

/// `NxN` with equal numbers in range.
fn tessellation(text: &str) -> Option<u32> {
    let (across, along) = text.split_once('x')?;
    let steps: u32 = across.parse().ok()?;
    (along.parse() == Ok(steps) && (1..=MOST_STEPS).contains(&steps)).then_some(steps)
}

/// From above, in front and a little from the spout's side.
const FROM: Vec3 = Vec3::new(0.35, -1.0, 0.5);

/// The lecture's 6321 triangles: the teapot's 6320, and one floor.
///
/// The lecture counts 6321 and does not say what the one more is: the floor is our guess.
fn teapot_on_floor() -> Scene {
    let mut mesh = teapot(10);
    let bounds = Aabb::around(mesh.corners.iter().copied());
    // An upright triangle around the teapot's shadow, about twice as large as the teapot.
    let (center, reach) = (bounds.center(), bounds.extent().x * 0.5);
    let first = mesh.corners.len() as u32;
    for (across, along) in [(-1.75, -1.0), (1.75, -1.0), (0.0, 2.0)] {
        mesh.corners.push(Vec3::new(center.x + across * reach, center.y + along * reach, bounds.min.z));
    }
    mesh.triangles.push([first, first + 1, first + 2]);
    Scene {
        name: TEAPOT.to_owned(),
        title: "The Utah teapot on a floor".to_owned(),
        prims: Prims::Mesh(mesh),
        flat: false,
        // Room for the boxes around it.
        view: View::fitting(&bounds.padded(0.4), FROM, Vec3::Z),
        note: "Newell's 32 patches (1975), each cut into 10×10 quads: 6400 triangles, less the 80 that collapse \
               at the poles of lid and base. The floor, one triangle more, is our guess at the lecture's 6321."
            .to_owned(),
        origin: DVec3::ZERO,
    }
}

fn teapot_alone(steps: u32) -> Scene {
    let mesh = teapot(steps);
    let bounds = Aabb::around(mesh.corners.iter().copied());
    Scene {
        name: format!("teapot:{steps}x{steps}"),
        title: format!("The Utah teapot, {} triangles", mesh.triangles.len()),
        prims: Prims::Mesh(mesh),
        flat: false,
        view: View::fitting(&bounds, FROM, Vec3::Z),
        note: format!("Newell's 32 patches (1975), each cut into {steps}×{steps} quads."),
        origin: DVec3::ZERO,
    }
}

/// The lecture's last word of warning: long thin triangles that all pass through one point.
fn needles(many: usize) -> Scene {
    let prims = Prims::Few(trial::scenes::needles(1, many));
    let view = View::fitting(&bounds(&prims), FROM, Vec3::Z);
    let (name, title) = (format!("needles:{many}"), "Needles through one point".to_owned());
    let note = "Every box around the point where they cross holds them all.".to_owned();
    Scene { name, title, prims, flat: false, view, note, origin: DVec3::ZERO }
}

/// A scene that structures are tried on, to look into what `raystep verify` found.
fn on_trial(case: Case) -> Scene {
    let Case { name, prims, flat } = case;
    let (from, up) = if flat { (Vec3::Z, Vec3::Y) } else { (FROM, Vec3::Z) };
    let view = View::fitting(&bounds(&prims), from, up);
    let note = "What structures are tried on.".to_owned();
    Scene { title: name.clone(), name, prims, flat, view, note, origin: DVec3::ZERO }
}
