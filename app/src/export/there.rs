//! What of all views a walk has, and what is said of one that it lacks.

use clap::ValueEnum;
use raystep_figure::{Pane, Reel};
use raystep_lesson::{Listing, Play};

use super::{Format, Order, Piece, Session, View};

impl Session<'_> {
    /// Why an order cannot be drawn: the view or a pane that is missing, and what there is instead; nothing if it can.
    pub(super) fn missing(&self, order: &Order) -> Option<String> {
        if order.format == Format::Json {
            return None;
        }
        let reel = self.reel();
        let there = There { reel: &reel, play: &self.play, listing: self.ground.library.listing(&self.ground.listing) };
        let piece = order.pieces.iter().find_map(|piece| match piece {
            Piece::View(view) if there.lacks_on_plates(*view).is_some() => Some(*view),
            _ => None,
        });
        let missing = piece.or(Some(order.view).filter(|view| there.lacks(*view).is_some()))?;
        let has = View::value_variants().iter().filter(|view| there.lacks(**view).is_none()).map(|view| view.name());
        let has: Vec<&str> = has.collect();
        Some(format!("{} has no view \"{}\"; there are {}", self.file_stem(), missing.name(), has.join(", ")))
    }
}

/// What views are drawn of.
pub(crate) struct There<'a> {
    /// The pictures of all steps.
    pub(crate) reel: &'a Reel<'a>,
    /// What happens.
    pub(crate) play: &'a Play,
    /// The listing that it follows, if there is one.
    pub(crate) listing: Option<&'a Listing>,
}

impl There<'_> {
    /// Why there is no such view; nothing if there is one.
    pub(crate) fn lacks(&self, view: View) -> Option<&'static str> {
        let There { reel, play, listing } = self;
        let pane = view.pane()?;
        // What is there in general may have nothing to show in this walk.
        let shows = match view {
            View::Tree => play.structure.node_count() > 0,
            View::Cells => play.structure.grid().is_some(),
            View::Slabs => play.tape.events().any(|event| {
                let name = event.name();
                name.starts_with("slab.") || name == "roots" || name == "clip"
            }),
            View::Listing => listing.is_some_and(|listing| !listing.lines.is_empty()),
            View::Heat => reel.has(pane) || self.is_hot(),
            _ => true,
        };
        let has = shows && (view == View::Heat || reel.has(pane));
        (!has).then_some(match view {
            View::Plate | View::Space => "There is nothing to draw.",
            View::Tree => "This structure has no tree.",
            View::T => "Nothing here is measured along a ray or a cut.",
            View::Cells => "This structure has no cells.",
            View::Matrix => "No pairs of objects are tested here.",
            View::Slabs => "No volume is tested slab by slab here.",
            View::Bytes => "Nothing of this structure is shown in memory.",
            View::Stack => "Nothing waits here: there is no stack.",
            View::Listing => "There is no listing here.",
            View::Work => "No work is counted here.",
            View::Changed => "It is not told here what a step changes.",
            View::Timeline => "There are no steps here.",
            View::Chart => "There is no chart here.",
            View::Table => "There is no table here.",
            View::Numbers => "No numbers are moved by hand here.",
            View::Heat => "Only solid scenes with a ray, and some boards, have a heat map.",
            View::Pictures => "There are no ray traced pictures here.",
        })
    }

    /// Why a view cannot stand on a plate among others; nothing if it can.
    pub(crate) fn lacks_on_plates(&self, view: View) -> Option<&'static str> {
        // A plate shows its panes; what is drawn in a way of its own stands alone.
        let alone =
            || view.pane().filter(|pane| !self.reel.has(*pane)).map(|_| "It stands alone: choose it as the view.");
        self.lacks(view).or_else(alone)
    }

    /// Whether a picture of what its rays cost can be made of its scene.
    fn is_hot(&self) -> bool {
        let instant = self.reel.start();
        let still = self.reel.still(&instant);
        !still.flat() && still.space().is_some() && !still.has(Pane::Picture) && self.play.tape.ray().is_some()
    }
}
