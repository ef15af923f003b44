//! A listing: pseudocode of our own, its lines labelled with the events they show.

use crate::reading::Reading;
use crate::vocabulary::{check_event, names};
use crate::{Condition, Facts, Plays, Problem, template};

/// An algorithm in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Listing {
    /// Its name: the file without its ending.
    pub name: String,
    /// Its lines.
    pub lines: Vec<Line>,
    /// The file it was read from.
    pub file: String,
}

/// A line of a listing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// How deep it is nested: two spaces each.
    pub indent: usize,
    /// The pseudocode.
    pub text: String,
    /// The events it shows: names, or the beginnings of names.
    pub events: Vec<String>,
    /// It shows them only if this holds.
    pub only_if: Option<Condition>,
    /// The line again with this step's numbers: text with `{{field}}`.
    pub values: Option<String>,
}

impl Listing {
    /// The line that shows the event of a step; of several, the one with the longest label, then one with a
    /// condition, then the first.
    pub fn line_of(&self, facts: &Facts<'_>) -> Option<usize> {
        let event = facts.event().name();
        let label = |line: &Line| {
            let length = line.events.iter().filter(|e| names(e, event)).map(String::len).max()?;
            let holds = line.only_if.as_ref().is_none_or(|condition| condition.holds(facts));
            holds.then_some((length, line.only_if.is_some()))
        };
        let fits = self.lines.iter().enumerate().filter_map(|(index, line)| Some((index, label(line)?)));
        fits.reduce(|best, other| if other.1 > best.1 { other } else { best }).map(|(index, _)| index)
    }

    /// The first line that shows events of this name, whatever else it asks for.
    pub fn line_named(&self, event: &str) -> Option<usize> {
        let label = |line: &Line| line.events.iter().filter(|e| names(e, event)).map(String::len).max();
        let fits = self.lines.iter().enumerate().filter_map(|(index, line)| Some((index, label(line)?)));
        fits.reduce(|best, other| if other.1 > best.1 { other } else { best }).map(|(index, _)| index)
    }

    /// Reads `code | event event if condition : values` line by line.
    pub(crate) fn read(name: &str, file: &str, text: &str) -> (Listing, Vec<Problem>) {
        let mut reading = Reading::new(file, text);
        let mut lines: Vec<Line> = Vec::new();
        if !reading.is_too_large() {
            reading.plays = whose(&reading);
            lines.extend(reading.lines().map(|(at, line)| read_line(at, line, &mut reading)));
        }
        while lines.last().is_some_and(|line| line.text.is_empty()) {
            lines.pop();
        }
        (Listing { name: name.to_owned(), lines, file: file.to_owned() }, reading.finish())
    }
}

/// Whose algorithm it is: a walk's, a packet's, a builder's, that of a fitting or that of pairs, whichever knows most of the events that it
/// names.
fn whose(reading: &Reading<'_>) -> Plays {
    let labels = reading.lines().filter_map(|(_, line)| line.split_once(" | "));
    let words: Vec<&str> =
        labels.flat_map(|(_, label)| label.split(" : ").next()).flat_map(str::split_whitespace).collect();
    let known = |plays: Plays| {
        let events = plays.events();
        words.iter().filter(|word| events.contains(word)).count()
    };
    // What a lane of a packet does goes by the names of walks.
    let others = [Plays::Build, Plays::Fit, Plays::Pairs, Plays::Packet];
    others.into_iter().fold(Plays::Walk, |best, other| if known(other) > known(best) { other } else { best })
}

/// Reads one line that begins at byte `at`.
fn read_line(at: usize, line: &str, reading: &mut Reading<'_>) -> Line {
    let (code, label) = line.split_once(" | ").unwrap_or((line, ""));
    let (names, values) = match label.split_once(" : ") {
        Some((names, values)) => (names, Some(values)),
        None => (label, None),
    };
    let byte_of = |part: &str| at + (part.as_ptr() as usize - line.as_ptr() as usize);
    let (names, condition) = match names.split_once(" if ") {
        Some((names, condition)) => (names, Some(condition.trim())),
        None => (names, None),
    };
    let events: Vec<String> = names.split_whitespace().map(str::to_owned).collect();
    for word in names.split_whitespace() {
        check_event(word, byte_of(word), reading);
        if let Some(values) = values {
            template::check(values, byte_of(values), word, reading);
        }
    }
    if line.contains(" | ") && events.is_empty() {
        reading.problem(byte_of(label), "a label begins with the events that its line shows: `code | plane : {{t}}`");
    }
    let only_if =
        condition.and_then(|condition| Condition::read(condition, &events.join("|"), byte_of(condition), reading));
    Line {
        indent: (code.len() - code.trim_start().len()) / 2,
        text: code.trim().to_owned(),
        events,
        only_if,
        values: values.map(|values| values.trim().to_owned()),
    }
}
