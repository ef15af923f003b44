//! Walks side by side as they were drawn last.

use std::sync::Arc;

use raystep_figure::{Ask, Figure, Pane};

use crate::shown::playback::Playback;

/// The figure of a step, with what it was drawn of.
pub(crate) struct AbreastKept {
    walks: Arc<Playback>,
    step: usize,
    room: [f32; 3],
    figure: Arc<Figure>,
}

impl AbreastKept {
    /// The walks at a step: as they are kept, if that still is right.
    pub(super) fn of(kept: Option<AbreastKept>, walks: &Arc<Playback>, step: usize, ask: &Ask<'_>) -> AbreastKept {
        let room = [ask.size.x, ask.size.y, ask.look.text];
        if let Some(kept) = kept
            && Arc::ptr_eq(&kept.walks, walks)
            && (kept.step, kept.room) == (step, room)
        {
            return kept;
        }
        let instant = walks.instant(step);
        let figure = Arc::new(walks.reel().still(&instant).draw(Pane::Picture, ask));
        AbreastKept { walks: walks.clone(), step, room, figure }
    }

    /// The figure.
    pub(super) fn figure(&self) -> &Figure {
        &self.figure
    }
}
