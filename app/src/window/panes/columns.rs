//! The panes beside the lesson: space over the ruler and the tree, and the walk, the stack and the work at
//! the right; in a narrow window tree, walk, stack and work share one place behind tabs.

use egui::{Frame, Panel, Ui};
use raystep_accel::Place;
use raystep_figure::{Look, Role};
use raystep_lesson::Plays;

use super::figure::figure;
use super::page::{Asked, Kept, Page};
use super::stage;
use crate::shown::pictures::{Pane, main_pane, shows_bytes};
use crate::shown::state::State;
use crate::window::look::remembered::Remembered;
use crate::window::look::visuals::fill;

/// Below this width of the window tree, walk, stack and work become tabs.
const NARROW: f32 = 1400.0;

fn narrow(ui: &Ui) -> bool {
    ui.ctx().content_rect().width() < NARROW
}

/// The column at the right.
pub(super) fn right(
    ui: &mut Ui,
    page: Page<'_>,
    kept: &mut Kept,
    sizes: &mut Remembered,
    asked: &mut Vec<Asked>,
) -> Option<Place> {
    let whole = ui.ctx().content_rect().width();
    let frame = Frame::new().fill(fill(page.theme, Role::Page));
    let usual = (whole * 0.28).clamp(318.0, 470.0);
    let dragged = sizes.walk;
    let widest = (whole * 0.42).max(300.0);
    let panel = Panel::right(salt("walk", dragged, whole)).frame(frame);
    let panel = panel.default_size(dragged.unwrap_or(usual).min(widest)).size_range(280.0..=widest);
    let shown = panel.show(ui, |ui| {
        let column = if narrow(ui) { tabs } else { stacked };
        column(ui, page, kept, sizes, asked)
    });
    note(ui, &mut sizes.walk, shown.response.rect.width(), usual);
    shown.inner
}

/// Walk, stack and work, one over the other.
fn stacked(
    ui: &mut Ui,
    page: Page<'_>,
    kept: &mut Kept,
    sizes: &mut Remembered,
    asked: &mut Vec<Asked>,
) -> Option<Place> {
    let height = ui.available_height();
    let frame = Frame::new();
    let heights = sizes.heights;
    let work = Panel::bottom(salt("work", heights.work, height))
        .frame(frame)
        .default_size(heights.work.unwrap_or(height * 0.2))
        .size_range(90.0..=height * 0.4);
    let shown = work.show(ui, |ui| pane(ui, page, kept, Pane::Work, asked));
    note(ui, &mut sizes.heights.work, shown.response.rect.height(), height * 0.2);
    let mut under = shown.inner;
    if !has(kept, Pane::Stack) {
        return pane(ui, page, kept, Pane::Listing, asked).or(under);
    }
    let stack = Panel::bottom(salt("stack", heights.stack, height))
        .frame(frame)
        .default_size(heights.stack.unwrap_or(height * 0.22))
        .size_range(70.0..=height * 0.5);
    let shown = stack.show(ui, |ui| pane(ui, page, kept, Pane::Stack, asked));
    note(ui, &mut sizes.heights.stack, shown.response.rect.height(), height * 0.22);
    under = shown.inner.or(under);
    pane(ui, page, kept, Pane::Listing, asked).or(under)
}

/// One of walk, tree, stack and work, chosen by tabs.
fn tabs(ui: &mut Ui, page: Page<'_>, kept: &mut Kept, sizes: &mut Remembered, asked: &mut Vec<Asked>) -> Option<Place> {
    let mut panes = vec![Pane::Listing];
    panes.extend(main(page.state));
    panes.extend([Pane::Stack, Pane::Work].into_iter().filter(|pane| has(kept, *pane)));
    if !panes.contains(&sizes.tab) {
        sizes.tab = Pane::Listing;
    }
    Frame::new().inner_margin(egui::Margin { left: 12, right: 8, top: 8, bottom: 4 }).show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            for tab in &panes {
                let button = egui::Button::selectable(*tab == sizes.tab, tab.name());
                if ui.add(button).clicked() {
                    sizes.tab = *tab;
                }
            }
        });
    });
    // What is short stands under the chosen pane as well.
    let height = ui.available_height();
    let chosen = sizes.tab;
    let below = match chosen {
        Pane::Listing if height > 520.0 && has(kept, Pane::Stack) => Some(Pane::Stack),
        Pane::Listing if height > 520.0 => Some(Pane::Work),
        Pane::Stack if height > 420.0 => Some(Pane::Work),
        _ => None,
    };
    let mut under = None;
    if let Some(below) = below {
        let frame = Frame::new();
        let panel = Panel::bottom("below").frame(frame).exact_size(height * 0.2).resizable(false);
        under = panel.show(ui, |ui| pane(ui, page, kept, below, asked)).inner;
    }
    pane(ui, page, kept, chosen, asked).or(under)
}

/// Space, the ruler, and the tree where there is room for it.
pub(super) fn center(
    ui: &mut Ui,
    page: Page<'_>,
    kept: &mut Kept,
    sizes: &mut Remembered,
    asked: &mut Vec<Asked>,
) -> Option<Place> {
    let height = ui.available_height();
    let frame = Frame::new().fill(fill(page.theme, Role::Panel));
    let mut under = None;
    let heights = sizes.heights;
    if let Some(main) = main(page.state).filter(|_| !narrow(ui)) {
        let usual = height * 0.2;
        let panel = Panel::bottom(salt("tree", heights.tree, height))
            .frame(frame)
            .default_size(heights.tree.unwrap_or(usual))
            .size_range(80.0..=height * 0.5);
        let shown = panel.show(ui, |ui| pane(ui, page, kept, main, asked));
        note(ui, &mut sizes.heights.tree, shown.response.rect.height(), usual);
        under = shown.inner;
    }
    if !has(kept, Pane::Ruler) {
        return stage::stages(ui, page, kept, asked).or(under);
    }
    // The costs of splits are curves and bytes are boxes; intervals are lines, of which four must fit.
    let bytes = bytes(page.state);
    let builds = page.state.slide().is_some_and(|slide| slide.plays == Plays::Build);
    let usual = match () {
        () if bytes => (height * 0.24).clamp(190.0, 220.0),
        () if builds => (height * 0.2).clamp(150.0, 200.0),
        () => (height * 0.15).clamp(112.0, 150.0),
    };
    let ruler = Panel::bottom(salt("ruler", heights.ruler, height))
        .frame(frame)
        .default_size(heights.ruler.unwrap_or(usual))
        .size_range(80.0..=height * 0.4);
    let shown = ruler.show(ui, |ui| pane(ui, page, kept, if bytes { Pane::Bytes } else { Pane::Ruler }, asked));
    note(ui, &mut sizes.heights.ruler, shown.response.rect.height(), usual);
    shown.inner.or(stage::stages(ui, page, kept, asked)).or(under)
}

/// Whether there is anything to show in a pane.
fn has(kept: &Kept, pane: Pane) -> bool {
    kept.pictures.as_ref().is_none_or(|pictures| pictures.has(pane))
}

/// Whether a node's bytes stand where else the ruler does.
pub(super) fn bytes(state: &State) -> bool {
    let show = state.slide().map_or(&[][..], |slide| slide.show.as_slice());
    state.playback().is_some_and(|playback| shows_bytes(playback, show))
}

/// The pane in which the structure of this slide is best seen.
fn main(state: &State) -> Option<Pane> {
    let show = state.slide().map_or(&[][..], |slide| slide.show.as_slice());
    main_pane(state.playback()?, show)
}

/// A pane as large as there is room; says which place the pointer is on.
fn pane(ui: &mut Ui, page: Page<'_>, kept: &mut Kept, pane: Pane, asked: &mut Vec<Asked>) -> Option<Place> {
    let rect = ui.available_rect_before_wrap();
    figure(ui, page, kept, pane, rect, &Look::WINDOW, asked)
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
