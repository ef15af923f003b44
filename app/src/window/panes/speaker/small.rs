//! A page in small: laid out in its own size, and all of it made smaller, lines and letters too.

use egui::emath::TSTransform;
use egui::{Id, LayerId, Rect, Ui, UiBuilder, Vec2};

/// Shows a page of this size in a smaller place, in the middle of it.
pub(super) fn small<R>(ui: &mut Ui, id: Id, place: Rect, size: Vec2, add: impl FnOnce(&mut Ui) -> R) -> R {
    let scale = (place.width() / size.x).min(place.height() / size.y).max(1e-3);
    let spare = (place.size() - size * scale) * 0.5;
    let layer = LayerId::new(ui.layer_id().order, id);
    ui.ctx().set_sublayer(ui.layer_id(), layer);
    ui.ctx().set_transform_layer(layer, TSTransform::new((place.min + spare).to_vec2(), scale));
    let page = Rect::from_min_size(egui::Pos2::ZERO, size);
    let mut child = ui.new_child(UiBuilder::new().layer_id(layer).max_rect(page).id_salt(id));
    child.set_clip_rect(page);
    add(&mut child)
}
