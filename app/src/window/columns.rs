//! The panes beside the lesson: space over the ruler and the tree, and the walk, the stack and the work at
//! the right; in a narrow window tree, walk, stack and work share one place behind tabs.

use egui::{Frame, Panel, Rect, Sense, Ui, vec2};
use raystep_accel::Place;
use raystep_figure::{Look, Role};
use raystep_lesson::Plays;

use super::app::App;
use super::painter::{paint_figure, place_at};
use super::pictures::{Pane, main_pane, shows_bytes};
use super::space_pane::glam_size;
use super::stage_pane;
use super::state::Beside;
use super::visuals::fill;

/// Below this width of the window tree, walk, stack and work become tabs.
const NARROW: f32 = 1400.0;

fn narrow(ui: &Ui) -> bool {
    ui.ctx().content_rect().width() < NARROW
}

/// The column at the right.
pub(super) fn right(app: &mut App, ui: &mut Ui) -> Option<Place> {
    let whole = ui.ctx().content_rect().width();
    let frame = Frame::new().fill(fill(app.theme, Role::Page));
    let usual = (whole * 0.28).clamp(318.0, 470.0);
    let kept = app.remembered.walk;
    let widest = (whole * 0.42).max(300.0);
    let panel = Panel::right(salt("walk", kept, whole)).frame(frame);
    let panel = panel.default_size(kept.unwrap_or(usual).min(widest)).size_range(280.0..=widest);
    let shown = panel.show(ui, |ui| if narrow(ui) { tabs(app, ui) } else { stacked(app, ui) });
    note(ui, &mut app.remembered.walk, shown.response.rect.width(), usual);
    shown.inner
}

/// Walk, stack and work, one over the other.
fn stacked(app: &mut App, ui: &mut Ui) -> Option<Place> {
    let height = ui.available_height();
    let frame = Frame::new();
    let sizes = app.remembered.heights;
    let work = Panel::bottom(salt("work", sizes.work, height))
        .frame(frame)
        .default_size(sizes.work.unwrap_or(height * 0.2))
        .size_range(90.0..=height * 0.4);
    let shown = work.show(ui, |ui| pane(app, ui, Pane::Work));
    note(ui, &mut app.remembered.heights.work, shown.response.rect.height(), height * 0.2);
    let mut under = shown.inner;
    if !has(app, Pane::Stack) {
        return pane(app, ui, Pane::Listing).or(under);
    }
    let stack = Panel::bottom(salt("stack", sizes.stack, height))
        .frame(frame)
        .default_size(sizes.stack.unwrap_or(height * 0.22))
        .size_range(70.0..=height * 0.5);
    let shown = stack.show(ui, |ui| pane(app, ui, Pane::Stack));
    note(ui, &mut app.remembered.heights.stack, shown.response.rect.height(), height * 0.22);
    under = shown.inner.or(under);
    pane(app, ui, Pane::Listing).or(under)
}

/// One of walk, tree, stack and work, chosen by tabs.
fn tabs(app: &mut App, ui: &mut Ui) -> Option<Place> {
    let mut panes = vec![Pane::Listing];
    panes.extend(main(app));
    panes.extend([Pane::Stack, Pane::Work].into_iter().filter(|pane| has(app, *pane)));
    if !panes.contains(&app.remembered.tab) {
        app.remembered.tab = Pane::Listing;
    }
    Frame::new().inner_margin(egui::Margin { left: 12, right: 8, top: 8, bottom: 4 }).show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            for tab in &panes {
                let button = egui::Button::selectable(*tab == app.remembered.tab, tab.name());
                if ui.add(button).clicked() {
                    app.remembered.tab = *tab;
                }
            }
        });
    });
    // What is short stands under the chosen pane as well.
    let height = ui.available_height();
    let chosen = app.remembered.tab;
    let below = match chosen {
        Pane::Listing if height > 520.0 && has(app, Pane::Stack) => Some(Pane::Stack),
        Pane::Listing if height > 520.0 => Some(Pane::Work),
        Pane::Stack if height > 420.0 => Some(Pane::Work),
        _ => None,
    };
    let mut under = None;
    if let Some(below) = below {
        let frame = Frame::new();
        let panel = Panel::bottom("below").frame(frame).exact_size(height * 0.2).resizable(false);
        under = panel.show(ui, |ui| pane(app, ui, below)).inner;
    }
    pane(app, ui, chosen).or(under)
}

/// Space, the ruler, and the tree where there is room for it.
pub(super) fn center(app: &mut App, ui: &mut Ui) -> Option<Place> {
    let height = ui.available_height();
    let frame = Frame::new().fill(fill(app.theme, Role::Panel));
    let mut under = None;
    let sizes = app.remembered.heights;
    if let Some(main) = main(app).filter(|_| !narrow(ui)) {
        let usual = height * 0.2;
        let panel = Panel::bottom(salt("tree", sizes.tree, height))
            .frame(frame)
            .default_size(sizes.tree.unwrap_or(usual))
            .size_range(80.0..=height * 0.5);
        let shown = panel.show(ui, |ui| pane(app, ui, main));
        note(ui, &mut app.remembered.heights.tree, shown.response.rect.height(), usual);
        under = shown.inner;
    }
    if !has(app, Pane::Ruler) {
        return stage_pane::stages(app, ui).or(under);
    }
    // The costs of splits are curves and bytes are boxes; intervals are lines, of which four must fit.
    let bytes = bytes(app);
    let builds = app.state.slide().is_some_and(|slide| slide.plays == Plays::Build);
    let usual = match () {
        () if bytes => (height * 0.24).clamp(190.0, 220.0),
        () if builds => (height * 0.2).clamp(150.0, 200.0),
        () => (height * 0.15).clamp(112.0, 150.0),
    };
    let ruler = Panel::bottom(salt("ruler", sizes.ruler, height))
        .frame(frame)
        .default_size(sizes.ruler.unwrap_or(usual))
        .size_range(80.0..=height * 0.4);
    let shown = ruler.show(ui, |ui| pane(app, ui, if bytes { Pane::Bytes } else { Pane::Ruler }));
    note(ui, &mut app.remembered.heights.ruler, shown.response.rect.height(), usual);
    shown.inner.or(stage_pane::stages(app, ui)).or(under)
}

/// Whether there is anything to show in a pane.
fn has(app: &App, pane: Pane) -> bool {
    app.pictures.as_ref().is_none_or(|pictures| pictures.has(pane))
}

/// Whether a node's bytes stand where else the ruler does.
pub(super) fn bytes(app: &App) -> bool {
    let show = app.state.slide().map_or(&[][..], |slide| slide.show.as_slice());
    app.state.playback().is_some_and(|playback| shows_bytes(playback, show))
}

/// The pane in which the structure of this slide is best seen.
fn main(app: &App) -> Option<Pane> {
    let show = app.state.slide().map_or(&[][..], |slide| slide.show.as_slice());
    main_pane(app.state.playback()?, show)
}

/// A pane as large as there is room; says which place the pointer is on.
fn pane(app: &mut App, ui: &mut Ui, pane: Pane) -> Option<Place> {
    let rect = ui.available_rect_before_wrap();
    figure(app, ui, pane, rect, &Look::WINDOW)
}

/// A pane's figure in a rectangle, hovered and clicked.
pub(super) fn figure(app: &mut App, ui: &mut Ui, pane: Pane, rect: Rect, look: &Look) -> Option<Place> {
    let response = ui.allocate_rect(rect, Sense::click());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, pane.name()));
    let mut pictures = app.pictures.take()?;
    let library = app.state.library.clone();
    let code = app.state.slide().and_then(|slide| library.listing(&slide.listing));
    let tests = app.second.shown().filter(|_| app.state.beside == Beside::Structure("list"));
    let tests = tests.map(|beside| ("brute force", beside.tests(app.beside_step(beside))));
    let drawn = pictures.pane(pane, glam_size(rect), look, code, &app.tree, tests);
    paint_figure(&ui.painter_at(rect), rect.min, drawn, app.theme, app.lit());
    let at = |pointer: egui::Pos2| place_at(drawn, rect.min, pointer);
    let under = response.hover_pos().and_then(at);
    let clicked = response.interact_pointer_pos().filter(|_| response.clicked()).map(at);
    let opened = response.double_clicked().then(|| response.interact_pointer_pos().and_then(at)).flatten();
    app.pictures = Some(pictures);
    if let Some(place) = clicked {
        app.pick(place);
    }
    // A second click on a node of a tree puts it on top, or the root back.
    if let (Pane::Tree, Some(Place::Node(node))) = (pane, opened) {
        app.tree.focus = (app.tree.focus != Some(node) && node.0 != 0).then_some(node);
    }
    under
}

/// What egui knows a pane by. A pane that nobody has sized gets its usual size anew with every window size.
pub(super) fn salt(name: &'static str, kept: Option<f32>, room: f32) -> (&'static str, u32) {
    (name, if kept.is_some() { 0 } else { room as u32 })
}

/// Remembers a pane's size once its edge was dragged and let go.
pub(super) fn note(ui: &Ui, kept: &mut Option<f32>, size: f32, usual: f32) {
    let down = ui.input(|input| input.pointer.any_down());
    if !down && (kept.is_some_and(|kept| (kept - size).abs() > 1.5) || kept.is_none() && (size - usual).abs() > 3.0) {
        *kept = Some(size.round());
    }
}

/// A strip at the top of a picture for its name.
pub(super) fn strip(rect: Rect, height: f32) -> (Rect, Rect) {
    (
        Rect::from_min_size(rect.min, vec2(rect.width(), height)),
        Rect::from_min_max(rect.min + vec2(0.0, height), rect.max),
    )
}
