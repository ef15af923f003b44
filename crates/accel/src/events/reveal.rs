//! The vocabulary of boards: tables and charts, whose rows, points and lines come to be seen one after the other.

use super::{CellId, Grain, Place, Value, vocabulary};

vocabulary! {
    /// One thing of a board that came to be seen. `entry` counts what came before it. A number that a row lacks is
    /// no number (NaN), and no field.
    pub enum Reveal {
        /// A row of a table: tests per ray as printed, their printed total, what follows from other printed numbers,
        /// and what was measured here, a ray: tests of primitives, nodes or cells entered, volumes tested; then how
        /// many nodes or cells the structure has, and how many bytes. Of a single volume around everything: how much room
        /// it encloses, its surface, how many planes bound it, how many cuts a test of it takes, its bytes, and of the rays that
        /// meet it the share in percent that meet nothing in it. Of packets how many lanes took part in a visit. What differs from machine to machine:
        /// millions of rays a second, microseconds of a ray, milliseconds of the building, the part of a picture's time in
        /// which rays are intersected in percent, and the seconds of a picture of a million rays; and whether any was timed.
        Row ["row"] {
            entry: u32,
            printed: f32,
            total: f32,
            computed: f32,
            tests: f32,
            visits: f32,
            boxes: f32,
            nodes: f32,
            bytes: f32,
            content: f32,
            area: f32,
            cuts: f32,
            planes: f32,
            vain: f32,
            alive: f32,
            speed: f32,
            time: f32,
            build: f32,
            share: f32,
            seconds: f32,
            timed: bool,
        }
        /// A point of a chart.
        Point ["point"] { entry: u32, x: f32, y: f32 }
        /// A line of a chart, its height at its two ends, and whether it was timed.
        Line ["line"] { entry: u32, from: f32, to: f32, first: f32, last: f32, timed: bool }
        /// A heat map: what its rays cost in the mean, the least and the most.
        Map ["map"] { entry: u32, mean: f32, least: f32, most: f32 }
        /// A picture: how many triangles it shows, the rays shot for it, what each tested in the mean, the seconds that it
        /// took, and whether it was timed.
        Picture ["picture"] { entry: u32, triangles: f32, rays: f32, tests: f32, seconds: f32, timed: bool }
    }
}

/// What counts things, and up to where single precision counts them one by one.
const WHOLE: [&str; 5] = ["nodes", "bytes", "planes", "triangles", "rays"];
const LAST: f32 = 16_777_216.0;

impl Reveal {
    /// The value of one of its fields as it is told: a count where it counts things, nothing where it is no number.
    pub fn told(&self, name: &str) -> Option<Value> {
        match self.field(name)? {
            Value::Number(x) if x.is_nan() => None,
            Value::Number(x) if WHOLE.contains(&name) && (0.0..=LAST).contains(&x) => Some(Value::Count(x as u32)),
            value => Some(value),
        }
    }

    /// What slides, listings and questions call it.
    pub fn name(&self) -> &'static str {
        match self {
            Reveal::Row { .. } => "row",
            Reveal::Point { .. } => "point",
            Reveal::Line { .. } => "line",
            Reveal::Map { .. } => "map",
            Reveal::Picture { .. } => "picture",
        }
    }

    /// What it is about: everything on a board has a place of its own, so that its parts light up together.
    pub fn place(&self) -> Place {
        match *self {
            Reveal::Row { entry, .. }
            | Reveal::Point { entry, .. }
            | Reveal::Line { entry, .. }
            | Reveal::Map { entry, .. }
            | Reveal::Picture { entry, .. } => Place::Cell(CellId(entry)),
        }
    }

    /// Every row, point and line is a step of its own.
    pub fn grain(&self) -> Grain {
        Grain::Visit
    }
}
