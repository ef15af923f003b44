//! The page that is shown, and the speaker's window beside it.

use egui::{Frame, Margin, Panel, Ui};
use raystep_accel::Place;
use raystep_figure::Role;

use super::{App, Held};
use crate::shown::view::RayChoice;
use crate::window::bars::{bottom, top};
use crate::window::look::visuals::fill;
use crate::window::panes::speaker::AskedHere;
use crate::window::panes::{Page, present, study};
use crate::window::{keys, speaker};

impl App {
    /// Shows the bars and does what they ask for; says which place the pointer is on.
    fn bars(&mut self, ui: &mut Ui) -> Option<Place> {
        let theme = self.theme();
        let bar = Frame::new().fill(fill(theme, Role::Page)).inner_margin(Margin::symmetric(16, 0));
        let top = Panel::top("top").exact_size(48.0).frame(bar).resizable(false);
        match top.show(ui, |ui| top::bar(ui, &self.state, theme)).inner {
            Some(top::Asked::Command(command)) => self.run(ui, command),
            Some(top::Asked::Slide(slide)) => self.state.show_slide(slide),
            Some(top::Asked::Ray(ray)) => self.state.show_ray(RayChoice::Named(ray), false),
            Some(top::Asked::Mistake(mistake)) => self.break_it(ui, mistake),
            Some(top::Asked::Theme(theme)) => self.set_theme(theme),
            None => {}
        }
        self.offer_to_go_on(ui);
        let bottom = Panel::bottom("bottom").exact_size(80.0).frame(bar).resizable(false);
        let lit = self.lit();
        let pictures = self.kept.pictures.as_mut();
        let (asked, under) = bottom.show(ui, |ui| bottom::bar(ui, &self.state, pictures, theme, lit)).inner;
        match asked {
            Some(bottom::Asked::Command(command)) => self.run(ui, command),
            Some(bottom::Asked::Step(step)) => {
                self.state.playing = false;
                self.state.go(step);
            }
            Some(bottom::Asked::Symbol(symbol)) => self.state.run_to_symbol(&symbol, keys::shift(ui)),
            None => {}
        }
        under
    }

    /// While another slide or stage is made, what is still shown of the one before fades.
    fn veil(&self, ui: &Ui, room: egui::Rect) {
        let leaves = self.state.leaves();
        let gone = ui.ctx().animate_bool_with_time(egui::Id::unique("veil"), leaves, 0.4);
        if leaves && gone > 0.0 {
            let page = fill(self.theme(), Role::Page);
            ui.painter().rect_filled(room, 0.0, page.gamma_multiply(0.75 * gone));
        }
    }

    /// Shows the panes and does what they ask for.
    pub(super) fn panes(&mut self, ui: &mut Ui) {
        let present = self.state.present;
        let in_bars = if present { None } else { self.bars(ui) };
        let mut asked = Vec::new();
        let room = ui.available_rect_before_wrap();
        let tasks = self.underway.tasks();
        let (heat, counting) = self.underway.heat();
        let held = self.held.as_ref();
        let page = Page {
            state: held.map_or(&self.state, |held| &held.state),
            beside: held.map_or(self.underway.beside(), |held| held.beside.as_ref()),
            mesh: held.map_or(self.underway.mesh(), |held| held.mesh.as_ref()),
            making: self.underway.is_making(),
            tasks: &tasks,
            heat,
            counting,
            lit: self.lit(),
            theme: self.theme(),
        };
        let under = match present {
            true => present::page(ui, page, &mut self.kept, &mut self.marks, &mut asked),
            false => study::page(ui, page, &mut self.kept, &mut self.remembered, &mut asked),
        };
        self.kept.hover(ui, under.or(in_bars));
        self.veil(ui, room);
        // What is held is only looked at.
        if self.held.is_none() {
            self.answer(ui, asked);
        }
    }

    /// Keeps what the class sees while its page is held; what covers it and what points at it goes on.
    pub(super) fn hold(&mut self) {
        let frozen = self.state.present && self.state.lecture.frozen;
        self.held = self.held.take().filter(|_| frozen);
        match &mut self.held {
            Some(held) => held.state.lecture = self.state.lecture.clone(),
            None if frozen => {
                let (beside, mesh) = (self.underway.beside().cloned(), self.underway.mesh().cloned());
                self.held = Some(Held { state: self.state.clone(), beside, mesh });
            }
            None => {}
        }
    }

    /// Shows the speaker's window, if it is open, and does what it asks for. Dialogs open there, where the class does not
    /// see them.
    pub(super) fn speak(&mut self, ui: &Ui) {
        if !self.state.present {
            return self.speaker.end();
        }
        self.speaker.keep_time(&self.state, ui.input(|input| input.time));
        if !self.state.lecture.speaker {
            return self.speaker.rest();
        }
        let size = ui.ctx().content_rect().size().max(egui::vec2(160.0, 90.0));
        let (id, builder) = speaker::viewport(ui.input(|input| input.viewport().monitor_size));
        let context = ui.ctx().clone();
        context.show_viewport_immediate(id, builder, |ui, class| {
            if ui.input(|input| input.viewport().close_requested()) {
                self.state.lecture.speaker = false;
                return;
            }
            // Embedded in the class's window it has the same keys.
            if class != egui::ViewportClass::EmbeddedWindow {
                self.take_keys(ui);
            }
            let tasks = self.underway.tasks();
            let (heat, counting) = self.underway.heat();
            let (theme, making) = (self.theme(), self.underway.is_making());
            let (beside, mesh) = (self.underway.beside(), self.underway.mesh());
            let page =
                Page { state: &self.state, beside, mesh, making, tasks: &tasks, heat, counting, lit: None, theme };
            let asked = self.speaker.show(ui, page, theme, size, &mut self.marks);
            for asked in asked {
                match asked {
                    AskedHere::Wall(asked) => self.answer(ui, vec![asked]),
                    AskedHere::Command(command) => self.run(ui, command),
                    AskedHere::Slide(slide) => self.state.show_slide(slide),
                    AskedHere::Step(step) => {
                        self.state.playing = false;
                        self.state.go(step);
                    }
                    AskedHere::Lengthen(_) | AskedHere::Length(_) | AskedHere::Restart => {}
                }
            }
            self.overlay(ui);
        });
    }
}
