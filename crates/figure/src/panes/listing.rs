//! The algorithm as text, the line of the current event marked, its numbers right under it.

use glam::Vec2;

use crate::page::{Anchor, Figure, Look, block, line, write};
use crate::theme::fonts::elided;
use crate::theme::{Face, Role, text_width};
use crate::words::{Fact, fill};

/// One line of an algorithm.
#[derive(Clone, Copy, Debug)]
pub struct ListingLine<'a> {
    /// How deep it is nested.
    pub indent: usize,
    /// The line.
    pub text: &'a str,
    /// Whether it shows the current event.
    pub current: bool,
    /// A template for the line's numbers: `({{plane}} − {{o}}) / {{d}} = {{t}}`.
    pub values: Option<&'a str>,
    /// What stands here by mistake, in the walk beside.
    pub instead: Option<&'a str>,
}

/// The lines, with the one marked that shows `event`. Of a long listing, the part around it. In a flat scene
/// nothing is said of z.
pub fn listing(
    title: &str,
    lines: &[ListingLine<'_>],
    event: Option<&dyn Fact>,
    flat: bool,
    size: Vec2,
    look: &Look,
) -> Figure {
    let mut figure = Figure::new(size);
    look.heading(&mut figure, title, "");
    let Rows { current, values, shown, row, top } = rows(lines, event, flat, size, look);
    let first = shown.start;

    // A little smaller rather than cut off.
    let left = look.margin() + look.text * 0.6;
    let width = size.x - left - look.margin();
    let indented = |indent: usize, text: &str| format!("{}{text}", "  ".repeat(indent));
    let fitting = |text: &str, size: f32| size * (width / text_width(text, Face::Mono, size).max(1.0)).clamp(0.8, 1.0);
    let full = look.text * 0.97;
    let letters = lines.iter().map(|line| fitting(&indented(line.indent, line.text), full)).fold(full, f32::min);
    let put = |figure: &mut Figure, role, place, y: f32, text: &str, letters, face| {
        let text = elided(text, face, letters, width);
        write(figure, role, place, Vec2::new(left, y), &text, letters, face, Anchor::Start);
    };

    let mut y = top + row * 0.5;
    for index in shown.clone() {
        // A listing that goes on beyond the pane says so.
        let cut = (index == shown.start && first > 0) || (index + 1 == shown.end && shown.end < lines.len());
        let line = &lines[index];
        let text = indented(line.indent, line.text);
        if Some(index) == current {
            let height = row * if values.is_some() { 2.0 } else { 1.0 };
            let corner = Vec2::new(look.margin() * 0.5, y - row * 0.5);
            mark(&mut figure, corner, Vec2::new(size.x - look.margin(), height), look);
            put(&mut figure, Role::Here, None, y, &text, letters, Face::MonoMedium);
            if let Some(values) = &values {
                y += row;
                let values = indented(line.indent + 1, values);
                let letters = fitting(&values, letters);
                put(&mut figure, Role::Value, event.map(Fact::place), y, &values, letters, Face::MonoMedium);
            }
        } else if cut {
            put(&mut figure, Role::Quiet, None, y, &indented(line.indent, "…"), letters, Face::Mono);
        } else {
            put(&mut figure, Role::Text, None, y, &text, letters, Face::Mono);
        }
        y += row;
        if let Some(instead) = line.instead {
            let instead = indented(line.indent, &format!("≠ {instead}"));
            put(&mut figure, Role::Wrong, None, y, &instead, fitting(&instead, letters), Face::MonoMedium);
            y += row;
        }
    }
    figure
}

/// How high a listing of so many lines is, with the numbers under one of them.
pub fn listing_height(lines: usize, look: &Look) -> f32 {
    look.heading(&mut Figure::default(), "", "") + look.line() * (lines as f32 + 1.0) + look.margin()
}

/// Which of a listing's lines stands at this height in the figure that [`listing`] draws.
pub fn line_at(
    lines: &[ListingLine<'_>],
    event: Option<&dyn Fact>,
    flat: bool,
    size: Vec2,
    look: &Look,
    y: f32,
) -> Option<usize> {
    let Rows { current, values, shown, row, mut top } = rows(lines, event, flat, size, look);
    shown.into_iter().find(|&index| {
        let numbers = usize::from(Some(index) == current && values.is_some());
        let height = row * (1 + numbers + usize::from(lines[index].instead.is_some())) as f32;
        top += height;
        (top - height..top).contains(&y)
    })
}

/// Where the lines of a listing stand.
struct Rows {
    current: Option<usize>,
    /// The numbers under the current line.
    values: Option<String>,
    /// The lines that there is room for.
    shown: std::ops::Range<usize>,
    /// The height of a line.
    row: f32,
    top: f32,
}

/// As many lines as fit, the current one a third from the top of them; one row more for its numbers.
fn rows(lines: &[ListingLine<'_>], event: Option<&dyn Fact>, flat: bool, size: Vec2, look: &Look) -> Rows {
    let top = look.heading(&mut Figure::default(), "", "");
    let current = lines.iter().position(|line| line.current);
    let values = current.and_then(|line| {
        let template = lines[line].values?;
        Some(if flat { fill(&without_z(template), event?) } else { fill(template, event?) })
    });
    let row = look.line();
    let rows = (((size.y - top - look.margin() * 0.5) / row) as usize).max(1);
    let extra = usize::from(values.is_some()) + lines.iter().filter(|line| line.instead.is_some()).count();
    let room = rows.saturating_sub(extra).max(1);
    let first = current.map_or(0, |line| line.saturating_sub(room / 3)).min(lines.len().saturating_sub(room));
    Rows { current, values, shown: first..lines.len().min(first + room), row, top }
}

/// How what a template says of the z axis begins, after what it says of the others: `x {{next_x}}  y {{next_y}}  z {{next_z}}`,
/// `{{nx}} × {{ny}} × {{nz}}`, `({{x}}, {{y}}, {{z}})`.
const OF_Z: [&str; 5] = ["  z {{", " × {{nz", ", {{z", ", {{normal_z", ", {{d_z"];

/// A template without what it says of the z axis.
fn without_z(template: &str) -> String {
    OF_Z.iter().fold(template.to_owned(), |mut left, begins| {
        let named = left.find(begins).and_then(|from| Some((from, from + left[from..].find("}}")? + 2)));
        if let Some((from, to)) = named {
            left.replace_range(from..to, "");
        }
        left
    })
}

/// The ground of the current line, with a bar at its left.
fn mark(figure: &mut Figure, corner: Vec2, size: Vec2, look: &Look) {
    figure.add(Role::Ground, None, block(corner, size, look.text * 0.2));
    let bar = corner + Vec2::new(1.5, 0.0);
    figure.add(Role::Here, None, line(bar, bar + Vec2::new(0.0, size.y)));
}
