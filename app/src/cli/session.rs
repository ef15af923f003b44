//! A slide played on one of its stages, with one of its rays or as a build, ready to be drawn.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};

use glam::Vec2;
use raystep_accel::{Aabb, Event, Rule, Structure};
use raystep_figure::{
    Figure, Look, Reel, Scenery, Shaded, Still, Theme, TreeView, fill, sentence, shaded, short, stage as picture_of,
};
use raystep_lesson::{Library, NamedRay, Play, Plays, Show, Slide, Stage, Tape};
use raystep_print::{Below, Plate, Record, Told, json, plate};
use raystep_scene::Scene;

use super::camera;
use super::fault::Fault;
use crate::reel::{beginning, lines, reel};

/// A walk or a build and the slide it belongs to.
pub(crate) struct Session<'a> {
    library: &'a Library,
    slide: &'a Slide,
    stage: &'a Stage,
    /// The ray that walks; none where a build is played.
    ray: Option<&'a NamedRay>,
    play: Play,
    node_bounds: Arc<Vec<Aabb>>,
    /// What the image of a solid scene is traced with.
    tracer: Arc<Structure>,
    /// The solid scene as it is seen in pictures of these sizes: the same at every step.
    scenery: Arc<Mutex<BTreeMap<[u32; 2], Arc<Shaded>>>>,
}

/// What a picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum View {
    /// The scene with the walk in it.
    Space,
    /// The tree of nodes.
    Tree,
    /// A page with all of it.
    Plate,
}

impl<'a> Session<'a> {
    /// Plays these rays of a stage, or its build.
    pub(crate) fn open(
        library: &'a Library,
        slide: &'a Slide,
        stage: &'a Stage,
        rays: &[&'a NamedRay],
    ) -> Result<Vec<Session<'a>>, Fault> {
        let wrong = |error: raystep_lesson::PlayError| Fault::new(format!("{}: {error}", slide.file));
        let built = stage.build(slide.plays).map_err(wrong)?;
        let (scene, structure) = (&built.scene, &built.structure);
        let node_bounds = Arc::new(structure.node_bounds());
        let scenery = Arc::default();
        let tracer = if structure.node_count() > 0 || scene.flat { Arc::clone(structure) } else { quick(scene)? };
        let session = |ray: Option<&'a NamedRay>| {
            let play = built.play(ray.map(|ray| ray.ray), &slide.beats)?;
            let (node_bounds, tracer, scenery) = (Arc::clone(&node_bounds), Arc::clone(&tracer), Arc::clone(&scenery));
            Some(Session { library, slide, stage, ray, play, node_bounds, tracer, scenery })
        };
        Ok(match slide.plays {
            Plays::Walk => rays.iter().filter_map(|ray| session(Some(ray))).collect(),
            Plays::Build => session(None).into_iter().collect(),
        })
    }

    /// How many steps it has.
    pub(crate) fn steps(&self) -> usize {
        self.play.tape.len()
    }

    /// The step at which a beat stands, if it is reached.
    pub(crate) fn step_of(&self, beat: usize) -> Option<usize> {
        self.play.beats.get(beat).copied().flatten()
    }

    /// Whether this is the ray that a beat is told on; a build has only itself.
    pub(crate) fn is_told_here(&self, beat: usize) -> bool {
        self.ray.is_none_or(|own| self.slide.ray_of(self.stage, beat).is_some_and(|ray| ray.name == own.name))
    }

    /// `"flat"` or `"solid"`.
    pub(crate) fn stage_name(&self) -> &'static str {
        self.stage.kind.name()
    }

    /// The beginning of a file's name: slide, stage, and the ray if it is not the stage's own.
    pub(crate) fn file_stem(&self) -> String {
        let own = self.stage.rays.first().map(|first| &first.name);
        let other = self.ray.filter(|ray| Some(&ray.name) != own);
        let ray = other.map_or_else(String::new, |ray| format!("-{}", slug(&ray.name)));
        format!("slide{}-{}{ray}", self.slide.name, self.stage.kind.name())
    }

    /// A step as a figure of this many pixels, and how many pixels a point has.
    pub(crate) fn figure(
        &self,
        view: View,
        step: usize,
        beat: Option<usize>,
        pixels: Vec2,
        theme: &Theme,
    ) -> (Figure, f32) {
        // Everything is laid out on a page of one size, so that a larger picture is the same picture.
        let page = match view {
            View::Plate => PLATE,
            View::Space | View::Tree => BARE,
        };
        let larger = if *theme == Theme::PROJECTOR { PROJECTED } else { 1.0 };
        let scale = (pixels.x * pixels.y / (page.x * page.y)).sqrt() * larger;
        let size = pixels / scale;
        let reel = reel(&self.play, &self.node_bounds);
        let instant = reel.at(step);
        let still = reel.still(&instant);
        let figure = match view {
            View::Space => self.picture(&reel, &still, size, scale, theme),
            View::Tree => still.tree(&TreeView::default(), size, &Look { titles: false, ..Look::WINDOW }),
            View::Plate => {
                let picture = |size| self.picture(&reel, &still, size, scale, theme);
                self.plate(&still, step, beat, size, &picture)
            }
        };
        (figure, scale)
    }

    /// The walk or the build as JSON.
    pub(crate) fn json(&self) -> Result<String, Fault> {
        let rule = self.stage.plan.rule(self.play.scene.flat).map_err(|error| Fault::new(error.to_string()))?;
        let told = match &self.play.tape {
            Tape::Walk(walk) => Told::Walk {
                name: self.ray.map(|ray| ray.name.as_str()),
                ray: &walk.ray,
                events: &walk.events,
                hit: walk.hit,
            },
            Tape::Build(build) => Told::Build(&build.events),
        };
        Ok(json(&Record {
            scene: &self.play.scene.name,
            kind: rule.kind(),
            parameters: &rule.parameters().into_iter().map(|p| (p.key.to_owned(), p.value)).collect::<Vec<_>>(),
            nodes: self.play.structure.node_count(),
            bytes: self.play.structure.bytes(),
            told,
            lost: self.play.tape.lost(),
        }))
    }

    fn picture(&self, reel: &Reel<'_>, still: &Still<'_>, size: Vec2, scale: f32, theme: &Theme) -> Figure {
        let shown = still.space();
        let prims = reel.prims();
        let camera = camera::of_stage(self.stage, &self.play.scene, &shown, size);
        if self.play.scene.flat {
            return picture_of(&shown, prims, &camera, size, Scenery::Drawn);
        }
        let pixels = [size.x * scale, size.y * scale].map(|side| (side.round() as u32).clamp(1, MOST_PIXELS));
        let made = || Arc::new(shaded(&self.tracer, prims, &camera, pixels[0], pixels[1], theme));
        let scenery = match self.scenery.lock() {
            // Whoever comes second waits for the first, and finds the image ready.
            Ok(mut known) => Arc::clone(known.entry(pixels).or_insert_with(made)),
            Err(_) => made(),
        };
        picture_of(&shown, prims, &camera, size, Scenery::Shaded(&scenery))
    }

    fn plate(
        &self,
        still: &Still<'_>,
        step: usize,
        beat: Option<usize>,
        size: Vec2,
        picture: &dyn Fn(Vec2) -> Figure,
    ) -> Figure {
        let event = still.event();
        let (heading, caption) = self.said(event.as_ref(), step, beat);
        let about = format!(
            "{} · {} · {} · {}",
            self.slide.section_title(),
            self.slide.numbers_text(),
            self.stage.kind.name(),
            self.ray.map_or_else(|| "how it is built".to_owned(), |ray| format!("ray: {}", ray.name))
        );
        let listing = lines(self.library.listing(&self.slide.listing), event);
        let mut below: Vec<Below> = self.slide.show.iter().filter_map(below).collect();
        below.dedup();
        let sheet = Plate {
            title: &self.slide.title,
            about: &about,
            heading: &heading,
            caption: &caption,
            still: *still,
            listing: &listing,
            below: &below,
            stack: self.play.structure.node_count() > 0,
        };
        plate(&sheet, size, picture)
    }

    /// The heading and the text of a step: a beat's if one stands here, else what the event says.
    fn said(&self, event: Option<&Event>, step: usize, beat: Option<usize>) -> (String, String) {
        let Some(event) = event else {
            let says = self.ray.map(|ray| format!("The ray **{}** is about to start.", ray.name));
            return ("The beginning".to_owned(), says.unwrap_or_else(|| beginning(self.slide.plays).to_owned()));
        };
        let here = |beat: &usize| self.step_of(*beat) == Some(step);
        let beat = beat.or_else(|| (0..self.slide.beats.len()).find(here));
        match beat.and_then(|beat| self.slide.beats.get(beat)) {
            Some(beat) => (fill(&beat.title, event), fill(&beat.text(event), event)),
            None => (capitalised(short(event)), sentence(event)),
        }
    }
}

/// A page is laid out on this many points, whatever its size in pixels.
const PLATE: Vec2 = Vec2::new(1600.0, 1000.0);
/// A bare view is: its letters are larger.
const BARE: Vec2 = Vec2::new(1000.0, 625.0);

/// How much larger everything is on a projector.
const PROJECTED: f32 = 1.2;

/// Most pixels on a side of a solid scene: a larger picture shows it a little softer.
const MOST_PIXELS: u32 = 2400;

/// A structure that is quick where the slide's own is not made to be.
fn quick(scene: &Scene) -> Result<Arc<Structure>, Fault> {
    let rule = Rule::default_for("bvh").map_err(|error| Fault::new(error.to_string()))?;
    let built = Structure::build(&scene.prims, &rule, &mut ()).map_err(|error| Fault::new(error.to_string()))?;
    Ok(Arc::new(built))
}

/// The pane of a page for a pane of a slide.
fn below(show: &Show) -> Option<Below> {
    match show {
        Show::Ruler => Some(Below::Ruler),
        Show::Tree => Some(Below::Tree),
        Show::Cells => Some(Below::Cells),
        Show::Slabs => Some(Below::Slabs),
        Show::Space | Show::Stack | Show::Listing | Show::Work => None,
    }
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().collect::<String>() + letters.as_str())
}

/// A name as a part of a file's name.
pub(crate) fn slug(name: &str) -> String {
    let plain = |letter: char| if letter.is_alphanumeric() { letter.to_ascii_lowercase() } else { '-' };
    let dashed: String = name.chars().map(plain).collect();
    dashed.split('-').filter(|part| !part.is_empty()).collect::<Vec<_>>().join("-")
}
