//! Trees of two children, built fast: what all the others are made from.

mod binned;
mod reference;
mod settings;
mod tree;

pub use settings::Settings;
pub(crate) use tree::{Knot, Tree};

use raystep_accel::Mesh;

/// The tree over a mesh that the settings ask for.
pub(crate) fn tree(mesh: &Mesh, settings: &Settings) -> Tree {
    let (references, bounds) = reference::references(mesh);
    binned::build(references, bounds, settings)
}
