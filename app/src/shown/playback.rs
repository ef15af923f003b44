//! One walk or build, ready to be shown at any step: what `lesson` plays, with what the views need beside it.

use std::sync::Arc;

use raystep_accel::{
    Accel, Cost, Event, Fill, Grow, Hit, Mistake, NodeId, Packet, Ray, Rule, Structure, Trace, Visit, Want,
};
use raystep_figure::{Film, Instant, Reel};
use raystep_lesson::{BuildTape, Choice, PacketTape, Play, Plays, Slide, Stage, Tape, WalkTape, WalksTape};
use raystep_scene::Scene;

use super::all_nodes::AllNodes;
use super::reel::reel;

use super::beside::{Beside, Rivals};
use super::steps::Steps;
use super::view::{RayChoice, View};

/// The most events of a mistaken walk that are kept.
const MOST: usize = 50_000;

/// A walk or a build and everything that its pictures are made of.
#[derive(Debug)]
pub struct Playback {
    /// What was asked for.
    pub view: View,
    /// What happens.
    pub play: Play,
    /// How the structure was built.
    pub rule: Rule,
    /// Its nodes, as pictures need them.
    pub nodes: Arc<AllNodes>,
    /// The questions of the beats that are reached.
    pub posed: Vec<Posed>,
    /// What can be done wrong in such a structure.
    pub mistakes: Vec<Mistake>,
    /// What it is shown as: the walk itself, or one beside it.
    pub kind: Beside,
    /// How many seconds the structure took to build.
    pub seconds: f32,
    film: Film,
    reached: Vec<f32>,
    /// What the builder weighed, where another cut is tried instead.
    instead: Option<Grow>,
}

/// A question and where it stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Posed {
    /// The beat that asks.
    pub beat: usize,
    /// The step at which it is asked.
    pub before: usize,
    /// The step that answers it.
    pub step: usize,
    /// What can be answered.
    pub choices: Vec<Choice>,
}

/// A built structure, which many rays can share.
#[derive(Clone, Debug)]
pub struct Built {
    /// What it was built over.
    pub scene: Arc<Scene>,
    /// How.
    pub rule: Rule,
    /// The structure.
    pub structure: Arc<Structure>,
    /// Its nodes, as pictures need them.
    pub nodes: Arc<AllNodes>,
    /// What is played without a ray: how it was built, or a board.
    pub told: Option<Tape>,
    /// How many seconds it took to build.
    pub seconds: f32,
}

impl Playback {
    /// Plays how it was built; where that was not kept, lets the view's ray walk through it.
    pub fn new(view: View, built: Built, ray: Option<Ray>, slide: &Slide, stage: &Stage) -> Option<Playback> {
        let Built { scene, rule, structure, nodes, told, seconds } = built;
        let told = told.map(|told| told.moved(&view.settings));
        // A mistake's own scene is no scene of the slide: nothing is told there.
        let beats = if view.example.is_some() { &[][..] } else { &slide.beats };
        let mut play = raystep_lesson::Built { scene, structure, told }.play(ray, beats)?;
        play.layout = slide.layout;
        // Beats that speak of another of the slide's rays are silent on this one. Those that name none speak of whichever
        // walks, also of one that was drawn.
        if let RayChoice::Named(index) = view.ray
            && let Some(this) = stage.rays.get(index)
            && slide.beats.iter().any(|beat| beat.ray.is_some())
        {
            for (beat, at) in play.beats.iter_mut().enumerate() {
                if slide.ray_of(stage, beat).is_some_and(|ray| ray.name != this.name) {
                    *at = None;
                }
            }
        }
        silence(&mut play, &rule, slide);
        // What stands on a board follows the numbers of its meter.
        let nodes = match &play.tape {
            Tape::Board(filled) if filled.board.meter().is_some() => {
                Arc::new(AllNodes::of(&play.structure, Some(&play.tape)))
            }
            _ => nodes,
        };
        let film = Film::new(&reel(&play, &nodes, None));
        let reached = reached(&play.tape);
        let mistakes = mistakes(rule.kind(), play.tape.plays());
        let (kind, posed) = (Beside::Nothing, Vec::new());
        let instead = None;
        let mut playback = Playback { view, play, rule, nodes, posed, mistakes, kind, seconds, film, reached, instead };
        playback.posed = playback.questions(slide);
        Some(playback)
    }

    /// Whether it is a board on which something is still to be measured, or with more rays.
    pub fn is_draft(&self) -> bool {
        matches!(&self.play.tape, Tape::Board(filled) if !filled.is_finished())
    }

    /// How far the measuring of a board is: the greater, the further.
    pub(crate) fn fineness(&self) -> (usize, usize) {
        match &self.play.tape {
            Tape::Board(filled) => filled.fineness(),
            _ => (0, 0),
        }
    }

    /// The same ray through the same structure with a mistake made.
    pub fn mistaken(&self, index: usize) -> Option<Playback> {
        let (mistake, ray) = (*self.mistakes.get(index)?, self.play.tape.ray()?);
        let (structure, prims) = (&self.play.structure, &self.play.scene.prims);
        let tape = match &self.play.tape {
            Tape::Packet(right) => {
                let mut tape = Trace::new(MOST);
                let found = mistake.walk_packet(structure, prims, Packet::of(&right.rays)?, &mut tape)?;
                let found = found[..right.rays.len()].to_vec();
                let right = PacketTape::clone(right);
                Tape::Packet(Arc::new(PacketTape { events: tape.events, lost: tape.lost, found, ..right }))
            }
            _ => {
                let mut tape = Trace::new(MOST);
                let hit = mistake.walk(structure, prims, &ray, &mut tape);
                Tape::Walk(WalkTape { ray, events: tape.events, lost: tape.lost, hit })
            }
        };
        let play = Play::new(self.play.scene.clone(), self.play.structure.clone(), tape, &[]);
        Some(self.aside(play, self.rule, self.nodes.clone(), Beside::Mistake(index)))
    }

    /// Whether a mistake shows on a ray: in the answer, or in the work.
    pub fn shows(&self, index: usize, ray: &Ray) -> bool {
        let Some(mistake) = self.mistakes.get(index) else { return false };
        let (structure, prims) = (&self.play.structure, &self.play.scene.prims);
        if let Tape::Packet(packet) = &self.play.tape {
            let rays = packet.packet_of(*ray);
            let Some(packet) = Packet::of(&rays) else { return false };
            let (mut right, mut wrong) = (Fill::default(), Fill::default());
            let answer = structure.walk_packet(prims, packet, Want::Nearest, &mut right);
            return mistake.walk_packet(structure, prims, packet, &mut wrong) != answer || right != wrong;
        }
        let (mut right, mut wrong) = (Cost::default(), Cost::default());
        let answer = structure.intersect(prims, ray, &mut right);
        mistake.walk(structure, prims, ray, &mut wrong) != answer || right != wrong
    }

    /// The same ray through another structure over the same scene; a build has none.
    pub fn through(&self, built: Built) -> Option<Playback> {
        let Built { scene, rule, structure, nodes, seconds, .. } = built;
        let kind = Beside::Structure(rule.kind());
        let ray = self.play.tape.ray()?;
        let tape = match &self.play.tape {
            Tape::Packet(packet) => {
                let tape = packet.walk(&scene, &structure, ray);
                // Not every structure is walked by packets.
                (!tape.events.is_empty()).then(|| Tape::Packet(Arc::new(tape)))?
            }
            _ => Tape::walk(&scene, &structure, ray),
        };
        let play = Play::new(scene, structure, tape, &[]);
        Some(Playback { seconds, ..self.aside(play, rule, nodes, kind) })
    }

    /// The same ray through this structure and others over the same scene, side by side.
    pub fn abreast(&self, others: Vec<Built>, rivals: Rivals) -> Option<Playback> {
        let (scene, structure, flat) = (self.play.scene.clone(), self.play.structure.clone(), self.play.scene.flat);
        let others = others.into_iter().map(|built| (built.rule, built.structure));
        let walks = WalksTape::of(std::iter::once((self.rule, structure.clone())).chain(others).collect(), flat);
        let told = Tape::Walks(Arc::new(walks));
        let nodes = Arc::new(AllNodes::of(&structure, Some(&told)));
        let built = Built { scene, rule: self.rule, structure, nodes, told: Some(told), seconds: self.seconds };
        self.abreast_of(built, rivals)
    }

    /// The same, where all of them stand already.
    pub(crate) fn abreast_of(&self, built: Built, rivals: Rivals) -> Option<Playback> {
        let Built { scene, rule, structure, nodes, told, .. } = built;
        let ray = self.play.tape.ray()?;
        let play = raystep_lesson::Built { scene, structure, told }.play(Some(ray), &[])?;
        Some(self.aside(play, rule, nodes, Beside::Abreast(rivals)))
    }

    fn aside(&self, play: Play, rule: Rule, nodes: Arc<AllNodes>, kind: Beside) -> Playback {
        let film = Film::new(&reel(&play, &nodes, None));
        let reached = reached(&play.tape);
        let (view, mistakes, seconds) = (self.view.clone(), self.mistakes.clone(), self.seconds);
        let (posed, instead) = (Vec::new(), None);
        Playback { view, play, rule, nodes, posed, mistakes, kind, seconds, film, reached, instead }
    }

    /// The same build, but that at one step another cut is weighed than the builder's.
    pub(crate) fn trying(&self, step: usize, weighed: Grow) -> Option<Playback> {
        let Tape::Build(build) = &self.play.tape else { return None };
        let mut build = BuildTape::clone(build);
        let place = build.events.get_mut(step.checked_sub(1)?)?;
        let instead = Some(std::mem::replace(place, weighed));
        let (scene, structure) = (self.play.scene.clone(), self.play.structure.clone());
        let (beats, beside) = (self.play.beats.clone(), self.play.beside.clone());
        let play = Play { beside, beats, ..Play::new(scene, structure, Tape::Build(Arc::new(build)), &[]) };
        let made = self.aside(play, self.rule, self.nodes.clone(), Beside::Nothing);
        Some(Playback { posed: self.posed.clone(), instead, ..made })
    }

    /// The step that stands at the same decision as a step of another walk: the same event at the same place, met as
    /// often before; else one of the same family.
    pub(crate) fn like(&self, other: &Playback, step: usize) -> Option<usize> {
        let Some(event) = other.event(step) else { return Some(0) };
        let family = |name: &'static str| name.split('.').next().unwrap_or(name);
        let find = |same: &dyn Fn(&Event) -> bool| {
            let before = other.play.tape.events().take(step).filter(|other| same(other)).count();
            let events = self.play.tape.events().enumerate().filter(|(_, event)| same(event));
            events.map(|(index, _)| index + 1).nth(before.saturating_sub(1))
        };
        let place = event.place();
        find(&|other| other.name() == event.name() && other.place() == place)
            .or_else(|| find(&|other| family(other.name()) == family(event.name()) && other.place() == place))
    }

    /// The step at which a node is divided.
    pub(crate) fn split_of(&self, divided: NodeId) -> Option<usize> {
        let splits = |event: &Event| matches!(event, Event::Build(Grow::Split { node, .. }) if *node == divided);
        self.play.tape.events().position(|event| splits(&event)).map(|index| index + 1)
    }

    /// What is played, to be played again.
    pub fn built(&self) -> Built {
        Built {
            scene: self.play.scene.clone(),
            rule: self.rule,
            structure: self.play.structure.clone(),
            nodes: self.nodes.clone(),
            told: self.play.tape.without_ray(),
            seconds: self.seconds,
        }
    }

    /// How far along the ray the walk has come at a step.
    pub fn reached(&self, step: usize) -> f32 {
        self.reached[step.min(self.reached.len() - 1)]
    }

    /// The last step at which the walk has come no farther along the ray than this.
    pub fn step_at(&self, t: f32) -> usize {
        self.reached.partition_point(|reached| *reached <= t).saturating_sub(1)
    }

    /// What the figures are drawn of.
    pub fn reel(&self) -> Reel<'_> {
        reel(&self.play, &self.nodes, self.instead)
    }

    /// The state after so many events.
    pub fn instant(&self, step: usize) -> Instant {
        self.film.at(&self.reel(), step)
    }

    /// What a walk has cost after so many events.
    pub fn cost(&self, step: usize) -> Option<Cost> {
        self.cost_at(&self.instant(step))
    }

    /// What a walk has cost at an instant; a build costs no ray anything.
    pub(crate) fn cost_at(&self, instant: &Instant) -> Option<Cost> {
        self.reel().still(instant).cost()
    }

    /// What a walk ends with: the answer's t and primitive, or nothing; of a packet that of its first ray. A build has no
    /// answer.
    pub fn answer(&self) -> Option<Option<Hit>> {
        match &self.play.tape {
            Tape::Walk(walk) => Some(walk.hit),
            Tape::Walks(walks) => match walks.walks.first() {
                Some(Tape::Walk(walk)) => Some(walk.hit),
                _ => None,
            },
            Tape::Packet(packet) => packet.found.first().copied(),
            Tape::Build(_) | Tape::Board(_) | Tape::Pairs(_) | Tape::Fit(_) => None,
        }
    }

    /// How many primitives a walk has tested after so many events.
    pub fn tests(&self, step: usize) -> u64 {
        self.cost(step).map_or(0, |cost| cost.prim_tests)
    }

    /// The steps.
    pub fn steps(&self) -> Steps<'_> {
        Steps { tape: &self.play.tape, flat: self.play.scene.flat, beats: &self.play.beats }
    }

    /// The event that a step shows.
    pub fn event(&self, step: usize) -> Option<Event> {
        self.play.event(step)
    }

    /// The beat that a step belongs to, and the step it waited for.
    pub fn beat_at(&self, step: usize) -> Option<(usize, usize)> {
        let beat = self.play.beat_at(step)?;
        Some((beat, self.play.beats[beat]?))
    }

    /// The step on which the slide opens: its first decision, or the question before it.
    pub fn opening(&self, predict: bool) -> usize {
        let first = self
            .play
            .beats
            .iter()
            .flatten()
            .copied()
            .min()
            .unwrap_or_else(|| self.steps().next(0, raystep_accel::Grain::Decision));
        let asked = self.posed.iter().find(|posed| predict && posed.step == first);
        asked.map_or(first, |posed| posed.before)
    }

    fn questions(&self, slide: &Slide) -> Vec<Posed> {
        let finest = raystep_accel::Grain::Arithmetic;
        let reached = self.play.beats.iter().enumerate().filter_map(|(beat, at)| Some((beat, (*at)?)));
        let mut posed: Vec<Posed> = reached
            .filter_map(|(beat, step)| {
                let choices = slide.beats.get(beat)?.ask.as_ref()?.choices(&self.play, step);
                let before = self.steps().previous(step, finest);
                (choices.len() > 1 && before < step).then_some(Posed { beat, before, step, choices })
            })
            .collect();
        posed.sort_by_key(|posed| posed.step);
        // One question at a time.
        posed.dedup_by_key(|posed| posed.step);
        posed
    }
}

/// What can be done wrong where such things are played in a structure of this kind: only walks go wrong, those of packets
/// in their own way.
pub(crate) fn mistakes(kind: &str, plays: Plays) -> Vec<Mistake> {
    let made_here = |mistake: &Mistake| match plays {
        Plays::Walk => !mistake.is_of_packets(),
        Plays::Packet => mistake.is_of_packets(),
        Plays::Build | Plays::Walks | Plays::Board | Plays::Pairs | Plays::Fit => false,
    };
    Mistake::of_kind(kind).filter(made_here).collect()
}

/// A beat that tells why a node is divided as it is says nothing of one that is cut by hand.
fn silence(play: &mut Play, rule: &Rule, slide: &Slide) {
    let Some(by_hand) = rule.by_hand().filter(|cuts| !cuts.is_empty()) else { return };
    for beat in 0..play.beats.len().min(slide.beats.len()) {
        let event = play.beats[beat].and_then(|step| play.event(step));
        if let Some(Event::Build(Grow::Split { node, .. })) = event
            && by_hand.of(node).is_some()
        {
            play.beats[beat] = None;
        }
    }
}

/// How far along the ray a walk has come, at every step: the largest t at which it entered something. A ray
/// that tests everything first stays at its beginning until the end; a build does not go along a ray.
fn reached(tape: &Tape) -> Vec<f32> {
    let Tape::Walk(walk) = tape else { return vec![0.0] };
    let mut far = walk.ray.t_min;
    let mut reached = vec![far];
    for event in &walk.events {
        far = match *event {
            Visit::Enter { t_near, .. } | Visit::Pop { t_near, .. } => far.max(t_near),
            Visit::End { hit: true, t, .. } => far.max(t),
            Visit::End { hit: false, .. } => f32::INFINITY,
            _ => far,
        };
        reached.push(far);
    }
    reached
}
