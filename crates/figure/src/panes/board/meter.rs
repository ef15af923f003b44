//! A meter: numbers on tracks of their own, to be moved by hand, and what follows from them.

use glam::Vec2;

use super::Filled;
use crate::page::{Anchor, Figure, Ink, Look, block, line, write};
use crate::theme::{Face, Role, text_width};
use crate::words::number;

/// A meter of a board.
#[derive(Clone, Debug, PartialEq)]
pub struct Meter {
    /// What it is about.
    pub title: String,
    /// What stands behind the title.
    pub about: String,
    /// The numbers.
    pub knobs: Vec<Knob>,
    /// What follows from them.
    pub gives: Vec<Given>,
    /// The entry with which it comes to be seen: the first that follows it.
    pub entry: usize,
}

/// A number that can be moved between two ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Knob {
    /// What it is called.
    pub name: String,
    /// What it counts.
    pub note: String,
    /// The least that it can be.
    pub from: f64,
    /// The most that it can be.
    pub to: f64,
    /// What it is.
    pub is: f64,
    /// Whether equal ways are equal factors.
    pub log: bool,
    /// Whether it is always a whole number.
    pub whole: bool,
}

/// What follows from the numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Given {
    /// What it is called.
    pub name: String,
    /// A few words below the name.
    pub note: String,
    /// Its number, with what stands behind it.
    pub value: String,
}

/// Where a number of a meter lies in a figure, so that it can be taken in the hand and typed.
#[derive(Clone, Debug, PartialEq)]
pub struct KnobLine {
    /// The number.
    pub knob: Knob,
    /// The end of its track where it is least, in points.
    pub low: Vec2,
    /// The end of its track where it is most.
    pub high: Vec2,
    /// The two corners of the box that holds its digits.
    pub digits: [Vec2; 2],
    /// The size of its digits.
    pub text: f32,
}

impl Knob {
    /// How far along its track a number lies: 0 at its lower end, 1 at its upper one.
    pub fn part(&self, value: f64) -> f64 {
        let along = |value: f64| if self.log { libm::log(value) } else { value };
        (along(value) - along(self.from)) / (along(self.to) - along(self.from))
    }

    /// The number that far along; whole, and in three digits where it is large.
    pub fn at(&self, part: f64) -> f64 {
        let part = part.clamp(0.0, 1.0);
        let value = match self.log {
            true => self.from * libm::pow(self.to / self.from, part),
            false => self.from + (self.to - self.from) * part,
        };
        self.nearest(rounded(value))
    }

    /// The nearest number that it can be.
    pub fn nearest(&self, value: f64) -> f64 {
        let value = if self.whole { libm::round(value) } else { value };
        value.clamp(self.from, self.to)
    }

    /// The number as it is read: all digits where they are whole and few, else three.
    pub fn digits(value: f64) -> String {
        if value == libm::trunc(value) && value.abs() < 1e6 { format!("{value}") } else { number(value as f32) }
    }
}

/// A number in three digits.
fn rounded(value: f64) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    let unit = libm::pow(10.0, libm::floor(libm::log10(value.abs())) - 2.0);
    libm::round(value / unit) * unit
}

impl KnobLine {
    /// Where its knob is.
    pub fn at(&self) -> Vec2 {
        self.low.lerp(self.high, self.knob.part(self.knob.is) as f32)
    }

    /// The number where its knob is moved to this point.
    pub fn to(&self, point: Vec2) -> f64 {
        let along = self.high - self.low;
        self.knob.at(f64::from((point - self.low).dot(along) / along.length_squared().max(1e-6)))
    }

    pub(super) fn moved(mut self, by: Vec2) -> KnobLine {
        for point in [&mut self.low, &mut self.high].into_iter().chain(&mut self.digits) {
            *point += by;
        }
        self
    }
}

/// The heights of a number and of what follows, in letters.
const KNOB: f32 = 3.1;
const GIVEN: f32 = 3.2;
/// The room of the heading, in letters.
const HEAD: f32 = 4.2;
/// The most letters that a track is long.
const LONGEST: f32 = 34.0;

impl Meter {
    /// How high it stands.
    pub(super) fn height(&self, look: &Look) -> f32 {
        look.text * self.lines()
    }

    fn lines(&self) -> f32 {
        HEAD + KNOB * self.knobs.len() as f32 + GIVEN * self.gives.len() as f32
    }

    /// How wide and how high it is at least, in letters.
    pub(super) fn letters(&self) -> [f32; 2] {
        [self.names(1.0) + self.widest(1.0) + 12.0, self.lines()]
    }

    /// The width of its names, with what the numbers count behind them.
    fn names(&self, text: f32) -> f32 {
        let width = |knob: &Knob| {
            let note = text_width(&knob.note, Face::Regular, text * 0.9);
            text_width(&knob.name, Face::Bold, text) + if note > 0.0 { note + text * 0.6 } else { 0.0 }
        };
        self.knobs.iter().map(width).fold(0.0, f32::max)
    }

    /// The width of the longest number that can stand there.
    fn widest(&self, text: f32) -> f32 {
        let ends = self.knobs.iter().flat_map(|knob| [knob.from, knob.to, knob.is]);
        let width = |value: f64| text_width(&Knob::digits(value), Face::Mono, text);
        ends.map(width).fold(text_width("5.55·10¹⁰", Face::Mono, text), f32::max) + text
    }

    /// Where its numbers lie in a room of this size.
    pub(super) fn lines_in(&self, room: Vec2, look: &Look) -> Vec<KnobLine> {
        let u = look.text;
        let left = look.margin() + self.names(u) + u * 1.6;
        let wide = self.widest(u);
        let right = (room.x - look.margin() - wide - u * 1.2).min(left + u * LONGEST).max(left + u * 4.0);
        let line = |(index, knob): (usize, &Knob)| {
            let y = u * (HEAD - 0.4 + KNOB * index as f32);
            let corner = Vec2::new(right + u * 1.2, y - u * 0.85);
            KnobLine {
                knob: knob.clone(),
                low: Vec2::new(left, y),
                high: Vec2::new(right, y),
                digits: [corner, corner + Vec2::new(wide, u * 1.7)],
                text: u,
            }
        };
        self.knobs.iter().enumerate().map(line).collect()
    }
}

pub(super) fn draw(meter: &Meter, filled: Filled, room: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(room);
    look.heading(&mut figure, &meter.title, &meter.about);
    let (u, left, small) = (look.text, look.margin(), look.small());
    let lines = meter.lines_in(room, look);
    for KnobLine { knob, low, high, digits: [min, max], .. } in &lines {
        let at = low.lerp(*high, knob.part(knob.is) as f32);
        write(&mut figure, Role::Text, None, Vec2::new(left, low.y), &knob.name, u, Face::Bold, Anchor::Start);
        let behind = Vec2::new(left + text_width(&knob.name, Face::Bold, u) + u * 0.6, low.y);
        write(&mut figure, Role::Quiet, None, behind, &knob.note, small, Face::Regular, Anchor::Start);
        figure.add(Role::Edge, None, line(*low, *high));
        figure.add(Role::Live, None, line(*low, at));
        figure.add(Role::Tick, None, Ink::Circle { center: at, radius: u * 0.55 });
        for (end, value, anchor) in [(low, knob.from, Anchor::Start), (high, knob.to, Anchor::End)] {
            let below = *end + Vec2::new(0.0, u * 1.25);
            let text = Knob::digits(value);
            write(&mut figure, Role::Quiet, None, below, &text, small * 0.92, Face::Regular, anchor);
        }
        figure.add(Role::Panel, None, block(*min, *max - *min, u * 0.3));
        let end = Vec2::new(max.x - u * 0.5, low.y);
        let text = Knob::digits(knob.is);
        write(&mut figure, Role::Value, None, end, &text, u, Face::Mono, Anchor::End);
    }
    let top = u * (HEAD + KNOB * lines.len() as f32);
    let widest = meter.gives.iter().map(|given| text_width(&given.value, Face::Bold, u * 1.6)).fold(u * 3.0, f32::max);
    for (index, given) in meter.gives.iter().enumerate() {
        let y = top + u * GIVEN * index as f32;
        // Whoever is asked does not read it off.
        let value = if filled.asks { "?" } else { &given.value };
        let role = if filled.asks { Role::Guess } else { Role::Missed };
        write(&mut figure, role, None, Vec2::new(left, y), value, u * 1.6, Face::Bold, Anchor::Start);
        let x = left + widest + u * 0.9;
        let one = given.note.is_empty();
        let name = Vec2::new(x, if one { y } else { y - u * 0.55 });
        write(&mut figure, Role::Text, None, name, &given.name, u, Face::Regular, Anchor::Start);
        let note = Vec2::new(x, y + u * 0.8);
        write(&mut figure, Role::Quiet, None, note, &given.note, small, Face::Regular, Anchor::Start);
    }
    figure
}

#[cfg(test)]
mod tests {
    use super::*;

    fn knob(from: f64, to: f64, log: bool, whole: bool) -> Knob {
        Knob { name: "N".to_owned(), note: String::new(), from, to, is: from, log, whole }
    }

    #[test]
    fn a_number_lies_where_its_track_says_and_never_beyond_its_ends() {
        // The ends, the scale, whether it is whole, how far along, and the number there.
        let table = [
            (1.0, 10_000.0, true, true, 0.5, 100.0),
            (1.0, 10_000.0, true, true, -1.0, 1.0),
            (1.0, 10_000.0, true, true, 2.0, 10_000.0),
            (1.0, 5e10, true, true, 1.0, 5e10),
            (0.0, 10.0, false, true, 0.26, 3.0),
            (0.0, 10.0, false, false, 0.2604, 2.6),
            (-1.0, 1.0, false, false, 0.5, 0.0),
        ];
        for (from, to, log, whole, part, value) in table {
            let knob = knob(from, to, log, whole);
            assert_eq!(knob.at(part), value, "{part} of {from}..{to}");
            assert!((0.0..=1.0).contains(&knob.part(knob.at(part))));
        }
    }
}
