//! A pane that is a figure: drawn, hovered and clicked.

use egui::{Rect, Sense, Ui};
use raystep_accel::Place;
use raystep_figure::Look;

use super::page::{Asked, Kept, Page};
use super::space::glam_size;
use crate::shown::beside::Beside;
use crate::shown::pictures::Pane;
use crate::window::look::painter::{paint_figure, place_at};

/// A pane's figure in a rectangle, hovered and clicked.
pub(super) fn figure(
    ui: &mut Ui,
    page: Page<'_>,
    kept: &mut Kept,
    pane: Pane,
    rect: Rect,
    look: &Look,
    asked: &mut Vec<Asked>,
) -> Option<Place> {
    let Page { state, theme, lit, .. } = page;
    let response = ui.allocate_rect(rect, Sense::click());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, pane.name()));
    let Kept { pictures, tree, .. } = kept;
    let code = state.slide().and_then(|slide| state.library.listing(&slide.listing));
    let tests = page.beside.filter(|_| state.beside == Beside::Structure("list"));
    let tests = tests.map(|beside| {
        let step = state.beside_step(beside);
        let name = if step < beside.steps().last() { "brute force, so far" } else { "brute force" };
        (name, beside.tests(step))
    });
    let drawn = pictures.as_mut()?.pane(pane, glam_size(rect), look, code, tree, tests);
    paint_figure(&ui.painter_at(rect), rect.min, drawn, theme, lit);
    let at = |pointer: egui::Pos2| place_at(drawn, rect.min, pointer);
    let under = response.hover_pos().and_then(at);
    let clicked = response.interact_pointer_pos().filter(|_| response.clicked()).map(at);
    let opened = response.double_clicked().then(|| response.interact_pointer_pos().and_then(at)).flatten();
    asked.extend(clicked.map(Asked::Pick));
    // A second click on a node of a tree puts it on top, or the root back.
    if let (Pane::Tree, Some(Place::Node(node))) = (pane, opened) {
        tree.focus = (tree.focus != Some(node) && node.0 != 0).then_some(node);
    }
    under
}
