//! What stands in the fields of an event.

use super::{CellId, Lanes, NodeId, Place, PrimId};
use crate::{Aabb, Axis, Direction};

/// The value of one field of an event.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A number: a t, a coordinate, a cost.
    Number(f32),
    /// A count.
    Count(u32),
    /// Yes or no.
    Flag(bool),
    /// An axis.
    Axis(Axis),
    /// One of a few words; all of them, in order.
    Word(&'static str, &'static [&'static str]),
    /// A place.
    Place(Place),
    /// Which rays of a packet.
    Lanes(Lanes),
    /// A box.
    Box(Aabb),
}

macro_rules! value_from {
    ($($from:ty => $make:expr;)*) => { $(
        impl From<$from> for Value {
            fn from(value: $from) -> Value {
                $make(value)
            }
        }
    )* };
}

value_from! {
    f32 => Value::Number;
    u32 => Value::Count;
    bool => Value::Flag;
    Axis => Value::Axis;
    Lanes => Value::Lanes;
    Place => Value::Place;
    Aabb => Value::Box;
    NodeId => |id| Value::Place(Place::Node(id));
    CellId => |id| Value::Place(Place::Cell(id));
    PrimId => |id| Value::Place(Place::Prim(id));
}

impl From<Direction> for Value {
    /// An axis where it is one, else its name.
    fn from(value: Direction) -> Value {
        match value {
            Direction::Along(axis) => Value::Axis(axis),
            Direction::Own(_) => Value::Word(value.name(), &["u", "v", "w"]),
            Direction::Slanted(_) => Value::Word(value.name(), &Direction::SLANTED),
            Direction::Normal => Value::Word(value.name(), &["n"]),
        }
    }
}
