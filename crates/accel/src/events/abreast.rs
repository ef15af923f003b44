//! The vocabulary of packets: what several rays do abreast, with the lanes that take part.

use super::{Grain, Lanes, NodeId, Place, PrimId, Value, Visit, vocabulary};

/// One thing that a packet did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PacketVisit {
    /// The lanes that take part. All others wait or are done.
    pub lanes: Lanes,
    /// What they did.
    pub step: PacketStep,
}

/// What lanes do: one of them alone, or all of `lanes` together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PacketStep {
    /// What a single lane computes, in the words of single rays.
    Lane(Visit),
    /// What the packet does with it.
    Packet(Abreast),
}

vocabulary! {
    /// What lanes do together. The lanes that take part stand beside it, in [`PacketVisit`].
    pub enum Abreast {
        /// A node was entered, once for all its lanes; `prims` references lie in it (0 in inner nodes).
        Enter ["packet.enter.inner", "packet.enter.leaf"] { node: NodeId, prims: u32, leaf: bool }
        /// Each lane has chosen its children: those of `to_first` go on with the first, those of
        /// `to_second` with the second, those of `both` with one after the other.
        Split ["packet.split.both", "packet.split.one", "packet.split.none"] { node: NodeId, first: NodeId, second: NodeId, to_first: Lanes, to_second: Lanes, both: Lanes }
        /// A node was put on the stack with the interval of each of its lanes; `depth` nodes wait now.
        Push ["packet.push"] { node: NodeId, depth: u32 }
        /// A node was taken from the stack, for those who still need it; `waited` were to visit it.
        Pop ["packet.pop"] { node: NodeId, waited: Lanes, depth: u32 }
        /// A node was taken from the stack and thrown away: none of those who `waited` needs it any more.
        Drop ["packet.drop"] { node: NodeId, waited: Lanes, depth: u32 }
        /// A primitive was tested by every lane; for those of `better` it is the best hit so far.
        Test ["packet.test"] { prim: PrimId, better: Lanes }
        /// The walk is over; those of `hit` have found something.
        End ["packet.end"] { hit: Lanes }
    }
}

/// The names that events can go by, each group with the fields that they have.
type Vocabulary = (&'static [&'static str], &'static [&'static str]);

impl PacketVisit {
    /// Every name that an event of a packet can go by, with the names of its fields: what the packet does, and what a
    /// lane computes for itself. Beside them each has `lanes`.
    pub const NAMES: &'static [Vocabulary] = &{
        let mut all: [Vocabulary; Abreast::NAMES.len() + Visit::NAMES.len()] =
            [(&[], &[]); Abreast::NAMES.len() + Visit::NAMES.len()];
        let mut index = 0;
        while index < all.len() {
            all[index] = match index < Abreast::NAMES.len() {
                true => Abreast::NAMES[index],
                false => Visit::NAMES[index - Abreast::NAMES.len()],
            };
            index += 1;
        }
        all
    };

    /// The lane that computes this for itself, if it is no step of the packet.
    pub fn lane(&self) -> Option<usize> {
        match self.step {
            PacketStep::Lane(_) => self.lanes.iter().next(),
            PacketStep::Packet(_) => None,
        }
    }

    /// Whether flat scenes leave it out.
    pub fn concerns_z(&self) -> bool {
        matches!(self.step, PacketStep::Lane(visit) if visit.concerns_z())
    }

    /// What slides, listings and questions call this event.
    pub fn name(&self) -> &'static str {
        match self.step {
            PacketStep::Lane(visit) => visit.name(),
            PacketStep::Packet(Abreast::Enter { leaf: false, .. }) => "packet.enter.inner",
            PacketStep::Packet(Abreast::Enter { leaf: true, .. }) => "packet.enter.leaf",
            PacketStep::Packet(Abreast::Split { to_first, to_second, .. }) => {
                match (to_first.is_empty(), to_second.is_empty()) {
                    (false, false) => "packet.split.both",
                    (true, true) => "packet.split.none",
                    _ => "packet.split.one",
                }
            }
            PacketStep::Packet(Abreast::Push { .. }) => "packet.push",
            PacketStep::Packet(Abreast::Pop { .. }) => "packet.pop",
            PacketStep::Packet(Abreast::Drop { .. }) => "packet.drop",
            PacketStep::Packet(Abreast::Test { .. }) => "packet.test",
            PacketStep::Packet(Abreast::End { .. }) => "packet.end",
        }
    }

    /// How coarse the event is. What a lane computes for itself is the packet's arithmetic.
    pub fn grain(&self) -> Grain {
        match self.step {
            PacketStep::Lane(_) => Grain::Arithmetic,
            PacketStep::Packet(Abreast::Enter { .. } | Abreast::End { .. }) => Grain::Visit,
            PacketStep::Packet(_) => Grain::Decision,
        }
    }

    /// What the event is about.
    pub fn place(&self) -> Place {
        match self.step {
            PacketStep::Lane(visit) => visit.place(),
            PacketStep::Packet(abreast) => match abreast {
                Abreast::Enter { node, .. }
                | Abreast::Split { node, .. }
                | Abreast::Push { node, .. }
                | Abreast::Pop { node, .. }
                | Abreast::Drop { node, .. } => Place::Node(node),
                Abreast::Test { prim, .. } => Place::Prim(prim),
                Abreast::End { .. } => Place::World,
            },
        }
    }

    /// The names of this event's fields, in order; beside them there is `lanes`.
    pub fn fields(&self) -> &'static [&'static str] {
        match &self.step {
            PacketStep::Lane(visit) => visit.fields(),
            PacketStep::Packet(abreast) => abreast.fields(),
        }
    }

    /// The value of the field called `name`, or of `lanes`.
    pub fn field(&self, name: &str) -> Option<Value> {
        match &self.step {
            _ if name == "lanes" => Some(Value::Lanes(self.lanes)),
            PacketStep::Lane(visit) => visit.field(name),
            PacketStep::Packet(abreast) => abreast.field(name),
        }
    }
}
