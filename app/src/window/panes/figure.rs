//! A pane that is a figure: drawn, hovered and clicked.

use egui::{Rect, Response, Sense, Ui};
use raystep_accel::Place;
use raystep_figure::{Look, RulerScale};

use super::meter;
use super::moving::Frame;
use super::page::{Asked, Kept, Page};
use super::space::{BORDER, glam_size};
use super::trial;
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
    // The borders of the pane are for dragging them.
    let response = ui.allocate_rect(rect, Sense::hover());
    // A ruler can be stretched and shifted, a cut that is weighed taken in the hand.
    let held = matches!(pane, Pane::Ruler | Pane::RulerLine | Pane::Picture);
    let sense = if held { Sense::click_and_drag() } else { Sense::click() };
    let response = ui.interact(rect.shrink(BORDER), response.id.with("pane"), sense);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, pane.name()));
    let Kept { pictures, tree, moving, sight, .. } = kept;
    let code = state.slide().and_then(|slide| state.library.listing(&slide.listing));
    let tests = page.beside.filter(|_| state.beside == Beside::Structure("list"));
    let tests = tests.map(|beside| {
        let step = state.beside_step(beside);
        let name = if step < beside.steps().last() { "brute force, so far" } else { "brute force" };
        (name, beside.tests(step))
    });
    let pictures = pictures.as_mut()?;
    if pane == Pane::Listing {
        let line = |pointer: egui::Pos2| pictures.line_at(code, glam_size(rect), look, pointer.y - rect.top());
        let clicked = response.interact_pointer_pos().filter(|_| response.clicked()).and_then(line);
        asked.extend(clicked.map(Asked::Line));
        if response.hover_pos().and_then(line).is_some() {
            response
                .clone()
                .on_hover_text_at_pointer("Click: the next time of this line · Shift+click: the time before");
        }
    }
    if let Some(scale) = pictures.scale(pane, glam_size(rect), look) {
        stretch(ui, &response, rect, &scale, state.view.part.is_some(), asked);
    }
    let drawn = pictures.pane(pane, glam_size(rect), look, code, tree, tests);
    let moved = moving.figure(ui, Frame::Pane(pane), rect, &drawn);
    paint_figure(&ui.painter_at(rect), rect.min, &moved.figure, theme, lit);
    if let Some(aloft) = moved.aloft.filter(|aloft| !aloft.marks.is_empty()) {
        let above = egui::LayerId::new(egui::Order::Foreground, egui::Id::unique("motion"));
        paint_figure(&ui.ctx().layer_painter(above), rect.min, &aloft, theme, None);
    }
    if pane == Pane::Picture && state.holdable().is_some() {
        trial::hold(ui, &response, rect, look, pictures, theme, &mut sight.hold, asked);
    }
    if pane == Pane::Picture {
        meter::hold(ui, &response, rect, look, pictures, theme, &mut sight.hold, asked);
    }
    let pixel = |pointer: egui::Pos2| {
        let point = glam::Vec2::new(pointer.x - rect.left(), pointer.y - rect.top());
        pictures.pixel_at(glam_size(rect), look, point)
    };
    let pointed = (pane == Pane::Picture).then(|| response.hover_pos().and_then(pixel)).flatten();
    if let Some(pixel) = pointed {
        if let Some(probe) = pictures.probe(glam_size(rect), look, &pixel) {
            paint_figure(&ui.painter_at(rect), rect.min, &probe, theme, None);
        }
        ui.ctx().set_cursor_icon(egui::CursorIcon::PointingHand);
        if response.clicked() {
            asked.push(Asked::MapPixel(pixel));
        }
        return None;
    }
    let at = |pointer: egui::Pos2| place_at(&drawn, rect.min, pointer);
    let under = response.hover_pos().and_then(at);
    let clicked = response.interact_pointer_pos().filter(|_| response.clicked()).map(at);
    let opened = response.double_clicked().then(|| response.interact_pointer_pos().and_then(at)).flatten();
    asked.extend(clicked.filter(|_| pane != Pane::Listing).map(Asked::Pick));
    // A second click on a node of a tree puts it on top, or the root back.
    if let (Pane::Tree, Some(Place::Node(node))) = (pane, opened) {
        tree.focus = (tree.focus != Some(node) && node.0 != 0).then_some(node);
    }
    under
}

/// The wheel stretches a ruler, a drag shifts what is stretched, and a double click shows all of it again.
fn stretch(ui: &Ui, response: &Response, rect: Rect, scale: &RulerScale, stretched: bool, asked: &mut Vec<Asked>) {
    if stretched && response.double_clicked() {
        asked.extend([Asked::Keep, Asked::Part(None)]);
        return;
    }
    if stretched && response.drag_started() {
        asked.push(Asked::Keep);
    }
    if stretched && response.dragged() && response.drag_delta().x != 0.0 {
        asked.push(Asked::Part(scale.shifted(response.drag_delta().x)));
    }
    let Some(pointer) = response.hover_pos() else { return };
    let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta.y, input.zoom_delta()));
    let factor = (scroll * 0.0025).exp() * pinch;
    if factor == 1.0 {
        return;
    }
    let part = scale.stretched(factor, pointer.x - rect.left());
    // The wheel has no beginning: its first turn can be undone.
    if !stretched && part.is_some() {
        asked.push(Asked::Keep);
    }
    asked.push(Asked::Part(part));
}
