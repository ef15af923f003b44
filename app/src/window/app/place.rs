//! Where the window stands: kept in a file, asked for at the next start, led to by links.

use std::path::PathBuf;
use std::sync::Arc;

use egui::Ui;
use raystep_scene::Scene;

use super::App;
use crate::shown::Link;
use crate::window::bars::go_on;
use crate::window::last::{Keeper, Last, named};

impl App {
    /// Keeps where the window stands in a file from now on. With `reopens` it asks whether to go on where the file says.
    pub fn keep_in(&mut self, file: PathBuf, reopens: bool) {
        if !reopens {
            self.keeper = Some(Keeper::new(file));
            return;
        }
        let (keeper, found) = Keeper::reopening(file);
        self.keeper = Some(keeper);
        found.wrong.into_iter().for_each(|sentence| self.complain(sentence));
        let of_these = |last: &Last| last.is_of(self.lessons.as_deref()) && last.place(&self.state.library).is_some();
        self.offers = found.last.filter(of_these).map(|last| (last, None));
    }

    /// Without the mesh that the window was opened for, it asks whether to go on where it stood, as it else does.
    pub(super) fn give_up_first_mesh(&mut self) {
        if std::mem::take(&mut self.first_mesh)
            && let Some(keeper) = self.keeper.take()
        {
            self.keep_in(keeper.file(), true);
        }
    }

    /// Goes on where the window stood the last time; says whether that was still asked.
    pub fn go_on(&mut self) -> bool {
        let Some((last, _)) = self.offers.take() else { return false };
        if let Some(keeper) = &mut self.keeper {
            keeper.goes_on(&last);
        }
        // What is not there any more is not missed.
        let _ = self.follow(last.link);
        true
    }

    /// Goes where a link leads, once its mesh is there; says what of it is not.
    pub(super) fn follow(&mut self, link: Link) -> Vec<String> {
        let wrong = link.open(&mut self.state, None);
        self.kept.sight.aspect = link.aspect;
        if let Some(mesh) = link.mesh.as_ref().map(PathBuf::from) {
            self.open_mesh(mesh);
            self.reopens = Some(link);
        }
        wrong
    }

    /// The place where the window stands.
    pub fn link(&self) -> Link {
        let shown = |(scene, _): &&(Arc<Scene>, PathBuf)| {
            self.state.view.mesh.as_ref().is_some_and(|mesh| Arc::ptr_eq(mesh, scene))
        };
        let mesh = self.mesh.as_ref().filter(shown).and_then(|(_, path)| named(path));
        Link::of(&self.state, mesh, self.kept.sight.aspect)
    }

    /// Asks whether to go on where the window stood, until somebody answers or does anything else.
    pub(super) fn offer_to_go_on(&mut self, ui: &mut Ui) {
        let theme = self.theme();
        let Some((last, asked_at)) = &mut self.offers else { return };
        let now = self.state.target();
        let asked_at = asked_at.get_or_insert_with(|| now.clone());
        let place = last.place(&self.state.library).filter(|_| asked_at.same_page(now));
        let chosen = place.map_or(Some(go_on::Chosen::Begin), |place| go_on::bar(ui, &place, theme));
        match chosen {
            Some(go_on::Chosen::GoOn) => drop(self.go_on()),
            Some(go_on::Chosen::Begin) => self.offers = None,
            None => {}
        }
    }

    /// Where the window stands; nothing while it goes somewhere else.
    fn stands(&self) -> Option<Last> {
        let stands = self.state.is_current() && self.reopens.is_none() && self.offers.is_none() && !self.first_mesh;
        stands.then(|| Last::of(self.link(), self.lessons.as_deref()))
    }

    /// The window closes: where it stands is kept at once.
    pub fn close(&mut self) {
        if let (Some(now), Some(keeper)) = (self.stands(), &mut self.keeper) {
            keeper.close(now);
        }
    }

    /// Keeps where the window stands now and then.
    pub(super) fn keep_place(&mut self, context: &egui::Context) {
        if self.keeper.is_none() {
            return;
        }
        if let (Some(now), Some(keeper)) = (self.stands(), &mut self.keeper)
            && let Some(waits) = keeper.keep(now)
        {
            context.request_repaint_after(waits);
        }
        if let Some(fault) = self.keeper.as_mut().and_then(Keeper::complaint) {
            self.complain(format!("Where the window stands is not kept: {fault}."));
        }
    }
}
