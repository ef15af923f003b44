//! The speaker's notes over the presenter's page, where there is one screen only.

use egui::{Frame, Margin, Rect, ScrollArea, Ui, UiBuilder, pos2};
use raystep_figure::{Face, Role};

use crate::window::look::prose::{LEADING, Prose};
use crate::window::look::visuals::{fill, line};
use crate::window::panes::page::{Kept, Page};

/// Letters of the notes, in parts of the page's, the first that they fit with; and the part of the page that they have.
const SIZES: [f32; 5] = [0.72, 0.66, 0.6, 0.55, 0.5];
const LEAST: f32 = 0.36;
const MOST: f32 = 0.55;

/// The notes in the lower part of the page: as high and as large as they need.
pub(super) fn over(ui: &mut Ui, page: Page<'_>, kept: &mut Kept, rect: Rect, body: f32) {
    let Some(slide) = page.state.slide() else { return };
    let notes = if slide.notes.is_empty() { "This slide has no notes." } else { &slide.notes };
    let (beside, above) = ((body * 1.4) as i8, (body * 0.6) as i8);
    let set = |size: f32| Prose {
        theme: page.theme,
        size: body * size,
        role: Role::Text,
        face: Face::Regular,
        leading: LEADING,
    };
    let wide = rect.width() - 2.0 * f32::from(beside);
    let mut high = |size: f32| set(size).height(ui, &mut kept.formulas, notes, wide) + 2.0 * f32::from(above);
    let fits = SIZES.into_iter().find(|size| high(*size) <= rect.height() * MOST);
    let size = fits.unwrap_or(SIZES[SIZES.len() - 1]);
    let high = high(size).clamp(rect.height() * LEAST, rect.height() * MOST);
    let below = Rect::from_min_max(pos2(rect.left(), rect.bottom() - high), rect.max);
    ui.painter().rect_filled(below, 0.0, fill(page.theme, Role::Panel));
    ui.painter().hline(below.x_range(), below.top(), line(page.theme, Role::Here));
    let mut child = ui.new_child(UiBuilder::new().max_rect(below));
    Frame::new().inner_margin(Margin::symmetric(beside, above)).show(&mut child, |ui| {
        ScrollArea::vertical().id_salt("notes").auto_shrink(false).show(ui, |ui| {
            ui.set_width(ui.available_width());
            set(size).show(ui, &mut kept.formulas, notes);
        });
    });
}
