//! Trees of two children, built fast: what all the others are made from.

mod binned;
mod reference;
mod reinsertion;
mod settings;
mod spatial;
mod tree;

pub use settings::Settings;
pub(crate) use tree::{Knot, Tree};

use raystep_accel::Mesh;

/// No branch of a tree is longer: walks have stacks of a fixed size.
pub(crate) const DEEPEST: u32 = 127;

/// The tree over a mesh that the settings ask for.
pub(crate) fn tree(mesh: &Mesh, settings: &Settings) -> Tree {
    let (references, bounds) = reference::references(mesh);
    let built = binned::build(mesh, references, bounds, settings);
    if settings.reinsertions == 0 {
        return built;
    }
    let mut improved = built.clone();
    reinsertion::improve(&mut improved, settings.reinsertions);
    // It may have become too high.
    if improved.depth <= DEEPEST { improved } else { built }
}
