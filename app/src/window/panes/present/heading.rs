//! The title of the presenter's page, and the way back to the study for whoever has a mouse only.

use egui::{Align2, Rect, Sense, Ui, vec2};
use raystep_figure::{Face, Role, text_width};

use crate::shown::command::Command;
use crate::shown::view::RayChoice;
use crate::window::look::painter::caption;
use crate::window::panes::page::{Asked, Page};

/// The slide's title, and where in the lecture it is. A long title is set smaller.
pub(super) fn show(ui: &Ui, page: Page<'_>, rect: Rect, body: f32) {
    let Some(slide) = page.state.slide() else { return };
    let mut section = format!("{} · {}", slide.section_title(), slide.numbers_text());
    // The slide opens on its first ray; another one is called by its name.
    let rays = page.state.stage().map_or(&[][..], |stage| &stage.rays);
    if let (RayChoice::Named(index @ 1..), None) = (&page.state.view.ray, page.state.view.example) {
        section += &rays.get(*index).map_or_else(String::new, |ray| format!(" · ray \u{201c}{}\u{201d}", ray.name));
    }
    let small = body * 0.68;
    let room = rect.width() - text_width(&section, Face::Regular, small) - body;
    let usual = body * 1.35;
    let size = usual.min(usual * room / text_width(&slide.title, Face::Bold, usual).max(1.0));
    let painter = ui.painter();
    caption(painter, rect.left_center(), Align2::LEFT_CENTER, &slide.title, Face::Bold, size, Role::Text, page.theme);
    let at = rect.right_center();
    caption(painter, at, Align2::RIGHT_CENTER, &section, Face::Regular, small, Role::Quiet, page.theme);
}

/// A button in the lower right corner, seen only while the mouse is there.
pub(super) fn way_back(ui: &mut Ui, page: Page<'_>, rect: Rect, body: f32, asked: &mut Vec<Asked>) {
    let corner = Rect::from_min_max(rect.max - vec2(body * 6.0, body * 2.0), rect.max - vec2(body * 0.4, body * 0.3));
    let back = ui.interact(corner, ui.scope_id().with("back"), Sense::click());
    back.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, "Back to the study page"));
    if back.hovered() {
        let at = corner.right_center();
        let says = "back to study";
        caption(ui.painter(), at, Align2::RIGHT_CENTER, says, Face::Regular, body * 0.6, Role::Here, page.theme);
    }
    if back.clicked() {
        asked.push(Asked::Command(Command::Present));
    }
}
