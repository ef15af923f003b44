//! One ray's walk on its ground, or the build of the ground's structure, ready to be drawn.

use raystep_accel::{Event, Ray};
use raystep_figure::{Reel, short, told};
use raystep_lesson::{Medium, NamedRay, Play, Plays, Tape};
use raystep_print::{Record, Told, json};

use super::ground::Ground;
use super::names::{of_own_ray, of_ray};
use crate::shown::reel::{beginning, reel, said};
use crate::shown::steps::Steps;

/// A walk or a build and what it is drawn on.
pub(crate) struct Session<'a> {
    pub(super) ground: &'a Ground<'a>,
    pub(super) play: Play,
    /// The name of the ray that walks; none where a build is played.
    pub(super) ray: Option<String>,
    stem: String,
}

impl<'a> Session<'a> {
    /// The walks of these rays of the ground's stage; where a build is played, that alone.
    pub(crate) fn of_rays(ground: &'a Ground<'a>, rays: &[&NamedRay]) -> Vec<Session<'a>> {
        if !ground.slide.plays.has_rays() {
            return Session::of_build(ground);
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

    /// The build of the ground's structure.
    pub(crate) fn of_build(ground: &'a Ground<'a>) -> Vec<Session<'a>> {
        Session::new(ground, None, None, ground.stem.clone()).into_iter().collect()
    }

    /// Plays the build if the ground kept it, else the ray; nothing where there is neither. The ray's name
    /// stands on plates, the stem at the beginning of files' names.
    fn new(ground: &'a Ground<'a>, ray: Option<Ray>, name: Option<&str>, stem: String) -> Option<Session<'a>> {
        let mut play = ground.built.play_with(ground.beside.as_ref(), ray, ground.beats)?;
        // A scene of no slide has nothing hidden from it.
        play.layout = if ground.beats.is_empty() { play.layout } else { ground.slide.layout };
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

    /// What it is called.
    pub(super) fn title(&self) -> &str {
        &self.ground.title
    }

    /// The beginning of a file's name: slide, stage, what was changed, and the ray if it is not the stage's own.
    pub(crate) fn file_stem(&self) -> &str {
        &self.stem
    }

    /// What is drawn at each step.
    pub(super) fn reel(&self) -> Reel<'_> {
        reel(&self.play, &self.ground.nodes, None)
    }

    /// Which steps one stops at.
    pub(super) fn stops(&self) -> Steps<'_> {
        Steps { tape: &self.play.tape, flat: self.play.scene.flat, beats: &self.play.beats }
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
            Tape::Fit(fit) => Told::Fit(&fit.events),
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
                let reel = self.reel();
                (capitalised(&short(event, reel.volume())), reel.sentence(step, event))
            }
        }
    }
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().collect::<String>() + letters.as_str())
}
