//! A walk as JSON, for other programs. `TRACE.md` beside this crate describes every key.

use raystep_accel::{Cost, Hit, Observer, Place, Ray, Value, Visit};
use serde::ser::{Serialize, SerializeMap, Serializer};

/// A walk and what it went through.
#[derive(Clone, Copy, Debug)]
pub struct Walked<'a> {
    /// The scene's name.
    pub scene: &'a str,
    /// The structure's kind: `list`, `grid`, `kd`, `bvh`.
    pub kind: &'a str,
    /// The structure's parameters with their values as text.
    pub parameters: &'a [(String, String)],
    /// How many nodes it has.
    pub nodes: usize,
    /// How many bytes it takes.
    pub bytes: usize,
    /// The ray's name, if it has one.
    pub name: Option<&'a str>,
    /// The ray.
    pub ray: &'a Ray,
    /// What happened, in order.
    pub events: &'a [Visit],
    /// How many more events there were than the recording holds.
    pub lost: u64,
    /// The answer.
    pub hit: Option<Hit>,
}

/// The walk as JSON text, ending with a newline.
pub fn json(walked: &Walked<'_>) -> String {
    let mut cost = Cost::default();
    for event in walked.events {
        cost.on(*event);
    }
    let document = Document {
        format: "raystep-walk",
        version: 1,
        scene: walked.scene,
        structure: Built {
            kind: walked.kind,
            parameters: Pairs(walked.parameters),
            nodes: walked.nodes,
            bytes: walked.bytes,
        },
        ray: Line {
            name: walked.name,
            o: walked.ray.o.to_array().map(Number),
            d: walked.ray.d.to_array().map(Number),
            t_min: Number(walked.ray.t_min),
            t_max: Number(walked.ray.t_max),
        },
        hit: walked.hit.map(|hit| Answer { t: Number(hit.t), prim: hit.prim.0 }),
        cost: Counters(cost),
        lost: walked.lost,
        events: walked.events.iter().enumerate().map(|(index, event)| Step { number: index + 1, event }).collect(),
    };
    // Only numbers, texts and maps with text keys: nothing that could fail.
    serde_json::to_string_pretty(&document).unwrap_or_default() + "\n"
}

#[derive(serde::Serialize)]
struct Document<'a> {
    format: &'static str,
    version: u32,
    scene: &'a str,
    structure: Built<'a>,
    ray: Line<'a>,
    hit: Option<Answer>,
    cost: Counters,
    lost: u64,
    events: Vec<Step<'a>>,
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
    o: [Number; 3],
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
struct Step<'a> {
    number: usize,
    event: &'a Visit,
}

impl Serialize for Step<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("step", &self.number)?;
        map.serialize_entry("name", self.event.name())?;
        map.serialize_entry("grain", self.event.grain().word())?;
        map.serialize_entry("at", &Field(Value::Place(self.event.place())))?;
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
        }
    }
}
