//! What a beat waits for: `split.both`, `push#2`, `slab.order` on the y axis.

use std::fmt;

use raystep_accel::{Event, Place, Value};

use crate::Tape;
use crate::reading::Reading;
use crate::vocabulary::{check_event, check_field, names};

/// An event to wait for: its name or the beginning of its name, which one of several, and what its
/// fields must be.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Wait {
    /// `"split.both"`, `"split"` for any of them, `"pop|drop"` for one or the other.
    pub event: String,
    /// The first, the second ... from where the walk stands.
    pub nth: u32,
    /// Fields and the values they must have, as text.
    pub fields: Vec<(String, String)>,
    /// Of walks side by side, the one that it waits for.
    pub of: Option<String>,
}

impl Wait {
    /// Whether this is such an event, whichever of several.
    pub fn matches(&self, event: &Event) -> bool {
        names(&self.event, event.name())
            && self.fields.iter().all(|(field, text)| event.field(field).is_some_and(|value| says(&value, text)))
    }

    /// The step that shows the event, looking from step `from` on.
    pub fn step(&self, tape: &Tape, from: usize, flat: bool) -> Option<usize> {
        let seen = |event: &Event| !(flat && event.concerns_z());
        let own = |index: usize| self.of.as_ref().is_none_or(|name| tape.is_of(index, name));
        let hits = tape.events().enumerate().skip(from);
        let hits = hits.filter(|(index, event)| seen(event) && own(*index) && self.matches(event));
        hits.map(|(index, _)| index + 1).nth(self.nth.saturating_sub(1) as usize)
    }
}

/// Reads `push#2`, or `slab.order#2 swapped=yes`; `at` is where it stands.
pub(crate) fn parse(text: &str, at: usize, reading: &mut Reading<'_>) -> Option<Wait> {
    let mut words = text.split_whitespace();
    let name = words.next().unwrap_or_default();
    let (event, nth) = name.split_once('#').map_or((name, "1"), |(event, nth)| (event, nth));
    let nth = match nth.parse() {
        Ok(nth) if nth > 0 => nth,
        _ => {
            reading.problem(at, format!("`#{nth}` should be a number from 1: `push#2` is the second push"));
            return None;
        }
    };
    let mut wait = Wait { event: event.to_owned(), nth, fields: Vec::new(), of: None };
    for word in words {
        let Some((field, value)) = word.split_once('=') else {
            reading.problem(at, format!("`{word}` should be `field=value`"));
            return None;
        };
        check_field(event, field, at, reading);
        wait.fields.push((field.to_owned(), value.to_owned()));
    }
    check_event(event, at, reading).then_some(wait)
}

impl fmt::Display for Wait {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.event)?;
        if self.nth > 1 {
            write!(f, "#{}", self.nth)?;
        }
        self.fields.iter().try_for_each(|(field, value)| write!(f, " {field}={value}"))?;
        self.of.iter().try_for_each(|name| write!(f, " of={name}"))
    }
}

/// Whether a value is written like this in a slide.
pub(crate) fn says(value: &Value, text: &str) -> bool {
    match *value {
        Value::Flag(yes) => text == if yes { "yes" } else { "no" },
        Value::Axis(axis) => text == axis.name(),
        Value::Word(word, _) => text == word,
        Value::Count(count) => text.parse() == Ok(count),
        Value::Number(number) => text.parse() == Ok(number),
        Value::Place(place) => text == id_text(place),
        Value::Lanes(lanes) => text == lanes.to_string() || text.parse() == Ok(lanes.count()),
        Value::Box(_) => false,
    }
}

/// The id of a place as a slide writes it.
fn id_text(place: Place) -> String {
    match place {
        Place::World => "box".to_owned(),
        Place::Node(node) => node.to_string(),
        Place::Cell(cell) => cell.to_string(),
        Place::Prim(prim) => prim.to_string(),
    }
}
