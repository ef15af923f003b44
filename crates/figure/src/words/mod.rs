//! Words and numbers: what an event says, and the one formatter of numbers.

pub(crate) mod fact;
mod number;
mod sentence;
mod volume;

pub use fact::{Answer, Fact, Symbol, sentence, short};
pub(crate) use number::counted;
pub use number::{fill, number, told, value};
pub use volume::VolumeName;
