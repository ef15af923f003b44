//! What the pane of heat maps keeps from frame to frame.

use std::sync::Arc;

use raystep_fast::FastKind;
use raystep_figure::{Ask, Figure, Pane};
use raystep_scene::Scene;

use crate::shown::heat::{Heated, Walked, Wish};

/// What is asked for, and what was drawn.
#[derive(Default)]
pub(crate) struct HeatKept {
    /// What is asked for, until somebody takes it.
    wish: Option<Wish>,
    /// What was asked for last.
    last: Option<Wish>,
    /// The structure at full speed that stands beside, and over what it is built.
    fast: Option<(Arc<Scene>, FastKind, Walked)>,
    /// The maps as they were drawn, in a room of this size with such letters.
    drawn: Option<(Arc<Heated>, [f32; 3], Arc<Figure>)>,
}

impl HeatKept {
    /// Asks for a map. Says whether it is another one than in the last frame.
    pub(super) fn ask_for(&mut self, wish: Wish) -> bool {
        let other = !self.last.as_ref().is_some_and(|last| last.is_same(&wish));
        self.last = Some(wish.clone());
        self.wish = Some(wish);
        other
    }

    /// A structure at full speed over a scene: the same one as long as neither changes; nothing over other shapes than
    /// triangles.
    pub(super) fn fast(&mut self, scene: &Arc<Scene>, kind: FastKind) -> Option<Walked> {
        let fits = |(over, own, _): &&(Arc<Scene>, FastKind, _)| Arc::ptr_eq(over, scene) && *own == kind;
        if self.fast.as_ref().filter(fits).is_none() {
            self.fast = Some((scene.clone(), kind, Walked::fast(scene, kind)?));
        }
        self.fast.as_ref().map(|(.., walked)| walked.clone())
    }

    /// What the pane has asked for in the last frame.
    pub(crate) fn take_wish(&mut self) -> Option<Wish> {
        self.wish.take()
    }

    /// The maps' figure: drawn once, as long as nothing has changed.
    pub(super) fn figure(&mut self, heated: &Arc<Heated>, ask: &Ask<'_>) -> Arc<Figure> {
        let key = [ask.size.x, ask.size.y, ask.look.text];
        let fits = |(drawn, own, _): &&(Arc<Heated>, [f32; 3], _)| Arc::ptr_eq(drawn, heated) && *own == key;
        if let Some((_, _, figure)) = self.drawn.as_ref().filter(fits) {
            return figure.clone();
        }
        let figure = Arc::new(heated.reel().still(&heated.instant()).draw(Pane::Picture, ask));
        self.drawn = Some((heated.clone(), key, figure.clone()));
        figure
    }
}
