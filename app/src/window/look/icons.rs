//! Buttons whose faces are drawn, not written.

use egui::{Painter, Pos2, Rect, Response, Role, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo, pos2, vec2};

/// A face of a button.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Icon {
    First,
    Previous,
    Play,
    Pause,
    Next,
    Last,
    Left,
    Right,
    More,
    Close,
}

/// A square button with a drawn face; `name` is what a screen reader says and a tooltip shows.
pub(crate) fn icon_button(ui: &mut Ui, icon: Icon, name: &str, tip: &str, loud: bool, side: f32) -> Response {
    let (rect, response) = ui.allocate_exact_size(Vec2::splat(side), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, ui.is_enabled(), name));
    if ui.is_rect_visible(rect) {
        let visuals = *ui.style().interact(&response);
        let selection = ui.visuals().selection.stroke.color;
        let (ground, face) = match (loud, response.hovered()) {
            (true, _) => (selection, ui.visuals().extreme_bg_color),
            (false, true) => (visuals.bg_fill, visuals.text_color()),
            (false, false) => (ui.visuals().faint_bg_color, visuals.text_color()),
        };
        let stroke = if response.hovered() || response.has_focus() { visuals.bg_stroke } else { Stroke::NONE };
        ui.painter().rect(rect, 5.0, ground, stroke, egui::StrokeKind::Inside);
        draw(ui.painter(), icon, rect.center(), side * 0.2, face);
    }
    response.on_hover_text(tip)
}

/// Draws a face around `at`; `unit` is half its height.
fn draw(painter: &Painter, icon: Icon, at: Pos2, unit: f32, color: egui::Color32) {
    let triangle = |left: f32, right: f32| {
        let corners = vec![at + vec2(left, -unit), at + vec2(right, 0.0), at + vec2(left, unit)];
        painter.add(Shape::convex_polygon(corners, color, Stroke::NONE));
    };
    let bar = |x: f32| {
        let rect = Rect::from_center_size(pos2(at.x + x, at.y), vec2(unit * 0.38, unit * 2.0));
        painter.rect_filled(rect, 0.0, color);
    };
    let chevron = |tip: f32| {
        let points = vec![at + vec2(-tip, -unit * 0.7), at + vec2(tip, 0.0), at + vec2(-tip, unit * 0.7)];
        painter.add(Shape::line(points, Stroke::new(unit * 0.34, color)));
    };
    match icon {
        Icon::Play => triangle(-unit * 0.7, unit),
        Icon::Pause => [-0.5, 0.5].into_iter().for_each(|x| bar(x * unit)),
        Icon::Next => triangle(-unit * 0.8, unit * 0.8),
        Icon::Previous => triangle(unit * 0.8, -unit * 0.8),
        Icon::Last => {
            triangle(-unit, unit * 0.6);
            bar(unit * 0.85);
        }
        Icon::First => {
            triangle(unit, -unit * 0.6);
            bar(-unit * 0.85);
        }
        Icon::Right => chevron(unit * 0.35),
        Icon::Left => chevron(-unit * 0.35),
        Icon::Close => {
            for y in [-0.7, 0.7] {
                let line = [at + vec2(-unit * 0.7, unit * y), at + vec2(unit * 0.7, -unit * y)];
                painter.line_segment(line, Stroke::new(unit * 0.3, color));
            }
        }
        Icon::More => {
            for x in [-1.0, 0.0, 1.0] {
                painter.circle_filled(at + vec2(x * unit * 0.95, 0.0), unit * 0.24, color);
            }
        }
    }
}
