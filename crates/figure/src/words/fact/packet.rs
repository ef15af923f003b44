//! Packets: a symbol for each thing that rays do together, and a few words for each event.

use std::borrow::Cow;

use raystep_accel::{Abreast, PacketStep, PacketVisit, Place, Value};

use super::{Fact, Symbol};
use crate::theme::Role;
use crate::words::{VolumeName, counted, mask, told};

const INNER: Symbol = Symbol { sign: "△", name: "inner node", role: Role::Here, rank: 5 };
const LEAF: Symbol = Symbol { sign: "▽", name: "leaf", role: Role::Here, rank: 6 };
const PUSH: Symbol = Symbol { sign: "□", name: "push", role: Role::Waiting, rank: 7 };
const POP: Symbol = Symbol { sign: "■", name: "pop", role: Role::Waiting, rank: 4 };
const DROP: Symbol = Symbol { sign: "×", name: "drop", role: Role::Dropped, rank: 8 };
const MISS: Symbol = Symbol { sign: "|", name: "no better hit", role: Role::Missed, rank: 3 };
const HIT: Symbol = Symbol { sign: "●", name: "better hit", role: Role::Hit, rank: 9 };

impl Fact for PacketVisit {
    fn name(&self) -> &'static str {
        self.name()
    }

    fn place(&self) -> Place {
        self.place()
    }

    fn field(&self, name: &str) -> Option<Value> {
        self.field(name)
    }

    fn concerns_z(&self) -> bool {
        self.concerns_z()
    }

    /// What a lane computes for itself has none: sixteen times as many would be a blot.
    fn symbol(&self) -> Option<Symbol> {
        let PacketStep::Packet(abreast) = self.step else { return None };
        Some(match abreast {
            Abreast::Enter { leaf: false, .. } => INNER,
            Abreast::Enter { .. } => LEAF,
            Abreast::Push { .. } => PUSH,
            Abreast::Pop { .. } => POP,
            Abreast::Drop { .. } => DROP,
            Abreast::Test { better, .. } if better.is_empty() => MISS,
            Abreast::Test { .. } => HIT,
            Abreast::Split { .. } | Abreast::End { .. } => return None,
        })
    }

    fn short(&self, volume: VolumeName) -> Cow<'static, str> {
        let abreast = match self.step {
            PacketStep::Packet(abreast) => abreast,
            PacketStep::Lane(visit) => return format!("{}: {}", number(self), visit.short(volume)).into(),
        };
        Cow::Borrowed(match abreast {
            Abreast::Enter { leaf: false, .. } => "a node is entered",
            Abreast::Enter { .. } => "a leaf is entered",
            Abreast::Split { .. } => match self.name() {
                "packet.split.both" => "both children are met",
                "packet.split.one" => "one child is met",
                _ => "no child is met",
            },
            Abreast::Push { .. } => "a node waits on the stack",
            Abreast::Pop { .. } => "a node comes off the stack",
            Abreast::Drop { .. } => "a node is dropped",
            Abreast::Test { better, .. } if better.is_empty() => "a primitive is tested",
            Abreast::Test { .. } => "a better hit",
            Abreast::End { .. } => "every ray has its answer",
        })
    }

    fn sentence(&self, volume: VolumeName) -> String {
        let abreast = match self.step {
            PacketStep::Packet(abreast) => abreast,
            PacketStep::Lane(visit) => return format!("Ray {}: {}", number(self), small(&visit.sentence(volume))),
        };
        let (many, width) = (self.lanes.count(), self.lanes.width());
        let who = format!("for {many} of {}, {}", counted(width as u64, "lane", "lanes"), mask(self.lanes));
        match abreast {
            Abreast::Enter { node, leaf: false, .. } => format!("The packet enters node {node} once, {who}."),
            Abreast::Enter { node, prims, .. } => {
                let holds = counted(u64::from(prims), "primitive", "primitives");
                format!("The packet enters node {node} once, {who}. It is a leaf with {holds}.")
            }
            Abreast::Split { node, first, second, to_first, to_second, .. } => match self.name() {
                "packet.split.both" => format!(
                    "Below node {node}, {} with node {first} and {} with node {second}: both are opened.",
                    go_on(to_first.count()),
                    go_on(to_second.count())
                ),
                "packet.split.one" => {
                    let (child, other) = if to_second.is_empty() { (first, second) } else { (second, first) };
                    format!("All go on with node {child}, and none with node {other}: that one stays closed.")
                }
                _ => format!("Below node {node}, no ray meets a child."),
            },
            Abreast::Push { node, .. } => format!("Node {node} waits, {who}."),
            Abreast::Pop { node, waited, .. } if waited == self.lanes => {
                format!("Node {node} is taken from the stack, {who}.")
            }
            Abreast::Pop { node, waited, .. } => {
                format!(
                    "Node {node} has waited for {} and is opened {who}: the others have a nearer hit.",
                    waited.count()
                )
            }
            Abreast::Drop { node, waited, .. } => {
                format!("Node {node} has waited for {}, but each has a nearer hit: it is dropped.", waited.count())
            }
            Abreast::Test { .. } => {
                told("{{prim}} is tested by {{lanes ray}}; for {{better ray}} it is the nearest so far.", self)
            }
            Abreast::End { .. } => told("The walk is over: {{hit ray}} of {{lanes ray}} met something.", self),
        }
    }
}

/// The number of the ray that computes something for itself.
fn number(visit: &PacketVisit) -> usize {
    visit.lane().map_or(0, |lane| lane + 1)
}

/// A sentence that goes on behind a colon.
fn small(sentence: &str) -> String {
    let mut letters = sentence.chars();
    letters.next().map_or_else(String::new, |first| first.to_lowercase().chain(letters).collect())
}

fn go_on(many: u32) -> String {
    if many == 1 { "1 ray goes on".to_owned() } else { format!("{many} rays go on") }
}
