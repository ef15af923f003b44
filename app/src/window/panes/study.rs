//! The study page: the lesson, space, and the figures around it.

use egui::{CentralPanel, Frame, Panel, Ui};
use raystep_accel::Place;
use raystep_figure::Role;

use super::by_hand;
use super::columns;
use super::lesson;
use super::page::{Asked, Kept, Page};
use super::underway;
use crate::window::look::remembered::Remembered;
use crate::window::look::visuals::fill;

/// Shows the page in all the room there is; says which place the pointer is on.
pub(crate) fn page(
    ui: &mut Ui,
    page: Page<'_>,
    kept: &mut Kept,
    sizes: &mut Remembered,
    asked: &mut Vec<Asked>,
) -> Option<Place> {
    let ground = Frame::new().fill(fill(page.theme, Role::Page));
    let width = ui.available_width();
    let widest = (width * 0.34).max(230.0);
    let usual = (width * 0.222).clamp(248.0, 400.0);
    let dragged = sizes.lesson;
    let left = Panel::left(columns::salt("lesson", dragged, width)).frame(ground);
    let left = left.default_size(dragged.unwrap_or(usual).min(widest)).size_range(220.0..=widest);
    let shown = left.show(ui, |ui| {
        if page.state.by_hand {
            let height = ui.available_height();
            let below = Panel::bottom("by hand").frame(Frame::new()).default_size(height * 0.46);
            let below = below.size_range(120.0..=height * 0.7);
            below.show(ui, |ui| by_hand::pane(ui, page.state, page.theme, asked));
        }
        // Above what is set by hand: nothing moves away under the hand that sets it.
        asked.extend(underway::strip(ui, page.tasks, page.theme).map(Asked::Stop));
        kept.notices.strip(ui, page.theme);
        lesson::pane(ui, page.state, page.theme, &mut kept.formulas, asked);
    });
    columns::note(ui, &mut sizes.lesson, shown.response.rect.width(), usual);
    let under = columns::right(ui, page, kept, sizes, asked);
    let ground = Frame::new().fill(fill(page.theme, Role::Panel));
    let center = CentralPanel::no_frame().frame(ground);
    center.show(ui, |ui| columns::center(ui, page, kept, sizes, asked)).inner.or(under)
}
