//! The numbers of a test on a line: the ray's t, shadows on a direction, a number and its limits.

use glam::Vec2;
use raystep_accel::{Part, Probe, Step, Trial, Visit};

use super::tried::Tried;
use crate::page::{Anchor, Figure, Ink, Look, Ticks, line, write};
use crate::theme::{Face, Role, text_width};
use crate::words::number;

/// A row: bars and points with their names.
#[derive(Default)]
struct Row {
    name: String,
    bars: Vec<(Role, [f32; 2])>,
    points: Vec<(Role, f32, String)>,
}

impl Row {
    fn new(name: impl Into<String>) -> Row {
        Row { name: name.into(), ..Row::default() }
    }

    fn bar(mut self, role: Role, ends: [f32; 2]) -> Row {
        if ends[0] <= ends[1] {
            self.bars.push((role, ends));
        }
        self
    }

    fn point(mut self, role: Role, at: f32, name: impl Into<String>) -> Row {
        self.points.push((role, at, name.into()));
        self
    }

    fn numbers(&self) -> impl Iterator<Item = f32> + '_ {
        let bars = self.bars.iter().flat_map(|(_, ends)| *ends);
        bars.chain(self.points.iter().map(|(_, at, _)| *at)).filter(|number| number.is_finite())
    }
}

/// What stands at points and under the axis, in letters of the pane.
const SMALL: f32 = 0.9;

/// The smallest letters, in those of the pane: of more rows than that only the last ones stand there.
const SMALLEST: f32 = 0.75;

/// How high a row is in its letters, with words above its points and with words beside them.
const ABOVE: f32 = 1.75;
const BESIDE: f32 = 1.3;

/// The line of numbers of this step; of what cuts a ray, all cuts so far.
pub(crate) fn numbers(tried: &Tried<'_>, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    let (title, about, mut rows) = rows(tried);
    let top = look.heading(&mut figure, title, &about) + look.text * 0.8;
    if rows.is_empty() {
        let at = Vec2::new(look.margin(), top + look.text);
        let says = "no numbers on a line at this step";
        write(&mut figure, Role::Quiet, None, at, says, look.text, Face::Regular, Anchor::Start);
        return figure;
    }
    // Words beside points, and then smaller letters, rather than not at all.
    let letters = |row: f32| look.text.min((size.y - top) / (rows.len() as f32 * row + 2.6));
    let aside = letters(ABOVE) < look.text;
    let row = if aside { BESIDE } else { ABOVE };
    let u = letters(row).max(look.text * SMALLEST);
    let room = size.y - top - u * 2.6;
    let high = (room / rows.len() as f32).clamp(u * row, u * 2.3);
    let fit = ((room / high + 0.01) as usize).max(1);
    rows.drain(..rows.len().saturating_sub(fit));
    let all = || rows.iter().flat_map(Row::numbers);
    let (low, most) = (all().fold(f32::INFINITY, f32::min), all().fold(f32::NEG_INFINITY, f32::max));
    let (low, most) = if low < most { (low, most) } else { (low - 1.0, low + 1.0) };
    let air = (most - low) * 0.08;
    let names = rows.iter().map(|row| text_width(&row.name, Face::Medium, u)).fold(u * 3.0, f32::max);
    let axis = Ticks {
        low: low - air,
        high: most + air,
        left: look.margin() + names + u * 1.2,
        right: size.x - look.margin() - u,
    };
    // What differs by roundings alone lies in the same place.
    let place = |value: f32| (axis.x(value) * 8.0).round() / 8.0;
    for (index, row) in rows.iter().enumerate() {
        let y = top + high * (index as f32 + if aside { 0.5 } else { 0.75 });
        let at = Vec2::new(look.margin(), y);
        write(&mut figure, Role::Text, None, at, &row.name, u, Face::Medium, Anchor::Start);
        let many = row.bars.len() as f32;
        for (bar, (role, ends)) in row.bars.iter().enumerate() {
            let y = y + (bar as f32 - (many - 1.0) * 0.5) * u * 0.7;
            let [from, to] = ends.map(|end| Vec2::new(place(end), y));
            figure.add(*role, None, line(from, to));
            for end in [from, to] {
                let tall = Vec2::new(0.0, u * 0.3);
                figure.add(Role::Seen, None, line(end - tall, end + tall));
            }
        }
        for (role, value, name) in row.points.iter().filter(|(_, value, _)| axis.shows(*value)) {
            let center = Vec2::new(place(*value), y);
            figure.add(*role, None, Ink::Circle { center, radius: u * 0.35 });
            let wide = text_width(name, Face::Regular, u * SMALL);
            let (at, anchor) = if aside {
                // Of an interval the one before it, the other behind it.
                let first = row.points.len() > 1 && row.points.iter().all(|(_, other, _)| value <= other);
                let left = first && center.x - u * 0.7 - wide > axis.left - u || center.x + u * 0.7 + wide > size.x;
                let away = if left { -u * 0.7 } else { u * 0.7 };
                (center + Vec2::new(away, 0.0), if left { Anchor::End } else { Anchor::Start })
            } else {
                let x = center.x.clamp(axis.left + wide * 0.5, axis.right - wide * 0.5);
                (Vec2::new(x, y - u * 0.95), Anchor::Middle)
            };
            write(&mut figure, *role, None, at, name, u * SMALL, Face::Regular, anchor);
        }
    }
    let bottom = top + high * rows.len() as f32 + u * 0.4;
    figure.add(Role::Edge, None, line(Vec2::new(axis.left, bottom), Vec2::new(axis.right, bottom)));
    for mark in axis.marks(u * 5.0) {
        let x = place(mark);
        figure.add(Role::Edge, None, line(Vec2::new(x, bottom - u * 0.25), Vec2::new(x, bottom + u * 0.25)));
        let at = Vec2::new(x, bottom + u * 1.0);
        write(&mut figure, Role::Quiet, None, at, &number(mark), u * SMALL, Face::Regular, Anchor::Middle);
    }
    figure
}

/// The title of the line, what it is about, and its rows.
fn rows(tried: &Tried<'_>) -> (&'static str, String, Vec<Row>) {
    let Some(last) = tried.last() else { return ("Numbers", String::new(), Vec::new()) };
    let along: Vec<Row> = tried.done.iter().enumerate().filter_map(|(index, trial)| cut(tried, index, trial)).collect();
    if !along.is_empty() {
        return ("t along the ray", String::new(), along);
    }
    let row = match last.step {
        Some(Step::Probe(Probe::Shadow { x, y, z, a_low, a_high, b_low, b_high, .. })) => {
            let about = format!("on the direction ({}, {}, {})", number(x), number(y), number(z));
            let rows = vec![
                Row::new("first").bar(Role::Live, [a_low, a_high]),
                Row::new("second").bar(Role::Here, [b_low, b_high]),
            ];
            return ("Shadows", about, rows);
        }
        Some(Step::Probe(Probe::Nearest { of, value, low, high, nearest, .. })) => Row::new(of.word())
            .bar(Role::Here, [low, high])
            .point(Role::Tick, value, "centre")
            .point(Role::Best, nearest, if nearest == value { "" } else { "nearest" }),
        Some(Step::Probe(Probe::Compare { of: Part::Radius, value, low, high, .. })) => Row::new("distance²")
            .bar(Role::Here, [low, high])
            .point(Role::Tick, value, number(value))
            .point(Role::Here, high, format!("radius² {}", number(high))),
        Some(Step::Probe(Probe::Compare { of, value, low, high, .. })) => {
            Row::new(of.word()).bar(Role::Here, [low, high]).point(Role::Tick, value, number(value))
        }
        Some(Step::Probe(Probe::Side { of, distance, reach, .. })) => Row::new(of.word())
            .bar(Role::Here, [distance - reach, distance + reach])
            .point(Role::Tick, distance, "middle of the box")
            .point(Role::Plane, 0.0, "plane"),
        Some(Step::Probe(Probe::Areas { u, v, w, .. })) => {
            let area = |name: &str, area: f32| {
                Row::new(name).bar(Role::Here, [area.min(0.0), area.max(0.0)]).point(Role::Tick, area, number(area))
            };
            return ("Areas with the edges", String::new(), vec![area("u", u), area("v", v), area("w", w)]);
        }
        _ => return ("Numbers", String::new(), Vec::new()),
    };
    ("Numbers", String::new(), vec![row])
}

/// What cuts the ray at this event, if something does.
fn cut(tried: &Tried<'_>, index: usize, trial: &Trial) -> Option<Row> {
    let now = index + 1 == tried.done.len();
    let role = if now { Role::Here } else { Role::Seen };
    let named = |name: &str, t: f32| format!("{name} {}", number(t));
    match trial.step? {
        Step::Probe(Probe::Cut { of, t, .. }) => Some(Row::new(of.word()).point(Role::Tick, t, named("t", t))),
        Step::Probe(Probe::Quadratic { of, t1, t2, real: true, .. }) => {
            let row = Row::new(of.word()).bar(role, [t1, t2]);
            Some(row.point(Role::Tick, t1, named("t1", t1)).point(Role::Tick, t2, named("t2", t2)))
        }
        Step::Probe(Probe::Narrow { t1, t2, t_near, t_far, empty, .. }) => {
            Some(narrowed(Row::new("cut, left"), role, [t1, t2], [t_near, t_far], empty))
        }
        Step::Slab(Visit::Narrow { axis, t1, t2, t_near, t_far, empty, .. }) => {
            Some(narrowed(Row::new(axis.name()), role, [t1, t2], [t_near, t_far], empty))
        }
        Step::Probe(Probe::Met { t, hit: true }) => Some(Row::new("met").point(Role::Best, t, named("t", t))),
        _ => None,
    }
}

/// An interval, and what it leaves.
fn narrowed(row: Row, role: Role, cut: [f32; 2], left: [f32; 2], empty: bool) -> Row {
    let finite = |ends: [f32; 2]| ends.iter().all(|end| end.is_finite());
    let row = if finite(cut) { row.bar(role, cut) } else { row };
    if empty || !finite(left) { row } else { row.bar(Role::Live, left) }
}
