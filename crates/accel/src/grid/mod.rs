//! Grids, slides 16-24 and 63: space in equal cells, each referring to the primitives that reach into it.
//!
//! The cells of the uniform grid lie in an array, those of the hashed grid in a hash table; in nested grids a
//! crowded cell holds a grid of its own. All three are built and walked by the same text.

mod build;
mod cells;
mod hashed;
mod lattice;
mod nested;
mod resolution;
mod view;
mod walk;

pub use cells::{Cells, Dense};
pub use hashed::{Hashed, HashedGrid};
pub use lattice::Lattice;
pub use nested::{Nested, NestedGrid};
pub use view::AnyGrid;
pub(crate) use walk::Crossing;

use crate::Margin;

/// The uniform grid: a box in equal cells, all of them stored.
pub type Grid = GridOf<Dense>;

/// Equal cells over all primitives, and what they refer to.
#[derive(Clone, Debug, PartialEq)]
pub struct GridOf<C> {
    /// The cells; in nested grids the coarse ones.
    pub lattice: Lattice,
    /// Their contents.
    pub(crate) cells: C,
    margin: Margin,
    /// Whether a ray remembers which primitives it tested.
    pub(crate) mailbox: bool,
}
