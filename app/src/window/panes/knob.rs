//! Small things that can be moved by keyboard: the ring around them, and the arrows.

use egui::{EventFilter, Id, Key, Pos2, Rect, Response, Sense, Stroke, Ui, WidgetInfo};
use raystep_figure::{Role, Theme};

use crate::window::look::visuals::ink;

/// How near to a knob the pointer must be to take hold of it, in points.
pub(super) const GRIP: f32 = 13.0;

/// A place that can have the focus, with its name; says whether it has.
pub(super) fn knob(ui: &Ui, id: Id, place: Pos2, name: &str, theme: &Theme) -> Option<Response> {
    let around = Rect::from_center_size(place, egui::Vec2::splat(GRIP * 2.0));
    let knob = ui.interact(around, id, Sense::focusable_noninteractive());
    knob.widget_info(|| WidgetInfo::labeled(egui::Role::Slider, true, name));
    if knob.has_focus() {
        ring(ui, place, theme, Role::Here);
        Some(knob)
    } else {
        None
    }
}

/// The arrows that were pressed while something has the focus: which, whether anew, and whether finely.
pub(super) fn arrows(ui: &Ui, id: Id) -> Vec<(Key, bool, bool)> {
    let filter = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(id, filter));
    let arrow = |event: &egui::Event| match *event {
        egui::Event::Key { key, pressed: true, repeat, modifiers, .. } => {
            let arrow = matches!(key, Key::ArrowLeft | Key::ArrowRight | Key::ArrowUp | Key::ArrowDown);
            (arrow && !modifiers.command).then_some((key, !repeat, modifiers.shift))
        }
        _ => None,
    };
    ui.input(|input| input.events.iter().filter_map(arrow).collect())
}

/// A ring around what can be moved.
pub(super) fn ring(ui: &Ui, at: Pos2, theme: &Theme, role: Role) {
    ui.painter().circle_stroke(at, GRIP * 0.5, Stroke::new(2.0, ink(theme, role)));
}
