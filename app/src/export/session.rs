//! One ray's walk on its ground, or the build of the ground's structure, ready to be drawn.

use glam::Vec2;
use raystep_accel::{Event, Ray};
use raystep_figure::{
    Ask, Camera, Figure, Look, Pane, Reel, Scenery, Still, Theme, close_up, inset_size, set_inset, short,
    stage as picture_of, told,
};
use raystep_lesson::{Medium, NamedRay, Play, Plays, Tape};
use raystep_print::{Plate, Record, Told, json, plate};

use super::ground::Ground;
use super::names::{of_own_ray, of_ray};
use crate::fault::Fault;
use crate::shown::eye;
use crate::shown::reel::{beginning, lines, pane, reel, said};

/// A walk or a build and what it is drawn on.
pub(crate) struct Session<'a> {
    pub(super) ground: &'a Ground<'a>,
    pub(super) play: Play,
    /// The name of the ray that walks; none where a build is played.
    pub(super) ray: Option<String>,
    stem: String,
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
    /// The walks of these rays of the ground's stage; where a build is played, that alone.
    pub(crate) fn of_rays(ground: &'a Ground<'a>, rays: &[&NamedRay]) -> Vec<Session<'a>> {
        if !ground.slide.plays.has_rays() {
            return Session::new(ground, None, None, ground.stem.clone()).into_iter().collect();
        }
        rays.iter().filter_map(|ray| Session::of_ray(ground, ray)).collect()
    }

    fn of_ray(ground: &'a Ground<'a>, ray: &NamedRay) -> Option<Session<'a>> {
        let stem = format!("{}{}", ground.stem, of_ray(ground.stage, &ray.name));
        Session::new(ground, Some(ray.ray), Some(&ray.name), stem)
    }

    /// The walk of another ray.
    pub(crate) fn of_own_ray(ground: &'a Ground<'a>, ray: Ray) -> Vec<Session<'a>> {
        let stem = format!("{}{}", ground.stem, of_own_ray(&ray));
        Session::new(ground, Some(ray), Some("your own"), stem).into_iter().collect()
    }

    /// Plays the build if the ground kept it, else the ray; nothing where there is neither. The ray's name
    /// stands on plates, the stem at the beginning of files' names.
    fn new(ground: &'a Ground<'a>, ray: Option<Ray>, name: Option<&str>, stem: String) -> Option<Session<'a>> {
        let play = ground.built.play_with(ground.beside.as_ref(), ray, ground.beats)?;
        Some(Session { ground, play, ray: name.map(str::to_owned), stem })
    }

    /// How many steps it has.
    pub(crate) fn steps(&self) -> usize {
        self.play.tape.len()
    }

    /// The beats of its slide.
    pub(crate) fn beats(&self) -> std::ops::Range<usize> {
        0..self.ground.beats.len()
    }

    /// The step at which a beat stands, if it is reached.
    pub(crate) fn step_of(&self, beat: usize) -> Option<usize> {
        self.play.beats.get(beat).copied().flatten()
    }

    /// Whether this is the ray that a beat is told on; a build has only itself.
    pub(crate) fn is_told_here(&self, beat: usize) -> bool {
        let ray = self.ground.slide.ray_of(self.ground.stage, beat);
        self.ray.as_ref().is_none_or(|own| ray.is_some_and(|ray| ray.name == *own))
    }

    /// `"flat"` or `"solid"`.
    pub(crate) fn stage_name(&self) -> &'static str {
        self.ground.stage.kind.name()
    }

    /// The beginning of a file's name: slide, stage, what was changed, and the ray if it is not the stage's own.
    pub(crate) fn file_stem(&self) -> &str {
        &self.stem
    }

    /// A step as a figure of this many pixels, and how many pixels a point has.
    pub(crate) fn figure(
        &self,
        view: View,
        step: usize,
        beat: Option<usize>,
        pixels: Vec2,
        theme: &Theme,
    ) -> Result<(Figure, f32), Fault> {
        // Everything is laid out on a page of one size, so that a larger picture is the same picture.
        let page = match view {
            View::Plate => PLATE,
            View::Space | View::Tree => BARE,
        };
        let larger = if *theme == Theme::PROJECTOR { PROJECTED } else { 1.0 };
        let scale = (pixels.x * pixels.y / (page.x * page.y)).sqrt() * larger;
        let size = pixels / scale;
        let reel = reel(&self.play, &self.ground.nodes, None);
        let instant = reel.at(step);
        let still = reel.still(&instant).to_depth(self.ground.depth);
        let figure = match view {
            View::Space => self.picture(&reel, &still, size, scale, theme),
            View::Tree => still.draw(Pane::Tree, &Ask::new(size, Look { titles: false, ..Look::WINDOW })),
            View::Plate => {
                let picture = |size| self.picture(&reel, &still, size, scale, theme);
                self.plate(&still, step, beat, size, &picture)
            }
        };
        self.ground.goes_on().map(|()| (figure, scale))
    }

    /// What is drawn at each step.
    pub(super) fn reel(&self) -> Reel<'_> {
        reel(&self.play, &self.ground.nodes, None)
    }

    /// The walk or the build as JSON.
    pub(crate) fn json(&self) -> String {
        let told = match &self.play.tape {
            Tape::Walk(walk) => {
                Told::Walk { name: self.ray.as_deref(), ray: &walk.ray, events: &walk.events, hit: walk.hit }
            }
            Tape::Build(build) => Told::Build(&build.events),
            Tape::Board(filled) => Told::Board(&filled.events),
            Tape::Packet(packet) => Told::Packet {
                name: self.ray.as_deref(),
                rays: &packet.rays,
                events: &packet.events,
                found: &packet.found,
            },
            Tape::Pairs(pairs) => Told::Pairs(&pairs.events),
            // The first of the walks: the others are the same ray's.
            Tape::Walks(walks) => match walks.walks.first() {
                Some(Tape::Walk(walk)) => {
                    Told::Walk { name: self.ray.as_deref(), ray: &walk.ray, events: &walk.events, hit: walk.hit }
                }
                _ => Told::Board(&[]),
            },
        };
        let rule = &self.ground.rule;
        json(&Record {
            scene: &self.play.scene.name,
            origin: self.play.scene.origin.to_array(),
            kind: rule.kind(),
            parameters: &rule.parameters().into_iter().map(|p| (p.key.to_owned(), p.value)).collect::<Vec<_>>(),
            nodes: self.play.structure.node_count(),
            bytes: self.play.structure.bytes(),
            told,
            lost: self.play.tape.lost(),
        })
    }

    fn picture(&self, reel: &Reel<'_>, still: &Still<'_>, size: Vec2, scale: f32, theme: &Theme) -> Figure {
        let Some(shown) = still.space().filter(|_| !still.has(Pane::Picture)) else {
            return still.draw(Pane::Picture, &Ask::new(size, Look::WINDOW));
        };
        let prims = reel.prims();
        let camera = self.ground.camera(&shown, size);
        if self.play.scene.flat {
            return picture_of(&shown, prims, &camera, size, Scenery::Drawn);
        }
        let scenery = |camera: &Camera, size: Vec2| self.ground.scenery(camera, size * scale, theme);
        let shaded = scenery(&camera, size);
        let mut figure =
            picture_of(&shown, prims, &camera, size, shaded.as_deref().map_or(Scenery::Left, Scenery::Shaded));
        // What is but a dot there is seen from near in a corner.
        if let (Some((title, bounds)), Some(size)) = (still.detail(), inset_size(size)) {
            let camera = eye::framed(&camera, &bounds, size);
            let shaded = scenery(&camera, size);
            let small =
                close_up(&shown, prims, &camera, size, shaded.as_deref().map_or(Scenery::Left, Scenery::Shaded));
            set_inset(&mut figure, small, &title);
        }
        figure
    }

    fn plate(
        &self,
        still: &Still<'_>,
        step: usize,
        beat: Option<usize>,
        size: Vec2,
        picture: &dyn Fn(Vec2) -> Figure,
    ) -> Figure {
        let slide = self.ground.slide;
        let event = self.play.event(step);
        let (heading, caption) = self.said(event.as_ref(), step, beat);
        let about = match (&self.ray, &self.play.tape) {
            (Some(ray), Tape::Packet(_)) => format!("{} · rays: {ray}", self.ground.about),
            (Some(ray), _) => format!("{} · ray: {ray}", self.ground.about),
            (None, Tape::Board(_) | Tape::Pairs(_)) => self.ground.about.clone(),
            (None, _) => format!("{} · how it is built", self.ground.about),
        };
        let listing = lines(self.ground.library.listing(&slide.listing), &self.play, &self.ground.rule, step, None);
        let mut below: Vec<Pane> = slide.show.iter().filter_map(pane).collect();
        below.dedup();
        let sheet = Plate {
            title: &slide.title,
            about: &about,
            heading: &heading,
            caption: &caption,
            still: *still,
            listing: &listing,
            below: &below,
        };
        plate(&sheet, size, picture)
    }

    /// The heading and the text of a step: a beat's if one stands here, else what the event says.
    pub(super) fn said(&self, event: Option<&Event>, step: usize, beat: Option<usize>) -> (String, String) {
        let Some(event) = event else {
            let plays = self.play.tape.plays();
            let what = if plays == Plays::Packet { "The rays" } else { "The ray" };
            let is = if plays == Plays::Packet { "are" } else { "is" };
            let says = self.ray.as_ref().map(|ray| format!("{what} **{ray}** {is} about to start."));
            return ("The beginning".to_owned(), says.unwrap_or_else(|| beginning(plays).to_owned()));
        };
        let here = |beat: &usize| self.step_of(*beat) == Some(step);
        let beat = beat.or_else(|| self.beats().find(here));
        match beat.and_then(|beat| self.ground.beats.get(beat)) {
            Some(beat) => (told(&beat.title, event), said(beat, &self.play, step, Medium::Paper)),
            None => {
                let reel = reel(&self.play, &self.ground.nodes, None);
                (capitalised(&short(event, reel.volume())), reel.sentence(step, event))
            }
        }
    }
}

/// A page is laid out on this many points, whatever its size in pixels.
const PLATE: Vec2 = Vec2::new(1600.0, 1000.0);
/// A bare view is: its letters are larger.
const BARE: Vec2 = Vec2::new(1000.0, 625.0);

/// How much larger everything is on a projector.
const PROJECTED: f32 = 1.2;

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().collect::<String>() + letters.as_str())
}
