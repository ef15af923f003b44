//! Small pictures of slides that come, made one after the other beside the window.

use std::collections::HashMap;
use std::sync::Arc;

use glam::Vec2;
use raystep_figure::{Figure, Theme};
use raystep_lesson::{Library, Stage, StageKind};

use super::bench::{Bench, Broken};
use super::task::Task;
use crate::export::{Changes, Ground, Session, View};
use crate::shown::all_nodes::AllNodes;

/// The size of a small picture, and of the page that it is laid out on, in points.
pub(crate) const SIZE: Vec2 = Vec2::new(480.0, 300.0);

/// Pictures by the places of slides.
pub(crate) struct Thumbs {
    /// The lessons that they are of.
    library: Option<Arc<Library>>,
    /// Those that are there; of some there is none.
    made: HashMap<Key, Option<Arc<Figure>>>,
    bench: Bench<Key, Drawn>,
}

/// A slide, the stage that is wished for, and the theme.
type Key = (usize, StageKind, &'static str);

/// What a picture came to.
struct Drawn(Option<Figure>);

impl Broken for Drawn {
    /// The sentence stands on the standard error; the slide has no picture.
    fn broken(_: String) -> Drawn {
        Drawn(None)
    }
}

impl Thumbs {
    pub(crate) fn new(context: &egui::Context) -> Thumbs {
        Thumbs { library: None, made: HashMap::new(), bench: Bench::new(context.clone()) }
    }

    /// The picture of a slide, once it is there.
    pub(crate) fn of(&self, slide: usize, wished: StageKind, theme: &Theme) -> Option<&Arc<Figure>> {
        self.made.get(&(slide, wished, theme.name))?.as_ref()
    }

    /// Makes the first of these that is not there.
    pub(crate) fn catch_up(
        &mut self,
        library: &Arc<Library>,
        slides: &[usize],
        wished: StageKind,
        theme: &'static Theme,
    ) {
        while let Some((key, Drawn(figure))) = self.bench.collect() {
            self.made.insert(key, figure.map(Arc::new));
        }
        if !self.library.as_ref().is_some_and(|known| Arc::ptr_eq(known, library)) {
            self.library = Some(library.clone());
            self.made.clear();
            self.bench.cancel();
        }
        if self.bench.wanted().is_some() {
            return;
        }
        let keys = slides.iter().map(|slide| (*slide, wished, theme.name));
        let Some(key) = keys.into_iter().find(|key| !self.made.contains_key(key)) else { return };
        let library = library.clone();
        let task = Task::new("Drawing what comes", "");
        self.bench.begin(key, task, false, move |task| Drawn(drawn(&library, key.0, wished, theme, task)));
    }

    /// Gives up what is being made.
    pub(crate) fn stop(&mut self) {
        self.bench.cancel();
    }

    /// Whether nothing is being made.
    pub(crate) fn is_idle(&self) -> bool {
        self.bench.is_idle()
    }
}

/// The slide where it speaks first, as it would be exported, but measured with few rays only.
fn drawn(library: &Library, slide: usize, wished: StageKind, theme: &Theme, task: &Task) -> Option<Figure> {
    let slide = library.slides.get(slide)?;
    let stage: &Stage = slide.opening_stage(wished)?;
    let built = stage.draft(slide.plays).ok()?;
    let rule = stage.plan.rule(built.scene.flat).ok()?;
    let nodes = Arc::new(AllNodes::of(&built.structure, built.told.as_ref()));
    let own = Changes { scene: None, settings: Vec::new(), own: None, seen: None, depth: None, told: true };
    let go_on = || !task.is_stopped();
    let ground = Ground::new(library, slide, stage, built, rule, nodes, own, &go_on);
    let rays: Vec<_> = stage.rays.iter().take(1).collect();
    let sessions = Session::of_rays(&ground, &rays);
    let session = sessions.first()?;
    let step = session.beats().filter_map(|beat| session.step_of(beat)).min().unwrap_or(0);
    session.figure(View::Space, step, None, SIZE, theme).ok().map(|(figure, _)| figure)
}
