//! What a step looks like, as plain data.
//!
//! A [`Figure`] is a list of [`Mark`]s: ink with a [`Role`] and a [`Place`](raystep_accel::Place).
//! The window paints figures with egui, `print` writes them as SVG; both ask the one [`Theme`] which
//! colour and which line a role has. A solid scene is a [`Space`]: the same marks in world space, which a
//! [`Camera`] projects into a figure and `paint` draws on the GPU.

mod branches;
mod bytes;
mod cells;
mod costs;
mod film;
mod growth;
mod ledger;
mod legend;
mod listing;
mod moments;
mod page;
mod reel;
mod ruler;
mod slabs;
mod space;
mod spans;
mod stack;
mod stage;
mod still;
mod theme;
mod tidy;
mod timeline;
mod tree;
mod words;
mod work;
mod world;

pub use branches::TreeView;
pub use bytes::bytes;
pub use cells::cells;
pub use costs::costs;
pub use film::Film;
pub use growth::{space_of_build, tree_of_build};
pub use ledger::{cells_of_build, work_of_build};
pub use listing::{ListingLine, listing};
pub use moments::{
    Build, Cut, Fate, GrowMoment, GrowNode, Inside, Moment, PrimTest, SlabCut, SlabTest, Stepping, Taken, Tally,
    Tested, Waiting, Walk, Weighed,
};
pub use page::{Anchor, Figure, Image, Ink, Look, Mark};
pub use reel::{Instant, Reel};
pub use ruler::{ruler, ruler_height, ruler_line, ruler_line_height};
pub use slabs::slabs;
pub use space::space;
pub use stack::{stack, stack_height, stack_of_build};
pub use stage::{Camera, Scenery, Shaded, labels, shaded, stage};
pub use still::Still;
pub use theme::{Color, Dash, Face, Role, Stroke, Style, Theme, fonts, text_width};
pub use timeline::{Track, timeline, timeline_of_build};
pub use tree::tree;
pub use words::{Answer, Fact, Symbol, VolumeName, fill, number, sentence, short, told, value};
pub use work::{tested, work};
pub use world::{Form, Nodes, Space, SpaceMark, circles, contour, faces, lines};
