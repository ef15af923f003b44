//! What of all views a walk has, and what is said of one that it lacks.

use clap::ValueEnum;
use raystep_figure::Pane;

use super::{Format, Order, Piece, Session, View};

impl Session<'_> {
    /// Why an order cannot be drawn: the view or a pane that is missing, and what there is instead; nothing if it can.
    pub(super) fn missing(&self, order: &Order) -> Option<String> {
        if order.format == Format::Json {
            return None;
        }
        // A plate shows its panes; what is drawn in a way of its own stands alone.
        let reel = self.reel();
        let stands = |view: View| self.has(view) && view.pane().is_none_or(|pane| reel.has(pane));
        let piece = order.pieces.iter().find_map(|piece| match piece {
            Piece::View(view) if !stands(*view) => Some(*view),
            _ => None,
        });
        let missing = piece.or(Some(order.view).filter(|view| !self.has(*view)))?;
        let there = View::value_variants().iter().filter(|view| self.has(**view)).map(|view| view.name());
        let there: Vec<&str> = there.collect();
        Some(format!("{} has no view \"{}\"; there are {}", self.file_stem(), missing.name(), there.join(", ")))
    }

    fn has(&self, view: View) -> bool {
        let (reel, structure) = (self.reel(), &self.play.structure);
        let Some(pane) = view.pane() else { return true };
        // What is there in general may have nothing to show in this walk.
        let shows = match view {
            View::Tree => structure.node_count() > 0,
            View::Cells => structure.grid().is_some(),
            View::Slabs => self.play.tape.events().any(|event| {
                let name = event.name();
                name.starts_with("slab.") || name == "roots" || name == "clip"
            }),
            View::Listing => {
                let listing = self.ground.library.listing(&self.ground.listing);
                listing.is_some_and(|listing| !listing.lines.is_empty())
            }
            View::Heat => return reel.has(Pane::Heat) || self.is_hot(),
            _ => true,
        };
        shows && reel.has(pane)
    }

    /// Whether a picture of what its rays cost can be made of its scene.
    fn is_hot(&self) -> bool {
        let reel = self.reel();
        let instant = reel.start();
        let still = reel.still(&instant);
        !still.flat() && still.space().is_some() && !still.has(Pane::Picture) && self.play.tape.ray().is_some()
    }
}
