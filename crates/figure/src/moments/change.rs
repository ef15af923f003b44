//! What is done to a finished structure: slide 44.

use raystep_accel::Change;

/// A primitive that is inserted into a finished structure, or deleted from it.
#[derive(Clone, Debug, PartialEq)]
pub struct Changed {
    /// What is done.
    pub change: Change,
    /// The events before it: those of the build and of other changes.
    pub from: usize,
    /// Whether the structure had room for it; else it stays as it was.
    pub done: bool,
    /// What is built anew instead to compare with, and how many nodes that makes.
    pub anew: Option<(String, u64)>,
}
