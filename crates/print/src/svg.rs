//! A figure as an SVG file.

use std::fmt::Write;

use glam::Vec2;
use raystep_accel::Place;
use raystep_figure::{Color, Figure, Ink, Mark, Role, Style, Theme};

use crate::decimal::decimal;
use crate::escaped::escaped;
use crate::formula;
use crate::glyphs::{Glyphs, Lettering, Strokes};
use crate::label::{ROUND, label_box, span};
use crate::pixels;
use crate::typefaces::Typeface;

/// How a figure becomes a file.
#[derive(Clone, Copy, Debug)]
pub struct Manner<'a> {
    /// Its colours.
    pub theme: &'a Theme,
    /// How letters stand in it.
    pub lettering: Lettering,
    /// Whether the page and the grounds of its panels are left out.
    pub clear: bool,
    /// Pixels of the file to a point of the figure.
    pub scale: f32,
}

impl<'a> Manner<'a> {
    /// Outlines on the theme's page, a pixel to a point.
    pub fn plain(theme: &'a Theme) -> Manner<'a> {
        Manner { theme, lettering: Lettering::Outlines, clear: false, scale: 1.0 }
    }

    /// Whether a mark is a ground that is left out.
    pub(crate) fn leaves_out(&self, mark: &Mark) -> bool {
        self.clear && matches!(mark.role, Role::Page | Role::Panel) && matches!(mark.ink, Ink::Rect { .. })
    }
}

/// The figure as an SVG file: rounded coordinates, letters as outlines, every mark with its role as its
/// class and its place as `data-place`.
pub fn svg(figure: &Figure, theme: &Theme) -> String {
    drawing(figure, &Manner::plain(theme))
}

/// The same, with letters, ground and size as `manner` says.
pub fn drawing(figure: &Figure, manner: &Manner<'_>) -> String {
    let (theme, glyphs) = (manner.theme, Glyphs::new(manner.lettering));
    let mut writer = Writer { theme, glyphs, hatched: Vec::new(), body: String::new() };
    for mark in figure.marks.iter().filter(|mark| !manner.leaves_out(mark)) {
        writer.mark(mark);
    }
    let mut definitions = String::new();
    for role in &writer.hatched {
        hatching(&mut definitions, *role, theme);
    }
    writer.glyphs.definitions(&mut definitions);
    let (width, height) = (decimal(figure.size.x), decimal(figure.size.y));
    let [across, down] = [figure.size.x, figure.size.y].map(|side| decimal(side * manner.scale));
    let page = theme.style(Role::Page).fill.filter(|_| !manner.clear);
    let page = page.map_or_else(String::new, |page| {
        format!("<rect width=\"{width}\" height=\"{height}\" fill=\"{}\"/>\n", page.to_hex())
    });
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{across}\" height=\"{down}\" \
         viewBox=\"0 0 {width} {height}\"{}>\n<defs>{definitions}</defs>\n{page}{}</svg>\n",
        writer.glyphs.root(),
        writer.body
    )
}

struct Writer<'a> {
    theme: &'a Theme,
    glyphs: Glyphs,
    /// Roles whose hatching the file must define.
    hatched: Vec<Role>,
    body: String,
}

impl Writer<'_> {
    fn mark(&mut self, mark: &Mark) {
        let class = format!("{:?}", mark.role).to_lowercase();
        let _ = write!(self.body, "<g class=\"{class}\"");
        if let Some(place) = mark.place {
            let _ = write!(self.body, " data-place=\"{}\"", place_name(place));
        }
        self.body.push('>');
        self.ink(&mark.ink, mark.role);
        self.body.push_str("</g>\n");
    }

    fn ink(&mut self, ink: &Ink, role: Role) {
        let style = self.theme.style(role);
        match ink {
            Ink::Line { points } => {
                let look = look(&Style { fill: None, hatch: false, ..style });
                let _ = write!(self.body, r#"<polyline points="{}"{look}/>"#, path(points));
            }
            Ink::Area { points } => self.shape(&format!(r#"<polygon points="{}""#, path(points)), role, &style),
            Ink::Rect { min, max, round } => self.shape(&rect(*min, *max, *round), role, &style),
            Ink::Circle { center, radius } => {
                let (x, y, r) = (decimal(center.x), decimal(center.y), decimal(*radius));
                self.shape(&format!(r#"<circle cx="{x}" cy="{y}" r="{r}""#), role, &style);
            }
            Ink::Image { min, max, image } => {
                let [x, y, width, height] = [min.x, min.y, max.x - min.x, max.y - min.y].map(decimal);
                let data = pixels::data_url(image);
                let _ = write!(
                    self.body,
                    r#"<image x="{x}" y="{y}" width="{width}" height="{height}" preserveAspectRatio="none" href="{data}"/>"#
                );
            }
            Ink::Arrowhead { tip, along, length } => {
                let (back, aside) = (*tip - *along * *length, along.perp() * (*length * 0.38));
                let color = style.stroke.map_or(style.text, |stroke| stroke.color);
                let points = path(&[*tip, back + aside, back - aside]);
                let _ = write!(self.body, r#"<polygon points="{points}"{}/>"#, paint("fill", color));
            }
            Ink::Formula { at, tex, size } => {
                let _ = write!(self.body, r#"<g{} aria-label="{}">"#, paint("fill", style.text), escaped(tex));
                let mut strokes = Strokes { out: &mut self.body, glyphs: &mut self.glyphs };
                formula::draw(&mut strokes, tex, *size, at.x, at.y);
                self.body.push_str("</g>");
            }
            Ink::Text { at, text, size, face, anchor, boxed } => {
                let (left, width) = span(*at, text, *face, *size, *anchor);
                let mut color = style.text;
                if *boxed {
                    let label = self.theme.label(role);
                    let (min, max) = label_box(left, at.y, width, *size);
                    self.shape(&rect(min, max, ROUND), role, &label);
                    color = label.text;
                }
                let _ = write!(self.body, r#"<g{} aria-label="{}">"#, paint("fill", color), escaped(text));
                let baseline = at.y + Typeface::Text(*face).middle() * size;
                self.glyphs.line(&mut self.body, text, *face, *size, left, baseline);
                self.body.push_str("</g>");
            }
        }
    }

    /// A closed shape, filled, then hatched, then outlined.
    fn shape(&mut self, open_tag: &str, role: Role, style: &Style) {
        let _ = write!(self.body, "{open_tag}{}/>", look(style));
        if style.hatch {
            if !self.hatched.contains(&role) {
                self.hatched.push(role);
            }
            let _ = write!(self.body, r#"{open_tag} fill="url(#{})"/>"#, hatching_name(role, self.theme));
        }
    }
}

fn rect(min: Vec2, max: Vec2, round: f32) -> String {
    let (min, max) = (min.min(max), min.max(max));
    let [x, y, width, height, round] = [min.x, min.y, max.x - min.x, max.y - min.y, round].map(decimal);
    let round = if round == "0" { String::new() } else { format!(r#" rx="{round}""#) };
    format!(r#"<rect x="{x}" y="{y}" width="{width}" height="{height}"{round}"#)
}

fn path(points: &[Vec2]) -> String {
    let pairs: Vec<String> = points.iter().map(|point| format!("{},{}", decimal(point.x), decimal(point.y))).collect();
    pairs.join(" ")
}

/// Fill and stroke as attributes.
fn look(style: &Style) -> String {
    let mut out = style.fill.map_or_else(|| r#" fill="none""#.to_owned(), |color| paint("fill", color));
    if let Some(stroke) = style.stroke {
        out += &paint("stroke", stroke.color);
        let _ = write!(out, r#" stroke-width="{}" stroke-linejoin="round""#, decimal(stroke.width));
        let pattern = stroke.dash.pattern(stroke.width);
        if !pattern.is_empty() {
            let lengths: Vec<String> = pattern.iter().map(|length| decimal(*length)).collect();
            let _ = write!(out, r#" stroke-dasharray="{}""#, lengths.join(" "));
        }
    }
    out
}

/// A colour as an attribute, its opacity as another.
fn paint(attribute: &str, color: Color) -> String {
    let hex = color.to_hex();
    if color.a == 255 {
        format!(r#" {attribute}="{hex}""#)
    } else {
        let opacity = decimal(f32::from(color.a) / 255.0);
        format!(r#" {attribute}="{hex}" {attribute}-opacity="{opacity}""#)
    }
}

/// Thin slanted lines in the colour of the role's outline.
fn hatching(out: &mut String, role: Role, theme: &Theme) {
    let style = theme.style(role);
    let color = style.stroke.map_or(style.text, |stroke| stroke.color);
    let _ = write!(
        out,
        r#"<pattern id="{}" width="7" height="7" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><path d="M0 0V7"{} stroke-width="1.6" stroke-opacity="0.7"/></pattern>"#,
        hatching_name(role, theme),
        paint("stroke", color),
    );
}

fn hatching_name(role: Role, theme: &Theme) -> String {
    format!("hatch-{}-{role:?}", theme.name).to_lowercase()
}

/// A place as the value of an attribute.
fn place_name(place: Place) -> String {
    match place {
        Place::World => "world".to_owned(),
        Place::Node(node) => format!("node-{node}"),
        Place::Cell(cell) => format!("cell-{cell}"),
        Place::Prim(prim) => format!("prim-{prim}"),
    }
}
