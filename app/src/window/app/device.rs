//! The device that the window is drawn with, which may be lost.

use egui::ViewportCommand;

use super::{App, Lost};
use crate::window::device::{self, Fate};

impl App {
    /// Draws solid stages with egui's own device. If there was another one before, what is shown goes on on this one.
    pub fn draw_with(&mut self, context: &egui::Context, state: &egui_wgpu::RenderState) {
        self.fate = Fate::of(&state.device, &state.queue, context);
        device::guard(context, &self.fate);
        self.kept.draw_with(Some(state));
        self.speaker.draw_with(Some(state));
        self.underway.upload_to(Some(state.device.clone()), self.state.playback());
    }

    /// If the window was closed since its device is lost: lets go of all that lies on that, and says what was there.
    pub(in crate::window) fn take_lost(&mut self) -> Option<Lost> {
        let lost = self.lost.take()?;
        self.kept.draw_with(None);
        self.speaker.draw_with(None);
        self.held = None;
        self.underway.upload_to(None, None);
        Some(lost)
    }

    /// Says for a while why the window was gone.
    pub(in crate::window) fn is_back(&mut self, context: &egui::Context) {
        self.kept.notices.say(context, "The graphics device was lost. The window is back with everything in it.");
    }

    /// Watches the device: once it is lost, the window closes.
    pub(super) fn watch_device(&mut self, context: &egui::Context) {
        for sentence in self.fate.wrong() {
            self.kept.notices.keep(sentence);
        }
        if self.lost.is_none()
            && let Some(why) = self.fate.lost()
        {
            let window = context.input(|input| input.viewport().clone());
            self.lost = Some(Lost { why, window });
            context.send_viewport_cmd(ViewportCommand::Close);
            context.request_repaint();
        }
    }
}
