//! Motion between two steps: what a figure shows moves from where it was, for less than a fifth of a second. The step
//! itself is there at once; only its picture arrives.

use std::collections::HashMap;
use std::sync::Arc;

use egui::{Pos2, Rect, Ui, vec2};
use glam::Vec2;
use raystep_accel::{Grain, Place};
use raystep_figure::{Figure, Motion};

use crate::shown::pictures::Pane;
use crate::shown::playback::Playback;
use crate::shown::state::State;

/// For how many seconds a figure moves.
const LASTS: f64 = 0.18;

/// A frame at the usual pace: the first picture of a motion is already under way.
const FRAME: f64 = 1.0 / 60.0;

/// What shows a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Frame {
    /// A pane.
    Pane(Pane),
    /// The picture of space.
    Space,
}

/// A figure as it was shown, and where.
#[derive(Clone)]
struct Shown {
    figure: Arc<Figure>,
    corner: Pos2,
}

/// The figures of this step and of the one before, while they move.
#[derive(Default)]
pub(crate) struct Moving {
    /// The walk and the step that are shown.
    at: Option<(Arc<Playback>, usize)>,
    /// When the motion began.
    began: Option<f64>,
    now: f64,
    before: HashMap<Frame, Shown>,
    last: HashMap<Frame, Shown>,
}

/// The figure to draw, and what crosses its edges.
pub(super) struct Drawn {
    pub(super) figure: Arc<Figure>,
    pub(super) aloft: Option<Figure>,
}

impl Moving {
    /// A frame begins. Motion begins where the same walk has gone one step on or back, and ends with any key or click.
    pub(crate) fn begin(&mut self, ui: &Ui, state: &State) {
        self.now = ui.input(|input| input.time);
        let pressed = ui.input(|input| {
            let key = |event: &egui::Event| matches!(event, egui::Event::Key { pressed: true, .. });
            input.events.iter().any(key) || input.pointer.any_pressed()
        });
        if pressed || self.began.is_some_and(|began| self.now - began >= LASTS) {
            self.end();
        }
        let at = state.playback().map(|playback| (playback.clone(), state.view.step));
        let same = |a: &(Arc<Playback>, usize), b: &(Arc<Playback>, usize)| Arc::ptr_eq(&a.0, &b.0) && a.1 == b.1;
        if self.at.as_ref().zip(at.as_ref()).is_some_and(|(old, new)| same(old, new)) {
            return;
        }
        self.end();
        let next = self.at.as_ref().zip(at.as_ref()).is_some_and(|(old, new)| is_next(old, new));
        if next && state.motion {
            self.before = std::mem::take(&mut self.last);
            self.began = Some(self.now - FRAME);
        } else {
            self.last.clear();
        }
        self.at = at;
    }

    fn end(&mut self) {
        self.began = None;
        self.before.clear();
    }

    /// How far the motion has come; nothing if nothing moves.
    fn share(&self) -> Option<f32> {
        let share = ((self.now - self.began?) / LASTS) as f32;
        // Fast at first, then slower.
        (share < 1.0).then(|| 1.0 - (1.0 - share).powi(3))
    }

    /// A figure as it is drawn now in this rectangle.
    pub(super) fn figure(&mut self, ui: &Ui, frame: Frame, rect: Rect, figure: &Arc<Figure>) -> Drawn {
        let still = Drawn { figure: figure.clone(), aloft: None };
        self.last.insert(frame, Shown { figure: figure.clone(), corner: rect.min });
        let (Some(share), Some(before)) = (self.share(), self.before.get(&frame)) else { return still };
        ui.ctx().request_repaint();
        let coming = self.coming(frame, rect, figure);
        let Some(motion) = Motion::between(&before.figure, figure, &coming) else { return still };
        Drawn { figure: Arc::new(motion.at(share)), aloft: Some(motion.aloft(share)) }
    }

    /// Where the places that come onto a stack were shown before: in the tree, else in space.
    fn coming(&self, frame: Frame, rect: Rect, figure: &Figure) -> Vec<(Place, Vec2)> {
        if !matches!(frame, Frame::Pane(Pane::Stack | Pane::Bin)) {
            return Vec::new();
        }
        let mut places: Vec<Place> = figure.marks.iter().filter_map(|mark| mark.place).collect();
        places.sort();
        places.dedup();
        let sources = [Frame::Pane(Pane::Tree), Frame::Space, Frame::Pane(Pane::Picture)];
        let was = |place: Place| {
            let shown = sources.iter().filter_map(|source| self.before.get(source));
            let mut seen = shown.filter_map(|shown| {
                let middle = shown.figure.middle_of(place)?;
                let at = shown.corner + vec2(middle.x, middle.y) - rect.min;
                Some(Vec2::new(at.x, at.y))
            });
            seen.next()
        };
        places.into_iter().filter_map(|place| Some((place, was(place)?))).collect()
    }
}

/// Whether the same walk has gone one step on or back, by whatever grain.
fn is_next(old: &(Arc<Playback>, usize), new: &(Arc<Playback>, usize)) -> bool {
    let (from, to) = (old.1, new.1);
    let steps = old.0.steps();
    let grains = [Grain::Arithmetic, Grain::Decision, Grain::Visit];
    Arc::ptr_eq(&old.0, &new.0)
        && from != to
        && grains.into_iter().any(|grain| steps.next(from, grain) == to || steps.previous(from, grain) == to)
}
