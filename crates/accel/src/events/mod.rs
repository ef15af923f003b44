//! What is told: the events of walks, of packets, of builds, of the fitting of volumes and of boards, the places that they are about, and who listens.

mod abreast;
mod cost;
mod fit;
mod grow;
mod lanes;
mod observer;
mod place;
mod reveal;
mod trace;
mod value;
mod visit;
mod vocabulary;

pub use abreast::{Abreast, PacketStep, PacketVisit};
pub use cost::Cost;
pub(crate) use fit::Unheard;
pub use fit::{Fit, FrameFrom};
pub use grow::{Grow, LeafReason};
pub use lanes::Lanes;
pub(crate) use observer::{BETWEEN_LOOKS, patiently, sort_patiently};
pub use observer::{Cancelled, Each, Observer};
pub use place::{CellId, NodeId, Place, PrimId};
pub use reveal::Reveal;
pub use trace::Trace;
pub use value::Value;
pub use visit::{Ending, Grain, Probed, Side, Verdict, Visit};
pub(crate) use vocabulary::{vocabulary, words};
