//! Walks, packets and builds as they were recorded, and the state of each after some of its events.

mod build;
mod change;
mod fit;
mod moment;
mod packet;
mod walk;

pub use build::{Build, Fate, GrowMoment, GrowNode, Taken, Tally, Weighed};
pub use change::Changed;
pub(crate) use fit::FitMoment;
pub use moment::{Cut, Inside, Moment, PrimTest, SlabCut, SlabTest, Stepping, Tested, Waiting};
pub use packet::{PacketMoment, PacketWalk};
pub use walk::Walk;
