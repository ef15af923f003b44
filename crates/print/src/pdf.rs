//! A figure as a page of its own in the PDF format, with its letters as text: for papers and handouts.

use std::collections::HashMap;

use glam::Vec2;
use krilla::color::rgb;
use krilla::geom::{Path, PathBuilder, Point, Rect, Size, Transform};
use krilla::metadata::Metadata;
use krilla::num::NormalizedF32;
use krilla::page::PageSettings;
use krilla::paint::{Fill, LineJoin, Pattern, Stroke as Line, StrokeDash};
use krilla::surface::Surface;
use krilla::tagging::{TagGroup, TagTree};
use krilla::text::{Font, GlyphId, KrillaGlyph};
use krilla::{Data, Document, SerializeSettings};
use ratex_types::path_command::PathCommand;
use raystep_figure::{Color, Face, Figure, Ink, Mark, Role, Style};

use crate::PrintError;
use crate::formula::{self, Hand};
use crate::label::{ROUND, label_box, span};
use crate::leaf::{Leaf, Teller};
use crate::svg::Manner;
use crate::typefaces::Typeface;

/// Points of print, 72 to an inch, to a pixel, of which style sheets count 96.
const PRINT: f32 = 0.75;

/// The figure as a PDF file of one page, as large as `manner` says, called `title`. The same figure gives the same
/// bytes: nothing in it tells when it was written.
///
/// # Errors
/// When the page is empty or too large.
pub fn pdf(figure: &Figure, title: &str, manner: &Manner<'_>) -> Result<Vec<u8>, PrintError> {
    pdf_pages(&[Leaf { figure, passages: &[] }], title, manner)
}

/// The pages of one PDF file, in their order, with what is read of them aloud: see [`pdf`].
///
/// # Errors
/// When a page is empty or too large.
pub fn pdf_pages(leaves: &[Leaf<'_>], title: &str, manner: &Manner<'_>) -> Result<Vec<u8>, PrintError> {
    let enable_tagging = leaves.iter().any(|leaf| !leaf.passages.is_empty());
    let mut document = Document::new_with(SerializeSettings { enable_tagging, ..SerializeSettings::default() });
    let about = Metadata::new().title(title.to_owned()).creator("Raystep".to_owned()).language("en".to_owned());
    document.set_metadata(about);
    let mut told = TagTree::new().with_lang(Some("en".to_owned()));
    for leaf in leaves {
        let size = leaf.figure.size * manner.scale * PRINT;
        let settings = PageSettings::from_wh(size.x, size.y).filter(|_| size.max_element() <= MOST);
        let mut page = document.start_page_with(settings.ok_or(PrintError::Size(size.x, size.y))?);
        if let Some(section) = paint_page(leaf, manner, page.surface()) {
            told.push(section);
        }
        page.finish();
    }
    if enable_tagging {
        document.set_tag_tree(told);
    }
    document.finish().map_err(|error| PrintError::Pack(format!("{error:?}")))
}

fn paint_page(leaf: &Leaf<'_>, manner: &Manner<'_>, mut surface: Surface<'_>) -> Option<TagGroup> {
    surface.push_transform(&Transform::from_scale(manner.scale * PRINT, manner.scale * PRINT));
    let mut painter = Painter { surface, manner, fonts: HashMap::new() };
    let mut teller = Teller::new(leaf.passages);
    if let Some(color) = manner.theme.style(Role::Page).fill.filter(|_| !manner.clear) {
        teller.comes(None, &mut painter.surface);
        painter.ground(leaf.figure.size, color);
    }
    for (index, mark) in leaf.figure.marks.iter().enumerate().filter(|(_, mark)| !manner.leaves_out(mark)) {
        teller.comes(Some(index), &mut painter.surface);
        painter.mark(mark);
    }
    teller.ends(&mut painter.surface);
    painter.surface.pop();
    painter.surface.finish();
    teller.told()
}

/// The longest side of a page that programs open, in points of print.
const MOST: f32 = 14_400.0;

struct Painter<'a> {
    surface: Surface<'a>,
    manner: &'a Manner<'a>,
    fonts: HashMap<Typeface, Font>,
}

impl Painter<'_> {
    fn ground(&mut self, size: Vec2, color: Color) {
        self.fill(color);
        self.path(rect(Vec2::ZERO, size, 0.0));
    }

    fn mark(&mut self, mark: &Mark) {
        let style = self.manner.theme.style(mark.role);
        match &mark.ink {
            Ink::Line { points } => {
                self.look(&Style { fill: None, ..style });
                self.path(polyline(points, false));
            }
            Ink::Area { points } => self.shape(polyline(points, true), &style),
            Ink::Rect { min, max, round } => self.shape(rect(*min, *max, *round), &style),
            Ink::Circle { center, radius } => {
                self.shape(rect(*center - *radius, *center + *radius, *radius), &style);
            }
            Ink::Image { min, max, image } => {
                let pixels = krilla::image::Image::from_rgba8(image.rgba.to_vec(), image.width, image.height);
                if let Some(size) = Size::from_wh(max.x - min.x, max.y - min.y) {
                    self.surface.push_transform(&Transform::from_translate(min.x, min.y));
                    self.surface.draw_image(pixels, size);
                    self.surface.pop();
                }
            }
            Ink::Arrowhead { tip, along, length } => {
                let (back, aside) = (*tip - *along * *length, along.perp() * (*length * 0.38));
                self.fill(style.stroke.map_or(style.text, |stroke| stroke.color));
                self.path(polyline(&[*tip, back + aside, back - aside], true));
            }
            Ink::Formula { at, tex, size } => {
                self.fill(style.text);
                formula::draw(self, tex, *size, at.x, at.y);
            }
            Ink::Text { at, text, size, face, anchor, boxed } => {
                let (left, width) = span(*at, text, *face, *size, *anchor);
                let mut color = style.text;
                if *boxed {
                    let label = self.manner.theme.label(mark.role);
                    let (min, max) = label_box(left, at.y, width, *size);
                    self.shape(rect(min, max, ROUND), &label);
                    color = label.text;
                }
                self.fill(color);
                self.line(text, *face, *size, left, at.y + Typeface::Text(*face).middle() * size);
            }
        }
    }

    /// A closed shape, filled, then hatched, then outlined.
    fn shape(&mut self, path: Option<Path>, style: &Style) {
        let Some(path) = path else { return };
        self.look(style);
        self.surface.draw_path(&path);
        if style.hatch {
            let hatching = self.hatching(style);
            self.surface.set_stroke(None);
            self.surface.set_fill(Some(hatching));
            self.surface.draw_path(&path);
        }
    }

    /// Thin slanted lines in the colour of the outline.
    fn hatching(&mut self, style: &Style) -> Fill {
        const APART: f32 = 7.0;
        let color = style.stroke.map_or(style.text, |stroke| stroke.color);
        let mut builder = self.surface.stream_builder();
        let mut tile = builder.surface();
        tile.set_fill(Some(Fill { paint: paint(color), opacity: opaque(0.7), ..Fill::default() }));
        // As wide as the half of a line that lies within its tile.
        if let Some(path) = rect(Vec2::ZERO, Vec2::new(0.8, APART), 0.0) {
            tile.draw_path(&path);
        }
        tile.finish();
        let pattern =
            Pattern { stream: builder.finish(), transform: Transform::from_rotate(45.0), width: APART, height: APART };
        Fill { paint: pattern.into(), ..Fill::default() }
    }

    fn path(&mut self, path: Option<Path>) {
        if let Some(path) = path {
            self.surface.draw_path(&path);
        }
    }

    /// From here on shapes and letters have this colour and no outline.
    fn fill(&mut self, color: Color) {
        self.look(&Style { stroke: None, fill: Some(color), hatch: false, text: color });
    }

    /// From here on shapes look so.
    fn look(&mut self, style: &Style) {
        let opacity = |color: Color| opaque(f32::from(color.a) / 255.0);
        let fill = style.fill.map(|color| Fill { paint: paint(color), opacity: opacity(color), ..Fill::default() });
        let stroke = style.stroke.map(|stroke| {
            let array = stroke.dash.pattern(stroke.width).to_vec();
            Line {
                paint: paint(stroke.color),
                width: stroke.width,
                line_join: LineJoin::Round,
                opacity: opacity(stroke.color),
                dash: (!array.is_empty()).then_some(StrokeDash { array, offset: 0.0 }),
                ..Line::default()
            }
        });
        self.surface.set_fill(fill);
        self.surface.set_stroke(stroke);
    }

    fn glyphs(&mut self, typeface: Typeface, text: &str, size: f32, x: f32, y: f32) {
        if text.trim().is_empty() {
            return;
        }
        let known = self.fonts.get(&typeface).cloned();
        let Some(font) = known.or_else(|| Font::new(Data::from(typeface.bytes()), 0)) else { return };
        self.fonts.insert(typeface, font.clone());
        let face = typeface.parsed();
        let em = f32::from(face.units_per_em());
        let glyph = |(at, letter): (usize, char)| {
            let glyph = face.glyph_index(letter).unwrap_or_default();
            KrillaGlyph {
                glyph_id: GlyphId::new(u32::from(glyph.0)),
                text_range: at..at + letter.len_utf8(),
                x_advance: f32::from(face.glyph_hor_advance(glyph).unwrap_or(0)) / em,
                x_offset: 0.0,
                y_offset: 0.0,
                y_advance: 0.0,
                location: None,
            }
        };
        let glyphs: Vec<KrillaGlyph> = text.char_indices().map(glyph).collect();
        self.surface.draw_glyphs(Point::from_xy(x, y), &glyphs, font, text, size, false);
    }
}

impl Hand for Painter<'_> {
    fn letter(&mut self, typeface: Typeface, letter: char, size: f32, x: f32, y: f32) {
        self.glyphs(typeface, letter.encode_utf8(&mut [0; 4]), size, x, y);
    }

    fn line(&mut self, text: &str, face: Face, size: f32, x: f32, y: f32) {
        self.glyphs(Typeface::Text(face), text, size, x, y);
    }

    fn bar(&mut self, x: f32, y: f32, width: f32, height: f32) {
        self.path(rect(Vec2::new(x, y), Vec2::new(x + width, y + height), 0.0));
    }

    fn outline(&mut self, commands: &[PathCommand], place: &dyn Fn(f64, f64) -> (f32, f32)) {
        let mut path = PathBuilder::new();
        for command in commands {
            match *command {
                PathCommand::MoveTo { x, y } => {
                    let (x, y) = place(x, y);
                    path.move_to(x, y);
                }
                PathCommand::LineTo { x, y } => {
                    let (x, y) = place(x, y);
                    path.line_to(x, y);
                }
                PathCommand::CubicTo { x1, y1, x2, y2, x, y } => {
                    let ((x1, y1), (x2, y2), (x, y)) = (place(x1, y1), place(x2, y2), place(x, y));
                    path.cubic_to(x1, y1, x2, y2, x, y);
                }
                PathCommand::QuadTo { x1, y1, x, y } => {
                    let ((x1, y1), (x, y)) = (place(x1, y1), place(x, y));
                    path.quad_to(x1, y1, x, y);
                }
                PathCommand::Close => path.close(),
            }
        }
        self.path(path.finish());
    }
}

/// A colour without its opacity.
fn paint(color: Color) -> krilla::paint::Paint {
    rgb::Color::new(color.r, color.g, color.b).into()
}

fn opaque(part: f32) -> NormalizedF32 {
    NormalizedF32::new(part).unwrap_or(NormalizedF32::ONE)
}

fn polyline(points: &[Vec2], closed: bool) -> Option<Path> {
    let mut path = PathBuilder::new();
    let (first, rest) = points.split_first()?;
    path.move_to(first.x, first.y);
    for point in rest {
        path.line_to(point.x, point.y);
    }
    if closed {
        path.close();
    }
    path.finish()
}

/// How far the handles of a curve lie along the sides of the square around a quarter of a circle.
const QUARTER: f32 = 0.552_284_8;

/// A rectangle, perhaps with round corners.
fn rect(a: Vec2, b: Vec2, round: f32) -> Option<Path> {
    let (min, max) = (a.min(b), a.max(b));
    let mut path = PathBuilder::new();
    let round = round.min((max - min).min_element() * 0.5);
    if round <= 0.0 {
        path.push_rect(Rect::from_ltrb(min.x, min.y, max.x, max.y)?);
        return path.finish();
    }
    let back = round * (1.0 - QUARTER);
    let (left, top, right, bottom) = (min.x, min.y, max.x, max.y);
    path.move_to(left + round, top);
    path.line_to(right - round, top);
    path.cubic_to(right - back, top, right, top + back, right, top + round);
    path.line_to(right, bottom - round);
    path.cubic_to(right, bottom - back, right - back, bottom, right - round, bottom);
    path.line_to(left + round, bottom);
    path.cubic_to(left + back, bottom, left, bottom - back, left, bottom - round);
    path.line_to(left, top + round);
    path.cubic_to(left, top + back, left + back, top, left + round, top);
    path.close();
    path.finish()
}
