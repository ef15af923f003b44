//! A test of two objects, step by step.

use raystep_accel::{Arrangement, Trial};

/// A test of two objects, as far as it has come.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tried<'a> {
    /// How the two lie.
    pub(crate) lies: &'a Arrangement,
    /// What has happened since they were laid out.
    pub(crate) done: &'a [Trial],
}

impl Tried<'_> {
    /// What happened last.
    pub(super) fn last(&self) -> Option<&Trial> {
        self.done.last()
    }
}
