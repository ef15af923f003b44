//! The figures of this step, drawn once and kept while nothing that they show changes.

use std::collections::HashMap;
use std::sync::Arc;

use glam::Vec2;
use raystep_accel::{Cost, Event, Grain, Grow, HandCut, Interval, Mistake, Place, Primitives};
pub(crate) use raystep_figure::Pane;
use raystep_figure::{
    Ask, Camera, CutLine, Depth, Figure, Grip, Guess, Ink, Instant, KnobLine, Look, Pixel, RulerScale, Scenery, Space,
    SpaceMark, Symbol, TreeView, nothing, stage_around,
};
use raystep_lesson::{Choice, Listing, Show};

use super::beside::Beside;
use super::playback::Playback;
use super::reel::lines;
use super::state::State;
use super::words::{label, shares};

/// The most primitives that are drawn as outlines.
const OUTLINED: usize = 2000;

/// The step that is shown, folded and drawn.
pub(crate) struct Pictures {
    key: Key,
    /// The walk or the build.
    pub(crate) playback: Arc<Playback>,
    /// Its state at this step.
    pub(crate) instant: Instant,
    /// What space shows, if there is space.
    pub(crate) space: Option<Arc<Space>>,
    /// Its state at the step before.
    before: Instant,
    /// The part of the ray that the ruler shows, if not all of it.
    part: Option<Interval>,
    figures: HashMap<PaneKey, Arc<Figure>>,
}

#[derive(Clone, PartialEq)]
struct Key {
    playback: usize,
    step: usize,
    /// Where the step before is, by the grain of steps.
    grain: Grain,
    /// While a question is open: whether it asks for a count, and the name of the event that answers it.
    asks: Option<(bool, &'static str)>,
    /// The last step that may be told of before a question is asked.
    told: usize,
    /// The mistake that is made in the walk beside.
    mistake: Option<Mistake>,
    /// How many boxes of a tree are drawn in space.
    depth: Depth,
}

#[derive(Clone, Copy, PartialEq, Eq, Hash)]
struct PaneKey {
    pane: Pane,
    size: [u32; 2],
    text: u32,
    extra: u64,
    part: [u32; 2],
}

impl Pictures {
    /// The pictures of the state's step: those kept, if they still are right.
    pub(crate) fn of(kept: Option<Pictures>, state: &State) -> Option<Pictures> {
        let playback = state.playback()?.clone();
        let asks = state.question().and_then(|posed| {
            let ask = state.slide()?.beats.get(posed.beat)?.ask.as_ref();
            let counts = ask?.about.is_total();
            Some((counts, playback.event(posed.step)?.name()))
        });
        let mistake = match state.beside {
            Beside::Mistake(index) => playback.mistakes.get(index).copied(),
            _ => None,
        };
        let (step, grain, depth, part) = (state.view.step, state.grain, state.depth(), state.view.part);
        let told = state.told();
        let key = Key { playback: Arc::as_ptr(&playback) as usize, step, grain, asks, told, mistake, depth };
        if let Some(kept) = kept
            && kept.key == key
        {
            return Some(Pictures { part, ..kept });
        }
        let mut instant = playback.instant(state.view.step);
        if let Some(posed) = state.question() {
            let guesses: Vec<Guess> = posed.choices.iter().map(guess).collect();
            playback.reel().guess(&mut instant, &guesses);
        }
        let before = playback.instant(playback.steps().previous(state.view.step, state.grain));
        let space = playback.reel().still(&instant).since(&before).to_depth(depth).space().map(Arc::new);
        Some(Pictures { key, playback, instant, space, before, part, figures: HashMap::new() })
    }

    /// The figure of a pane.
    pub(crate) fn pane(
        &mut self,
        pane: Pane,
        size: Vec2,
        look: &Look,
        code: Option<&Listing>,
        view: &TreeView,
        beside: Option<(&str, u64)>,
    ) -> Arc<Figure> {
        let extra =
            beside.map_or(0, |(_, tests)| tests + 1) ^ (view.focus.map_or(0, |node| u64::from(node.0) + 1) << 20);
        let sized = [size.x as u32, size.y as u32];
        let Key { asks, told: ahead, mistake, .. } = self.key;
        let text = (look.text * 8.0) as u32 * 2 + u32::from(look.titles);
        let Pictures { playback, instant, space, before, part, figures, .. } = self;
        let part = part.filter(|_| matches!(pane, Pane::Ruler | Pane::RulerLine));
        let bits = part.map_or([0; 2], |part| [part.near.to_bits(), part.far.to_bits()]);
        let key = PaneKey { pane, size: sized, text, extra, part: bits };
        let draw = || {
            let reel = playback.reel();
            let still = reel.still(instant).since(before);
            if pane == Pane::Work && asks.is_some_and(|(counts, _)| counts) {
                return Arc::new(nothing("Work so far", WAITS, size, look));
            }
            // Bytes tell of what is asked only where that is a plane, of the node or a side of the box, or what is in a slot.
            let told = |coming: &str| coming == "plane" || coming.starts_with("slab") || coming.starts_with("probe");
            let hide = asks.is_some_and(|(_, coming)| pane != Pane::Bytes || told(coming));
            let lines = lines(code, &playback.play, &playback.rule, still.step(), mistake);
            let space = space.as_deref();
            // The tree says how many nodes it has: not while that is asked.
            let view = &TreeView { uncounted: asks.is_some_and(|(total, _)| total), ..view.clone() };
            let ask = Ask {
                hide,
                told: ahead,
                view: Some(view),
                lines: &lines,
                beside,
                part,
                space,
                ..Ask::new(size, *look)
            };
            Arc::new(still.draw(pane, &ask))
        };
        figures.entry(key).or_insert_with(draw).clone()
    }

    /// The scale of the ruler in a pane of this size, if it can be stretched.
    pub(crate) fn scale(&self, pane: Pane, size: Vec2, look: &Look) -> Option<RulerScale> {
        let ask = Ask { part: self.part, ..Ask::new(size, *look) };
        self.playback.reel().still(&self.instant).scale(pane, &ask)
    }

    /// What lights up in space where the pointer is on a place.
    pub(crate) fn lit(&self, place: Option<Place>) -> Vec<SpaceMark> {
        place.map_or_else(Vec::new, |place| self.playback.reel().still(&self.instant).lit(place))
    }

    /// Whether there is anything to show in a pane.
    pub(crate) fn has(&self, pane: Pane) -> bool {
        self.playback.reel().has(pane)
    }

    /// Whether anything that is followed is not as it was at the step before.
    pub(crate) fn changes(&self) -> bool {
        let ask = Ask::new(Vec2::new(400.0, 300.0), Look::WINDOW);
        let figure = self.playback.reel().still(&self.instant).since(&self.before).draw(Pane::Changed, &ask);
        figure.marks.iter().any(|mark| matches!(&mark.ink, Ink::Text { text, .. } if text == "\u{2192}"))
    }

    /// How well the picture in the middle is seen in so much room: 1 is well. Nothing where it does not matter.
    pub(crate) fn worth(&self, size: Vec2, look: &Look) -> Option<f32> {
        let reel = self.playback.reel();
        let still = reel.still(&self.instant);
        still.worth(&Ask::new(size, *look)).filter(|_| still.has(Pane::Picture))
    }

    /// How high a pane should be, where that follows from what it shows.
    pub(crate) fn height(&self, pane: Pane, look: &Look) -> Option<f32> {
        self.playback.reel().still(&self.instant).height(pane, look)
    }

    /// How high the presenter's ruler is.
    pub(crate) fn ruler_line_height(&self, look: &Look) -> f32 {
        let reel = self.playback.reel();
        let still = reel.still(&self.instant);
        let height = still.height(Pane::RulerLine, look).filter(|_| still.has(Pane::RulerLine));
        height.unwrap_or(0.0)
    }

    /// The line of the listing at this height of its pane.
    pub(crate) fn line_at(&self, code: Option<&Listing>, size: Vec2, look: &Look, y: f32) -> Option<usize> {
        let reel = self.playback.reel();
        let still = reel.still(&self.instant);
        let lines = lines(code, &self.playback.play, &self.playback.rule, still.step(), self.key.mistake);
        still.line_at(&Ask { lines: &lines, ..Ask::new(size, *look) }, y)
    }

    /// The line of the cut that is weighed in a picture of this size, where it can be taken in the hand.
    pub(crate) fn cut_line(&self, size: Vec2, look: &Look) -> Option<CutLine> {
        let ask = Ask { hide: self.key.asks.is_some(), ..Ask::new(size, *look) };
        self.playback.reel().still(&self.instant).cut_line(&ask)
    }

    /// The cut that stands where that line is moved to.
    pub(crate) fn cut_to(&self, size: Vec2, look: &Look, point: Vec2) -> Option<HandCut> {
        let ask = Ask { hide: self.key.asks.is_some(), ..Ask::new(size, *look) };
        self.playback.reel().still(&self.instant).cut_to(&ask, point)
    }

    /// Where the object is taken in the hand that can be moved through space.
    pub(crate) fn grip(&self) -> Option<Grip> {
        self.playback.reel().still(&self.instant).grip()
    }

    /// Where the numbers lie that can be moved by hand, in a picture of this size.
    pub(crate) fn knobs(&self, size: Vec2, look: &Look) -> Vec<KnobLine> {
        self.playback.reel().still(&self.instant).knobs(&Ask::new(size, *look))
    }

    /// The pixel of a heat map at a point of a picture of this size.
    pub(crate) fn pixel_at(&self, size: Vec2, look: &Look, point: Vec2) -> Option<Pixel> {
        let ask = Ask { hide: self.key.asks.is_some(), ..Ask::new(size, *look) };
        self.playback.reel().still(&self.instant).pixel_at(&ask, point)
    }

    /// What lies over the picture where a pixel of a heat map is pointed at.
    pub(crate) fn probe(&self, size: Vec2, look: &Look, pixel: &Pixel) -> Option<Figure> {
        let ask = Ask { hide: self.key.asks.is_some(), ..Ask::new(size, *look) };
        self.playback.reel().still(&self.instant).probe(&ask, pixel)
    }

    /// The symbol whose name stands at this point of the timeline.
    pub(crate) fn symbol_at(&self, size: Vec2, look: &Look, point: Vec2) -> Option<Symbol> {
        let ask = Ask { hide: self.key.asks.is_some(), told: self.key.told, ..Ask::new(size, *look) };
        self.playback.reel().still(&self.instant).symbol_at(&ask, point)
    }

    /// The step with which this one is compared, if there is one before.
    pub(crate) fn since(&self) -> Option<usize> {
        Some(self.before.step()).filter(|before| *before < self.instant.step())
    }

    /// The work so far in a few words; nothing while a question asks for it.
    pub(crate) fn tally(&self) -> String {
        match self.key.asks {
            Some((true, _)) => WAITS.to_owned(),
            _ => self.playback.reel().still(&self.instant).tally(),
        }
    }

    /// Space as a camera sees it; `painted` says that the primitives are drawn below it.
    /// Labels keep off the rectangle between two corners that are `kept`.
    pub(crate) fn stage(
        &self,
        kept: Option<[Vec2; 2]>,
        space: &Space,
        camera: &Camera,
        size: Vec2,
        painted: bool,
    ) -> Figure {
        drawn(kept, space, &self.playback, camera, size, painted)
    }
}

/// What stands where the answer to an open question would.
const WAITS: &str = "shown once the question is answered";

/// A walk beside at a step: folded once, and kept while nothing has moved.
pub(crate) struct Drawn {
    walk: Arc<Playback>,
    step: usize,
    depth: Depth,
    /// What space shows.
    pub(crate) space: Space,
    /// What it has cost so far.
    pub(crate) cost: Option<Cost>,
}

impl Drawn {
    /// The walk at this step: as it is kept, if that still is right.
    pub(crate) fn of(kept: Option<Drawn>, beside: &Arc<Playback>, step: usize, depth: Depth) -> Drawn {
        if let Some(kept) = kept
            && Arc::ptr_eq(&kept.walk, beside)
            && (kept.step, kept.depth) == (step, depth)
        {
            return kept;
        }
        let instant = beside.instant(step);
        let space = beside.reel().still(&instant).to_depth(depth).space().unwrap_or_default();
        Drawn { walk: beside.clone(), step, depth, space, cost: beside.cost_at(&instant) }
    }

    /// What lights up in space where the pointer is on a place.
    pub(crate) fn lit(&self, place: Option<Place>) -> Vec<SpaceMark> {
        let instant = self.walk.reel().start();
        place.map_or_else(Vec::new, |place| self.walk.reel().still(&instant).lit(place))
    }
}

/// Space as a camera sees it. So many primitives that their outlines would be a blot are left out.
pub(crate) fn drawn(
    kept: Option<[Vec2; 2]>,
    space: &Space,
    playback: &Playback,
    camera: &Camera,
    size: Vec2,
    painted: bool,
) -> Figure {
    let prims = &playback.play.scene.prims;
    let scenery = if painted || prims.len() > OUTLINED { Scenery::Left } else { Scenery::Drawn };
    stage_around(kept, space, prims, camera, size, scenery)
}

/// An answer of an open question with what it names: a place, or a plane that a builder weighs.
fn guess(choice: &Choice) -> Guess {
    let plane = match choice.own {
        Some(Event::Build(Grow::Weigh { axis, plane, .. })) => Some((axis, plane)),
        _ => None,
    };
    // In the picture its line says where it is.
    Guess { place: choice.place, plane, text: shares(choice).unwrap_or_else(|| label(choice)) }
}

/// Whether a slide wants to see bytes, and there are any.
pub(crate) fn shows_bytes(playback: &Playback, show: &[Show]) -> bool {
    show.contains(&Show::Bytes) && playback.reel().has(Pane::Bytes)
}

/// The pane that is best seen beside space.
pub(crate) fn main_pane(playback: &Playback, show: &[Show]) -> Option<Pane> {
    let reel = playback.reel();
    reel.best().or_else(|| (show.contains(&Show::Slabs) && reel.has(Pane::Slabs)).then_some(Pane::Slabs))
}
