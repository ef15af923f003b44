//! A stage in the head of a slide.

use std::sync::Arc;

use glam::{Vec2, Vec3};
use raystep_scene::Scenes;
use toml::Spanned;
use toml::de::DeValue;

use crate::counts::{self, check_count, check_length};
use crate::keys::{FromToml, Keys, wrong};
use crate::reading::Reading;
use crate::{Look, NamedRay, Plan, Plays, Stage, StageKind, board, change, fit, limits, packets, pairs, walks};

/// No tree is deeper.
const LEVELS: f32 = 64.0;

/// The only stage of a slide that has but one: flat if its scene's name begins so.
pub(super) fn stage_in_head(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Option<Stage> {
    let scene = keys.raw("scene").and_then(|value| String::from_toml(value.get_ref()));
    if scene.is_none() && !keys.has("scene") && reading.plays == Plays::Board {
        return stage(StageKind::Flat, keys, reading);
    }
    if reading.plays == Plays::Pairs {
        return stage(StageKind::Solid, keys, reading);
    }
    if scene.is_none() {
        reading.problem(0, "there is no stage: write a table [flat] or [solid] with `scene`, `structure` and `rays`");
    }
    let kind = if scene?.starts_with("flat") { StageKind::Flat } else { StageKind::Solid };
    stage(kind, keys, reading)
}

/// One stage.
pub(super) fn stage(kind: StageKind, keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Option<Stage> {
    // A board that measures nothing stands on nothing.
    let scene = match reading.plays {
        Plays::Board if !keys.has("scene") => Some((keys.at(), "nothing".to_owned())),
        // Pairs lie in a space of their own.
        Plays::Pairs => Some((keys.at(), pairs::SCENE.to_owned())),
        _ => keys.need::<String>("scene", reading),
    };
    let abreast = if reading.plays == Plays::Walks { abreast(keys, reading) } else { Vec::new() };
    reading.abreast = walks::names(&abreast);
    let volume = if reading.plays == Plays::Fit { fit::read(keys, reading) } else { None };
    let structure = if reading.plays == Plays::Fit { None } else { keys.table("structure", reading) };
    let own = match structure.filter(|_| reading.plays != Plays::Walks) {
        Some(mut table) => Plan::read(&mut table, reading),
        None if reading.plays == Plays::Walks => abreast.first().cloned(),
        // Whatever stands on a board has a structure of its own.
        None if matches!(reading.plays, Plays::Board | Plays::Pairs) => Some(Plan::all()),
        // What is fitted needs none; the scene's own picture is made through boxes.
        None if reading.plays == Plays::Fit => Some(Plan::boxes()),
        None => {
            reading.problem(keys.at(), "`structure` is missing: write `structure = { kind = \"kd\" }`");
            None
        }
    };
    let rays = match reading.plays {
        Plays::Walk | Plays::Walks => rays(keys, reading),
        Plays::Packet => packets::read(keys, reading),
        Plays::Build | Plays::Board | Plays::Pairs | Plays::Fit => no_rays(keys, reading),
    };
    let board = (reading.plays == Plays::Board).then(|| Arc::new(board::read(keys, reading)));
    let pairs = if reading.plays == Plays::Pairs { pairs::read(keys, reading) } else { Vec::new() };
    let changes = if reading.plays == Plays::Build { change::read(keys, reading) } else { Vec::new() };
    let beside = keys.table("beside", reading).and_then(|mut table| Plan::read(&mut table, reading));
    reading.beside |= beside.is_some();
    let mut camera = keys.table("camera", reading);
    let camera_at = camera.as_ref().map_or(0, Keys::at);
    let look = camera.as_mut().and_then(|table| look(kind, table, reading));
    if let Some(table) = camera {
        table.finish(reading);
        if reading.plays == Plays::Walks {
            reading.problem(camera_at, "walks side by side show all of their scene: leave `camera` out");
        }
    }
    let levels = levels(kind, keys, reading);
    let (scene_at, scene) = scene?;
    let [scene_spot, camera_spot] = [scene_at, camera_at].map(|at| reading.spot(at));
    let plan = own?;
    Some(Stage {
        kind,
        scene,
        scenes: Scenes::default(),
        plan,
        beside,
        rays,
        changes,
        abreast,
        pairs,
        volume,
        board,
        camera: look,
        levels,
        scene_spot,
        camera_spot,
    })
}

/// `structures = [{ kind = "kd" }, { kind = "bsp" }]`: from two to nine over a flat scene.
fn abreast(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Vec<Plan> {
    let at = keys.at();
    let tables = keys.tables("structures", reading);
    let many = tables.len();
    let plans: Vec<Plan> = tables.into_iter().filter_map(|mut table| Plan::read(&mut table, reading)).collect();
    if !(2..=9).contains(&many) {
        reading.problem(
            at,
            "from two to nine structures stand side by side: write `structures = [{ kind = \"kd\" }, { kind = \"bvh\" }]`",
        );
    }
    plans
}

/// Down to which level of the tree a solid stage shows boxes; a flat one shows them all.
fn levels(kind: StageKind, keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Option<u32> {
    let (at, levels) = keys.get::<f32>("levels", reading)?;
    match kind {
        StageKind::Flat => reading.problem(at, "`levels` belongs to a solid stage: a flat one shows all boxes"),
        StageKind::Solid if (1.0..=LEVELS).contains(&levels) && levels.fract() == 0.0 => return Some(levels as u32),
        StageKind::Solid => {
            reading.problem(at, format!("`levels` is {levels}: it is a whole number from 1 to {LEVELS}"));
        }
    }
    None
}

/// `[{ name = "both", from = [-3, 1], towards = [4, 0.5] }]`
fn rays(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Vec<NamedRay> {
    const WHAT: &str = "a list of rays: [{ name = \"...\", from = [x, y], towards = [x, y] }]";
    let Some(value) = keys.raw("rays") else {
        reading.problem(keys.at(), format!("`rays` is missing: write `rays = ` and {WHAT}"));
        return Vec::new();
    };
    let Some(list) = value.get_ref().as_array() else {
        wrong("rays", WHAT, value, reading);
        return Vec::new();
    };
    if !check_count("rays", value.span().start, list.len(), limits::RAYS, reading) {
        return Vec::new();
    }
    let mut rays: Vec<NamedRay> = Vec::new();
    for value in list {
        let Some(ray) = ray(value, reading) else { continue };
        if rays.iter().any(|other| other.name == ray.name) {
            reading
                .problem(value.span().start, format!("the ray `{}` is there twice: each name stands once", ray.name));
        }
        rays.push(ray);
    }
    if list.len() < 2 {
        reading.problem(value.span().start, format!("a stage has two rays or more; here is {}", list.len()));
    }
    rays
}

/// A build or a board needs no ray.
fn no_rays(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Vec<NamedRay> {
    if let Some(value) = keys.raw("rays") {
        let plays = reading.plays.one();
        reading
            .problem(value.span().start, format!("`rays` belong to a slide that plays a walk: this one plays {plays}"));
    }
    Vec::new()
}

/// One ray.
fn ray(value: &Spanned<DeValue<'_>>, reading: &mut Reading<'_>) -> Option<NamedRay> {
    let at = value.span().start;
    let Some(table) = value.get_ref().as_table() else {
        wrong("rays", "a list of tables: { name = \"...\", from = [x, y], towards = [x, y] }", value, reading);
        return None;
    };
    let mut keys = Keys::new(table, at);
    let name = keys.need::<String>("name", reading);
    let from = keys.need::<Vec3>("from", reading);
    let towards = keys.get::<Vec3>("towards", reading);
    let direction = keys.get::<Vec3>("direction", reading);
    let range = keys.get::<Vec2>("t", reading);
    let promises = keys.get::<Vec<String>>("promise", reading);
    keys.finish(reading);

    let ((name_at, name), (_, from)) = (name?, from?);
    check_length("the ray's name", name_at, &name, reading);
    if name.trim().is_empty() {
        reading.problem(name_at, "the ray's name is empty: it says what is to be seen");
    }
    let (direction_at, direction) = match (towards, direction) {
        (Some((at, towards)), None) => (at, (towards - from).normalize_or_zero()),
        (None, Some(direction)) => direction,
        _ => {
            reading.problem(at, "a ray has either `towards` (a point) or `direction`");
            return None;
        }
    };
    let range = range.map_or([0.0, f32::INFINITY], |(_, range)| range.into());
    let valid = raystep_accel::Ray::new(from, direction).and_then(|ray| ray.within(range[0], range[1]));
    let ray =
        valid.map_err(|error| reading.problem(direction_at, format!("the ray cannot be walked: {error}"))).ok()?;
    let promises = counts::promises(promises.unwrap_or_default(), reading);
    let (others, spot, name_spot) = (Vec::new(), reading.spot(at), reading.spot(name_at));
    Some(NamedRay { name, ray, others, promises, spot, name_spot })
}

/// A camera from which something can be seen.
fn look(kind: StageKind, keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Option<Look> {
    match kind {
        StageKind::Flat => {
            let (center, half_height) =
                (keys.need::<Vec2>("center", reading), keys.need::<f32>("half_height", reading));
            let ((center_at, center), (height_at, half_height)) = (center?, half_height?);
            let good = is_seen_at("center", center_at, center.extend(0.0), reading);
            if !(MIN_HALF_HEIGHT..=FURTHEST).contains(&half_height) {
                let message =
                    format!("`half_height` is {half_height}: it is a number from {MIN_HALF_HEIGHT} to {FURTHEST}");
                reading.problem(height_at, message);
                return None;
            }
            good.then_some(Look::Flat { center, half_height })
        }
        StageKind::Solid => {
            let (eye, target) = (keys.need::<Vec3>("eye", reading), keys.need::<Vec3>("target", reading));
            let (up, fov) = (keys.get::<Vec3>("up", reading), keys.get::<f32>("fov_degrees", reading));
            let ((eye_at, eye), (target_at, target)) = (eye?, target?);
            let (up_at, up) = up.unwrap_or((eye_at, Vec3::Z));
            let (fov_at, fov_degrees) = fov.unwrap_or((eye_at, 40.0));
            let places = [("eye", eye_at, eye), ("target", target_at, target), ("up", up_at, up)];
            if !places.into_iter().fold(true, |good, (key, at, point)| is_seen_at(key, at, point, reading) && good) {
                return None;
            }
            if !(1.0..=170.0).contains(&fov_degrees) {
                reading.problem(fov_at, format!("`fov_degrees` is {fov_degrees}: it is a number from 1 to 170"));
                return None;
            }
            let along = (target - eye).normalize_or_zero();
            if along == Vec3::ZERO {
                reading.problem(target_at, "`target` is where the `eye` is: nothing can be seen from there");
                return None;
            }
            if up.normalize_or_zero().cross(along).length() < 1e-3 {
                reading
                    .problem(up_at, "`up` points along the view, or nowhere: choose another one, as in up = [0, 1, 0]");
                return None;
            }
            Some(Look::Solid { eye, target, up, fov_degrees })
        }
    }
}

/// From the middle of a picture to its upper edge, at least.
const MIN_HALF_HEIGHT: f32 = 0.001;
/// A camera's places and heights lie no further out.
const FURTHEST: f32 = 1e7;

/// Says so if a camera's place lies nowhere.
fn is_seen_at(key: &str, at: usize, point: Vec3, reading: &mut Reading<'_>) -> bool {
    let good = point.abs().cmple(Vec3::splat(FURTHEST)).all();
    if !good {
        reading
            .problem(at, format!("`{key}` lies nowhere: its coordinates are numbers from -{FURTHEST} to {FURTHEST}"));
    }
    good
}
