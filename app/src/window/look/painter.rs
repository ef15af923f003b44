//! The one painter of figures: every pane is a [`Figure`], and this is how egui draws it.

use egui::{Align2, Painter, Pos2, Rect, Shape, pos2, vec2};
use raystep_accel::Place;
use raystep_figure::{Anchor, Dash, Face, Figure, Ink, Mark, Role, Style, Theme, is_label};

use super::fonts::font;
use super::images;
use super::outline::{self, hatching};
use super::visuals::color32;

/// Height of the middle of small letters over the baseline, in parts of the size; the shipped families agree.
const MIDDLE: f32 = 0.273;

/// The largest rectangle that is filled while the pointer is on it, in square points.
const LARGE: f32 = 2500.0;

/// Draws a figure with its upper left corner at `origin`; marks of the hovered place light up.
pub(crate) fn paint_figure(painter: &Painter, origin: Pos2, figure: &Figure, theme: &Theme, hovered: Option<Place>) {
    for mark in &figure.marks {
        paint_mark(painter, origin, mark, mark.role, theme);
    }
    for mark in figure.marks.iter().filter(|mark| is_lit(mark, hovered)) {
        paint_lit(painter, origin, mark, theme);
    }
}

/// Lights up one sign of a place on a timeline: the one nearest to `x`. All of them would be a bar of light.
pub(crate) fn paint_nearest_lit(
    painter: &Painter,
    origin: Pos2,
    figure: &Figure,
    theme: &Theme,
    hovered: Option<Place>,
    x: f32,
) {
    let signs = figure.marks.iter().filter_map(|mark| match mark.ink {
        Ink::Text { at, .. } if mark.place == hovered && hovered.is_some() => Some((mark, (at.x - x).abs())),
        _ => None,
    });
    if let Some((mark, _)) = signs.min_by(|a, b| a.1.total_cmp(&b.1)) {
        paint_lit(painter, origin, mark, theme);
    }
}

/// Whether a mark lights up with a place. Splits that were weighed stay quiet: a node has dozens of them.
fn is_lit(mark: &Mark, lit: Option<Place>) -> bool {
    let crowd = mark.role == Role::Candidate && !matches!(mark.ink, Ink::Text { .. });
    lit.is_some() && mark.place == lit && lit != Some(Place::World) && !crowd
}

/// Draws only the labels of a figure: the rest lies in a picture below.
pub(crate) fn paint_labels(painter: &Painter, origin: Pos2, figure: &Figure, theme: &Theme, hovered: Option<Place>) {
    for mark in figure.marks.iter().filter(|mark| is_label(mark)) {
        paint_mark(painter, origin, mark, mark.role, theme);
        if is_lit(mark, hovered) {
            paint_lit(painter, origin, mark, theme);
        }
    }
}

/// The place under the pointer: of all marks there, the smallest one's.
pub(crate) fn place_at(figure: &Figure, origin: Pos2, pointer: Pos2) -> Option<Place> {
    let local = pointer - origin.to_vec2();
    let under = figure.marks.iter().rev().filter_map(|mark| Some((mark.place?, outline::reach(&mark.ink, local)?)));
    under.reduce(|best, other| if other.1 < best.1 { other } else { best }).map(|(place, _)| place)
}

/// The place of the line, ring or label under the pointer: labels first, then the nearest line.
pub(crate) fn line_at(figure: &Figure, origin: Pos2, pointer: Pos2) -> Option<Place> {
    let local = pointer - origin.to_vec2();
    let near = figure.marks.iter().rev().filter_map(|mark| {
        let away = outline::away(&mark.ink, local)?;
        // Candidates and the ray are no places of their own.
        let is_place = !matches!(mark.role, Role::Candidate | Role::Live | Role::Ray);
        Some((mark.place.filter(|_| is_place)?, away))
    });
    near.reduce(|best, other| if other.1 < best.1 { other } else { best }).map(|(place, _)| place)
}

fn paint_mark(painter: &Painter, origin: Pos2, mark: &Mark, role: Role, theme: &Theme) {
    let style = theme.style(role);
    match &mark.ink {
        Ink::Text { at, text, size, face, anchor, boxed } => {
            let at = origin + vec2(at.x, at.y);
            if *boxed {
                let label = theme.label(role);
                paint_box(painter, at, text, *size, *face, *anchor, &label);
                write(painter, at, text, *size, *face, *anchor, &label);
            } else {
                write(painter, at, text, *size, *face, *anchor, &style);
            }
        }
        Ink::Arrowhead { tip, along, length } => {
            let color = style.stroke.map_or(style.text, |stroke| stroke.color);
            let (tip, along) = (origin + vec2(tip.x, tip.y), vec2(along.x, along.y));
            let (back, side) = (tip - along * *length, along.rot90() * (*length * 0.42));
            let corners = vec![tip, back + side, back - side];
            painter.add(Shape::convex_polygon(corners, color32(color), egui::Stroke::NONE));
        }
        Ink::Circle { center, radius } if *radius < 5.0 && !style.hatch => {
            // A dot: filled with its line's colour.
            let color = style.stroke.map_or(style.text, |stroke| stroke.color);
            let fill = style.fill.filter(|_| *radius >= 3.0).unwrap_or(color);
            let center = origin + vec2(center.x, center.y);
            painter.circle_filled(center, *radius, color32(fill));
            if let Some(stroke) = style.stroke.filter(|_| *radius >= 3.0) {
                painter.circle_stroke(center, *radius, (stroke.width, color32(stroke.color)));
            }
        }
        Ink::Image { min, max, image } => {
            let texture = images::texture(painter.ctx(), image);
            let rect = Rect::from_min_max(origin + vec2(min.x, min.y), origin + vec2(max.x, max.y));
            let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
            painter.image(texture.id(), rect, whole, egui::Color32::WHITE);
        }
        // No pane of the window holds these: formulas stand in the prose.
        Ink::Formula { .. } => {}
        ink => paint_shape(painter, origin, ink, &style),
    }
}

/// Fill, hatching and outline of a shape.
fn paint_shape(painter: &Painter, origin: Pos2, ink: &Ink, style: &Style) {
    let closed = !matches!(ink, Ink::Line { .. });
    if let (true, Some(fill)) = (closed, style.fill) {
        painter.extend(outline::filled(ink, origin, color32(fill)));
    }
    let Some(stroke) = style.stroke else { return };
    let line = egui::Stroke::new(stroke.width, color32(stroke.color));
    if closed && style.hatch {
        let thin = egui::Stroke::new(1.0, color32(stroke.color).gamma_multiply(0.55));
        for [from, to] in hatching(ink, origin) {
            painter.line_segment([from, to], thin);
        }
    }
    if stroke.dash == Dash::Solid {
        painter.add(outline::stroked(ink, origin, line));
        return;
    }
    let pattern = stroke.dash.pattern(stroke.width);
    let mut shapes = Vec::new();
    let path = outline::path(ink, origin);
    // Parts and gaps in turn.
    let every = |first: usize| pattern.iter().skip(first).step_by(2).copied().collect::<Vec<f32>>();
    Shape::dashed_line_many_with_offset(&path, line, &every(0), &every(1), 0.0, &mut shapes);
    painter.extend(shapes);
}

/// A mark again, as what the pointer is on.
fn paint_lit(painter: &Painter, origin: Pos2, mark: &Mark, theme: &Theme) {
    let style = theme.style(Role::Hover);
    match &mark.ink {
        Ink::Text { at, text, size, face, anchor, .. } => {
            let at = origin + vec2(at.x, at.y);
            // The light is translucent: the ground first, or the text below would show through.
            let ground = Style { fill: theme.style(Role::Panel).fill, ..style };
            paint_box(painter, at, text, *size, *face, *anchor, &ground);
            paint_box(painter, at, text, *size, *face, *anchor, &style);
            let plain = Style { text: theme.style(Role::Text).text, ..style };
            write(painter, at, text, *size, *face, *anchor, &plain);
        }
        Ink::Arrowhead { .. } | Ink::Formula { .. } | Ink::Image { .. } => {}
        ink => {
            // What is large is outlined only, so that what lies in it stays readable.
            let large = matches!(ink, Ink::Rect { min, max, .. } if (max.x - min.x) * (max.y - min.y) > LARGE);
            let style = if large { Style { fill: None, ..style } } else { style };
            paint_shape(painter, origin, ink, &style);
        }
    }
}

/// Where a text of this width lies.
fn text_left(at: Pos2, width: f32, anchor: Anchor) -> f32 {
    match anchor {
        Anchor::Start => at.x,
        Anchor::Middle => at.x - width * 0.5,
        Anchor::End => at.x - width,
    }
}

/// The box around a label.
fn paint_box(painter: &Painter, at: Pos2, text: &str, size: f32, face: Face, anchor: Anchor, style: &Style) {
    let (min, max) = outline::text_box(glam::Vec2::new(at.x, at.y), text, size, face, anchor);
    let rect = Rect::from_min_max(pos2(min.x, min.y), pos2(max.x, max.y));
    let stroke = style.stroke.map_or(egui::Stroke::NONE, |stroke| (stroke.width, color32(stroke.color)).into());
    let fill = style.fill.map(color32).unwrap_or_default();
    painter.rect(rect, 4.0, fill, stroke, egui::StrokeKind::Middle);
}

fn write(painter: &Painter, at: Pos2, text: &str, size: f32, face: Face, anchor: Anchor, style: &Style) {
    let color = color32(style.text);
    let galley = painter.layout_no_wrap(text.to_owned(), font(face, size), color);
    let row = galley.rows.first();
    let baseline = row.map_or(0.0, |row| row.pos.y + row.glyphs.first().map_or(0.0, |glyph| glyph.pos.y));
    let left = text_left(at, galley.size().x, anchor);
    painter.galley(pos2(left, at.y + size * MIDDLE - baseline), galley, color);
}

/// A short text of the window itself, outside any figure.
pub(crate) fn caption(
    painter: &Painter,
    at: Pos2,
    align: Align2,
    text: &str,
    face: Face,
    size: f32,
    role: Role,
    theme: &Theme,
) -> Rect {
    painter.text(at, align, text, font(face, size), color32(theme.style(role).text))
}
