//! The figures of this step, drawn once and kept while nothing that they show changes.

use std::collections::HashMap;
use std::sync::Arc;

use glam::Vec2;
use raystep_accel::{Event, Grow, Primitives};
use raystep_figure::{Camera, Figure, Instant, Look, Scenery, Space, TreeView, stage};
use raystep_lesson::{Choice, Listing, Show};

use super::playback::Playback;
use super::state::State;
use crate::reel::lines;

/// The most primitives that are drawn as outlines.
const OUTLINED: usize = 2000;

/// The step that is shown, folded and drawn.
pub(super) struct Pictures {
    key: Key,
    /// The walk or the build.
    pub(super) playback: Arc<Playback>,
    /// Its state at this step.
    pub(super) instant: Instant,
    /// What space shows.
    pub(super) space: Space,
    figures: HashMap<PaneKey, Figure>,
}

#[derive(Clone, PartialEq)]
struct Key {
    playback: usize,
    step: usize,
    asking: bool,
}

#[derive(Clone, Copy, PartialEq, Eq, Hash)]
struct PaneKey {
    pane: Pane,
    size: [u32; 2],
    text: u32,
    extra: u64,
}

/// A pane that is a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Pane {
    Ruler,
    RulerLine,
    Tree,
    Cells,
    Slabs,
    Bytes,
    Walk,
    Stack,
    StackHere,
    Work,
    Legend,
    Timeline,
}

impl Pane {
    /// What stands on its tab.
    pub(super) fn name(self) -> &'static str {
        match self {
            Pane::Ruler | Pane::RulerLine => "t along the ray",
            Pane::Tree => "Tree",
            Pane::Cells => "Cells",
            Pane::Slabs => "Slabs",
            Pane::Bytes => "Bytes",
            Pane::Walk => "Walk",
            Pane::Stack | Pane::StackHere => "Stack",
            Pane::Work => "Work",
            Pane::Legend => "Signs",
            Pane::Timeline => "Timeline",
        }
    }
}

impl Pictures {
    /// The pictures of the state's step: those kept, if they still are right.
    pub(super) fn of(kept: Option<Pictures>, state: &State) -> Option<Pictures> {
        let playback = state.playback()?.clone();
        let asking = state.question().is_some();
        let key = Key { playback: Arc::as_ptr(&playback) as usize, step: state.view.step, asking };
        if let Some(kept) = kept
            && kept.key == key
        {
            return Some(kept);
        }
        let mut instant = playback.instant(state.view.step);
        if let Some(posed) = state.question() {
            guess(&mut instant, &posed.choices);
        }
        let space = playback.reel().still(&instant).space();
        Some(Pictures { key, playback, instant, space, figures: HashMap::new() })
    }

    /// The figure of a pane.
    pub(super) fn pane(
        &mut self,
        pane: Pane,
        size: Vec2,
        look: &Look,
        code: Option<&Listing>,
        view: &TreeView,
        beside: Option<(&str, u64)>,
    ) -> &Figure {
        let extra =
            beside.map_or(0, |(_, tests)| tests + 1) ^ (view.focus.map_or(0, |node| u64::from(node.0) + 1) << 20);
        let sized = [size.x as u32, size.y as u32];
        let asking = self.key.asking;
        let key = PaneKey { pane, size: sized, text: (look.text * 8.0) as u32, extra };
        let Pictures { playback, instant, space, figures, .. } = self;
        figures.entry(key).or_insert_with(|| {
            let reel = playback.reel();
            let still = reel.still(instant);
            match pane {
                Pane::Ruler => still.ruler(asking, size, look),
                Pane::RulerLine => still.ruler_line(asking, size, look),
                Pane::Tree => still.tree(view, size, look),
                Pane::Cells => still.cells(asking, size, look),
                Pane::Slabs => still.slabs(size, look),
                Pane::Bytes => still.bytes(size, look),
                Pane::Walk => still.listing(&lines(code, &playback.play, instant.step()), size, look),
                Pane::Stack => still.stack(false, size, look),
                Pane::StackHere => still.stack(true, size, look),
                Pane::Work => still.work(beside, size, look),
                Pane::Legend => still.legend(space, size, look),
                Pane::Timeline => still.timeline(asking, size, look),
            }
        })
    }

    /// Whether there is anything to show in a pane.
    pub(super) fn has(&self, pane: Pane) -> bool {
        let reel = self.playback.reel();
        let still = reel.still(&self.instant);
        match pane {
            Pane::Ruler | Pane::RulerLine => still.has_ruler(),
            Pane::Stack | Pane::StackHere => still.has_stack(),
            _ => true,
        }
    }

    /// How high the presenter's ruler is.
    pub(super) fn ruler_line_height(&self, look: &Look) -> f32 {
        let reel = self.playback.reel();
        let still = reel.still(&self.instant);
        if still.has_ruler() { still.ruler_line_height(look) } else { 0.0 }
    }

    /// How high the legend of this width is.
    pub(super) fn legend_height(&self, width: f32, look: &Look) -> f32 {
        self.playback.reel().still(&self.instant).legend_height(&self.space, width, look)
    }

    /// Space as a camera sees it; `painted` says that the primitives are drawn below it.
    pub(super) fn stage(&self, camera: &Camera, size: Vec2, painted: bool) -> Figure {
        drawn(&self.space, &self.playback, camera, size, painted)
    }
}

/// Space as a camera sees it. So many primitives that their outlines would be a blot are left out.
pub(super) fn drawn(space: &Space, playback: &Playback, camera: &Camera, size: Vec2, painted: bool) -> Figure {
    let prims = &playback.play.scene.prims;
    let scenery = if painted || prims.len() > OUTLINED { Scenery::Left } else { Scenery::Drawn };
    stage(space, prims, camera, size, scenery)
}

/// Shows the answers of an open question where they lie: places of a walk, planes of a build.
fn guess(instant: &mut Instant, choices: &[Choice]) {
    match instant {
        Instant::Walk(moment) => {
            let guess = |choice: &Choice| Some((choice.place?, super::question::label(choice)));
            moment.guesses = choices.iter().filter_map(guess).collect();
        }
        Instant::Build(moment) => {
            let guess = |choice: &Choice| match choice.own {
                Some(Event::Build(Grow::Weigh { axis, plane, .. })) => {
                    Some((axis, plane, super::question::label(choice)))
                }
                _ => None,
            };
            moment.guesses = choices.iter().filter_map(guess).collect();
        }
    }
}

/// Whether a slide wants to see a node's bytes, and there are any.
pub(super) fn shows_bytes(playback: &Playback, show: &[Show]) -> bool {
    show.contains(&Show::Bytes) && matches!(&*playback.play.structure, raystep_accel::Structure::Kd(_))
}

/// The pane that a structure is best seen in beside space.
pub(super) fn main_pane(playback: &Playback, show: &[Show]) -> Option<Pane> {
    use raystep_accel::Structure;
    match &*playback.play.structure {
        Structure::Slab(_) => Some(Pane::Slabs),
        structure if structure.grid().is_some() => Some(Pane::Cells),
        Structure::List(_) => show.contains(&Show::Slabs).then_some(Pane::Slabs),
        _ => Some(Pane::Tree),
    }
}
