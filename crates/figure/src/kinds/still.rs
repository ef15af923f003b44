//! One step of a reel, and every picture of it.

use std::borrow::Cow;

use glam::Vec2;
use raystep_accel::{Aabb, Cost, HandCut, Place};

use super::{Detail, Instant, Kind};
use crate::page::{Figure, Look};
use crate::panes::{Ask, CutLine, Grip, KnobLine, Pane, Pixel, RulerScale, legend, line_at, track};
use crate::theme::Role;
use crate::words::{Fact, Symbol};
use crate::world::{Depth, Form, Space, SpaceMark, edges};

/// One step, with what it belongs to. Window and page draw this and need not know which kind it is.
#[derive(Clone, Copy)]
pub struct Still<'a> {
    kind: &'a dyn Kind,
    at: &'a Instant,
    /// The instant with which it is compared.
    before: Option<&'a Instant>,
    /// How many boxes of a tree a solid picture shows.
    depth: Depth,
}

/// A primitive is large from this part of the scene on.
const LARGE: f32 = 0.25;

/// Whether a kind has anything to show in a pane. Whatever has steps has a timeline, and whatever names signs a
/// legend.
pub(super) fn has(kind: &dyn Kind, pane: Pane) -> bool {
    match pane {
        Pane::Timeline => true,
        Pane::Legend => !kind.signs().is_empty(),
        _ => kind.panes().contains(&pane),
    }
}

impl<'a> Still<'a> {
    pub(super) fn new(kind: &'a dyn Kind, at: &'a Instant) -> Still<'a> {
        Still { kind, at, before: None, depth: Depth::default() }
    }

    /// The same, compared with an earlier instant: space shows where that one stood, and a pane what has changed.
    pub fn since(self, before: &'a Instant) -> Still<'a> {
        Still { before: Some(before), ..self }
    }

    /// The same, with so many boxes of a tree in a solid picture.
    pub fn to_depth(self, depth: Depth) -> Still<'a> {
        Still { depth, ..self }
    }

    /// How many boxes of a tree a solid picture shows where so many are asked for.
    pub fn depth(&self, asked: Depth) -> Depth {
        self.kind.depth(self.at, asked)
    }

    /// How many steps have happened.
    pub fn step(&self) -> usize {
        self.at.step()
    }

    /// What it shows; nothing before the first step.
    pub fn fact(&self) -> Option<&'a dyn Fact> {
        self.kind.fact(self.at.step())
    }

    /// Whether space is flat.
    pub fn flat(&self) -> bool {
        self.kind.flat()
    }

    /// What space shows, if there is space.
    pub fn space(&self) -> Option<Space> {
        let mut space = self.kind.space(self.at, self.depth)?;
        if let Some(before) = self.before {
            self.kind.ghost(before, self.at, &mut space);
        }
        Some(space)
    }

    /// Whether there is anything to show in a pane.
    pub fn has(&self, pane: Pane) -> bool {
        has(self.kind, pane)
    }

    /// Whether a pane could only say at this step that there is nothing to show: on paper others get its room.
    pub fn is_bare(&self, pane: Pane) -> bool {
        self.kind.is_bare(self.at, pane)
    }

    /// A pane; an empty figure where there is nothing to show.
    pub fn draw(&self, pane: Pane, ask: &Ask<'_>) -> Figure {
        let drawn = self.kind.draw(self.at, pane, ask).or_else(|| match pane {
            Pane::Legend => {
                let space = ask.space.map(Cow::Borrowed).or_else(|| self.space().map(Cow::Owned))?;
                Some(legend::legend(&space, self.kind.signs(), ask.size, &ask.look))
            }
            Pane::Changed => self.kind.changed(self.before.unwrap_or(self.at), self.at, ask),
            Pane::Timeline => Some(track(
                self.kind.len(),
                &|step| self.kind.fact(step),
                self.kind.volume(),
                self.kind.flat(),
                self.at.step(),
                ask,
            )),
            _ => None,
        });
        drawn.unwrap_or_else(|| Figure::new(ask.size))
    }

    /// How high a pane should be, where that follows from what it shows.
    pub fn height(&self, pane: Pane, look: &Look) -> Option<f32> {
        self.kind.height(pane, look)
    }

    /// How well the picture in the middle is seen in so much room: 1 is well. Nothing where it does not matter.
    pub fn worth(&self, ask: &Ask<'_>) -> Option<f32> {
        self.kind.worth(self.at, ask)
    }

    /// How much room a legend of this width has at every step, so that what stands beside it never moves.
    pub fn legend_room(width: f32, look: &Look) -> f32 {
        legend::legend_room(width, look)
    }

    /// How high a legend of this width becomes.
    pub fn legend_height(&self, space: &Space, width: f32, look: &Look) -> f32 {
        legend::legend_height(space, self.kind.signs(), width, look)
    }

    /// Which line of the listing that is asked for stands at this height.
    pub fn line_at(&self, ask: &Ask<'_>, y: f32) -> Option<usize> {
        line_at(ask.lines, self.fact(), self.flat(), ask.size, &ask.look, y)
    }

    /// The scale of the ruler that is asked for, if it can be stretched.
    pub fn scale(&self, pane: Pane, ask: &Ask<'_>) -> Option<RulerScale> {
        self.kind.scale(self.at, pane, ask)
    }

    /// The symbol whose name stands at this point of the timeline that is asked for.
    pub fn symbol_at(&self, ask: &Ask<'_>, point: Vec2) -> Option<Symbol> {
        self.kind.symbol_at(self.at, ask, point)
    }

    /// The line of the cut that is weighed in the picture that is asked for, where it can be taken in the hand.
    pub fn cut_line(&self, ask: &Ask<'_>) -> Option<CutLine> {
        self.kind.cut_line(self.at, ask)
    }

    /// The cut that stands where its line is moved to.
    pub fn cut_to(&self, ask: &Ask<'_>, point: Vec2) -> Option<HandCut> {
        self.kind.cut_to(self.at, ask, point)
    }

    /// Where the object is taken in the hand that can be moved through space.
    pub fn grip(&self) -> Option<Grip> {
        self.kind.grip(self.at)
    }

    /// Where the numbers lie that can be moved by hand, in the picture that is asked for.
    pub fn knobs(&self, ask: &Ask<'_>) -> Vec<KnobLine> {
        self.kind.knobs(self.at, ask)
    }

    /// The pixel of a heat map at a point of the picture in the middle of the page.
    pub fn pixel_at(&self, ask: &Ask<'_>, point: Vec2) -> Option<Pixel> {
        self.kind.pixel_at(self.at, ask, point)
    }

    /// What lies over that picture where a pixel of a heat map is pointed at.
    pub fn probe(&self, ask: &Ask<'_>, pixel: &Pixel) -> Option<Figure> {
        self.kind.probe(self.at, ask, pixel)
    }

    /// How many rows its stack has.
    pub fn stacked(&self) -> usize {
        self.kind.stacked(self.at)
    }

    /// What the part of space is called where it happens; nothing if that is everywhere or over.
    pub fn here(&self) -> Option<Place> {
        self.kind.here(self.at)
    }

    /// The box of a place as far as it is known.
    pub fn bounds(&self, place: Place) -> Aabb {
        self.kind.bounds(self.at, place)
    }

    /// What bounds a place, as forms in space; nothing if that is not known.
    pub fn outline(&self, place: Place) -> Vec<Form> {
        self.kind.outline(self.at, place)
    }

    /// What lights up in space where the pointer is on a place: its outline, and nothing else of it. A primitive that is
    /// large in the scene has no light on its surface either.
    pub fn lit(&self, place: Place) -> Vec<SpaceMark> {
        if place == Place::World {
            return Vec::new();
        }
        let all = self.kind.bounds(self.at, Place::World).extent().length();
        let outlined = |form: Form| match form {
            Form::Box(bounds) if !self.kind.flat() => Form::Body(edges(&bounds)),
            Form::Prim(_) if self.kind.bounds(self.at, place).extent().length() > LARGE * all => {
                Form::Body(edges(&self.kind.bounds(self.at, place)))
            }
            form => form,
        };
        let forms = self.kind.outline(self.at, place).into_iter().map(outlined);
        forms.map(|form| SpaceMark { form, role: Role::Hover, place: Some(place) }).collect()
    }

    /// What is but a dot in the whole picture of space and worth seeing from near: its name and its box.
    pub fn detail(&self) -> Option<Detail> {
        self.kind.detail(self.at)
    }

    /// What a ray has paid so far.
    pub fn cost(&self) -> Option<Cost> {
        self.kind.cost(self.at)
    }

    /// The work so far in a few words.
    pub fn tally(&self) -> String {
        self.kind.tally(self.at)
    }
}
