//! The panes: each shows one side of a moment as a figure, or in space.

mod bytes;
mod cells;
mod costs;
mod growth;
mod ledger;
pub(crate) mod legend;
mod listing;
mod ruler;
mod slabs;
mod space;
mod stack;
mod timeline;
mod tree;
mod work;

pub use bytes::bytes;
pub use cells::cells;
pub use costs::costs;
pub use growth::{space_of_build, tree_of_build};
pub use ledger::{cells_of_build, work_of_build};
pub use listing::{ListingLine, listing};
pub use ruler::{ruler, ruler_height, ruler_line, ruler_line_height};
pub use slabs::slabs;
pub use space::space;
pub use stack::{stack, stack_height, stack_of_build};
pub use timeline::{Track, timeline, timeline_of_build};
pub use tree::{TreeView, tree};
pub use work::{tested, work};
