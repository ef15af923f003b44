//! Letters as outlines, so that a file looks the same wherever it is opened. Each letter's outline
//! is written once per file and used by reference.

use std::collections::BTreeMap;
use std::fmt::Write;

use raystep_figure::{Face, fonts};
use ttf_parser::GlyphId;

use crate::decimal::decimal;
use crate::typefaces::Typeface;

/// The letters that a file uses.
#[derive(Default)]
pub(crate) struct Glyphs {
    outlines: BTreeMap<String, String>,
}

impl Glyphs {
    /// Writes one line of text with its left end on the baseline at `x`, `y`.
    pub(crate) fn line(&mut self, out: &mut String, text: &str, face: Face, size: f32, x: f32, y: f32) {
        let scale = size / EM;
        let _ = write!(out, r#"<g transform="translate({} {}) scale({scale:.5})">"#, decimal(x), decimal(y));
        // The pen stands where the letters before it end: the same advances as in every layout.
        for (_, letter, pen) in fonts::pens(text, face, EM).filter(|(_, letter, _)| !letter.is_whitespace()) {
            if let Some(id) = self.id(Typeface::Text(face), letter) {
                let _ = write!(out, r##"<use href="#{id}" x="{}"/>"##, decimal(pen));
            }
        }
        out.push_str("</g>");
    }

    /// Writes one letter with its origin at `x`, `y`.
    pub(crate) fn letter(&mut self, out: &mut String, typeface: Typeface, letter: char, size: f32, x: f32, y: f32) {
        if let Some(id) = self.id(typeface, letter) {
            let scale = size / EM;
            let (x, y) = (decimal(x), decimal(y));
            let _ = write!(out, r##"<use href="#{id}" transform="translate({x} {y}) scale({scale:.5})"/>"##);
        }
    }

    /// The outlines of all letters used, for the file's definitions.
    pub(crate) fn definitions(&self, out: &mut String) {
        for (id, outline) in &self.outlines {
            let _ = write!(out, r#"<path id="{id}" d="{outline}"/>"#);
        }
    }

    fn id(&mut self, typeface: Typeface, letter: char) -> Option<String> {
        let face = typeface.parsed();
        let glyph = face.glyph_index(letter).unwrap_or_default();
        let id = format!("{}-{:x}", typeface.tag(), glyph.0);
        if !self.outlines.contains_key(&id) {
            let outline = outline(face, glyph)?;
            self.outlines.insert(id.clone(), outline);
        }
        Some(id)
    }
}

/// Outlines are written for this size of a face.
const EM: f32 = 100.0;

fn outline(face: &ttf_parser::Face<'_>, glyph: GlyphId) -> Option<String> {
    let mut pen = Pen { d: String::new(), scale: EM / f32::from(face.units_per_em()) };
    face.outline_glyph(glyph, &mut pen)?;
    Some(pen.d)
}

/// Writes an outline as the data of an SVG path, y downwards.
struct Pen {
    d: String,
    scale: f32,
}

impl Pen {
    fn to(&mut self, command: char, points: &[(f32, f32)]) {
        self.d.push(command);
        for (i, (x, y)) in points.iter().enumerate() {
            let gap = if i == 0 { "" } else { " " };
            let _ = write!(self.d, "{gap}{} {}", tenth(x * self.scale), tenth(-y * self.scale));
        }
    }
}

fn tenth(x: f32) -> String {
    decimal((x * 10.0).round() / 10.0)
}

impl ttf_parser::OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.to('M', &[(x, y)]);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.to('L', &[(x, y)]);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.to('Q', &[(x1, y1), (x, y)]);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.to('C', &[(x1, y1), (x2, y2), (x, y)]);
    }

    fn close(&mut self) {
        self.d.push('Z');
    }
}
