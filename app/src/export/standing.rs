//! How grounds come to be: of a slide's stage, or of a scene of no slide.

use std::sync::Arc;

use raystep_accel::{Cancelled, Rule};
use raystep_figure::{Depth, Pane};
use raystep_lesson::{Built, Care, Library, Plays, Slide, Stage, Tape};
use raystep_scene::Scene;

use super::ground::{Changes, Ground};
use crate::clock::Clock;
use crate::fault::Fault;
use crate::shown::all_nodes::AllNodes;
use crate::shown::camera::Seen;
use crate::shown::kind_name::kind_name;
use crate::shown::own::OwnScene;

/// What differs from a slide's stage.
#[derive(Default)]
pub(crate) struct Changed {
    /// Parameters of the structure: keys and values.
    pub(crate) settings: Vec<(String, String)>,
    /// The scene with shapes that were moved by hand.
    pub(crate) own: Option<OwnScene>,
    /// Where it is seen from, and how that is called.
    pub(crate) seen: Option<(String, Seen)>,
    /// How many boxes of a tree are drawn in space.
    pub(crate) depth: Option<Depth>,
}

impl<'a> Ground<'a> {
    /// A stage as its slide has it.
    pub(crate) fn of_stage(library: &'a Library, slide: &'a Slide, stage: &'a Stage) -> Result<Ground<'a>, Fault> {
        Ground::of_changed_stage(library, slide, stage, Changed::default(), false)
    }

    /// A stage with what differs from its slide's, and perhaps with times of this machine.
    pub(crate) fn of_changed_stage(
        library: &'a Library,
        slide: &'a Slide,
        stage: &'a Stage,
        changed: Changed,
        times: bool,
    ) -> Result<Ground<'a>, Fault> {
        let Changed { settings, own, seen, depth } = changed;
        let wrong = |error: &dyn std::fmt::Display| Fault::new(format!("{}: {error}", slide.file));
        let scene = match &own {
            Some(own) => own.scene.clone(),
            None => stage.scenes.named(&stage.scene).map_err(|error| wrong(&error))?,
        };
        let mut rule = stage.plan.rule(scene.flat).map_err(|error| wrong(&error))?;
        for (key, value) in &settings {
            match stage.own_setting(key, value) {
                Some(set) => set.map_err(Fault::new)?,
                None => rule.set(key, value).map_err(|error| Fault::new(error.to_string()))?,
            }
        }
        let (structure, told) = Tape::record(slide.plays, Some(stage), &scene, &rule, Care::Full, &mut ())
            .map_err(|error| wrong(&error))?;
        let told = told.map(|told| measured(told.moved(&settings), &scene, times)).transpose();
        let told = told.map_err(|error| wrong(&error))?;
        let nodes = Arc::new(AllNodes::of(&structure, told.as_ref()));
        let built = Built { scene, structure: Arc::new(structure), told };
        let (settings, seen) = with_camera(settings, seen);
        let own = own.as_ref().map(|own| &*own.scene);
        let changes = Changes { scene: None, settings, own, seen, depth, told: true };
        Ok(Ground::new(library, slide, stage, built, rule, nodes, changes, &|| true))
    }

    /// A scene of no slide, with a structure over it; `builds` tells how that is built.
    pub(crate) fn of_scene(
        library: &'a Library,
        scene: Scene,
        rule: Rule,
        builds: bool,
        seen: Option<(String, Seen)>,
    ) -> Result<Ground<'a>, Fault> {
        // Somebody must stand for the slide; nothing of it is told.
        let slide = library.slides.iter().find(|slide| slide.plays == if builds { Plays::Build } else { Plays::Walk });
        let place = slide.and_then(|slide| Some((slide, slide.stages.first()?)));
        let (slide, stage) = place.ok_or_else(|| Fault::new("there is no slide that plays such a thing"))?;
        let (structure, told) = Tape::record(slide.plays, None, &scene, &rule, Care::Full, &mut ())
            .map_err(|error| Fault::new(error.to_string()))?;
        let usual = Rule::default_for(rule.kind()).map(|usual| if scene.flat { usual.flat() } else { usual });
        let differs = usual.map(|usual| rule.differences(&usual)).unwrap_or_default();
        let settings = differs.into_iter().map(|(key, value)| (key.to_owned(), value)).collect();
        let (settings, seen) = with_camera(settings, seen);
        let nodes = Arc::new(AllNodes::of(&structure, told.as_ref()));
        let show = [Some(Pane::Ruler), Pane::best_of(&structure)].into_iter().flatten().collect();
        let title = scene.title.clone();
        let built = Built { scene: Arc::new(scene), structure: Arc::new(structure), told };
        let own = Changes { scene: Some(title), settings, own: None, seen, depth: None, told: false };
        let mut ground = Ground::new(library, slide, stage, built, rule, nodes, own, &|| true);
        let title = format!("{} over {}", kind_name(rule.kind()), ground.built.scene.title);
        let stem = if builds { format!("{}-build", ground.stem) } else { ground.stem.clone() };
        let about = ground.about.replacen(&ground.built.scene.title, kind_name(rule.kind()), 1);
        (ground.title, ground.stem, ground.about) = (title, stem, about);
        (ground.listing, ground.show) = (listing(&rule, builds).to_owned(), show);
        Ok(ground)
    }
}

/// A board on which all is measured that is to be, also where its meter was moved.
fn measured(told: Tape, scene: &Scene, times: bool) -> Result<Tape, Cancelled> {
    let Tape::Board(filled) = told else { return Ok(told) };
    let filled = filled.filled(scene, Care::Full, &mut ())?;
    Ok(Tape::Board(if times { filled.timed(scene, &Clock::new(&|| true))? } else { filled }))
}

/// The camera stands among what differs.
fn with_camera(
    mut settings: Vec<(String, String)>,
    seen: Option<(String, Seen)>,
) -> (Vec<(String, String)>, Option<Seen>) {
    let (name, seen) = seen.unzip();
    settings.extend(name.map(|name| ("camera".to_owned(), name)));
    (settings, seen)
}

/// The name of the listing that a walk or a build follows.
fn listing(rule: &Rule, builds: bool) -> &'static str {
    let is = |key: &str, value: &str| rule.parameters().iter().any(|own| own.key == key && own.value == value);
    match (rule.kind(), builds) {
        ("list", false) => "list",
        ("grid", false) if is("mailbox", "false") => "grid-walk-simple",
        ("grid", false) => "grid-walk",
        ("grid", true) => "grid-build",
        ("nested-grid", false) => "nested-walk",
        ("nested-grid", true) => "nested-build",
        ("hashed-grid", false) => "hashed-walk",
        ("kd", false) => "kd-walk",
        ("kd", true) => "kd-build",
        ("octree", false) => "octree-walk",
        ("octree", true) => "octree-build",
        ("bsp", false) => "bsp-walk",
        ("bsp", true) => "bsp-build",
        ("bvh", false) if is("order", "printed") => "bvh-walk-printed",
        ("bvh", false) => "bvh-walk-ordered",
        ("bvh", true) if is("builder", "top-down") => "bvh-build",
        ("bvh", true) if is("builder", "insertion") => "bvh-insertion",
        _ => "",
    }
}
