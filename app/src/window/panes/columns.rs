//! The panes beside the lesson: space over the ruler and the tree, and the walk, what changed, the stack and the work
//! at the right; in a narrow window what is not the walk shares one place below it behind tabs.

use egui::{Frame, Panel, Ui};
use raystep_accel::Place;
use raystep_figure::{Look, Role, listing_height};
use raystep_lesson::{Plays, Show};

use super::figure::figure;
use super::page::{Asked, Kept, Page};
use super::stage;
use crate::shown::beside::Beside;
use crate::shown::pictures::{Pane, Pictures, main_pane, shows_bytes};
use crate::shown::state::State;
use crate::window::look::remembered::Remembered;
use crate::window::look::visuals::{fill, ink};

/// Below this width of the window what changed, the stack and the work share one place behind tabs.
const NARROW: f32 = 1400.0;

/// Below this height of the page the tree stands behind a tab as well.
const LOW: f32 = 540.0;

/// Most of the height that the walk takes of itself, and the least height of a row, of that of the stack, in which two
/// can be seen, of the work, which has three lines and two more where a walk stands beside, and of what stands behind tabs.
const WALK: f32 = 0.66;
const ROW: f32 = 70.0;
const STACK: f32 = 104.0;
const WORK: f32 = 102.0;
const BESIDE: f32 = 46.0;
const TABS: f32 = 124.0;

/// The height in which the walk stands whole.
fn walk(state: &State) -> f32 {
    let listing = state.slide().and_then(|slide| state.library.listing(&slide.listing));
    listing.map_or(0.0, |listing| listing_height(listing.lines.len(), &Look::WINDOW))
}

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
    // A board needs all the room, and nothing runs beside it. Walks side by side have their own trees and stacks.
    if abreast(page.state)
        || ![Pane::Listing, Pane::Changed, Pane::Stack, Pane::Work].into_iter().any(|pane| has(kept, pane))
    {
        return None;
    }
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

/// The walk, what changed, the stack and the work, one over the other.
fn stacked(
    ui: &mut Ui,
    page: Page<'_>,
    kept: &mut Kept,
    sizes: &mut Remembered,
    asked: &mut Vec<Asked>,
) -> Option<Place> {
    let height = ui.available_height();
    let heights = &mut sizes.heights;
    let mut rows = vec![
        (Pane::Work, "work", &mut heights.work, 0.148),
        (Pane::Stack, "stack", &mut heights.stack, 0.135),
        (Pane::Changed, "changed", &mut heights.changed, 0.142),
    ];
    rows.retain(|(shown, ..)| has(kept, *shown));
    // What follows from what is shown is higher, but the walk has its room first.
    let own = |pane: Pane| kept.pictures.as_ref().and_then(|pictures| pictures.height(pane, &Look::WINDOW));
    let wanted =
        |(shown, _, _, part): &(Pane, _, _, f32)| (height * part).max(own(*shown).unwrap_or(0.0).min(height * 0.38));
    let wanted: Vec<f32> = rows.iter().map(wanted).collect();
    let left = height - walk(page.state).min(height * WALK);
    let scale = (left / wanted.iter().sum::<f32>()).min(1.0);
    let least = |shown: Pane| match shown {
        Pane::Work if page.state.beside != Beside::Nothing => WORK + BESIDE,
        Pane::Work => WORK,
        // The walk has its room first.
        Pane::Stack if left >= ROW + STACK + WORK => STACK,
        _ => ROW,
    };
    let usual = rows.iter().zip(wanted).map(|((shown, ..), wanted)| (wanted * scale).max(least(*shown)));
    let mut usual: Vec<f32> = usual.collect();
    // What needs more than its part has it from what changed.
    let over = (usual.iter().sum::<f32>() - left).max(0.0);
    if let Some(changed) = rows.iter().position(|(shown, ..)| *shown == Pane::Changed) {
        usual[changed] = (usual[changed] - over).max(ROW);
    }
    let mut under = None;
    for ((shown, name, size, _), usual) in rows.into_iter().zip(usual) {
        let panel = Panel::bottom(salt(name, *size, usual))
            .frame(Frame::new())
            .resizable(true)
            .default_size(size.unwrap_or(usual))
            .size_range(ROW..=height * 0.4);
        let shown = panel.show(ui, |ui| pane(ui, page, kept, shown, asked));
        note(ui, size, shown.response.rect.height(), usual);
        under = shown.inner.or(under);
    }
    pane(ui, page, kept, Pane::Listing, asked).or(under)
}

/// The walk, and below it one of what changed, the stack and the work, chosen by tabs; in a low window also the tree.
fn tabs(ui: &mut Ui, page: Page<'_>, kept: &mut Kept, sizes: &mut Remembered, asked: &mut Vec<Asked>) -> Option<Place> {
    let height = ui.available_height();
    let low = height < LOW;
    let mut panes = vec![Pane::Changed];
    panes.extend(main(page.state).filter(|_| low));
    panes.extend([Pane::Stack, Pane::Work]);
    panes.retain(|pane| has(kept, *pane));
    let Some(&first) = panes.first() else { return pane(ui, page, kept, Pane::Listing, asked) };
    if !panes.contains(&sizes.tab) {
        sizes.tab = first;
    }
    let usual = match low {
        true => height * 0.44,
        false => (height * 0.28).max(176.0).min((height - walk(page.state)).max(TABS)),
    };
    let below = Panel::bottom(salt("tabs", sizes.heights.tabs, usual))
        .frame(Frame::new())
        .resizable(true)
        .default_size(sizes.heights.tabs.unwrap_or(usual))
        .size_range(110.0..=height * 0.7);
    let shown = below.show(ui, |ui| {
        Frame::new().inner_margin(egui::Margin { left: 8, right: 8, top: 7, bottom: 0 }).show(ui, |ui| {
            ui.horizontal(|ui| {
                ui.spacing_mut().item_spacing.x = 2.0;
                ui.spacing_mut().button_padding.x = 9.0;
                for tab in &panes {
                    let button = egui::Button::selectable(*tab == sizes.tab, tab.name());
                    if ui.add(button).clicked() {
                        sizes.tab = *tab;
                    }
                }
                let since = kept.pictures.as_ref().and_then(Pictures::since).filter(|_| sizes.tab == Pane::Changed);
                if let Some(since) = since {
                    ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                        let says =
                            egui::RichText::new(format!("since {since}")).small().color(ink(page.theme, Role::Quiet));
                        ui.add(egui::Label::new(says).truncate());
                    });
                }
            });
        });
        // Its name stands on the tab already.
        let rect = ui.available_rect_before_wrap();
        figure(ui, page, kept, sizes.tab, rect, &Look { titles: false, ..Look::WINDOW }, asked)
    });
    note(ui, &mut sizes.heights.tabs, shown.response.rect.height(), usual);
    pane(ui, page, kept, Pane::Listing, asked).or(shown.inner)
}

/// Space, the ruler, and the tree where there is room for it.
pub(super) fn center(
    ui: &mut Ui,
    page: Page<'_>,
    kept: &mut Kept,
    sizes: &mut Remembered,
    asked: &mut Vec<Asked>,
) -> Option<Place> {
    if abreast(page.state) {
        return stage::stages(ui, page, kept, asked);
    }
    let height = ui.available_height();
    let frame = Frame::new().fill(fill(page.theme, Role::Panel));
    let mut under = None;
    let heights = sizes.heights;
    if let Some(main) = main(page.state).filter(|_| !narrow(ui) || height >= LOW) {
        // A small tree gets the room to stand there whole.
        let whole = kept.pictures.as_ref().and_then(|pictures| pictures.height(main, &Look::WINDOW)).unwrap_or(0.0);
        let usual = (height * 0.2).max(whole.min(height * 0.32));
        let panel = Panel::bottom(salt("tree", heights.tree, usual))
            .frame(frame)
            .resizable(true)
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
    let builds = page.state.slide().is_some_and(|slide| !slide.plays.has_rays());
    let usual = match () {
        // What a slide is about gets the room.
        () if bytes && shows_first(page.state, Show::Bytes) => (height * 0.42).clamp(220.0, 360.0),
        () if bytes => (height * 0.26).clamp(200.0, 240.0),
        // A row a ray.
        () if packet(page.state) => {
            let own = kept.pictures.as_ref().and_then(|pictures| pictures.height(Pane::Ruler, &Look::WINDOW));
            own.unwrap_or(0.0).clamp(112.0, (height * 0.26).max(112.0))
        }
        () if builds => (height * 0.2).clamp(150.0, 200.0),
        () => (height * 0.15).clamp(112.0, 150.0),
    };
    // Bytes have a height of their own.
    let remembered = if bytes { &mut sizes.heights.bytes } else { &mut sizes.heights.ruler };
    let ruler = Panel::bottom(salt(if bytes { "bytes" } else { "ruler" }, *remembered, height))
        .frame(frame)
        .resizable(true)
        .default_size(remembered.unwrap_or(usual))
        .size_range(80.0..=height * 0.5);
    let shown = ruler.show(ui, |ui| pane(ui, page, kept, if bytes { Pane::Bytes } else { Pane::Ruler }, asked));
    note(ui, remembered, shown.response.rect.height(), usual);
    shown.inner.or(stage::stages(ui, page, kept, asked)).or(under)
}

/// Whether several other structures stand beside the walk.
fn abreast(state: &State) -> bool {
    matches!(state.beside, Beside::Abreast(_)) && state.heat().is_none()
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

/// Whether several rays walk together.
fn packet(state: &State) -> bool {
    state.slide().is_some_and(|slide| slide.plays == Plays::Packet)
}

/// Whether a slide is most of all about a pane.
fn shows_first(state: &State, show: Show) -> bool {
    state.slide().is_some_and(|slide| slide.show.first() == Some(&show))
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
