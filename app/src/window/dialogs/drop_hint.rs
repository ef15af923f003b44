//! What dropping files on the window does, while they are held over it.

use egui::{Align2, Id, LayerId, Order, StrokeKind, Ui};
use raystep_figure::{Face, Role, Theme};

use crate::window::look::painter::caption;
use crate::window::look::visuals::{fill, line};

/// Shows the hint while files are held over the window.
pub(super) fn show(ui: &Ui, theme: &Theme) {
    if ui.input(|input| input.raw.hovered_files.is_empty()) {
        return;
    }
    let rect = ui.ctx().content_rect();
    let painter = ui.ctx().layer_painter(LayerId::new(Order::Foreground, Id::unique("drop hint")));
    painter.rect_filled(rect, 0.0, fill(theme, Role::Page).gamma_multiply(0.85));
    painter.rect_stroke(rect.shrink(14.0), 10.0, line(theme, Role::Here), StrokeKind::Inside);
    let says = "Drop an OBJ file: a ray walks through it";
    caption(&painter, rect.center(), Align2::CENTER_CENTER, says, Face::Medium, 22.0, Role::Text, theme);
}
