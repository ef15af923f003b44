//! A formula as a file.

use raystep_figure::Color;

use crate::decimal::decimal;
use crate::escaped::escaped;
use crate::formula::{draw, extent};
use crate::glyphs::{Glyphs, Strokes};

/// A formula as an SVG file of its own, as large as its [`extent`].
pub fn formula(tex: &str, size: f32, color: Color) -> String {
    let room = extent(tex, size);
    let mut glyphs = Glyphs::default();
    let mut body = String::new();
    draw(&mut Strokes { out: &mut body, glyphs: &mut glyphs }, tex, size, 0.0, room.height);
    let mut definitions = String::new();
    glyphs.definitions(&mut definitions);
    let (width, height) = (decimal(room.width), decimal(room.height + room.depth));
    format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}"><defs>{definitions}</defs><g fill="{}" aria-label="{}">{body}</g></svg>"#,
        color.to_hex(),
        escaped(tex),
    )
}
