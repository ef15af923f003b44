//! The algorithm as text, the line of the current event marked, its numbers right under it.

use glam::Vec2;

use crate::fonts::elided;
use crate::look::{block, line, write};
use crate::{Anchor, Face, Fact, Figure, Look, Role, fill};

/// One line of an algorithm.
#[derive(Clone, Copy, Debug)]
pub struct ListingLine<'a> {
    /// How deep it is nested.
    pub indent: usize,
    /// The line.
    pub text: &'a str,
    /// Names of the events that happen in it.
    pub events: &'a [String],
    /// A template for the line's numbers: `({{plane}} − {{o}}) / {{d}} = {{t}}`.
    pub values: Option<&'a str>,
}

/// The lines, with the one marked in which `event` happens. Of a long listing, the part around it.
pub fn listing<E: Fact>(lines: &[ListingLine<'_>], event: Option<&E>, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    let top = look.heading(&mut figure, "Walk", "");
    let current = event.and_then(|event| current_line(lines, event));
    let values = current.and_then(|line| Some(fill(lines[line].values?, event?)));

    // As many rows as fit, the current line a third from the top of them; one row more for its numbers.
    let row = look.line();
    let rows = (((size.y - top - look.margin() * 0.5) / row) as usize).max(1);
    let room = rows.saturating_sub(usize::from(values.is_some())).max(1);
    let first = current.map_or(0, |line| line.saturating_sub(room / 3)).min(lines.len().saturating_sub(room));
    let shown = first..lines.len().min(first + room);

    let face_size = look.text * 0.97;
    let left = look.margin() + look.text * 0.6;
    let width = size.x - left - look.margin();
    let text = |shown: &ListingLine<'_>, face| {
        let indented = format!("{}{}", "  ".repeat(shown.indent), shown.text);
        elided(&indented, face, face_size, width)
    };
    let mut y = top + row * 0.5;
    for index in shown.clone() {
        // A listing that goes on beyond the pane says so.
        let cut = (index == shown.start && first > 0) || (index + 1 == shown.end && shown.end < lines.len());
        let at = Vec2::new(left, y);
        if Some(index) == current {
            let height = row * if values.is_some() { 2.0 } else { 1.0 };
            let corner = Vec2::new(look.margin() * 0.5, y - row * 0.5);
            mark(&mut figure, corner, Vec2::new(size.x - look.margin(), height), look);
            write(
                &mut figure,
                Role::Here,
                None,
                at,
                &text(&lines[index], Face::MonoMedium),
                face_size,
                Face::MonoMedium,
                Anchor::Start,
            );
            if let Some(values) = &values {
                y += row;
                let indented = format!("{}{values}", "  ".repeat(lines[index].indent + 1));
                let values = elided(&indented, Face::MonoMedium, face_size, width);
                let place = event.map(Fact::place);
                write(
                    &mut figure,
                    Role::Value,
                    place,
                    Vec2::new(left, y),
                    &values,
                    face_size,
                    Face::MonoMedium,
                    Anchor::Start,
                );
            }
        } else if cut {
            let dots = format!("{}…", "  ".repeat(lines[index].indent));
            write(&mut figure, Role::Quiet, None, at, &dots, face_size, Face::Mono, Anchor::Start);
        } else {
            write(
                &mut figure,
                Role::Text,
                None,
                at,
                &text(&lines[index], Face::Mono),
                face_size,
                Face::Mono,
                Anchor::Start,
            );
        }
        y += row;
    }
    figure
}

/// The first line in which the event happens.
pub fn current_line(lines: &[ListingLine<'_>], event: &impl Fact) -> Option<usize> {
    lines.iter().position(|line| line.events.iter().any(|name| name == event.name()))
}

/// The ground of the current line, with a bar at its left.
fn mark(figure: &mut Figure, corner: Vec2, size: Vec2, look: &Look) {
    figure.add(Role::Ground, None, block(corner, size, look.text * 0.2));
    let bar = corner + Vec2::new(1.5, 0.0);
    figure.add(Role::Here, None, line(bar, bar + Vec2::new(0.0, size.y)));
}
