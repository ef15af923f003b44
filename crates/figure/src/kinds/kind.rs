//! What a kind of picture says of itself.

use glam::Vec2;
use raystep_accel::{Aabb, Cost, Direction, HandCut, Place, Prims};

use super::{Detail, Instant};
use crate::page::{Figure, Look};
use crate::panes::{Ask, CutLine, Grip, KnobLine, Pane, Pixel, RulerScale, symbol_on_track};
use crate::theme::Role;
use crate::words::{Fact, Symbol, VolumeName};
use crate::world::{Depth, Form, Space};

/// Something that is shown step by step. A kind says how many steps it has, keeps the state that pictures of a
/// step need, and draws the panes that it names; of everything else there is nothing to draw. Window, presenter's
/// page, plates and films ask a [`Reel`](super::Reel) and need not know which kind it holds.
pub trait Kind {
    /// How many steps there are; before the first one nothing has happened.
    fn len(&self) -> usize;

    /// Whether nothing happens.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The state before the first step.
    fn start(&self) -> Instant;

    /// Lets steps happen until `step` have. Steps already taken are not taken back.
    fn advance(&self, at: &mut Instant, step: usize);

    /// The panes that [`draw`](Kind::draw) draws, and [`Pane::Changed`] if [`changed`](Kind::changed) does.
    fn panes(&self) -> Vec<Pane>;

    /// A pane at an instant; nothing if it is not one of [`panes`](Kind::panes).
    fn draw(&self, at: &Instant, pane: Pane, ask: &Ask<'_>) -> Option<Figure>;

    /// Whether a pane could only say at an instant that there is nothing to show: on paper others get its room.
    fn is_bare(&self, at: &Instant, pane: Pane) -> bool {
        let _ = (at, pane);
        false
    }

    /// What step `step` shows, the first one being 1: whatever slides, listings and templates can say of it.
    fn fact(&self, step: usize) -> Option<&dyn Fact> {
        let _ = step;
        None
    }

    /// What space shows, in a solid scene with so many boxes of a tree. Where there is no space, [`Pane::Picture`]
    /// stands in its place.
    fn space(&self, at: &Instant, depth: Depth) -> Option<Space> {
        let _ = (at, depth);
        None
    }

    /// How many boxes of a tree [`space`](Kind::space) shows where so many are asked for.
    fn depth(&self, at: &Instant, asked: Depth) -> Depth {
        let _ = at;
        asked
    }

    /// The deepest level of the tree whose boxes a solid picture shows; nothing where there is no such choice.
    fn deepest(&self) -> Option<u32> {
        None
    }

    /// What bounds a place, as forms in space; nothing if that is not known.
    fn outline(&self, at: &Instant, place: Place) -> Vec<Form> {
        let _ = (at, place);
        Vec::new()
    }

    /// Puts the outline of the place where an earlier instant stood below the marks of space.
    fn ghost(&self, before: &Instant, at: &Instant, space: &mut Space) {
        let _ = (before, at, space);
    }

    /// The values that have changed since an earlier instant; nothing if none are followed.
    fn changed(&self, before: &Instant, at: &Instant, ask: &Ask<'_>) -> Option<Figure> {
        let _ = (before, at, ask);
        None
    }

    /// The name of the structure that a step is of, where several walk.
    fn whose(&self, step: usize) -> Option<&str> {
        let _ = step;
        None
    }

    /// The scale of a ruler that can be stretched.
    fn scale(&self, at: &Instant, pane: Pane, ask: &Ask<'_>) -> Option<RulerScale> {
        let _ = (at, pane, ask);
        None
    }

    /// The symbol whose name stands at this point of the timeline.
    fn symbol_at(&self, at: &Instant, ask: &Ask<'_>, point: Vec2) -> Option<Symbol> {
        symbol_on_track(self.len(), &|step| self.fact(step), self.volume(), self.flat(), at.step(), ask, point)
    }

    /// The primitives that space is about.
    fn prims(&self) -> &Prims {
        const { &Prims::Few(Vec::new()) }
    }

    /// Whether space is flat.
    fn flat(&self) -> bool {
        true
    }

    /// What is tested before anything in it, in a word.
    fn volume(&self) -> VolumeName {
        VolumeName::BOX
    }

    /// What the marks of space mean, in the order of a legend.
    fn signs(&self) -> &'static [(Role, &'static str)] {
        &[]
    }

    /// The pane in which it is best seen beside space.
    fn best(&self) -> Option<Pane> {
        None
    }

    /// How high a pane should be, where that follows from what it shows.
    fn height(&self, pane: Pane, look: &Look) -> Option<f32> {
        let _ = (pane, look);
        None
    }

    /// How many rows the stack has.
    fn stacked(&self, at: &Instant) -> usize {
        let _ = at;
        0
    }

    /// What the part of space is called where it happens; nothing if that is everywhere or over.
    fn here(&self, at: &Instant) -> Option<Place> {
        let _ = at;
        None
    }

    /// The box of a place as far as it is known.
    fn bounds(&self, at: &Instant, place: Place) -> Aabb {
        let _ = (at, place);
        Aabb::EMPTY
    }

    /// What is but a dot in the whole picture of space and worth seeing from near: its name and its box.
    fn detail(&self, at: &Instant) -> Option<Detail> {
        let _ = at;
        None
    }

    /// What a ray has paid so far.
    fn cost(&self, at: &Instant) -> Option<Cost> {
        let _ = at;
        None
    }

    /// The work so far in a few words.
    fn tally(&self, at: &Instant) -> String {
        let _ = at;
        String::new()
    }

    /// The line of the cut that is weighed, where it can be taken in the hand.
    fn cut_line(&self, at: &Instant, ask: &Ask<'_>) -> Option<CutLine> {
        let _ = (at, ask);
        None
    }

    /// The cut that stands where its line is moved to.
    fn cut_to(&self, at: &Instant, ask: &Ask<'_>, point: Vec2) -> Option<HandCut> {
        let _ = (at, ask, point);
        None
    }

    /// Where the object is taken in the hand that can be moved through space.
    fn grip(&self, at: &Instant) -> Option<Grip> {
        let _ = at;
        None
    }

    /// How well the picture in the middle is seen in so much room: 1 is well. Nothing where it does not matter.
    fn worth(&self, at: &Instant, ask: &Ask<'_>) -> Option<f32> {
        let _ = (at, ask);
        None
    }

    /// Where the numbers lie that can be moved by hand.
    fn knobs(&self, at: &Instant, ask: &Ask<'_>) -> Vec<KnobLine> {
        let _ = (at, ask);
        Vec::new()
    }

    /// The pixel of a heat map at a point of the picture in the middle of the page.
    fn pixel_at(&self, at: &Instant, ask: &Ask<'_>, point: Vec2) -> Option<Pixel> {
        let _ = (at, ask, point);
        None
    }

    /// What lies over that picture where a pixel of a heat map is pointed at.
    fn probe(&self, at: &Instant, ask: &Ask<'_>, pixel: &Pixel) -> Option<Figure> {
        let _ = (at, ask, pixel);
        None
    }

    /// Shows the answers of an open question where they lie. What happens knows nothing of them.
    fn guess(&self, at: &mut Instant, guesses: &[Guess]) {
        let _ = (at, guesses);
    }
}

/// An answer that an open question offers.
#[derive(Clone, Debug, PartialEq)]
pub struct Guess {
    /// The place that it names.
    pub place: Option<Place>,
    /// The plane that it names: across this axis, at this coordinate.
    pub plane: Option<(Direction, f32)>,
    /// Its word.
    pub text: String,
}
