//! Words and numbers: what an event says, and the one formatter of numbers.

mod coordinate;
pub(crate) mod fact;
mod number;
mod sentence;
mod sum;
mod template;
mod volume;

pub use coordinate::coordinate;
pub(crate) use fact::veiled_visit;
pub use fact::{Answer, Fact, Symbol, sentence, short, veiled};
pub use number::{ROUGH, counted, number, value, whole};
pub(crate) use number::{digits, mask, one_or_many};
pub(crate) use sum::{Piece, come_out};
pub use template::{fill, told};
pub use volume::VolumeName;
