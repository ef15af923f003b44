//! Formulas: TeX in, outlines out. The one place that knows who sets them.

use std::fmt::Write;

use ratex_layout::{LayoutOptions, layout, to_display_list, validate_layout};
use ratex_types::display_item::{DisplayItem, DisplayList};
use ratex_types::path_command::PathCommand;
use raystep_figure::{Color, Face, fonts};

use crate::decimal::decimal;
use crate::glyphs::Glyphs;
use crate::svg::escaped;
use crate::typefaces::{MathFont, Typeface};

/// How much room a formula takes, in points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// From its left end to its right.
    pub width: f32,
    /// Above the line that letters stand on.
    pub height: f32,
    /// Below that line.
    pub depth: f32,
}

/// How much room a formula takes at this size of its letters.
pub fn extent(tex: &str, size: f32) -> Extent {
    match set(tex) {
        Some(list) => Extent {
            width: list.width as f32 * size,
            height: list.height as f32 * size,
            depth: list.depth as f32 * size,
        },
        // What cannot be set stands there as it was typed.
        None => Extent { width: fonts::text_width(tex, Face::Italic, size), height: size * 0.75, depth: size * 0.25 },
    }
}

/// A formula as an SVG file of its own, as large as its [`Extent`].
pub fn formula(tex: &str, size: f32, color: Color) -> String {
    let room = extent(tex, size);
    let mut glyphs = Glyphs::default();
    let mut body = String::new();
    draw(&mut body, &mut glyphs, tex, size, 0.0, room.height);
    let mut definitions = String::new();
    glyphs.definitions(&mut definitions);
    let (width, height) = (decimal(room.width), decimal(room.height + room.depth));
    format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}"><defs>{definitions}</defs><g fill="{}" aria-label="{}">{body}</g></svg>"#,
        color.to_hex(),
        escaped(tex),
    )
}

/// Writes a formula with its left end on the baseline at `x`, `y`; filled as the group around it says.
pub(crate) fn draw(out: &mut String, glyphs: &mut Glyphs, tex: &str, size: f32, x: f32, y: f32) {
    let Some(list) = set(tex) else {
        glyphs.line(out, tex, Face::Italic, size, x, y);
        return;
    };
    // The layout measures in em from the upper left corner.
    let top = y - list.height as f32 * size;
    let place = |em_x: f64, em_y: f64| (x + em_x as f32 * size, top + em_y as f32 * size);
    for item in &list.items {
        match item {
            DisplayItem::GlyphPath { x, y, scale, font, char_code, .. } => {
                let (x, y) = place(*x, *y);
                let letter = char::from_u32(*char_code).unwrap_or(char::REPLACEMENT_CHARACTER);
                glyphs.letter(out, Typeface::Math(MathFont::named(font)), letter, *scale as f32 * size, x, y);
            }
            DisplayItem::Line { x, y, width, thickness, .. } => {
                rect(out, place(*x, *y - *thickness * 0.5), *width as f32 * size, *thickness as f32 * size);
            }
            DisplayItem::Rect { x, y, width, height, .. } => {
                rect(out, place(*x, *y), *width as f32 * size, *height as f32 * size);
            }
            DisplayItem::Path { x, y, commands, .. } => path(out, commands, |dx, dy| place(*x + dx, *y + dy)),
        }
    }
}

/// The formula laid out; nothing when it is not one.
fn set(tex: &str) -> Option<DisplayList> {
    let nodes = ratex_parser::parse(tex).ok()?;
    let boxed = layout(&nodes, &LayoutOptions::default());
    validate_layout(&boxed).ok()?;
    Some(to_display_list(&boxed))
}

fn rect(out: &mut String, (x, y): (f32, f32), width: f32, height: f32) {
    let (x, y, width, height) = (decimal(x), decimal(y), decimal(width), decimal(height));
    let _ = write!(out, r#"<rect x="{x}" y="{y}" width="{width}" height="{height}"/>"#);
}

fn path(out: &mut String, commands: &[PathCommand], place: impl Fn(f64, f64) -> (f32, f32)) {
    let point = |x: f64, y: f64| {
        let (x, y) = place(x, y);
        format!("{} {}", decimal(x), decimal(y))
    };
    out.push_str(r#"<path d=""#);
    for command in commands {
        let _ = match *command {
            PathCommand::MoveTo { x, y } => write!(out, "M{}", point(x, y)),
            PathCommand::LineTo { x, y } => write!(out, "L{}", point(x, y)),
            PathCommand::CubicTo { x1, y1, x2, y2, x, y } => {
                write!(out, "C{} {} {}", point(x1, y1), point(x2, y2), point(x, y))
            }
            PathCommand::QuadTo { x1, y1, x, y } => write!(out, "Q{} {}", point(x1, y1), point(x, y)),
            PathCommand::Close => write!(out, "Z"),
        };
    }
    out.push_str(r#""/>"#);
}
