//! The panes: each shows one side of a moment as a figure, or in space.

mod bars;
mod bin;
mod board;
mod bytes;
mod cells;
mod changed;
mod costs;
mod fit;
mod lanes;
pub(crate) mod legend;
mod listing;
mod packet;
mod pairs;
mod pane;
mod ruler;
mod slabs;
mod space;
mod stack;
mod timeline;
mod tree;
mod walks;
mod weighing;
mod work;

pub use bars::{Bar, Bars};
pub(crate) use bin::bin_of_packet;
pub use bin::{bin, bin_of_build};
pub use board::{
    Chart, Column, Curve, Dot, Drawn, ELSEWHERE, Given, Knob, KnobLine, Known, Map, Maps, Meter, Panel, Picture,
    Pictures, Pixel, Row, Scale, Table,
};
pub(crate) use board::{board, knobs, pixel_at, probe, worth};
pub use bytes::bytes;
pub(crate) use bytes::bytes_height;
pub use cells::{cells, cells_of_build};
pub use changed::{changed, changed_height, changed_of_build};
pub use costs::costs;
pub(crate) use fit::space_of_fit;
pub use listing::{ListingLine, line_at, listing, listing_height};
pub(crate) use packet::{
    listing_of_packet, matrix, matrix_height, rulers, rulers_height, space_of_packet, stack_of_packet, tree_of_packet,
};
pub use pairs::Grip;
pub(crate) use pairs::{
    Tried, matrix as matrix_of_pairs, matrix_height as matrix_of_pairs_height, numbers, space_of_pair, steps,
};
pub use pane::{Ask, Pane};
pub use ruler::{RulerScale, ruler, ruler_height, ruler_line, ruler_line_height};
pub(crate) use ruler::{ruler_line_of, ruler_of, ruler_scale};
pub use slabs::slabs;
pub(crate) use space::depth_of_build;
pub use space::{ghost, ghost_of_build, space, space_of_build, space_of_build_to, space_to};
pub use stack::{stack, stack_height, stack_of_build};
pub use timeline::{Track, timeline, timeline_of_build};
pub(crate) use timeline::{symbol_at, symbol_of_build_at, symbol_on_track, track};
pub(crate) use tree::tree_with;
pub use tree::{TreeView, tree, tree_height, tree_of_build};
pub(crate) use walks::{Walker, walks, worth as worth_of_walks};
pub use weighing::CutLine;
pub(crate) use weighing::{beside_plots, cut_line, cut_to, weighing};
pub(crate) use work::tests_of;
pub(crate) use work::weighed;
pub use work::{tested, work, work_of_build};
