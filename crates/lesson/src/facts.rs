//! What is known at a step: the fields of its event, those of events before it, and how often things happened.

use raystep_accel::{Event, Place, Value};

use crate::reading::Reading;
use crate::vocabulary::{check_event, check_field};
use crate::{BoardTape, Care, Play, Plays, StageKind, Tape, WalksTape, names};

/// What a slide can say at a step of what is played. Nothing in it comes from later steps.
#[derive(Clone, Copy, Debug)]
pub struct Facts<'a> {
    tape: &'a Tape,
    beside: Option<&'a Tape>,
    /// How many events have happened; the last one is [`Facts::event`].
    step: usize,
    event: Event,
    stage: StageKind,
}

impl<'a> Facts<'a> {
    /// What is known at a step; nothing before the first.
    pub fn at(play: &'a Play, step: usize) -> Option<Facts<'a>> {
        let stage = if play.scene.flat { StageKind::Flat } else { StageKind::Solid };
        Some(Facts { tape: &play.tape, beside: play.beside.as_ref(), step, event: play.event(step)?, stage })
    }

    /// The event of the step.
    pub fn event(&self) -> &Event {
        &self.event
    }

    /// The stage that it happens on.
    pub fn stage(&self) -> StageKind {
        self.stage
    }

    /// A fact by its name: `t` of this event, `plane.d` of the last such event before it, `count.test` of all
    /// such events so far, `beside.count.test` of the play beside at its end, `alone.count.test` of the rays of a packet
    /// one by one, `Nx` of a board's meter. Nothing if that never happened.
    pub fn field(&self, name: &str) -> Option<Value> {
        if let Some(name) = name.strip_prefix(BESIDE) {
            // Of the play beside everything has happened, its last event too.
            let tape = self.beside?;
            let event = tape.event(tape.len().checked_sub(1)?)?;
            return Facts { tape, beside: None, step: tape.len() + 1, event, stage: self.stage }.field(name);
        }
        if let (Tape::Packet(packet), Some(name)) = (self.tape, name.strip_prefix(ALONE)) {
            return packet.count_alone(name.strip_prefix(COUNT)?).map(Value::Count);
        }
        if let (Tape::Walks(walks), Some((own, rest))) = (self.tape, name.split_once('.'))
            && let Some(walker) = walks.names().iter().position(|known| known == own)
        {
            return self.of_walk(walks, walker, rest);
        }
        if let Some(event) = name.strip_prefix(COUNT) {
            return self.tape.count(event, self.step).map(Value::Count);
        }
        match name.rsplit_once('.') {
            Some((event, field)) => self.known(&self.before(event)?, field),
            None => self.known(&self.event, name).or_else(|| self.tape.number(name)),
        }
    }

    /// How carefully a fact was measured; all but the numbers of boards are as they are.
    pub fn care(&self, name: &str) -> Care {
        let (event, field) = match name.rsplit_once('.') {
            Some((event, field)) => (self.before(event), field),
            None => (Some(self.event), name),
        };
        match (self.tape, event.map(|event| event.place())) {
            (Tape::Board(board), Some(Place::Cell(entry))) => board.care_of_number(entry.0 as usize, field),
            _ => Care::Full,
        }
    }

    /// A field of an event; of a board nothing where nothing was measured, and a sign where something is still to be.
    fn known(&self, event: &Event, name: &str) -> Option<Value> {
        let Event::Board(reveal) = event else { return event.field(name) };
        let waits = |board: &BoardTape| match reveal.place() {
            Place::Cell(entry) => board.care_of_number(entry.0 as usize, name) == Care::Bare,
            _ => false,
        };
        reveal.told(name).or_else(|| match self.tape {
            Tape::Board(board) if waits(board) => Some(Value::Word(WAITS, &[])),
            _ => None,
        })
    }

    /// A fact of one of several walks, as far as it has come.
    fn of_walk(&self, walks: &WalksTape, walker: usize, name: &str) -> Option<Value> {
        let tape = walks.walks.get(walker)?;
        let done = walks.done(walker, self.step);
        if let Some(event) = name.strip_prefix(COUNT) {
            return tape.count(event, done).map(Value::Count);
        }
        let event = tape.event(done.checked_sub(1)?)?;
        // Its last event has happened, too.
        let own = Facts { tape, beside: None, step: done + 1, event, stage: self.stage };
        name.rsplit_once('.').and_then(|(event, field)| own.before(event)?.field(field))
    }

    /// The last event of that name before this one.
    fn before(&self, event: &str) -> Option<Event> {
        let before = (0..self.step.saturating_sub(1)).rev();
        before.filter_map(|index| self.tape.event(index)).find(|other| names(event, other.name()))
    }
}

/// What stands for a number that is still to be measured.
const WAITS: &str = "\u{2026}";

const BESIDE: &str = "beside.";
const COUNT: &str = "count.";
const ALONE: &str = "alone.";

/// Says so if there can be no such fact where a beat waits for `event`.
pub(crate) fn check_fact(event: &str, name: &str, at: usize, reading: &mut Reading<'_>) {
    let (name, at) = match name.strip_prefix(BESIDE) {
        Some(name) if reading.beside => (name, at + BESIDE.len()),
        Some(_) => {
            reading.problem(at, "nothing is played beside: give the stage `beside = { kind = \"...\" }`");
            return;
        }
        None => (name, at),
    };
    if let Some(name) = name.strip_prefix(ALONE).filter(|_| reading.plays == Plays::Packet) {
        let at = at + ALONE.len();
        match name.strip_prefix(COUNT) {
            Some(counted) => {
                check_event(counted, at + COUNT.len(), reading);
            }
            None => reading.problem(at, "of rays one by one only counts are known, as in `alone.count.enter`"),
        }
        return;
    }
    let own = name.split_once('.').filter(|(own, _)| reading.abreast.iter().any(|known| known == own));
    let (name, at) = own.map_or((name, at), |(own, rest)| (rest, at + own.len() + 1));
    if let Some(counted) = name.strip_prefix(COUNT) {
        check_event(counted, at + COUNT.len(), reading);
    } else if let Some((other, field)) = name.rsplit_once('.') {
        if check_event(other, at, reading) {
            check_field(other, field, at + other.len() + 1, reading);
        }
    } else if !reading.numbers.iter().any(|known| known == name) {
        check_field(event, name, at, reading);
    }
}
