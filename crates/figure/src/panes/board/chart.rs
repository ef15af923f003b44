//! A chart: points and lines over two axes, each named where it ends.

use glam::Vec2;

use super::known::{Known, heading, legend};
use super::{Filled, place};
use crate::page::{Anchor, Figure, Ink, Look, Ticks, block, line, write};
use crate::theme::{Face, Role, text_width};
use crate::words::number;

/// A chart of a board.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// What it is about.
    pub title: String,
    /// What stands behind the title.
    pub about: String,
    /// Across.
    pub x: Scale,
    /// Up.
    pub y: Scale,
    /// What is drawn in it.
    pub drawn: Vec<Drawn>,
}

/// An axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Scale {
    /// What it counts.
    pub name: String,
    /// Whether equal steps on it are equal factors.
    pub log: bool,
    /// Its lower end.
    pub from: f64,
    /// Its upper end.
    pub to: f64,
    /// Numbers that stand on it with words of their own; round numbers where there are none.
    pub ticks: Vec<(f64, String)>,
}

/// Something drawn in a chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawn {
    /// When it comes to be seen.
    pub entry: usize,
    /// What it is called.
    pub name: String,
    /// A few words below the name.
    pub note: String,
    /// Whether it moves with the meter.
    pub moves: bool,
    /// What it is.
    pub curve: Curve,
    /// How well it is known.
    pub known: Known,
}

/// A point, or points joined by a line.
#[derive(Clone, Debug, PartialEq)]
pub enum Curve {
    /// A point.
    Point(Dot),
    /// A line through points; a guess is dashed.
    Line {
        /// Its points, from left to right.
        dots: Vec<Dot>,
        /// Whether it is but a guess.
        guess: bool,
    },
}

/// Two numbers.
pub type Dot = [f64; 2];

impl Curve {
    fn dots(&self) -> &[Dot] {
        match self {
            Curve::Point(dot) => std::slice::from_ref(dot),
            Curve::Line { dots, .. } => dots,
        }
    }
}

impl Chart {
    /// When what is drawn in it comes to be seen.
    pub(super) fn entries(&self) -> Vec<usize> {
        self.drawn.iter().map(|drawn| drawn.entry).collect()
    }

    /// What it says of those of its lines that are seen, and not as they will stay.
    fn legend(&self, filled: Filled) -> Option<String> {
        let seen = || self.drawn.iter().filter(|drawn| filled.shows(drawn.entry));
        let waits: Vec<&str> =
            seen().filter(|drawn| drawn.known == Known::NotYet).map(|drawn| drawn.name.as_str()).collect();
        match waits[..] {
            [] => legend(seen().map(|drawn| drawn.known)),
            _ => Some(format!("{}: not measured yet", waits.join(", "))),
        }
    }
}

impl Scale {
    /// How far along the axis a number lies: 0 at its lower end, 1 at its upper one.
    fn part(&self, value: f64) -> f32 {
        let along = |value: f64| if self.log { libm::log10(value.max(f64::MIN_POSITIVE)) } else { value };
        ((along(value) - along(self.from)) / (along(self.to) - along(self.from))) as f32
    }

    fn shows(&self, value: f64) -> bool {
        (-1e-3..=1.001).contains(&self.part(value))
    }

    /// What stands on it.
    fn marks(&self, most: f32) -> Vec<(f64, String)> {
        if !self.ticks.is_empty() {
            return self.ticks.clone();
        }
        let round = |value: f64| (value, number(value as f32));
        if !self.log {
            let ticks = Ticks { low: self.from as f32, high: self.to as f32, left: 0.0, right: most };
            return ticks.marks(1.0).into_iter().map(|value| round(f64::from(value))).collect();
        }
        let (low, high) = (libm::ceil(libm::log10(self.from) - 1e-9), libm::floor(libm::log10(self.to) + 1e-9));
        let every = libm::ceil((high - low + 1.0) / f64::from(most)).max(1.0);
        let count = libm::floor((high - low) / every) as i32;
        (0..=count.max(0)).map(|index| round(libm::pow(10.0, low + every * f64::from(index)))).collect()
    }
}

/// Parts of a line between two points, when it is asked where the line runs.
const PARTS: usize = 24;

/// Lines of fewer points than these were measured.
const LAW: usize = 40;

/// The page of a chart.
struct Plot<'a> {
    chart: &'a Chart,
    look: &'a Look,
    min: Vec2,
    max: Vec2,
    /// Where the dots of each curve lie.
    dots: Vec<Vec<Vec2>>,
    /// Where names stand already.
    taken: Vec<(Vec2, Vec2)>,
}

pub(super) fn draw(chart: &Chart, filled: Filled, room: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(room);
    let top = heading(look, &mut figure, &chart.title, &chart.about, chart.legend(filled)) + look.text * 1.2;
    let u = look.text;
    let up = chart.y.marks((room.y / (u * 3.0)).max(2.0));
    let names = up.iter().map(|(_, text)| text_width(text, Face::Regular, look.small())).fold(0.0, f32::max);
    let min = Vec2::new(look.margin() + names + u * 0.8, top + u * 1.0);
    let max = Vec2::new(room.x - look.margin() - u * 2.0, room.y - look.margin() - u * 3.2);
    let mut plot = Plot { chart, look, min, max, dots: Vec::new(), taken: Vec::new() };
    plot.dots = chart.drawn.iter().map(|drawn| drawn.curve.dots().iter().map(|dot| plot.at(*dot)).collect()).collect();
    plot.axes(&mut figure, &up);
    // What is new lies on top, and its name finds its room first.
    let mut order: Vec<&Drawn> = chart.drawn.iter().filter(|drawn| filled.shows(drawn.entry)).collect();
    order.sort_by_key(|drawn| drawn.entry);
    // Points lie on their lines.
    order.sort_by_key(|drawn| (matches!(drawn.curve, Curve::Point(_)), drawn.moves, drawn.entry));
    let named: Vec<(&Drawn, Vec2)> =
        order.iter().rev().filter_map(|drawn| Some((*drawn, plot.place(drawn)?))).collect();
    // The lines of the scale do not run through names.
    for (from, to) in &plot.taken {
        let around = Vec2::new(look.text * 0.2, 0.0);
        figure.add(Role::Page, None, block(*from - around, *to - *from + 2.0 * around, look.text * 0.2));
    }
    for drawn in &order {
        plot.ink(&mut figure, drawn, filled.is_new(drawn.entry));
    }
    for (drawn, corner) in named {
        plot.name(&mut figure, drawn, corner, filled.is_new(drawn.entry));
    }
    figure
}

impl Plot<'_> {
    fn at(&self, [x, y]: Dot) -> Vec2 {
        let part = Vec2::new(self.chart.x.part(x), 1.0 - self.chart.y.part(y));
        self.min + part * (self.max - self.min)
    }

    fn axes(&self, figure: &mut Figure, up: &[(f64, String)]) {
        let (u, small) = (self.look.text, self.look.small());
        for (value, text) in up.iter().filter(|(value, _)| self.chart.y.shows(*value)) {
            let y = self.at([self.chart.x.from, *value]).y;
            figure.add(Role::Panel, None, line(Vec2::new(self.min.x, y), Vec2::new(self.max.x, y)));
            let at = Vec2::new(self.min.x - u * 0.5, y);
            write(figure, Role::Quiet, None, at, text, small, Face::Regular, Anchor::End);
        }
        let across = self.chart.x.marks(((self.max.x - self.min.x) / (u * 6.0)).max(2.0));
        for (value, text) in across.iter().filter(|(value, _)| self.chart.x.shows(*value)) {
            let x = self.at([*value, self.chart.y.from]).x;
            figure.add(Role::Panel, None, line(Vec2::new(x, self.min.y), Vec2::new(x, self.max.y)));
            let at = Vec2::new(x, self.max.y + u * 1.0);
            write(figure, Role::Quiet, None, at, text, small, Face::Regular, Anchor::Middle);
        }
        let corner = Vec2::new(self.min.x, self.max.y);
        figure.add(Role::Edge, None, line(corner, self.max));
        figure.add(Role::Edge, None, line(corner, self.min));
        let middle = Vec2::new((self.min.x + self.max.x) * 0.5, self.max.y + u * 2.4);
        write(figure, Role::Quiet, None, middle, &self.chart.x.name, small, Face::Regular, Anchor::Middle);
        let above = Vec2::new(self.look.margin(), self.min.y - u * 1.2);
        write(figure, Role::Quiet, None, above, &self.chart.y.name, small, Face::Regular, Anchor::Start);
    }

    /// The line or the point itself.
    fn ink(&self, figure: &mut Figure, drawn: &Drawn, new: bool) {
        let place = place(drawn.entry);
        let u = self.look.text;
        match &drawn.curve {
            Curve::Point(dot) => {
                let center = self.at(*dot);
                // Lines end at its rim.
                figure.add(Role::Page, place, Ink::Circle { center, radius: u * 0.42 });
                if drawn.moves {
                    // From where it stands on the axes.
                    let feet = [Vec2::new(center.x, self.max.y), Vec2::new(self.min.x, center.y)];
                    for foot in feet {
                        figure.add(Role::Ray, place, line(foot, center));
                    }
                    figure.add(Role::Tick, place, Ink::Circle { center, radius: u * 0.5 });
                    return;
                }
                let role = if new { Role::Here } else { Role::Text };
                figure.add(role, place, Ink::Circle { center, radius: u * 0.42 });
            }
            Curve::Line { dots, guess } => {
                let rough = drawn.known == Known::Roughly;
                let role = match (guess, new) {
                    _ if rough => Role::Waiting,
                    (true, _) => Role::Waiting,
                    (false, true) => Role::Here,
                    (false, false) => Role::Seen,
                };
                let points: Vec<Vec2> =
                    dots.iter().filter(|dot| self.chart.y.shows(dot[1])).map(|dot| self.at(*dot)).collect();
                // What was measured has few points, a law has many: each of the few is marked.
                let marks = if points.len() < LAW { points.clone() } else { Vec::new() };
                if points.len() > 1 {
                    figure.add(role, place, Ink::Line { points });
                }
                for center in marks {
                    figure.add(Role::Page, place, Ink::Circle { center, radius: u * 0.25 });
                    figure.add(Role::Seen, place, Ink::Circle { center, radius: u * 0.25 });
                }
            }
        }
    }

    /// Where a name covers least.
    fn place(&mut self, drawn: &Drawn) -> Option<Vec2> {
        let u = self.look.text;
        let wide =
            text_width(&drawn.name, Face::Bold, u).max(text_width(&drawn.note, Face::Regular, self.look.small()));
        let size = Vec2::new(wide, if drawn.note.is_empty() { u * 1.3 } else { u * 2.6 });
        let named = self.named(drawn).into_iter();
        let corners = named.flat_map(|at| self.around(at, size).into_iter().map(move |corner| (at, corner)));
        let hidden = |(at, corner): &(Vec2, Vec2)| self.hidden(*corner, *corner + size) + self.taken_from(drawn, *at);
        let (_, corner) = corners.min_by_key(hidden)?;
        self.taken.push((corner, corner + size));
        Some(corner)
    }

    /// The name, with its note below.
    fn name(&self, figure: &mut Figure, drawn: &Drawn, corner: Vec2, new: bool) {
        let u = self.look.text;
        let place = place(drawn.entry);
        let role = match drawn.known {
            Known::Roughly => Role::Quiet,
            _ if new || drawn.moves => Role::Value,
            _ => Role::Text,
        };
        write(figure, role, place, corner + Vec2::new(0.0, u * 0.65), &drawn.name, u, Face::Bold, Anchor::Start);
        let below = corner + Vec2::new(0.0, u * 1.95);
        write(figure, Role::Quiet, place, below, &drawn.note, self.look.small(), Face::Regular, Anchor::Start);
    }

    /// Where on a curve its name may stand: at a point, at the end of what was measured or before it, along a law.
    fn named(&self, drawn: &Drawn) -> Vec<Vec2> {
        let dots = match &drawn.curve {
            Curve::Point(dot) => return vec![self.at(*dot)],
            Curve::Line { dots, .. } => dots,
        };
        let inside: Vec<Vec2> = dots.iter().filter(|dot| self.chart.y.shows(dot[1])).map(|dot| self.at(*dot)).collect();
        if inside.len() < LAW {
            return inside.into_iter().rev().collect();
        }
        // In the middle there is most room.
        [0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8].map(|part| inside[(inside.len() as f32 * part) as usize]).to_vec()
    }

    /// What it counts to name something where another line ends, which is named there.
    fn taken_from(&self, drawn: &Drawn, at: Vec2) -> usize {
        let curves = || self.chart.drawn.iter().zip(&self.dots);
        let ends = |own: bool| {
            let some = curves().filter(move |(other, _)| (other.entry == drawn.entry) == own);
            let lines = some.filter(|(_, dots)| dots.len() > 1);
            lines.filter_map(|(_, dots)| dots.last()).any(|end| end.distance(at) < self.look.text)
        };
        if ends(false) && !ends(true) { POINT } else { 0 }
    }

    /// The corners of a name beside a point, right of it first, and of one moved into the chart.
    fn around(&self, at: Vec2, size: Vec2) -> Vec<Vec2> {
        let (u, Vec2 { x: wide, y: high }) = (self.look.text, size);
        let sides = [
            Vec2::new(u * 0.9, -high * 0.5),
            Vec2::new(-u * 0.9 - wide, -high * 0.5),
            Vec2::new(u * 0.5, u * 0.5),
            Vec2::new(-wide - u * 0.5, -high - u * 0.5),
            Vec2::new(u * 0.5, -high - u * 0.5),
            Vec2::new(-wide - u * 0.5, u * 0.5),
            Vec2::new(-wide * 0.5, -high - u * 0.9),
            Vec2::new(-wide * 0.5, u * 0.9),
            Vec2::new(u * 1.1, u * 0.5),
        ];
        let end = Vec2::new(self.max.x + u * 2.0, self.max.y) - size;
        let begin = Vec2::new(self.min.x + u * 0.2, self.min.y - u);
        let moved = sides[6..].iter().map(|side| at + *side).map(|corner| corner.clamp(begin, end.max(begin)));
        let inside = |corner: &Vec2| corner.cmpge(begin).all() && corner.cmple(end).all();
        sides.iter().map(|side| at + *side).filter(inside).chain(moved).collect()
    }

    /// How much a box on the page would hide of names, lines and points.
    fn hidden(&self, min: Vec2, max: Vec2) -> usize {
        let apart = |(a, b): &(Vec2, Vec2)| max.x < a.x || b.x < min.x || max.y < a.y || b.y < min.y;
        let names = self.taken.iter().filter(|taken| !apart(taken)).count();
        let within = |at: Vec2| at.x > min.x && at.x < max.x && at.y > min.y && at.y < max.y;
        let crosses = |from: Vec2, to: Vec2| {
            !apart(&(from.min(to), from.max(to)))
                && (0..=PARTS).any(|part| within(from.lerp(to, part as f32 / PARTS as f32)))
        };
        let curves = self.chart.drawn.iter().zip(&self.dots).map(|(drawn, dots)| match &drawn.curve {
            Curve::Point(_) => usize::from(within(dots[0])) * POINT,
            Curve::Line { .. } => dots.windows(2).filter(|pair| crosses(pair[0], pair[1])).count(),
        });
        names * NAME + curves.sum::<usize>()
    }
}

/// What it counts to hide a point or a name, where a piece of a line counts 1.
const POINT: usize = 100;
const NAME: usize = 1000;
