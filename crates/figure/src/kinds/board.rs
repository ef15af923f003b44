//! A board that is filled: tables and charts.

use glam::Vec2;
use raystep_accel::Reveal;

use super::{Instant, Kind};
use crate::page::Figure;
use crate::panes::{Ask, KnobLine, Pane, Panel, Pixel, board, knobs, pixel_at, probe, worth};
use crate::words::Fact;

/// Tables and charts, and what comes to be seen on them.
#[derive(Clone, Debug)]
pub struct Board<'a> {
    /// What stands on it.
    pub panels: &'a [Panel],
    /// What comes to be seen, in order.
    pub events: &'a [Reveal],
    /// What each of these is called.
    pub names: &'a [String],
}

impl Kind for Board<'_> {
    fn len(&self) -> usize {
        self.events.len()
    }

    fn start(&self) -> Instant {
        Instant::new(0_usize)
    }

    fn advance(&self, at: &mut Instant, step: usize) {
        let shown = at.state_mut::<usize>();
        *shown = step.min(self.events.len()).max(*shown);
    }

    fn panes(&self) -> Vec<Pane> {
        std::iter::once(Pane::Picture).chain(self.panels.iter().map(Panel::pane)).collect()
    }

    fn draw(&self, at: &Instant, pane: Pane, ask: &Ask<'_>) -> Option<Figure> {
        if pane == Pane::Picture {
            return Some(board(self.panels, *at.state(), ask));
        }
        let shown: Vec<Panel> = self.panels.iter().filter(|panel| pane == panel.pane()).cloned().collect();
        (!shown.is_empty()).then(|| board(&shown, *at.state(), ask))
    }

    fn pixel_at(&self, at: &Instant, ask: &Ask<'_>, point: Vec2) -> Option<Pixel> {
        pixel_at(self.panels, *at.state(), ask, point)
    }

    fn probe(&self, at: &Instant, ask: &Ask<'_>, pixel: &Pixel) -> Option<Figure> {
        Some(probe(self.panels, *at.state(), ask, pixel))
    }

    fn worth(&self, _: &Instant, ask: &Ask<'_>) -> Option<f32> {
        Some(worth(self.panels, ask))
    }

    fn knobs(&self, at: &Instant, ask: &Ask<'_>) -> Vec<KnobLine> {
        knobs(self.panels, *at.state(), ask)
    }

    fn fact(&self, step: usize) -> Option<&dyn Fact> {
        let event = self.events.get(step.checked_sub(1)?)?;
        Some(event)
    }

    fn tally(&self, at: &Instant) -> String {
        let step: usize = *at.state();
        step.checked_sub(1).and_then(|index| self.names.get(index)).cloned().unwrap_or_default()
    }
}
