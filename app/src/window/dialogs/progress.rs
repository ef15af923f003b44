//! What is under way beside the UI thread, on a strip over the foot of the page, each with a button that gives it up.

use std::sync::Arc;

use egui::{Area, Frame, Id, Order, ProgressBar, RichText, Ui, vec2};
use raystep_figure::{Role, Theme};

use crate::window::look::visuals::ink;
use crate::window::work::task::Task;

/// Shows what is under way; says what shall be given up.
pub(super) fn strip(ui: &Ui, tasks: &[Arc<Task>], theme: &Theme) -> Option<Arc<Task>> {
    if tasks.is_empty() {
        return None;
    }
    ui.ctx().request_repaint_after_secs(0.05);
    let area = Area::new(Id::unique("underway")).order(Order::Foreground);
    let area = area.fade_in(false).anchor(egui::Align2::CENTER_BOTTOM, vec2(0.0, -92.0));
    area.show(ui.ctx(), |ui| Frame::popup(ui.style()).show(ui, |ui| rows(ui, tasks, theme)).inner).inner
}

/// A row for each task; says which shall be given up.
fn rows(ui: &mut Ui, tasks: &[Arc<Task>], theme: &Theme) -> Option<Arc<Task>> {
    let mut stopped = None;
    for task in tasks {
        ui.horizontal(|ui| {
            match task.part() {
                Some(part) => {
                    let bar = ProgressBar::new(part).desired_width(90.0).desired_height(6.0);
                    ui.add(bar.fill(ink(theme, Role::Here)));
                }
                None => {
                    ui.spinner();
                }
            }
            ui.label(RichText::new(task.says()));
            if ui.button("Cancel").clicked() {
                stopped = Some(task.clone());
            }
        });
    }
    stopped
}
