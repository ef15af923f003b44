//! What a builder has done so far, in numbers.

/// How often a builder did what.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Primitives put into the box.
    pub boxed: u64,
    /// Cells that the box of a primitive met.
    pub rasterised: u64,
    /// Those that the primitive itself did not reach.
    pub pruned: u64,
    /// References stored.
    pub stored: u64,
    /// Splits weighed.
    pub weighed: u64,
    /// Splits taken.
    pub taken: u64,
    /// Times that two sets became one.
    pub joined: u64,
    /// Leaves made.
    pub leaves: u64,
}
