//! What a step looks like, as plain data.
//!
//! A [`Figure`] is a list of [`Mark`]s: ink with a [`Role`] and a [`Place`](raystep_accel::Place).
//! The window paints figures with egui, `print` writes them as SVG; both ask the one [`Theme`] which
//! colour and which line a role has. A solid scene is a [`Space`]: the same marks in world space, which a
//! [`Camera`] projects into a figure and `paint` draws on the GPU.

mod film;
mod moments;
mod page;
mod panes;
mod reel;
mod stage;
mod still;
mod theme;
mod words;
mod world;

pub use film::Film;
pub use moments::{
    Build, Cut, Fate, GrowMoment, GrowNode, Inside, Moment, PrimTest, SlabCut, SlabTest, Stepping, Taken, Tally,
    Tested, Waiting, Walk, Weighed,
};
pub use page::{Anchor, Figure, Image, Ink, Look, Mark};
pub use panes::{
    ListingLine, Track, TreeView, bytes, cells, cells_of_build, costs, listing, ruler, ruler_height, ruler_line,
    ruler_line_height, slabs, space, space_of_build, stack, stack_height, stack_of_build, tested, timeline,
    timeline_of_build, tree, tree_of_build, work, work_of_build,
};
pub use reel::{Instant, Reel};
pub use stage::{Camera, Scenery, Shaded, labels, shaded, stage};
pub use still::Still;
pub use theme::{Color, Dash, Face, Role, Stroke, Style, Theme, fonts, text_width};
pub use words::{Answer, Fact, Symbol, VolumeName, fill, number, sentence, short, told, value};
pub use world::{Form, Nodes, Space, SpaceMark, circles, contour, faces, lines};
