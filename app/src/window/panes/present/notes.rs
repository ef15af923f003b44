//! The speaker's notes over the presenter's page, where there is one screen only.

use egui::{Frame, Margin, Rect, ScrollArea, Ui, UiBuilder, pos2};
use raystep_figure::{Face, Role};

use crate::window::look::prose::{LEADING, Prose};
use crate::window::look::visuals::{fill, line};
use crate::window::panes::page::{Kept, Page};

/// The notes in the lower third of the page.
pub(super) fn over(ui: &mut Ui, page: Page<'_>, kept: &mut Kept, rect: Rect, body: f32) {
    let Some(slide) = page.state.slide() else { return };
    let notes = if slide.notes.is_empty() { "This slide has no notes." } else { &slide.notes };
    let below = Rect::from_min_max(pos2(rect.left(), rect.bottom() - rect.height() * 0.36), rect.max);
    ui.painter().rect_filled(below, 0.0, fill(page.theme, Role::Panel));
    ui.painter().hline(below.x_range(), below.top(), line(page.theme, Role::Here));
    let mut child = ui.new_child(UiBuilder::new().max_rect(below));
    Frame::new().inner_margin(Margin::symmetric((body * 1.4) as i8, (body * 0.6) as i8)).show(&mut child, |ui| {
        ScrollArea::vertical().id_salt("notes").auto_shrink(false).show(ui, |ui| {
            ui.set_width(ui.available_width());
            let prose =
                Prose { theme: page.theme, size: body * 0.72, role: Role::Text, face: Face::Regular, leading: LEADING };
            prose.show(ui, &mut kept.formulas, notes);
        });
    });
}
