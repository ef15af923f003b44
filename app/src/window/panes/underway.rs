//! What is under way beside the UI thread, in a strip of its own at the foot of the lesson, each with a button that gives
//! it up.

use std::sync::Arc;

use egui::{Align, Frame, Label, Layout, Margin, Panel, ProgressBar, RichText, Ui};
use raystep_figure::{Role, Theme};

use crate::window::look::visuals::{fill, ink};
use crate::window::work::task::Task;

/// Shows what is under way at the foot of `ui`; says what shall be given up.
pub(super) fn strip(ui: &mut Ui, tasks: &[Arc<Task>], theme: &Theme) -> Option<Arc<Task>> {
    if tasks.is_empty() {
        return None;
    }
    ui.ctx().request_repaint_after_secs(0.05);
    let frame = Frame::new().fill(fill(theme, Role::Panel)).inner_margin(Margin::symmetric(22, 8));
    let panel = Panel::bottom("underway").frame(frame).resizable(false).max_size(ui.available_height() * 0.4);
    let mut stopped = None;
    panel.show(ui, |ui| {
        for task in tasks {
            if row(ui, task, theme) {
                stopped = Some(task.clone());
            }
        }
    });
    stopped
}

/// A task, with how far it is below what it says; says whether it shall be given up.
fn row(ui: &mut Ui, task: &Task, theme: &Theme) -> bool {
    let layout = Layout::right_to_left(Align::TOP);
    let cancelled = ui.with_layout(layout, |ui| {
        let cancelled = ui.button("Cancel").clicked();
        ui.with_layout(Layout::top_down(Align::Min), |ui| {
            let says = RichText::new(task.says()).color(ink(theme, Role::Text));
            match task.part() {
                Some(part) => {
                    ui.add(Label::new(says).wrap());
                    let bar = ProgressBar::new(part).desired_width(ui.available_width()).desired_height(6.0);
                    ui.add(bar.fill(ink(theme, Role::Here)));
                }
                None => {
                    ui.horizontal_wrapped(|ui| {
                        ui.spinner();
                        ui.label(says);
                    });
                }
            }
        });
        cancelled
    });
    cancelled.inner
}
