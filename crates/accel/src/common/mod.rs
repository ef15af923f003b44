//! What structures have in common: the questions they answer, the box that a build begins with, and what a walk
//! carries along.

mod accel;
mod around;
mod bars;
mod mailbox;
mod margin;
mod random;
mod stack;

pub use accel::Accel;
pub(crate) use around::around;
pub(crate) use bars::{bars_origin, bars_projection};
pub(crate) use mailbox::{Mailbox, test_each};
pub use margin::Margin;
pub use random::Random;
pub(crate) use stack::{Part, Stack};
