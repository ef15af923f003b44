//! Commands, and the keys that stand for them.

use std::sync::Arc;

use egui::{Ui, ViewportCommand, ViewportId};
use raystep_figure::Theme;
use raystep_lesson::Slide;
use raystep_scene::Scene;

use super::App;
use crate::fault::Fault;
use crate::rating::rays;
use crate::shown::beside::Beside;
use crate::shown::command::Command;
use crate::window::keys;
use crate::window::panes::Kept;
use crate::window::work::exporting::{self, Window, Wish};

/// Rays across and down by which all structures are measured.
const JUDGED: [u32; 2] = [160, 120];

impl App {
    /// Does what the keys say, while no dialog has them.
    pub(super) fn take_keys(&mut self, ui: &Ui) {
        // A press goes on from a page that was seen: one that came before the page was drawn is none.
        let page = (self.state.view.slide, self.state.view.stage);
        let mut unseen = self.seen.replace(page) != Some(page) && self.state.present;
        // What is open on the speaker's window leaves the class's window to the clicker.
        let wall = self.state.present && self.state.lecture.speaker && !ui.ctx().embed_viewports();
        let aside = wall && ui.ctx().viewport_id() == ViewportId::ROOT;
        if aside && self.overlay.is_open() && ui.input(|input| input.key_pressed(egui::Key::Escape)) {
            self.overlay.close();
            return;
        }
        let busy = self.overlay.is_open() && !aside;
        let escape = ui.input(|input| input.key_pressed(egui::Key::Escape)) && !busy;
        // What is held goes back to where it was, and nothing else happens.
        let takes_back = escape && self.kept.sight.let_go();
        if takes_back {
            self.state.take_back();
        } else if !busy {
            let (events, focused) = keys::events(ui);
            for event in events {
                // What a key means depends on what was typed before it, be it in the same frame.
                let typing = self.state.letters_of_number();
                if let Some(command) = keys::given_by(&event, focused, self.state.present, &typing) {
                    let goes = matches!(command, Command::Onward | Command::Backward);
                    if !(goes && unseen) {
                        self.run(ui, command);
                    }
                    unseen |= self.state.present && goes;
                }
            }
        }
        if escape && !takes_back {
            self.state.picked = None;
            if self.state.lecture.cover.take().is_none() && self.state.present {
                self.state.apply(Command::Present);
            }
        }
    }

    /// Does what a command says.
    pub fn run(&mut self, ui: &Ui, command: Command) {
        let context = ui.ctx();
        if self.kept.pages.turn(&self.state, command) {
            context.request_repaint();
            return;
        }
        match command {
            // The class sees no dialog: they open on the speaker's window, or in the study.
            Command::Palette | Command::Help | Command::Export | Command::Open | Command::Best
                if self.state.present && !self.state.lecture.speaker => {}
            Command::Skip if self.go_on() => {}
            Command::FullScreen => {
                let full = context.input(|input| input.viewport().fullscreen.unwrap_or(false));
                context.send_viewport_cmd(ViewportCommand::Fullscreen(!full));
            }
            Command::Palette => self.overlay.find(),
            Command::Help => self.overlay.help(self.state.present),
            Command::Export => self.overlay.export(&self.state, self.theme()),
            Command::Open => self.overlay.open(),
            Command::Copy => self.copy(),
            Command::Link => {
                let link = self.link().to_string();
                self.say(ui, format!("The link is on the clipboard: {link}"));
                context.copy_text(link);
            }
            Command::Cancel => self.underway.stop_all(&mut self.state),
            Command::Theme => {
                let themes = [&Theme::LIGHT, &Theme::DARK, &Theme::PROJECTOR];
                let now = themes.iter().position(|theme| theme.name == self.theme().name).unwrap_or(0);
                self.set_theme(themes[(now + 1) % themes.len()]);
            }
            Command::ZoomIn => egui::gui_zoom::zoom_in(context),
            Command::ZoomOut => egui::gui_zoom::zoom_out(context),
            Command::ZoomReset => context.set_zoom_factor(1.0),
            Command::Frame => self.frame_here(),
            Command::Best => self.judge(ui),
            Command::Offer(offer) if self.state.offers_best(offer) => self.judge(ui),
            Command::Heat => {
                self.state.apply(command);
                if self.state.is_current() && !self.state.can_heat() {
                    self.say(ui, "A heat map needs a solid scene and a structure; this slide has none.");
                }
            }
            Command::Break => {
                let on = matches!(self.state.beside, Beside::Mistake(_));
                self.break_it(ui, (!on).then_some(0));
            }
            other => self.go(ui, other),
        }
    }

    /// Does what changes the state alone, and says what is not where it was expected.
    fn go(&mut self, ui: &Ui, command: Command) {
        let typed = if command == Command::Skip { self.state.lecture.typed.clone() } else { String::new() };
        let stood = self.state.target().clone();
        let left = self.state.slide().map(Slide::id);
        self.state.apply(command);
        if !typed.is_empty() && self.state.library.numbered(&typed).is_none() {
            self.say(ui, format!("There is no slide {typed}."));
        }
        let now = self.state.target();
        if let (Some(mesh), Some(left), None) = (stood.mesh, left, &now.mesh)
            && now.slide != stood.slide
            && !self.state.present
        {
            self.say(ui, format!("{} stays on slide {left}; Ctrl+O opens it here.", mesh.title));
        }
    }

    /// Measures all structures over the mesh that was opened last, or the solid scene that is shown, or the teapot.
    fn judge(&mut self, ui: &Ui) {
        let shown = self.state.playback().map(|playback| playback.play.scene.clone());
        let mesh = self.mesh.as_ref().map(|(mesh, _)| mesh.clone());
        let scene = mesh.or(shown.filter(|scene| !scene.flat));
        let scene = scene.or_else(|| Scene::named("teapot-6321").ok().map(Arc::new));
        let Some(scene) = scene else { return };
        let camera = self.kept.sight.camera_of(&self.state, &scene);
        match rays(&camera, JUDGED) {
            Ok(rays) => {
                self.underway.judging.begin(scene, rays);
                self.overlay.best();
            }
            Err(error) => self.say(ui, format!("The camera shoots no rays: {error}.")),
        }
    }

    /// Moves the camera to where the walk stands.
    fn frame_here(&mut self) {
        let Kept { pictures, sight, .. } = &mut self.kept;
        let seen = pictures.as_ref().and_then(|pictures| sight.framed(&self.state, pictures));
        if let Some(seen) = seen {
            sight.aspect = seen.aspect;
            self.state.look(Some(seen.camera));
        }
    }

    /// Shows a mistake beside the walk, on a ray where it shows; or none.
    pub(super) fn break_it(&mut self, ui: &Ui, mistake: Option<usize>) {
        if let Some(consequence) = self.underway.break_it(&mut self.state, mistake) {
            self.say(ui, consequence);
        }
        self.catch_up_beside(ui);
    }

    /// Writes files beside the UI thread.
    pub(super) fn write(&mut self, wish: Wish) -> Result<(), Fault> {
        let window = Window::of(&self.state, self.kept.sight.aspect)?;
        exporting::write(&mut self.underway.errands, window, wish);
        Ok(())
    }

    /// Puts the picture of space on the clipboard, as it would be exported.
    fn copy(&mut self) {
        let sight = &self.kept.sight;
        let window = Window::of(&self.state, sight.aspect);
        exporting::copy(
            &mut self.underway.errands,
            window,
            self.state.view.step,
            sight.size * 2.0,
            self.themes[usize::from(self.state.present)],
        );
    }
}
