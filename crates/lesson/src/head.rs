//! The head of a slide: TOML between two lines of `+++`.

use glam::{Vec2, Vec3};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::keys::{At, FromToml, Keys, wrong};
use crate::problem::misspelt;
use crate::reading::Reading;
use crate::{Look, NamedRay, Plan, Plays, Setting, Show, Spot, Stage, StageKind, wait};

/// The format that this program reads.
const FORMAT: f32 = 1.0;

/// What a head says.
#[derive(Default)]
pub(crate) struct Head {
    pub(crate) numbers: Vec<String>,
    pub(crate) title: String,
    pub(crate) listing: String,
    pub(crate) listing_spot: Spot,
    pub(crate) show: Vec<Show>,
    pub(crate) stages: Vec<Stage>,
}

/// Reads a head. `text` is the file up to the head's end, its first `+++` blanked, so that a byte of it is
/// the same byte of the file.
pub(crate) fn read(text: &str, reading: &mut Reading<'_>) -> Head {
    let (table, errors) = DeTable::parse_recoverable(text);
    for error in &errors {
        reading.problem(error.span().map_or(0, |span| span.start), format!("the head is no TOML: {}", error.message()));
    }
    if !errors.is_empty() {
        return Head::default();
    }
    let mut keys = Keys::new(table.get_ref(), 0);

    if let Some((at, format)) = keys.need::<f32>("format", reading)
        && format != FORMAT
    {
        reading.problem(at, format!("format {format} is not known here: this program reads format {FORMAT}"));
    }
    let numbers = keys.need::<Numbers>("slide", reading).map(|(_, Numbers(numbers))| numbers).unwrap_or_default();
    let (title_at, title) = keys.need::<String>("title", reading).unwrap_or_default();
    if title_at > 0 && title.trim().is_empty() {
        reading.problem(title_at, "the title is empty");
    }
    // Everything that follows names the events of what is played.
    reading.plays = plays(&mut keys, reading);
    let (listing_at, listing) = keys.need::<String>("listing", reading).unwrap_or_default();
    let show = show(&mut keys, reading);

    // Two stages in tables of their own, or one whose keys stand in the head itself.
    let mut stages = Vec::new();
    for kind in StageKind::ALL {
        if let Some(mut table) = keys.table(kind.name(), reading) {
            stages.extend(stage(kind, &mut table, reading));
            table.finish(reading);
        }
    }
    if !keys.has("flat") && !keys.has("solid") {
        stages.extend(stage_in_head(&mut keys, reading));
    }
    keys.finish(reading);
    Head { numbers, title, listing, listing_spot: reading.spot(listing_at), show, stages }
}

/// What the slide plays: a walk if it does not say.
fn plays(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Plays {
    let Some((at, name)) = keys.get::<String>("plays", reading) else { return Plays::default() };
    let known = Plays::ALL.into_iter().find(|plays| plays.name() == name);
    known.unwrap_or_else(|| {
        reading.problem(at, misspelt("thing to play", &name, &Plays::ALL.map(Plays::name)));
        Plays::default()
    })
}

/// The panes that a slide shows; space and the listing if it does not say.
fn show(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Vec<Show> {
    let Some((at, names)) = keys.get::<Vec<String>>("show", reading) else {
        return vec![Show::Space, Show::Listing];
    };
    let mut show = Vec::new();
    for name in names {
        match Show::NAMES.iter().find(|(known, _)| *known == name) {
            Some((_, pane)) => show.push(*pane),
            None => reading.problem(at, misspelt("pane", &name, &Show::NAMES.map(|(known, _)| known))),
        }
    }
    show
}

/// The only stage of a slide that has but one: flat if its scene's name begins so.
fn stage_in_head(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Option<Stage> {
    let scene = keys.raw("scene").and_then(|value| String::from_toml(value.get_ref()));
    if scene.is_none() {
        reading.problem(0, "there is no stage: write a table [flat] or [solid] with `scene`, `structure` and `rays`");
    }
    let kind = if scene?.starts_with("flat") { StageKind::Flat } else { StageKind::Solid };
    stage(kind, keys, reading)
}

/// One stage.
fn stage(kind: StageKind, keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Option<Stage> {
    let scene = keys.need::<String>("scene", reading);
    let own = match keys.table("structure", reading) {
        Some(mut table) => plan(&mut table, reading),
        None => {
            reading.problem(keys.at(), "`structure` is missing: write `structure = { kind = \"kd\" }`");
            None
        }
    };
    let rays = match reading.plays {
        Plays::Walk => rays(keys, reading),
        Plays::Build => no_rays(keys, reading),
    };
    let beside = keys.table("beside", reading).and_then(|mut table| plan(&mut table, reading));
    reading.beside |= beside.is_some();
    let camera = keys.table("camera", reading).and_then(|mut table| {
        let look = look(kind, &mut table, reading);
        table.finish(reading);
        look
    });
    let (scene_at, scene) = scene?;
    Some(Stage { kind, scene, plan: own?, beside, rays, camera, scene_spot: reading.spot(scene_at) })
}

/// `{ kind = "kd", max_depth = 6 }`
fn plan(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Option<Plan> {
    let (at, kind) = keys.need::<String>("kind", reading)?;
    let rest = keys.rest(reading);
    let setting = |((at, key), value): (At<String>, String)| Setting { key, value, spot: reading.spot(at) };
    Some(Plan { kind, settings: rest.into_iter().map(setting).collect(), spot: reading.spot(at) })
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

/// A build needs no ray.
fn no_rays(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Vec<NamedRay> {
    if let Some(value) = keys.raw("rays") {
        reading.problem(value.span().start, "`rays` belong to a slide that plays a walk: this one plays a build");
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

    let ((_, name), (_, from)) = (name?, from?);
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
    let promises = promises
        .map_or(Vec::new(), |(at, texts)| texts.iter().filter_map(|text| wait::parse(text, at, reading)).collect());
    Some(NamedRay { name, ray, promises, spot: reading.spot(at) })
}

/// A camera.
fn look(kind: StageKind, keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Option<Look> {
    Some(match kind {
        StageKind::Flat => Look::Flat {
            center: keys.need::<Vec2>("center", reading)?.1,
            half_height: keys.need::<f32>("half_height", reading)?.1,
        },
        StageKind::Solid => Look::Solid {
            eye: keys.need::<Vec3>("eye", reading)?.1,
            target: keys.need::<Vec3>("target", reading)?.1,
            up: keys.get::<Vec3>("up", reading).map_or(Vec3::Z, |(_, up)| up),
            fov_degrees: keys.get::<f32>("fov_degrees", reading).map_or(40.0, |(_, fov)| fov),
        },
    })
}

/// The numbers of slides: 33, "13a", or several.
struct Numbers(Vec<String>);

impl FromToml for Numbers {
    const WHAT: &'static str = "a slide's number, or several: 33, \"13a\", [33, 38]";

    fn from_toml(value: &DeValue<'_>) -> Option<Numbers> {
        let one = |value: &DeValue<'_>| match value {
            DeValue::Integer(number) => Some(number.to_string()),
            DeValue::String(text) => Some(text.to_string()),
            _ => None,
        };
        match value.as_array() {
            Some(list) => list.iter().map(|value| one(value.get_ref())).collect::<Option<_>>().map(Numbers),
            None => one(value).map(|number| Numbers(vec![number])),
        }
    }
}
