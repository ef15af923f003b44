//! Letters in an SVG file: as outlines, so that it looks the same wherever it is opened, each outline written once and
//! used by reference; or as text in faces that the file brings along or only names.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use ratex_types::path_command::PathCommand;
use raystep_figure::{Face, fonts, text_width};
use ttf_parser::GlyphId;

use crate::decimal::decimal;
use crate::escaped::escaped;
use crate::formula::Hand;
use crate::typefaces::Typeface;
use crate::webfont;

/// How letters stand in an SVG file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Lettering {
    /// As outlines: the same everywhere, and nothing to search or to edit.
    #[default]
    Outlines,
    /// As text, in faces that the file brings along, with the letters that it uses.
    Embedded,
    /// As text, in faces that the file only names: those who open it need them, or get others of the same width.
    Named,
}

/// The letters that a file uses.
#[derive(Default)]
pub(crate) struct Glyphs {
    lettering: Lettering,
    outlines: BTreeMap<String, String>,
    /// By the tag of their face.
    used: BTreeMap<String, (Typeface, BTreeSet<char>)>,
}

impl Glyphs {
    pub(crate) fn new(lettering: Lettering) -> Glyphs {
        Glyphs { lettering, ..Glyphs::default() }
    }

    /// Writes one line of text with its left end on the baseline at `x`, `y`.
    pub(crate) fn line(&mut self, out: &mut String, text: &str, face: Face, size: f32, x: f32, y: f32) {
        let typeface = Typeface::Text(face);
        if self.lettering != Lettering::Outlines {
            // Programs differ in what they make of several spaces: each part between them stands where it belongs.
            for (at, part) in parts(text) {
                let before = text_width(&text[..at], face, size);
                self.text(out, typeface, part, size, x + before, y);
            }
            return;
        }
        let scale = size / EM;
        let _ = write!(out, r#"<g transform="translate({} {}) scale({scale:.5})">"#, decimal(x), decimal(y));
        // The pen stands where the letters before it end: the same advances as in every layout.
        for (_, letter, pen) in fonts::pens(text, face, EM).filter(|(_, letter, _)| !letter.is_whitespace()) {
            if let Some(id) = self.id(typeface, letter) {
                let _ = write!(out, r##"<use href="#{id}" x="{}"/>"##, decimal(pen));
            }
        }
        out.push_str("</g>");
    }

    /// Writes one letter with its origin at `x`, `y`.
    pub(crate) fn letter(&mut self, out: &mut String, typeface: Typeface, letter: char, size: f32, x: f32, y: f32) {
        if self.lettering != Lettering::Outlines {
            self.text(out, typeface, letter.encode_utf8(&mut [0; 4]), size, x, y);
        } else if let Some(id) = self.id(typeface, letter) {
            let scale = size / EM;
            let (x, y) = (decimal(x), decimal(y));
            let _ = write!(out, r##"<use href="#{id}" transform="translate({x} {y}) scale({scale:.5})"/>"##);
        }
    }

    /// Writes a text that stays one.
    fn text(&mut self, out: &mut String, typeface: Typeface, text: &str, size: f32, x: f32, y: f32) {
        if text.trim().is_empty() {
            return;
        }
        let (_, used) = self.used.entry(typeface.tag()).or_insert_with(|| (typeface, BTreeSet::new()));
        used.extend(text.chars());
        let [family, instead] = typeface.family();
        let (x, y, points) = (decimal(x), decimal(y), decimal(size));
        let _ = write!(out, r#"<text x="{x}" y="{y}" font-family="'{family}', {instead}" font-size="{points}""#);
        if typeface.weight() != 400 {
            let _ = write!(out, r#" font-weight="{}""#, typeface.weight());
        }
        if typeface.slants() {
            out.push_str(r#" font-style="italic""#);
        }
        // Another face than the one that is named takes as much room.
        if let (Lettering::Named, Typeface::Text(face)) = (self.lettering, typeface) {
            let width = decimal(text_width(text, face, size));
            let _ = write!(out, r#" textLength="{width}" lengthAdjust="spacingAndGlyphs""#);
        }
        let _ = write!(out, ">{}</text>", escaped(text));
    }

    /// What the root of the file must say so that letters stand where the layout put them.
    pub(crate) fn root(&self) -> &'static str {
        match self.lettering {
            Lettering::Outlines => "",
            Lettering::Embedded | Lettering::Named => {
                " text-rendering=\"geometricPrecision\" style=\"font-kerning:none;font-variant-ligatures:none\""
            }
        }
    }

    /// The outlines of all letters used, or the faces, for the file's definitions.
    pub(crate) fn definitions(&self, out: &mut String) {
        for (id, outline) in &self.outlines {
            let _ = write!(out, r#"<path id="{id}" d="{outline}"/>"#);
        }
        if self.lettering == Lettering::Embedded && !self.used.is_empty() {
            out.push_str("<style>");
            for (typeface, letters) in self.used.values() {
                webfont::face(out, *typeface, letters);
            }
            out.push_str("</style>");
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

/// The parts of a line between spaces at its ends, and between several in a row: where each begins in the line.
fn parts(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut at = 0;
    text.split("  ").filter_map(move |part| {
        let begin = at + part.len() - part.trim_start().len();
        at += part.len() + 2;
        Some((begin, part.trim())).filter(|(_, part)| !part.is_empty())
    })
}

/// Draws formulas into an SVG file, filled as the group around them says.
pub(crate) struct Strokes<'a> {
    pub(crate) out: &'a mut String,
    pub(crate) glyphs: &'a mut Glyphs,
}

impl Hand for Strokes<'_> {
    fn letter(&mut self, typeface: Typeface, letter: char, size: f32, x: f32, y: f32) {
        self.glyphs.letter(self.out, typeface, letter, size, x, y);
    }

    fn line(&mut self, text: &str, face: Face, size: f32, x: f32, y: f32) {
        self.glyphs.line(self.out, text, face, size, x, y);
    }

    fn bar(&mut self, x: f32, y: f32, width: f32, height: f32) {
        let [x, y, width, height] = [x, y, width, height].map(decimal);
        let _ = write!(self.out, r#"<rect x="{x}" y="{y}" width="{width}" height="{height}"/>"#);
    }

    fn outline(&mut self, commands: &[PathCommand], place: &dyn Fn(f64, f64) -> (f32, f32)) {
        let point = |x: f64, y: f64| {
            let (x, y) = place(x, y);
            format!("{} {}", decimal(x), decimal(y))
        };
        let out = &mut *self.out;
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

#[cfg(test)]
mod tests {
    #[test]
    fn a_line_is_parted_where_spaces_would_be_lost() {
        let check = |line: &str, parts: &[(usize, &str)]| assert_eq!(super::parts(line).collect::<Vec<_>>(), parts);
        check("go on with near", &[(0, "go on with near")]);
        check("    push far ", &[(4, "push far")]);
        check("[0.637, 8.55]   hit", &[(0, "[0.637, 8.55]"), (16, "hit")]);
        check("  ", &[]);
    }
}
