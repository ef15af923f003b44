//! The possible answers of a question, read off what is played.

use raystep_accel::{Axis, Event, Grow, Lanes, Place, Structure, Value, Visit};

use crate::{About, Ask, Choice, Play, Reason, Tape, names};

/// The answers beside the right one to the question where a node is cut: nearest to its middle, and with
/// the most even shares.
pub(crate) const CUTS: [&str; 2] = ["middle", "even"];

/// How a slide writes that no walk has the fewest alone.
pub(crate) const ALIKE: &str = "alike";

/// The answers to the question which rays of a packet take part that are no fields of its event: those of this step,
/// every ray that there is, those that the right answer leaves out.
pub(crate) const LANES: [&str; 3] = ["lanes", "all", "rest"];

/// What a slide calls the children of a split as they lie in memory.
pub(crate) const SIBLINGS: [&str; 2] = ["first", "second"];

/// Most answers of a question about rays: there are four keys.
const LETTERS: usize = 4;

/// As many answers as a question about a number offers.
const NUMBERS: usize = 3;

impl Ask {
    /// The answers to choose from when the tape stands before `step`, the right one among them. Fewer than
    /// two: this walk leaves nothing to ask.
    pub fn choices(&self, play: &Play, step: usize) -> Vec<Choice> {
        let Some(event) = play.event(step) else { return Vec::new() };
        if let About::Said(right) = &self.about {
            return self.said(right);
        }
        if let About::Least(event) = &self.about {
            return self.least(event, play);
        }
        let Some(right) = self.right(play, &event) else { return Vec::new() };
        if is_cut(self, &event) {
            return self.cuts(play, step, &event);
        }
        let values = match right {
            Value::Flag(_) => vec![("yes".to_owned(), Value::Flag(true)), ("no".to_owned(), Value::Flag(false))],
            Value::Axis(_) => axes(play.scene.flat),
            Value::Word(name, []) => self.events(play, name),
            Value::Word(word, all) => self.words(word, all),
            Value::Place(_) => self.places(&event),
            Value::Number(_) => self.numbers(&event, right),
            Value::Count(count) => self.counts(play, &event, count),
            Value::Lanes(right) => self.lanes(play, &event, right),
            // Boxes cannot be chosen from.
            Value::Box(_) => Vec::new(),
        };
        let choice = |(answer, value): (String, Value)| {
            let answer = self.sibling(&play.structure, &event, &value).map_or(answer, str::to_owned);
            Choice {
                label: self.label(&answer).or_else(|| side(&play.structure, &event, &value, play.scene.flat)),
                value,
                place: if let Value::Place(place) = value { Some(place) } else { None },
                right: same(&value, &right),
                reason: if same(&value, &right) { None } else { self.reason(&answer) },
                own: None,
                of_list: false,
            }
        };
        values.into_iter().map(choice).collect()
    }

    /// The right answer.
    pub fn right(&self, play: &Play, event: &Event) -> Option<Value> {
        match &self.about {
            About::Field(field) => event.field(field),
            About::Count { event: name, .. } => Some(Value::Count(self.count(name, play, event))),
            About::Event(_) => Some(Value::Word(event.name(), &[])),
            About::Said(_) | About::Least(_) => None,
        }
    }

    /// The walks to choose from, and that none of them has the fewest such events alone.
    fn least(&self, event: &str, play: &Play) -> Vec<Choice> {
        let Tape::Walks(walks) = &play.tape else { return Vec::new() };
        let counts: Vec<u32> = walks.walks.iter().filter_map(|walk| walk.count(event, walk.len())).collect();
        let Some(least) = counts.iter().copied().min() else { return Vec::new() };
        let alone = counts.iter().filter(|count| **count == least).count() == 1;
        let walk = |(index, name): (usize, String)| (name, alone && counts.get(index) == Some(&least));
        let mut answers: Vec<(String, bool)> = walks.names().into_iter().enumerate().map(walk).collect();
        answers.push((ALIKE.to_owned(), !alone));
        let choice = |(index, (answer, right)): (usize, (String, bool))| Choice {
            label: self
                .label(&answer)
                .or_else(|| (answer == ALIKE).then(|| "no single one".to_owned()))
                .or(Some(answer.clone())),
            value: Value::Count(index as u32),
            place: None,
            right,
            reason: if right { None } else { self.reason(&answer) },
            own: None,
            of_list: false,
        };
        answers.into_iter().enumerate().map(choice).collect()
    }

    /// The answer that the slide says, among the wrong ones, in the order of their letters, which tells nothing.
    fn said(&self, right: &str) -> Vec<Choice> {
        let mut answers: Vec<(&str, Option<&Reason>)> = vec![(right, None)];
        answers.extend(self.reasons.iter().map(|reason| (reason.answer.as_str(), Some(reason))));
        answers.sort_by_key(|(answer, _)| *answer);
        let choice = |(index, (answer, reason)): (usize, (&str, Option<&Reason>))| Choice {
            label: Some(reason.and_then(|reason| reason.label.clone()).unwrap_or_else(|| answer.to_owned())),
            value: Value::Count(index as u32),
            place: None,
            right: reason.is_none(),
            reason: reason.map(|reason| reason.text.clone()),
            own: None,
            of_list: false,
        };
        answers.into_iter().enumerate().map(choice).collect()
    }

    /// How many events of that name there are, only those alike if the question says so.
    fn count(&self, name: &str, play: &Play, coming: &Event) -> u32 {
        let alike = |event: &Event| match &self.about {
            About::Count { alike: Some(field), .. } => event.field(field) == coming.field(field),
            _ => true,
        };
        play.tape.events().filter(|event| names(name, event.name()) && alike(event)).count() as u32
    }

    /// Why an answer is wrong: what the slide says of it, else what it says of all others.
    fn reason(&self, answer: &str) -> Option<String> {
        let said = |answer: &str| self.reasons.iter().find(|reason| reason.answer == answer);
        said(answer).or_else(|| said("else")).map(|reason| reason.text.clone())
    }

    /// What the slide calls a child by its place among the two, if it does.
    fn sibling(&self, structure: &Structure, event: &Event, value: &Value) -> Option<&'static str> {
        let lower = is_lower(structure, event, value)?;
        let name = SIBLINGS[usize::from(!lower)];
        self.reasons.iter().any(|reason| reason.answer == name).then_some(name)
    }

    /// What the slide writes on the button of an answer.
    fn label(&self, answer: &str) -> Option<String> {
        self.reasons.iter().find(|reason| reason.answer == answer).and_then(|reason| reason.label.clone())
    }

    /// The events that may come.
    fn events(&self, play: &Play, right: &'static str) -> Vec<(String, Value)> {
        let About::Event(patterns) = &self.about else { return Vec::new() };
        let known = play.tape.plays().vocabulary().iter().flat_map(|(known, _)| known.iter().copied());
        let value = |pattern: &String| {
            let name =
                if names(pattern, right) { Some(right) } else { known.clone().find(|name| names(pattern, name)) };
            Some((pattern.clone(), Value::Word(name?, &[])))
        };
        patterns.iter().filter_map(value).collect()
    }

    /// The words that the slide offers, or all; the right one in any case.
    fn words(&self, right: &'static str, all: &'static [&'static str]) -> Vec<(String, Value)> {
        let offered =
            |word: &&&str| self.options.is_empty() || **word == right || self.options.iter().any(|o| o == **word);
        all.iter().filter(offered).map(|word| ((*word).to_owned(), Value::Word(word, all))).collect()
    }

    /// The places that the event names, in the order of their ids, so that the order tells nothing.
    fn places(&self, event: &Event) -> Vec<(String, Value)> {
        let place = |field: &&'static str| match event.field(field) {
            Some(Value::Place(place)) if *field != "node" || self.about == About::Field("node".to_owned()) => {
                Some((place, (*field).to_owned()))
            }
            _ => None,
        };
        let mut places: Vec<(Place, String)> = event.fields().iter().filter_map(place).collect();
        places.sort();
        places.dedup_by_key(|(place, _)| *place);
        places.into_iter().map(|(place, field)| (field, Value::Place(place))).collect()
    }

    /// The right number, those that the slide gives a reason for, and others of the event.
    fn numbers(&self, event: &Event, right: Value) -> Vec<(String, Value)> {
        let About::Field(asked) = &self.about else { return Vec::new() };
        let named = self.reasons.iter().map(|reason| reason.answer.as_str());
        let mut numbers = vec![(asked.clone(), right)];
        let least = self.reasons.iter().filter(|reason| event.field(&reason.answer).is_some()).count() + 1;
        for field in named.chain(event.fields().iter().copied()) {
            if numbers.len() >= least.max(NUMBERS) {
                break;
            }
            if let Some(value @ Value::Number(_)) = event.field(field)
                && !numbers.iter().any(|(_, other)| same(other, &value))
            {
                numbers.push((field.to_owned(), value));
            }
        }
        numbers.sort_by(|a, b| number(&a.1).total_cmp(&number(&b.1)));
        numbers
    }

    /// Planes that were weighed: the one taken, the one nearest to the node's middle, the one with the most
    /// even shares. They stand in the order of their coordinates, so that the order tells nothing.
    fn cuts(&self, play: &Play, step: usize, event: &Event) -> Vec<Choice> {
        let Event::Build(Grow::Split { node, axis, plane, .. }) = *event else { return Vec::new() };
        let mut weighed: Vec<(f32, u32, Grow)> = Vec::new();
        let mut middle = None;
        for past in (1..step).rev().map_while(|step| play.event(step)) {
            match past {
                Event::Build(Grow::Weigh { node: of, axis: across, plane, below, above, .. }) if of == node => {
                    if let (true, Event::Build(grow)) = (across == axis, past) {
                        weighed.push((plane, below.abs_diff(above), grow));
                    }
                }
                Event::Build(Grow::Open { node: of, bounds, .. }) if of == node => {
                    middle = axis.axis().map(|axis| bounds.center()[axis]);
                    break;
                }
                _ => break,
            }
        }
        let Some(middle) = middle else { return Vec::new() };
        let by = |less: fn(&(f32, u32, Grow), f32) -> f32| {
            weighed.iter().min_by(|a, b| less(a, middle).total_cmp(&less(b, middle))).copied()
        };
        let taken = weighed.iter().find(|weighed| weighed.0 == plane).copied();
        let others = [by(|weighed, middle| (weighed.0 - middle).abs()), by(|weighed, _| weighed.1 as f32)];
        let mut cuts = vec![("", taken)];
        cuts.extend(CUTS.into_iter().zip(others));
        let mut choices: Vec<Choice> = Vec::new();
        for (answer, cut) in cuts {
            let Some((at, _, own)) = cut else { continue };
            let value = Value::Number(at);
            if !choices.iter().any(|other| same(&other.value, &value)) {
                let reason = if answer.is_empty() { None } else { self.reason(answer) };
                let (label, place) = (None, None);
                let (own, of_list) = (Some(Event::Build(own)), matches!(*play.structure, Structure::Bvh(_)));
                choices.push(Choice { label, value, place, right: at == plane, reason, own, of_list });
            }
        }
        choices.sort_by(|a, b| number(&a.value).total_cmp(&number(&b.value)));
        choices
    }

    /// Which rays of a packet take part: the right ones, the others that the event names, all, and those left out. In the
    /// order of their masks, which tells nothing.
    fn lanes(&self, play: &Play, event: &Event, right: Lanes) -> Vec<(String, Value)> {
        let About::Field(asked) = &self.about else { return Vec::new() };
        let Tape::Packet(packet) = &play.tape else { return Vec::new() };
        let there = Lanes::of(right.width(), |lane| lane < packet.rays.len());
        let named = event.fields().iter().chain(&["lanes"]).filter_map(|field| match event.field(field) {
            Some(Value::Lanes(lanes)) => Some(((*field).to_owned(), lanes)),
            _ => None,
        });
        let rest = Lanes::of(right.width(), |lane| there.has(lane) && !right.has(lane));
        let mut answers = vec![(asked.clone(), right)];
        for (answer, lanes) in named.chain([("rest".to_owned(), rest), ("all".to_owned(), there)]) {
            if answers.len() < LETTERS && !answers.iter().any(|(_, other)| *other == lanes) {
                answers.push((answer, lanes));
            }
        }
        answers.sort_by_key(|(_, lanes)| lanes.mask());
        answers.into_iter().map(|(answer, lanes)| (answer, Value::Lanes(lanes))).collect()
    }

    /// The right count, those that the slide gives a reason for (a number, a field, an event of the walk,
    /// `all` primitives), and neighbours.
    fn counts(&self, play: &Play, event: &Event, right: u32) -> Vec<(String, Value)> {
        let counted = |answer: &str| -> Option<u32> {
            if answer == "all" {
                return Some(raystep_accel::Primitives::len(&play.scene.prims) as u32);
            }
            match event.field(answer) {
                Some(Value::Count(count)) => Some(count),
                _ if play.tape.plays().events().contains(&answer) => Some(self.count(answer, play, event)),
                _ => answer.parse().ok(),
            }
        };
        let mut counts = vec![(String::new(), right)];
        let named = self.reasons.iter().filter_map(|r| Some((r.answer.clone(), counted(&r.answer)?)));
        // Neighbours on both sides, in an order that tells nothing about which is right.
        let apart = 1 + right / 5;
        let (more, less) = (right + apart, right.saturating_sub(apart));
        let near = if right.is_multiple_of(2) { [more, less] } else { [less, more] };
        let near = [near[0], near[1], more + apart].map(|count| (count.to_string(), count));
        for (answer, value) in named.chain(near) {
            if counts.len() < NUMBERS.max(self.reasons.len() + 1) && !counts.iter().any(|(_, other)| *other == value) {
                counts.push((answer, value));
            }
        }
        counts.sort_by_key(|(_, count)| *count);
        counts.into_iter().map(|(answer, count)| (answer, Value::Count(count))).collect()
    }
}

/// Whether it asks where a node is cut.
pub(crate) fn is_cut(ask: &Ask, event: &Event) -> bool {
    matches!(event, Event::Build(Grow::Split { .. })) && ask.about == About::Field("plane".to_owned())
}

/// x, y and, in space, z.
fn axes(flat: bool) -> Vec<(String, Value)> {
    let axes = if flat { &Axis::ALL[..2] } else { &Axis::ALL[..] };
    axes.iter().map(|axis| (axis.name().to_owned(), Value::Axis(*axis))).collect()
}

/// On which side of the split a child lies, in words: a button says more than an id.
fn side(structure: &Structure, event: &Event, value: &Value, flat: bool) -> Option<String> {
    let lower = is_lower(structure, event, value)?;
    let Event::Walk(Visit::Split { node, .. }) = event else { return None };
    let (axis, _) = structure.split(*node)?;
    let word = match (axis.axis()?, flat) {
        (Axis::X, true) => ["left", "right"],
        (Axis::Y, true) | (Axis::Z, false) => ["lower", "upper"],
        (Axis::X, false) => ["smaller x", "larger x"],
        (Axis::Y, false) => ["smaller y", "larger y"],
        (Axis::Z, true) => return None,
    };
    Some(word[usize::from(!lower)].to_owned())
}

/// Of a child of a split, whether it is the lower one, which lies first in memory.
fn is_lower(structure: &Structure, event: &Event, value: &Value) -> Option<bool> {
    match (event, value) {
        (Event::Walk(Visit::Split { node, .. }), Value::Place(Place::Node(child))) => {
            Some(structure.children(*node).first() == Some(child))
        }
        _ => None,
    }
}

/// Whether two values read the same: numbers, in the three digits that a student sees.
fn same(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => {
            a == b || (a.is_nan() && b.is_nan()) || (a - b).abs() < 5e-3 * a.abs().max(b.abs()).min(f32::MAX)
        }
        _ => a == b,
    }
}

fn number(value: &Value) -> f32 {
    if let Value::Number(number) = value { *number } else { 0.0 }
}
