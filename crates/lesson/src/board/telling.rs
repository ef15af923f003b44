//! What a board tells as it is filled: an event for each entry, with its numbers as far as they are known.

use raystep_accel::{Appraisal, Reveal};

use super::panel::Entry;
use super::timing::Timed;
use super::{BoardTape, Care, Column, Measured, Rendered, Row, Stroke};

/// What is counted of rays: the more of them, the truer.
const OF_RAYS: [&str; 10] = ["tests", "visits", "boxes", "alive", "mean", "least", "most", "rays", "first", "last"];

impl BoardTape {
    /// How carefully a number of an entry was measured, by the name of its field: what does not depend on rays is known
    /// once anything is, and what is not measured at all is as it is.
    pub fn care_of_number(&self, entry: usize, field: &str) -> Care {
        let Some(what) = self.places.get(entry).and_then(|place| self.board.entry(*place)) else { return Care::Full };
        let is_measured = match what {
            Entry::Row(row) => is_measured(row, field),
            Entry::Drawn(drawn) => {
                matches!(drawn.stroke, Stroke::Growth { .. }) && ["from", "to", "first", "last"].contains(&field)
            }
            Entry::Map(..) => ["mean", "least", "most"].contains(&field),
            Entry::Picture(_) => ["triangles", "rays", "tests"].contains(&field),
        };
        match self.care_of(entry) {
            _ if !is_measured => Care::Full,
            Care::Draft if !OF_RAYS.contains(&field) && !self.is_stale(entry) => Care::Full,
            care => care,
        }
    }

    /// Tells what comes to be seen, with its numbers.
    pub(super) fn tell(&mut self) {
        let entries = self.places.iter().enumerate();
        let events = entries.filter_map(|(index, place)| Some(self.reveal(index, self.board.entry(*place)?)));
        self.events = events.collect();
    }

    fn reveal(&self, index: usize, what: Entry<'_>) -> Reveal {
        let (entry, numbers) = (index as u32, &self.numbers);
        let measured = self.measured.get(index).and_then(Option::as_ref);
        let appraised = self.appraised.get(index).and_then(Option::as_ref);
        let counted = self.counted.get(index).and_then(Option::as_ref);
        let rendered = self.rendered.get(index).and_then(Option::as_ref);
        let grown = self.grown.get(index).map_or(&[][..], Vec::as_slice);
        let timed = self.timed.get(index).and_then(Option::as_ref).and_then(|timing| timing.as_ref().ok());
        let time = |of: fn(&Timed) -> f64| timed.map_or(f32::NAN, |timed| of(timed) as f32);
        match what {
            Entry::Picture(_) => {
                let told = |number: fn(&Rendered) -> f64| rendered.map_or(f32::NAN, |rendered| number(rendered) as f32);
                Reveal::Picture {
                    entry,
                    triangles: told(|rendered| rendered.triangles as f64),
                    rays: told(|rendered| rendered.rays as f64),
                    tests: told(|rendered| rendered.tests),
                    seconds: time(|timed| timed.seconds),
                    timed: timed.is_some(),
                }
            }
            Entry::Map(..) => {
                let [least, most] = counted.map_or([f32::NAN; 2], |counted| counted.range().map(|count| count as f32));
                let mean = counted.map_or(f32::NAN, |counted| counted.mean() as f32);
                Reveal::Map { entry, mean, least, most }
            }
            Entry::Row(row) => {
                let own = |column: Column| {
                    row.cells
                        .iter()
                        .find(|(key, _)| *key == column)
                        .map_or(f32::NAN, |(_, cell)| cell.number(numbers) as f32)
                };
                let here = |count: fn(&Measured) -> f64| measured.map_or(f32::NAN, |measured| count(measured) as f32);
                let around =
                    |number: fn(&Appraisal) -> f64| appraised.map_or(f32::NAN, |appraised| number(appraised) as f32);
                Reveal::Row {
                    entry,
                    printed: own(Column::Printed),
                    total: own(Column::Total),
                    computed: own(Column::Computed),
                    tests: here(|measured| measured.tests),
                    visits: here(|measured| measured.visits),
                    boxes: here(|measured| measured.boxes),
                    nodes: here(|measured| measured.nodes as f64),
                    bytes: match appraised {
                        Some(appraised) => appraised.bytes as f32,
                        None => here(|measured| measured.bytes as f64),
                    },
                    alive: here(|measured| measured.alive),
                    content: around(|appraised| appraised.content),
                    area: around(|appraised| f64::from(appraised.area)),
                    cuts: around(|appraised| appraised.cuts),
                    planes: around(|appraised| f64::from(appraised.planes)),
                    vain: around(|appraised| f64::from(appraised.vain_share()) * 100.0),
                    speed: time(|timed| timed.speed),
                    time: time(Timed::time),
                    build: time(|timed| timed.build),
                    share: time(|timed| timed.share * 100.0),
                    seconds: time(|timed| timed.seconds),
                    timed: timed.is_some(),
                }
            }
            Entry::Drawn(drawn) => match &drawn.stroke {
                Stroke::Point(x, y) => {
                    Reveal::Point { entry, x: x.at(0.0, numbers) as f32, y: y.at(0.0, numbers) as f32 }
                }
                Stroke::Growth { .. } => {
                    let dot = |dot: Option<&[f64; 2]>| dot.map_or([f32::NAN; 2], |dot| dot.map(|number| number as f32));
                    let ([from, first], [to, last]) = (dot(grown.first()), dot(grown.last()));
                    Reveal::Line { entry, from, to, first, last, timed: timed.is_some() }
                }
                Stroke::Law { law, from, to, .. } => Reveal::Line {
                    entry,
                    from: *from as f32,
                    to: *to as f32,
                    first: law.at(*from, numbers) as f32,
                    last: law.at(*to, numbers) as f32,
                    timed: false,
                },
            },
        }
    }
}

/// Whether a number of a row is measured.
fn is_measured(row: &Row, field: &str) -> bool {
    let walked = row.plan.is_some() || row.fast.is_some();
    match field {
        "tests" | "visits" | "boxes" | "nodes" => walked,
        "alive" => walked && row.how.lanes.is_some(),
        "bytes" => walked || row.volume.is_some(),
        "content" | "area" | "cuts" | "planes" | "vain" => row.volume.is_some(),
        _ => false,
    }
}
