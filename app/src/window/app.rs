//! The window: one `ui` that shows the state and turns what happens into commands.

use std::sync::Arc;

use egui::{CentralPanel, Frame, Panel, Ui, ViewportCommand};
use raystep_accel::Place;
use raystep_figure::{Camera, Theme, TreeView};
use raystep_lesson::Library;
use raystep_paint::Mesh;

use super::keys;
use crate::shown::beside::Beside;
use crate::shown::command::Command;
use crate::shown::pictures::Pictures;
use crate::shown::state::State;
use crate::shown::view::RayChoice;
use crate::window::bars::bottom;
use crate::window::bars::top;
use crate::window::dialogs::export;
use crate::window::dialogs::help;
use crate::window::dialogs::open;
use crate::window::dialogs::palette;
use crate::window::dialogs::palette::Palette;
use crate::window::dialogs::toasts::Toasts;
use crate::window::look::formulas::Formulas;
use crate::window::look::remembered::Remembered;
use crate::window::look::visuals;
use crate::window::look::visuals::fill;
use crate::window::panes::columns;
use crate::window::panes::lesson;
use crate::window::panes::present;
use crate::window::panes::solid::Solid;
use crate::window::panes::space::Hold;
use crate::window::work::errands::Errands;
use crate::window::work::second::Second;
use crate::window::work::workshop::{Failure, Made, Workshop};

/// The window.
pub struct App {
    /// What is shown.
    pub state: State,
    pub(super) theme: &'static Theme,
    pub(super) workshop: Workshop,
    pub(super) formulas: Formulas,
    pub(super) pictures: Option<Pictures>,
    pub(super) second: Second,
    pub(super) solid: Solid,
    /// The solid scene on the GPU, where there is one.
    pub(super) mesh: Option<Arc<Mesh>>,
    pub(super) solid_beside: Solid,
    pub(super) hovered: Option<Place>,
    pub(super) picked: Option<Place>,
    pub(super) tree: TreeView,
    pub(super) hold: Option<Hold>,
    /// The aspect (width / height) of the picture in which the camera was moved last.
    pub(super) aspect: f32,
    /// Where space is seen from while a ray is dragged.
    pub(super) still: Option<Camera>,
    /// The size of the picture of space.
    pub(super) space_size: glam::Vec2,
    pub(super) toasts: Toasts,
    pub(super) errands: Errands,
    pub(super) remembered: Remembered,
    pub(super) export: Option<export::Form>,
    pub(super) opening: Option<open::Form>,
    palette: Option<Palette>,
    help: bool,
    styled: Option<&'static str>,
}

impl App {
    /// A window on these lessons, standing on a slide.
    pub fn new(context: &egui::Context, library: Library, slide: usize, remembered: Remembered) -> App {
        context.set_fonts(crate::window::look::fonts::definitions());
        let mut state = State::new(Arc::new(library), slide);
        state.predict = remembered.predict;
        let theme = Theme::named(&remembered.theme).unwrap_or(&Theme::LIGHT);
        context.set_zoom_factor(remembered.zoom);
        App {
            state,
            theme,
            workshop: Workshop::new(context.clone()),
            formulas: Formulas::default(),
            pictures: None,
            second: Second::new(context),
            solid: Solid::default(),
            mesh: None,
            solid_beside: Solid::default(),
            hovered: None,
            picked: None,
            tree: TreeView::default(),
            hold: None,
            aspect: 1.6,
            still: None,
            space_size: glam::Vec2::new(1000.0, 625.0),
            toasts: Toasts::default(),
            errands: Errands::new(context.clone()),
            remembered,
            export: None,
            opening: None,
            palette: None,
            help: false,
            styled: None,
        }
    }

    /// Lets lessons in a folder be read again when they are saved.
    pub fn watch_lessons(&mut self, folder: &std::path::Path) {
        self.errands.watch(folder);
    }

    /// Opens a mesh beside the UI thread.
    pub fn open_mesh(&mut self, path: std::path::PathBuf) {
        self.errands.load(path);
    }

    /// Whether nothing is built beside the UI thread, not even what was given up.
    pub fn is_idle(&self) -> bool {
        self.workshop.is_idle()
    }

    /// Does what a command says.
    pub fn run(&mut self, ui: &Ui, command: Command) {
        let context = ui.ctx();
        match command {
            Command::FullScreen => {
                let full = context.input(|input| input.viewport().fullscreen.unwrap_or(false));
                context.send_viewport_cmd(ViewportCommand::Fullscreen(!full));
            }
            Command::Palette => self.palette = Some(Palette::default()),
            Command::Help => self.help = !self.help,
            Command::Export => self.export = Some(export::Form::of(&self.state, self.theme)),
            Command::Open => self.opening = Some(open::Form::default()),
            Command::Copy => self.copy(),
            Command::Cancel => self.cancel(),
            Command::Theme => {
                let themes = [&Theme::LIGHT, &Theme::DARK, &Theme::PROJECTOR];
                let now = themes.iter().position(|theme| theme.name == self.theme.name).unwrap_or(0);
                self.set_theme(themes[(now + 1) % themes.len()]);
            }
            Command::ZoomIn => egui::gui_zoom::zoom_in(context),
            Command::ZoomOut => egui::gui_zoom::zoom_out(context),
            Command::ZoomReset => context.set_zoom_factor(1.0),
            Command::Frame => self.frame_here(),
            Command::Break => {
                let on = matches!(self.state.beside, Beside::Mistake(_));
                self.break_it(ui, (!on).then_some(0));
            }
            other => self.state.apply(other),
        }
    }

    /// Makes the walk that the state asks for, as far as it is not there.
    fn catch_up(&mut self, ui: &Ui) {
        self.collect(ui);
        match self.state.wanted() {
            Some(wanted) => {
                self.workshop.ask(wanted, &self.state.library);
                self.collect(ui);
            }
            None => {
                self.workshop.cancel();
            }
        }
        self.errands_done(ui);
        self.catch_up_beside(ui);
    }

    fn collect(&mut self, ui: &Ui) {
        match self.workshop.collect() {
            Some(Ok(Made { playback, mesh })) => {
                if self.state.arrive(Arc::new(playback)) {
                    self.mesh = mesh;
                }
            }
            Some(Err(Failure::Cancelled)) => self.state.refuse(),
            Some(Err(Failure::Wrong(sentence))) => {
                self.toasts.say(ui, sentence);
                self.state.refuse();
            }
            None => {}
        }
    }

    /// Gives up everything that is under way: what is shown stays.
    pub(super) fn cancel(&mut self) {
        for task in self.errands.tasks() {
            task.stop();
        }
        if self.workshop.cancel() {
            self.state.refuse();
        }
        if self.second.cancel() {
            self.state.beside = Beside::Nothing;
        }
    }

    pub(super) fn set_theme(&mut self, theme: &'static Theme) {
        self.theme = theme;
        theme.name.clone_into(&mut self.remembered.theme);
    }

    /// The theme's colours and sizes for egui, when they are not set yet.
    fn dress(&mut self, ui: &mut Ui) {
        if self.styled != Some(self.theme.name) {
            self.styled = Some(self.theme.name);
            let style = visuals::style(self.theme);
            for theme in [egui::Theme::Light, egui::Theme::Dark] {
                ui.ctx().set_style_of(theme, style.clone());
            }
            ui.set_style(style);
        }
    }

    /// A click on a place: an answer, or the step at which the walk meets it next.
    pub(super) fn pick(&mut self, place: Option<Place>) {
        if let Some(place) = place.filter(|_| self.state.question().is_some())
            && self.state.answer_place(place)
        {
            return;
        }
        self.picked = place.filter(|place| *place != Place::World);
        let Some(place) = self.picked.filter(|_| self.state.question().is_none()) else { return };
        if let Some(playback) = self.state.playback() {
            let now = self.state.view.step;
            let steps = playback.reel().steps_at(place);
            let next = steps.iter().find(|step| **step > now).or(steps.first()).copied();
            if let Some(step) = next {
                self.state.go(step);
            }
        }
    }

    /// What lights up: where the pointer is, else what was picked.
    pub(super) fn lit(&self) -> Option<Place> {
        self.hovered.or(self.picked)
    }

    fn dialogs(&mut self, ui: &mut Ui) {
        if let Some(palette) = &mut self.palette {
            let (close, chosen) = palette.show(ui, &self.state.library, self.theme);
            if close {
                self.palette = None;
            }
            match chosen {
                Some(palette::Choice::Command(command)) => self.run(ui, command),
                Some(palette::Choice::Slide(slide)) => self.state.show_slide(slide),
                None => {}
            }
        }
        if self.help && help::page(ui, self.theme) {
            self.help = false;
        }
        self.export_dialog(ui);
        self.open_dialog(ui);
        self.underway(ui);
        self.toasts.show(ui, self.theme);
        self.drop_hint(ui);
    }

    fn bars(&mut self, ui: &mut Ui) -> Option<Place> {
        let bar = Frame::new()
            .fill(fill(self.theme, raystep_figure::Role::Page))
            .inner_margin(egui::Margin::symmetric(16, 0));
        let top = Panel::top("top").exact_size(48.0).frame(bar).resizable(false);
        match top.show(ui, |ui| top::bar(ui, &self.state, self.theme)).inner {
            Some(top::Asked::Command(command)) => self.run(ui, command),
            Some(top::Asked::Slide(slide)) => self.state.show_slide(slide),
            Some(top::Asked::Ray(ray)) => self.state.show_ray(RayChoice::Named(ray), false),
            Some(top::Asked::Set(key, value)) => self.state.set(&key, &value),
            Some(top::Asked::Mistake(mistake)) => self.break_it(ui, mistake),
            Some(top::Asked::Theme(theme)) => self.set_theme(theme),
            None => {}
        }
        let bottom = Panel::bottom("bottom").exact_size(80.0).frame(bar).resizable(false);
        let lit = self.lit();
        let (asked, under) =
            bottom.show(ui, |ui| bottom::bar(ui, &self.state, self.pictures.as_mut(), self.theme, lit)).inner;
        match asked {
            Some(bottom::Asked::Command(command)) => self.run(ui, command),
            Some(bottom::Asked::Step(step)) => {
                self.state.playing = false;
                self.state.go(step);
            }
            None => {}
        }
        under
    }

    fn page(&mut self, ui: &mut Ui) {
        let mut under = self.bars(ui);
        let page = Frame::new().fill(fill(self.theme, raystep_figure::Role::Page));
        let width = ui.available_width();
        let widest = (width * 0.34).max(230.0);
        let usual = (width * 0.222).clamp(248.0, 400.0);
        let kept = self.remembered.lesson;
        let left = Panel::left(columns::salt("lesson", kept, width)).frame(page);
        let left = left.default_size(kept.unwrap_or(usual).min(widest)).size_range(220.0..=widest);
        let shown = left.show(ui, |ui| lesson::pane(ui, &self.state, self.theme, &mut self.formulas));
        columns::note(ui, &mut self.remembered.lesson, shown.response.rect.width(), usual);
        if let Some(command) = shown.inner {
            self.run(ui, command);
        }
        under = columns::right(self, ui).or(under);
        let ground = Frame::new().fill(fill(self.theme, raystep_figure::Role::Panel));
        under = CentralPanel::no_frame().frame(ground).show(ui, |ui| columns::center(self, ui)).inner.or(under);
        self.hover(ui, under);
    }

    /// What the pointer is on lights up from the next frame on.
    pub(super) fn hover(&mut self, ui: &Ui, under: Option<Place>) {
        if under != self.hovered {
            self.hovered = under;
            ui.ctx().request_repaint();
        }
    }
}

impl eframe::App for App {
    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        self.dress(ui);
        let busy = self.palette.is_some() || self.help || self.export.is_some() || self.opening.is_some();
        if !busy {
            for command in keys::pressed(ui) {
                self.run(ui, command);
            }
        }
        if ui.input(|input| input.key_pressed(egui::Key::Escape)) && !busy {
            self.picked = None;
            if self.state.present {
                self.state.apply(Command::Present);
            }
        }
        self.catch_up(ui);
        let seconds = ui.input(|input| input.stable_dt).min(0.1);
        if let Some(wait) = self.state.tick(seconds) {
            ui.ctx().request_repaint_after_secs(wait.min(0.1));
        }
        self.pictures = Pictures::of(self.pictures.take(), &self.state);
        let drawn = self.state.stamp();
        if self.state.present {
            present::page(self, ui);
        } else {
            self.page(ui);
        }
        self.dialogs(ui);
        self.remember(ui);
        if self.state.stamp() != drawn {
            // What was clicked shows without waiting for the pointer to move again.
            ui.ctx().request_repaint();
        }
    }
}
