//! One ray through up to four structures: the walk that is shown and those of the user's choice, side by side.

use std::sync::Arc;

use egui::{Rect, Sense, Ui};
use raystep_figure::{Ask, Look};

use super::abreast_kept::AbreastKept;
use super::page::{Kept, Page};
use super::space::glam_size;
use crate::shown::playback::Playback;
use crate::window::look::painter::paint_figure;

/// Shows the walks in a rectangle, as far as they have come along the ray; letters `scale` times as large as usual.
pub(super) fn show(ui: &mut Ui, page: Page<'_>, kept: &mut Kept, walks: &Arc<Playback>, rect: Rect, scale: f32) {
    let response = ui.allocate_rect(rect, Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "Walks side by side"));
    let look = Look { text: Look::WINDOW.text * scale, ..Look::WINDOW };
    let ask = Ask::new(glam_size(rect), look);
    let drawn = AbreastKept::of(kept.abreast.take(), walks, page.state.beside_step(walks), &ask);
    paint_figure(&ui.painter_at(rect), rect.min, drawn.figure(), page.theme, None);
    kept.abreast = Some(drawn);
}
