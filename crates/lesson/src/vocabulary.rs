//! The names of events and of their fields, as slides and listings use them.

use raystep_accel::Trial;

use crate::Plays;
use crate::problem::{listed, misspelt};
use crate::reading::Reading;

impl Plays {
    /// Every name that a slide can wait for: those of the events, and their beginnings (`split`).
    pub(crate) fn events(self) -> Vec<&'static str> {
        let mut known: Vec<&'static str> = Vec::new();
        for name in self.vocabulary().iter().flat_map(|(names, _)| names.iter().copied()) {
            let beginnings = name.match_indices('.').map(|(dot, _)| &name[..dot]);
            for word in beginnings.chain([name]) {
                if !known.contains(&word) {
                    known.push(word);
                }
            }
        }
        known
    }

    /// The fields that every event of that name has.
    pub(crate) fn fields(self, event: &str) -> Vec<&'static str> {
        let known = self.vocabulary().iter();
        let mut variants =
            known.filter(|(known, _)| known.iter().any(|name| names(event, name))).map(|(_, fields)| *fields);
        let first = variants.next();
        let of_all = first.filter(|_| self == Plays::Pairs).map_or(&[][..], |_| &Trial::COMMON);
        let fields = variants.fold(first.unwrap_or_default().to_vec(), |common, fields| {
            common.into_iter().filter(|f| fields.contains(f)).collect()
        });
        let others = fields.into_iter().filter(|field| !of_all.contains(field));
        let mut common: Vec<_> = of_all.iter().copied().chain(others).collect();
        // Whatever a packet does, it says who takes part.
        if self == Plays::Packet {
            common.push("lanes");
        }
        common
    }
}

/// Whether `name` is `pattern`, or begins with it at a dot; `|` stands between alternatives.
pub fn names(pattern: &str, name: &str) -> bool {
    let begins = |word: &str| name.strip_prefix(word).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'));
    pattern.split('|').any(begins)
}

/// Says so if there is no such event.
pub(crate) fn check_event(event: &str, at: usize, reading: &mut Reading<'_>) -> bool {
    let known = reading.plays.events();
    let what = format!(
        "event of a {}",
        match reading.plays {
            Plays::Walks => "walk",
            Plays::Pairs => "pair",
            plays => plays.name(),
        }
    );
    let mut good = true;
    for word in event.split('|').filter(|word| !known.contains(word)) {
        reading.problem(at, misspelt(&what, word, &known));
        good = false;
    }
    good
}

/// Says so if the event lacks the field.
pub(crate) fn check_field(event: &str, field: &str, at: usize, reading: &mut Reading<'_>) {
    let (known, events) = (reading.plays.fields(event), reading.plays.events());
    if !known.contains(&field) && event.split('|').all(|word| events.contains(&word)) {
        let message = misspelt(&format!("field of `{event}`"), field, &known);
        let all = if message.contains("did you mean") && !known.is_empty() {
            format!(" It has {}.", listed(&known))
        } else {
            String::new()
        };
        reading.problem(at, message + &all);
    }
}
