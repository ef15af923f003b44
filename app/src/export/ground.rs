//! What walks are drawn on: a slide's stage, or the window as it stands, with the structure already built.

use std::sync::{Arc, Mutex, PoisonError};

use glam::Vec2;
use raystep_accel::Rule;
use raystep_figure::{Ask, Camera, Depth, Figure, Look as Letters, Maps, Pane, Shaded, Space, Theme, shaded};
use raystep_lesson::{Beat, Built, Column, Library, Look, NamedRay, Slide, Stage};
use raystep_scene::Scene;

use super::names::{of_own_scene, of_slide, slug};
use crate::fault::Fault;
use crate::shown::all_nodes::AllNodes;
use crate::shown::camera::{self, Seen};
use crate::shown::heat::{Walked, Wish};
use crate::shown::kind_name::kind_name;
use crate::shown::reel::pane;

/// A scene, the structure over it, and the slide that speaks of it.
pub(crate) struct Ground<'a> {
    pub(crate) library: &'a Library,
    pub(crate) slide: &'a Slide,
    pub(crate) stage: &'a Stage,
    /// What is told on it.
    pub(super) beats: &'a [Beat],
    pub(super) built: Built,
    /// What plays beside, for its numbers.
    pub(super) beside: Option<Built>,
    pub(super) rule: Rule,
    pub(super) nodes: Arc<AllNodes>,
    /// The beginning of files' names.
    pub(super) stem: String,
    /// The name of the listing that it follows.
    pub(super) listing: String,
    /// The panes below space on a plate.
    pub(super) show: Vec<Pane>,
    /// What a plate is called.
    pub(super) title: String,
    /// What a plate says about it.
    pub(super) about: String,
    look: Option<Look>,
    seen: Option<Seen>,
    /// How many boxes of a tree are drawn in space.
    pub(super) depth: Depth,
    /// The solid scene as cameras see it in pictures of these sizes: the same at every step.
    scenery: Mutex<Vec<Scenery>>,
    /// Whether somebody still waits for the pictures.
    go_on: &'a (dyn Fn() -> bool + Sync),
}

/// The solid scene as a camera sees it in a picture of this size.
type Scenery = (Camera, [u32; 2], Arc<Shaded>);

/// What differs from the slide's own stage.
pub(crate) struct Changes<'a> {
    /// A scene that is not the stage's: its name.
    pub(crate) scene: Option<String>,
    /// Parameters of the structure.
    pub(crate) settings: Vec<(String, String)>,
    /// The slide's scene as somebody has changed it by hand.
    pub(crate) own: Option<&'a Scene>,
    /// The camera, once it was moved.
    pub(crate) seen: Option<Seen>,
    /// How many boxes of a tree are drawn in space.
    pub(crate) depth: Option<Depth>,
    /// Whether the slide's beats are told.
    pub(crate) told: bool,
}

impl<'a> Ground<'a> {
    /// What is built, with what differs from the stage.
    pub(crate) fn new(
        library: &'a Library,
        slide: &'a Slide,
        stage: &'a Stage,
        built: Built,
        rule: Rule,
        nodes: Arc<AllNodes>,
        changes: Changes<'_>,
        go_on: &'a (dyn Fn() -> bool + Sync),
    ) -> Ground<'a> {
        let Changes { scene: other, settings, own, seen, depth, told } = changes;
        let depth = depth.unwrap_or(stage.levels.map_or(Depth::Path, Depth::Down));
        let look = stage.camera.filter(|_| other.is_none());
        let (mut stem, mut about) = match other {
            Some(name) => (format!("{}-{}", slug(&name), rule.kind()), name),
            None => {
                let kind = stage.kind.name();
                // A board looks the same on every stage.
                let on = if stage.board.is_some() { String::new() } else { format!(" · {kind}") };
                let about = format!("{} · {}{on}", slide.section_title(), slide.numbers_text());
                (format!("{}-{kind}", of_slide(library, slide)), about)
            }
        };
        if let Some(own) = own {
            stem.push_str(&of_own_scene(own));
            about.push_str(" · scene changed by hand");
        }
        for (key, value) in settings {
            stem.push_str(&format!("-{}-{}", slug(&key), slug(&value)));
            about.push_str(&format!(" · {}: {value}", key.replace('_', " ")));
        }
        let beats = if told { slide.beats.as_slice() } else { &[] };
        let beside = if told { stage.build_beside(&built.scene, slide.plays).ok().flatten() } else { None };
        Ground {
            library,
            slide,
            stage,
            beats,
            built,
            beside,
            rule,
            nodes,
            stem,
            listing: slide.listing.clone(),
            show: slide.show.iter().filter_map(pane).collect(),
            title: slide.title.clone(),
            about,
            look,
            seen,
            depth,
            scenery: Mutex::default(),
            go_on,
        }
    }

    /// Where it is seen from in a picture of this size.
    pub(super) fn camera(&self, shown: &Space, size: Vec2) -> Camera {
        match &self.seen {
            Some(seen) => seen.all_in(size),
            None => camera::of_stage(self.look, &self.built.scene, shown, size),
        }
    }

    /// What each ray costs of a picture that fills a page of this size.
    pub(super) fn heat(&self, shown: &Space, size: Vec2) -> Result<Figure, Fault> {
        let Built { structure, scene, .. } = &self.built;
        let wish = Wish {
            scene: scene.clone(),
            structures: vec![(kind_name(self.rule.kind()).to_owned(), Walked::Textbook(structure.clone()))],
            of: Column::Tests,
            camera: self.camera(shown, size),
            size,
        };
        let rays = size.to_array().map(|side| side.round() as u32);
        let heated = wish.count(rays, self.go_on).ok_or_else(cancelled)?;
        let look = Letters { text: Letters::WINDOW.text * 1.2, ..Letters::WINDOW };
        let ask = Ask::new(Maps::room(size, 1, &look), look);
        Ok(heated.reel().still(&heated.instant()).draw(Pane::Picture, &ask))
    }

    /// An error once nobody waits for the pictures any more.
    pub(super) fn goes_on(&self) -> Result<(), Fault> {
        if (self.go_on)() { Ok(()) } else { Err(cancelled()) }
    }

    /// The solid scene in a picture of so many pixels; nothing if it is given up.
    pub(super) fn scenery(&self, camera: &Camera, size: Vec2, theme: &Theme) -> Option<Arc<Shaded>> {
        let smaller = (MOST_PIXELS / size.max_element()).min(1.0);
        let pixels = size.to_array().map(|side| ((side * smaller).round() as u32).max(1));
        // Whoever comes second waits for the first, and finds the image ready.
        let mut known = self.scenery.lock().unwrap_or_else(PoisonError::into_inner);
        let same = known.iter().find(|(seen, size, _)| seen == camera && *size == pixels);
        if let Some((.., shaded)) = same {
            return Some(Arc::clone(shaded));
        }
        let Built { structure, scene, .. } = &self.built;
        let made = shaded(structure, &scene.prims, camera, pixels[0], pixels[1], theme, &self.go_on)?;
        let made = Arc::new(made);
        known.push((*camera, pixels, Arc::clone(&made)));
        Some(made)
    }
}

/// Nobody waits any more.
pub(super) fn cancelled() -> Fault {
    Fault::new("the export was cancelled")
}

/// The rays that a stage's beats are told on, each once.
pub(crate) fn rays_of_beats<'a>(slide: &'a Slide, stage: &'a Stage) -> Vec<&'a NamedRay> {
    let mut rays: Vec<&NamedRay> = Vec::new();
    for ray in (0..slide.beats.len()).filter_map(|beat| slide.ray_of(stage, beat)) {
        if !rays.iter().any(|known| known.name == ray.name) {
            rays.push(ray);
        }
    }
    rays
}

/// Most pixels on a side of a solid scene: a larger picture shows it a little softer.
const MOST_PIXELS: f32 = 4800.0;
