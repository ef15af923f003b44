//! What a speaker does without the keys: each button names its key.

use egui::{Button, Rect, RichText, Stroke, Ui, UiBuilder, vec2};
use raystep_figure::{Face, Role};

use super::desk::{AskedHere, Desk};
use crate::shown::command::Command;
use crate::shown::lecture::{Cover, InHand};
use crate::window::look::fonts::font;
use crate::window::look::visuals::{fill, ink};

pub(super) fn show(ui: &mut Ui, desk: &Desk<'_>, rect: Rect, asked: &mut Vec<AskedHere>) {
    let theme = desk.wall.theme;
    let lecture = &desk.wall.state.lecture;
    let buttons = [
        (Command::Backward, "Back", false),
        (Command::Onward, "On", false),
        (Command::NextRay, "Other ray", false),
        (Command::Panes, "Other panes", false),
        (Command::Pointer, "Pointer", lecture.in_hand == InHand::Pointer),
        (Command::Pen, "Pen", lecture.in_hand == InHand::Pen),
        (Command::Black, "Black", lecture.cover == Some(Cover::Black)),
        (Command::White, "White", lecture.cover == Some(Cover::White)),
        (Command::Freeze, "Hold", lecture.frozen),
        (Command::Palette, "Find", false),
    ];
    let gap = 6.0;
    let rows = buttons.len().div_ceil(2);
    let size = vec2((rect.width() - gap) * 0.5, ((rect.height() - gap * (rows - 1) as f32) / rows as f32).min(34.0));
    for (index, (command, name, on)) in buttons.into_iter().enumerate() {
        let at = vec2((index % 2) as f32 * (size.x + gap), (index / 2) as f32 * (size.y + gap));
        let place = Rect::from_min_size(rect.min + at, size);
        let key = command.entry().and_then(|entry| entry.presenting.first()).copied().unwrap_or_default();
        let key = key.replace("Page down", "PgDn").replace("Page up", "PgUp");
        let text = RichText::new(name).font(font(Face::Medium, 13.5)).color(ink(theme, Role::Text));
        let hint = RichText::new(key).font(font(Face::Mono, 12.0)).color(ink(theme, Role::Quiet));
        let (ground, edge) = if on { (Role::Ground, Role::Here) } else { (Role::Panel, Role::Edge) };
        let button = Button::new(text).right_text(hint).min_size(size);
        let button = button.fill(fill(theme, ground)).stroke(Stroke::new(1.2, ink(theme, edge)));
        let response = ui.new_child(UiBuilder::new().max_rect(place)).add_sized(size, button);
        response.widget_info(|| egui::WidgetInfo::selected(egui::Role::Button, true, on, command.name()));
        if response.clicked() {
            asked.push(AskedHere::Command(command));
        }
    }
}
