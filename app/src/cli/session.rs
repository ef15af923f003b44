//! A slide played on one of its stages with one of its rays, ready to be drawn.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};

use glam::Vec2;
use raystep_accel::{Aabb, Rule, Structure};
use raystep_figure::{
    Figure, ListingLine, Look, Moment, Scenery, Shaded, Theme, TreeView, Walk, fill, sentence, shaded, short, space,
    stage as picture_of, tree,
};
use raystep_lesson::{Library, NamedRay, Play, Show, Slide, Stage};
use raystep_print::{Below, Plate, Walked, json, plate};
use raystep_scene::Scene;

use super::camera;
use super::fault::Fault;

/// A walk and the slide it belongs to.
pub(crate) struct Session<'a> {
    library: &'a Library,
    slide: &'a Slide,
    stage: &'a Stage,
    ray: &'a NamedRay,
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
    /// Plays these rays of a stage.
    pub(crate) fn open(
        library: &'a Library,
        slide: &'a Slide,
        stage: &'a Stage,
        rays: &[&'a NamedRay],
    ) -> Result<Vec<Session<'a>>, Fault> {
        let wrong = |error: raystep_lesson::PlayError| Fault::new(format!("{}: {error}", slide.file));
        let (scene, structure) = stage.build().map_err(wrong)?;
        let node_bounds = Arc::new(structure.node_bounds());
        let scenery = Arc::default();
        let tracer = if structure.node_count() > 0 || scene.flat { Arc::clone(&structure) } else { quick(&scene)? };
        let play = |ray: &&'a NamedRay| Session {
            library,
            slide,
            stage,
            ray,
            play: Play::new(Arc::clone(&scene), Arc::clone(&structure), ray.ray, &slide.beats),
            node_bounds: Arc::clone(&node_bounds),
            tracer: Arc::clone(&tracer),
            scenery: Arc::clone(&scenery),
        };
        Ok(rays.iter().map(play).collect())
    }

    /// How many steps the walk has.
    pub(crate) fn steps(&self) -> usize {
        self.play.events.len()
    }

    /// The step at which a beat stands, if the walk reaches it.
    pub(crate) fn step_of(&self, beat: usize) -> Option<usize> {
        self.play.beats.get(beat).copied().flatten()
    }

    /// Whether this is the ray that a beat is told on.
    pub(crate) fn is_told_here(&self, beat: usize) -> bool {
        self.slide.ray_of(self.stage, beat).is_some_and(|ray| ray.name == self.ray.name)
    }

    /// `"flat"` or `"solid"`.
    pub(crate) fn stage_name(&self) -> &'static str {
        self.stage.kind.name()
    }

    /// The beginning of a file's name: slide, stage, and the ray if it is not the stage's own.
    pub(crate) fn file_stem(&self) -> String {
        let own = self.stage.rays.first().is_some_and(|first| first.name == self.ray.name);
        let ray = if own { String::new() } else { format!("-{}", slug(&self.ray.name)) };
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
        let walk = self.walk();
        let moment = Moment::at(&walk, step);
        let figure = match view {
            View::Space => self.picture(&walk, &moment, size, scale, theme),
            View::Tree => tree(&walk, &moment, &TreeView::default(), size, &Look { titles: false, ..Look::WINDOW }),
            View::Plate => {
                let picture = |size| self.picture(&walk, &moment, size, scale, theme);
                self.plate(&walk, &moment, beat, size, &picture)
            }
        };
        (figure, scale)
    }

    /// The walk as JSON.
    pub(crate) fn json(&self) -> Result<String, Fault> {
        let rule = self.stage.plan.rule(self.play.scene.flat).map_err(|error| Fault::new(error.to_string()))?;
        Ok(json(&Walked {
            scene: &self.play.scene.name,
            kind: rule.kind(),
            parameters: &rule.parameters().into_iter().map(|p| (p.key.to_owned(), p.value)).collect::<Vec<_>>(),
            nodes: self.play.structure.node_count(),
            bytes: self.play.structure.bytes(),
            name: Some(&self.ray.name),
            ray: &self.play.ray,
            events: &self.play.events,
            lost: self.play.lost,
            hit: self.play.hit,
        }))
    }

    fn walk(&self) -> Walk<'_> {
        Walk {
            structure: &self.play.structure,
            prims: &self.play.scene.prims,
            node_bounds: &self.node_bounds,
            ray: self.play.ray,
            events: &self.play.events,
            flat: self.play.scene.flat,
        }
    }

    fn picture(&self, walk: &Walk<'_>, moment: &Moment, size: Vec2, scale: f32, theme: &Theme) -> Figure {
        let shown = space(walk, moment);
        let camera = camera::of_stage(self.stage, &self.play.scene, &shown, size);
        if self.play.scene.flat {
            return picture_of(&shown, walk.prims, &camera, size, Scenery::Drawn);
        }
        let pixels = [size.x * scale, size.y * scale].map(|side| (side.round() as u32).clamp(1, MOST_PIXELS));
        let made = || Arc::new(shaded(&self.tracer, walk.prims, &camera, pixels[0], pixels[1], theme));
        let scenery = match self.scenery.lock() {
            // Whoever comes second waits for the first, and finds the image ready.
            Ok(mut known) => Arc::clone(known.entry(pixels).or_insert_with(made)),
            Err(_) => made(),
        };
        picture_of(&shown, walk.prims, &camera, size, Scenery::Shaded(&scenery))
    }

    fn plate(
        &self,
        walk: &Walk<'_>,
        moment: &Moment,
        beat: Option<usize>,
        size: Vec2,
        picture: &dyn Fn(Vec2) -> Figure,
    ) -> Figure {
        let (heading, caption) = self.said(moment, beat);
        let about = format!(
            "{} · {} · {} · ray: {}",
            self.slide.section_title(),
            self.slide.numbers_text(),
            self.stage.kind.name(),
            self.ray.name
        );
        let event: Vec<String> = moment.event.iter().map(|event| event.name().to_owned()).collect();
        let listing = self.listing(&event);
        let mut below: Vec<Below> = self.slide.show.iter().filter_map(below).collect();
        below.dedup();
        let sheet = Plate {
            title: &self.slide.title,
            about: &about,
            heading: &heading,
            caption: &caption,
            walk: *walk,
            moment,
            listing: &listing,
            below: &below,
            stack: walk.structure.node_count() > 0,
        };
        plate(&sheet, size, picture)
    }

    /// The heading and the text of a step: a beat's if one stands here, else what the event says.
    fn said(&self, moment: &Moment, beat: Option<usize>) -> (String, String) {
        let Some(event) = &moment.event else {
            return ("Before the walk".to_owned(), format!("The ray **{}** is about to start.", self.ray.name));
        };
        let here = |beat: &usize| self.step_of(*beat) == Some(moment.step);
        let beat = beat.or_else(|| (0..self.slide.beats.len()).find(here));
        match beat.and_then(|beat| self.slide.beats.get(beat)) {
            Some(beat) => (fill(&beat.title, event), fill(&beat.text(event), event)),
            None => (capitalised(short(event)), sentence(event)),
        }
    }

    /// The slide's algorithm; only the line that shows the event goes by its name.
    fn listing<'b>(&'b self, event: &'b [String]) -> Vec<ListingLine<'b>> {
        let Some(listing) = self.library.listing(&self.slide.listing) else { return Vec::new() };
        let current = event.first().and_then(|event| listing.line_of(event));
        let line = |(index, line): (usize, &'b raystep_lesson::Line)| ListingLine {
            indent: line.indent,
            text: &line.text,
            events: if Some(index) == current { event } else { &[] },
            values: line.values.as_deref(),
        };
        listing.lines.iter().enumerate().map(line).collect()
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
