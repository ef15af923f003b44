//! A walk, a packet, a build, a board or pairs as JSON, for other programs. `TRACE.md` beside this crate describes every
//! key.

use raystep_accel::{
    Cost, Event, Fill, Fit, Grow, Hit, Observer, PacketVisit, Place, Ray, Reveal, Trial, Value, Visit,
};
use serde::ser::{Serialize, SerializeMap, Serializer};

/// What is written: what it is about, and what happened.
#[derive(Clone, Copy, Debug)]
pub struct Record<'a> {
    /// The scene's name.
    pub scene: &'a str,
    /// What was subtracted from the coordinates of the scene's file, so that single precision keeps their digits.
    pub origin: [f64; 3],
    /// The structure's kind: `list`, `grid`, `kd`, `bvh`.
    pub kind: &'a str,
    /// The structure's parameters with their values as text.
    pub parameters: &'a [(String, String)],
    /// How many nodes it has.
    pub nodes: usize,
    /// How many bytes it takes.
    pub bytes: usize,
    /// What happened.
    pub told: Told<'a>,
    /// How many more events there were than the recording holds.
    pub lost: u64,
}

/// What happened, in order.
#[derive(Clone, Copy, Debug)]
pub enum Told<'a> {
    /// A ray walked.
    Walk {
        /// The ray's name, if it has one.
        name: Option<&'a str>,
        /// The ray.
        ray: &'a Ray,
        /// What it did.
        events: &'a [Visit],
        /// The answer.
        hit: Option<Hit>,
    },
    /// The structure was built.
    Build(&'a [Grow]),
    /// Several rays walked together.
    Packet {
        /// What they are called together, if they have a name.
        name: Option<&'a str>,
        /// The rays, one a lane.
        rays: &'a [Ray],
        /// What they did, together and each for itself.
        events: &'a [PacketVisit],
        /// The answer of each.
        found: &'a [Option<Hit>],
    },
    /// A board was filled.
    Board(&'a [Reveal]),
    /// Pairs of objects were tested.
    Pairs(&'a [Trial]),
    /// A volume was fitted.
    Fit(&'a [Fit]),
}

/// The walk, the packet, the build, the board, the pairs or the fitting as JSON text, ending with a newline.
pub fn json(record: &Record<'_>) -> String {
    let structure =
        Built { kind: record.kind, parameters: Pairs(record.parameters), nodes: record.nodes, bytes: record.bytes };
    let (scene, lost, version) = (record.scene, record.lost, 1);
    let origin = Some(record.origin).filter(|origin| *origin != [0.0; 3]);
    match record.told {
        Told::Walk { name, ray, events, hit } => {
            let mut cost = Cost::default();
            for event in events {
                cost.on(*event);
            }
            text(&Walked {
                format: "raystep-walk",
                version,
                scene,
                origin,
                structure,
                ray: line(name, ray, record.origin),
                hit: hit.map(answer),
                cost: Counters(cost),
                lost,
                events: steps(events.iter().copied().map(Event::Walk)),
            })
        }
        Told::Packet { name, rays, events, found } => {
            let mut fill = Fill::default();
            for event in events {
                fill.on(*event);
            }
            text(&Abreast {
                format: "raystep-packet",
                version,
                scene,
                origin,
                structure,
                name,
                rays: rays.iter().map(|ray| line(None, ray, record.origin)).collect(),
                hits: found.iter().map(|found| found.map(answer)).collect(),
                visits: fill.visits,
                lane_visits: fill.lane_visits,
                lanes: fill.lanes,
                lost,
                events: steps(events.iter().copied().map(Event::Packet)),
            })
        }
        Told::Build(events) => {
            let events = steps(events.iter().copied().map(Event::Build));
            text(&Grown { format: "raystep-build", version, scene, origin, structure, lost, events })
        }
        Told::Board(events) => {
            let events = steps(events.iter().copied().map(Event::Board));
            text(&Grown { format: "raystep-board", version, scene, origin, structure, lost, events })
        }
        Told::Pairs(events) => {
            let events = steps(events.iter().copied().map(Event::Pair));
            text(&Grown { format: "raystep-pairs", version, scene, origin, structure, lost, events })
        }
        Told::Fit(events) => {
            let events = steps(events.iter().copied().map(Event::Fit));
            text(&Grown { format: "raystep-fit", version, scene, origin, structure, lost, events })
        }
    }
}

fn line<'a>(name: Option<&'a str>, ray: &Ray, origin: [f64; 3]) -> Line<'a> {
    Line {
        name,
        o: [0, 1, 2].map(|axis| Coordinate { seen: ray.o[axis], from: origin[axis] }),
        d: ray.d.to_array().map(Number),
        t_min: Number(ray.t_min),
        t_max: Number(ray.t_max),
    }
}

fn answer(hit: Hit) -> Answer {
    Answer { t: Number(hit.t), prim: hit.prim.0 }
}

/// Only numbers, texts and maps with text keys: nothing that could fail.
fn text(document: &impl Serialize) -> String {
    serde_json::to_string_pretty(document).unwrap_or_default() + "\n"
}

fn steps(events: impl Iterator<Item = Event>) -> Vec<Step> {
    events.enumerate().map(|(index, event)| Step { number: index + 1, event }).collect()
}

#[derive(serde::Serialize)]
struct Walked<'a> {
    format: &'static str,
    version: u32,
    scene: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    origin: Option<[f64; 3]>,
    structure: Built<'a>,
    ray: Line<'a>,
    hit: Option<Answer>,
    cost: Counters,
    lost: u64,
    events: Vec<Step>,
}

#[derive(serde::Serialize)]
struct Abreast<'a> {
    format: &'static str,
    version: u32,
    scene: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    origin: Option<[f64; 3]>,
    structure: Built<'a>,
    name: Option<&'a str>,
    rays: Vec<Line<'a>>,
    hits: Vec<Option<Answer>>,
    visits: u64,
    lane_visits: u64,
    lanes: u64,
    lost: u64,
    events: Vec<Step>,
}

#[derive(serde::Serialize)]
struct Grown<'a> {
    format: &'static str,
    version: u32,
    scene: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    origin: Option<[f64; 3]>,
    structure: Built<'a>,
    lost: u64,
    events: Vec<Step>,
}

#[derive(serde::Serialize)]
struct Built<'a> {
    kind: &'a str,
    parameters: Pairs<'a>,
    nodes: usize,
    bytes: usize,
}

#[derive(serde::Serialize)]
struct Line<'a> {
    name: Option<&'a str>,
    o: [Coordinate; 3],
    d: [Number; 3],
    t_min: Number,
    t_max: Number,
}

#[derive(serde::Serialize)]
struct Answer {
    t: Number,
    prim: u32,
}

/// A number; infinities and NaN, which JSON lacks, as text.
struct Number(f32);

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if self.0.is_finite() {
            serializer.serialize_f32(self.0)
        } else if self.0.is_nan() {
            serializer.serialize_str("nan")
        } else {
            serializer.serialize_str(if self.0 > 0.0 { "inf" } else { "-inf" })
        }
    }
}

/// A coordinate of the scene's file, seen from a place.
struct Coordinate {
    seen: f32,
    from: f64,
}

impl Serialize for Coordinate {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if self.from == 0.0 {
            Number(self.seen).serialize(serializer)
        } else {
            serializer.serialize_f64(f64::from(self.seen) + self.from)
        }
    }
}

struct Pairs<'a>(&'a [(String, String)]);

impl Serialize for Pairs<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(key, value)| (key, value)))
    }
}

struct Counters(Cost);

impl Serialize for Counters {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let cost = &self.0;
        serializer.collect_map([
            ("prim_tests", cost.prim_tests),
            ("box_tests", cost.box_tests),
            ("node_visits", cost.node_visits),
            ("cell_steps", cost.cell_steps),
            ("plane_tests", cost.plane_tests),
            ("pushes", cost.pushes),
            ("drops", cost.drops),
            ("skips", cost.skips),
            ("probes", cost.probes),
        ])
    }
}

/// An event: its name, its place, and all its fields by their names.
struct Step {
    number: usize,
    event: Event,
}

impl Serialize for Step {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("step", &self.number)?;
        map.serialize_entry("name", self.event.name())?;
        map.serialize_entry("grain", self.event.grain().word())?;
        map.serialize_entry("at", &Field(Value::Place(self.event.place())))?;
        if let Event::Packet(visit) = self.event {
            map.serialize_entry("lanes", &Field(Value::Lanes(visit.lanes)))?;
        }
        for name in self.event.fields() {
            if let Some(value) = self.event.field(name).filter(|_| *name != "place") {
                map.serialize_entry(name, &Field(value))?;
            }
        }
        map.end()
    }
}

struct Field(Value);

impl Serialize for Field {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            Value::Number(x) => Number(x).serialize(serializer),
            Value::Count(n) => serializer.serialize_u32(n),
            Value::Flag(yes) => serializer.serialize_bool(yes),
            Value::Axis(axis) => serializer.serialize_str(axis.name()),
            Value::Word(word, _) => serializer.serialize_str(word),
            Value::Lanes(lanes) => serializer.collect_str(&lanes),
            Value::Place(place) => {
                let (kind, id) = match place {
                    Place::World => return serializer.serialize_str("world"),
                    Place::Node(node) => ("node", node.0),
                    Place::Cell(cell) => ("cell", cell.0),
                    Place::Prim(prim) => ("prim", prim.0),
                };
                serializer.collect_map([(kind, id)])
            }
            Value::Box(bounds) => {
                let corner = |corner: glam::Vec3| corner.to_array().map(Number);
                serializer.collect_map([("min", corner(bounds.min)), ("max", corner(bounds.max))])
            }
        }
    }
}
