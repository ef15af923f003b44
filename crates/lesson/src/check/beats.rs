//! What beats say, ask and have said where they stand: every fact is there, every choice has its reason.

use raystep_accel::{Event, Value, Visit};

use super::Checker;
use crate::problem::{listed, misspelt};
use crate::{About, Ask, Beat, Column, Facts, Listing, Play, Slide, Tape, condition, names};

impl Checker<'_> {
    /// Keeps which paragraphs can be said.
    pub(super) fn hear(&mut self, slide: &Slide, play: &Play) {
        for (beat, step) in slide.beats.iter().zip(&play.beats) {
            let Some(facts) = step.and_then(|step| Facts::at(play, step)) else { continue };
            for paragraph in beat.paragraphs.iter().filter(|paragraph| paragraph.is_asked_for(&facts)) {
                // Nobody times anything here.
                let timed = matches!(&play.tape, Tape::Board(board) if board.untimed().is_some());
                let later = |name: &str| {
                    let field = name.rsplit('.').next().unwrap_or(name);
                    timed && Column::NAMES.iter().any(|(known, column)| *known == field && column.is_timed())
                };
                *self.told.entry(paragraph.spot).or_default() |= paragraph.is_known_but(&facts, &later);
            }
        }
    }

    /// A beat where it belongs, `what`: it happens, its listing shows it, and there is something to ask.
    pub(super) fn beat(
        &mut self,
        slide: &Slide,
        what: &str,
        beat: &Beat,
        step: Option<usize>,
        play: &Play,
        listing: Option<&Listing>,
    ) {
        let wait = beat.wait(play.scene.flat);
        let Some((step, facts)) = step.and_then(|step| Some((step, Facts::at(play, step)?))) else {
            let seen = play.tape.events().filter(|event| wait.matches(event)).count();
            let message = format!(
                "`{wait}` never happens {what} after the beat before it{}",
                if seen > 0 { format!(" (in the whole {}: {seen})", slide.plays.name()) } else { String::new() },
            );
            self.say(slide, beat.spot, message);
            return;
        };
        let event = facts.event();
        if let Some(listing) = listing.filter(|listing| listing.line_of(&facts).is_none()) {
            self.say(slide, beat.spot, format!("the listing `{}` has no line for `{}`", listing.name, event.name()));
        }
        if let Some(ask) = &beat.ask {
            let choices = ask.choices(play, step);
            if choices.len() < 2 || !choices.iter().any(|choice| choice.right) {
                self.say(slide, ask.spot, format!("there is nothing to choose between {what}"));
            }
            self.reasons(slide, ask, play, event);
        }
    }

    /// Every reason is for an answer that can be given.
    pub(super) fn reasons(&mut self, slide: &Slide, ask: &Ask, play: &Play, event: &Event) {
        if let (About::Least(_), Tape::Walks(walks)) = (&ask.about, &play.tape) {
            let mut allowed = walks.names();
            allowed.push(crate::choices::ALIKE.to_owned());
            let allowed: Vec<&str> = allowed.iter().map(String::as_str).collect();
            for reason in ask.reasons.iter().filter(|reason| !allowed.contains(&reason.answer.as_str())) {
                self.say(slide, reason.spot, misspelt("answer to this question", &reason.answer, &allowed));
            }
        }
        let Some(right) = ask.right(play, event) else { return };
        for reason in ask.reasons.iter().filter(|reason| reason.answer != "else") {
            let answer = reason.answer.as_str();
            let mut allowed = spellings(&right);
            if let About::Event(events) = &ask.about {
                allowed.extend(events.iter().map(String::as_str));
            }
            let alike = |field: &&&str| {
                event.field(field).is_some_and(|value| std::mem::discriminant(&value) == std::mem::discriminant(&right))
            };
            match right {
                Value::Number(_) if crate::choices::is_cut(ask, event) => allowed.extend(crate::choices::CUTS),
                Value::Place(_) | Value::Number(_) => {
                    allowed.extend(event.fields().iter().filter(alike));
                    if matches!(event, Event::Walk(Visit::Split { .. })) {
                        allowed.extend(crate::choices::SIBLINGS);
                    }
                }
                Value::Lanes(_) => {
                    allowed.extend(crate::choices::LANES);
                    allowed.extend(event.fields().iter().filter(alike));
                }
                Value::Count(_) if answer.parse::<u32>().is_ok() => continue,
                Value::Count(_) => {
                    allowed.push("all");
                    allowed.extend(event.fields().iter().filter(alike));
                    allowed.extend(slide.plays.events());
                }
                _ => {}
            }
            if !allowed.contains(&answer) {
                self.say(slide, reason.spot, misspelt("answer to this question", answer, &allowed));
            }
        }
        if let Value::Word(_, words @ [_, ..]) = right {
            for option in ask.options.iter().filter(|option| !words.contains(&option.as_str())) {
                self.say(slide, ask.spot, misspelt("answer to this question", option, words));
            }
        }
    }

    /// Conditions compare fields with values that they can have.
    pub(super) fn values(&mut self, slide: &Slide, beat: &Beat, play: &Play) {
        let waits = std::iter::once(&beat.at).chain(&beat.at_solid).flat_map(|wait| &wait.fields);
        let waits = waits.map(|(field, text)| (field.as_str(), text.as_str(), beat.spot));
        let conditions = beat.paragraphs.iter().filter_map(|p| Some((p.only_if.as_ref()?, p.spot)));
        let words = conditions.clone().flat_map(|(all, spot)| all.words().map(move |(fact, text)| (fact, text, spot)));
        for (fact, text, spot) in waits.chain(words) {
            // Of a k-DOP's slabs some stand across axes and others between them: one example does not say all.
            let mut allowed: Vec<&str> = Vec::new();
            let can_be = |value: Value| {
                let words = spellings(&value);
                let free = words.is_empty() || words.contains(&text);
                for word in words {
                    if !allowed.contains(&word) {
                        allowed.push(word);
                    }
                }
                free
            };
            if !examples(beat, fact, play).any(can_be) && !allowed.is_empty() {
                let message = format!("`{fact}` is never `{text}`: it can be {}", listed(&allowed));
                self.say(slide, spot, message);
            }
        }
        for (fact, spot) in conditions.flat_map(|(all, spot)| all.numbers().map(move |fact| (fact, spot))) {
            if examples(beat, fact, play).next().is_some_and(|value| condition::number_of(&value).is_none()) {
                self.say(slide, spot, format!("`{fact}` is no number: it can only be asked whether it `=` a word"));
            }
        }
    }
}

/// The values of a fact of a beat, wherever in the play it is one.
fn examples<'a>(beat: &'a Beat, fact: &'a str, play: &'a Play) -> impl Iterator<Item = Value> + 'a {
    let (event, field, count) = match fact.rsplit_once('.') {
        Some(("count" | "beside.count" | "alone.count", _)) => (None, "", Some(Value::Count(0))),
        // `count.slab.divide`: what is counted has a name of two words.
        Some((event, _)) if ["count.", "beside.", "alone."].iter().any(|of| event.starts_with(of)) => (None, "", None),
        Some((event, field)) => (Some(event), field, None),
        None => (Some(beat.at.event.as_str()), fact, None),
    };
    let named = event.into_iter().flat_map(|event| play.tape.events().filter(move |other| names(event, other.name())));
    count.into_iter().chain(named.filter_map(|event| event.field(field)))
}

/// How a field's values are spelt, where there are but a few.
fn spellings(value: &Value) -> Vec<&'static str> {
    match value {
        Value::Flag(_) => vec!["yes", "no"],
        Value::Axis(_) => vec!["x", "y", "z"],
        Value::Word(_, words) => words.to_vec(),
        _ => Vec::new(),
    }
}
