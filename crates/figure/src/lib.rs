//! What a step looks like, as plain data.
//!
//! A [`Figure`] is a list of [`Mark`]s: ink with a [`Role`] and a [`Place`](raystep_accel::Place).
//! The window paints figures with egui, `print` writes them as SVG; both ask the one [`Theme`] which
//! colour and which line a role has. A solid scene is a [`Space`]: the same marks in world space, which a
//! [`Camera`] projects into a figure and `paint` draws on the GPU.
//!
//! The rooms, from the ground up; each knows those above it in this list, and none below:
//!
//! - `theme`: roles, the one table from a role to its look, and the shipped faces
//! - `page`: figures, their marks, and the few shapes that all panes share
//! - `words`: what an event says, and the one formatter of numbers
//! - `world`: drawings in world space, and what bodies and nodes look like there
//! - `stage`: a drawing in world space as a camera sees it
//! - `moments`: walks and builds as they were recorded, and the state of each after some events
//! - `panes`: one side of a moment each: space, tree, cells, ruler, costs, stack, slabs, bytes, listing, work …
//! - `kinds`: what can be shown step by step, each kind with the panes that it can draw

mod kinds;
mod moments;
mod page;
mod panes;
mod stage;
mod theme;
mod words;
mod world;

pub use kinds::{Board, Detail, Film, Fitting, Guess, Instant, Kind, Pairs, Reel, Still, Walks};
pub use moments::{
    Build, Changed, Cut, Fate, GrowMoment, GrowNode, Inside, Moment, PacketMoment, PacketWalk, PrimTest, SlabCut,
    SlabTest, Stepping, Taken, Tally, Tested, Waiting, Walk, Weighed,
};
pub use page::{Anchor, Figure, Image, Ink, Look, Mark, Motion, nothing};
pub use panes::{
    Ask, Bar, Bars, Chart, Column, Curve, CutLine, Dot, Drawn, ELSEWHERE, Given, Grip, Knob, KnobLine, Known,
    ListingLine, Map, Maps, Meter, Pane, Panel, Picture, Pictures, Pixel, Row, RulerScale, Scale, Table, Track,
    TreeView, bin, bin_of_build, bytes, cells, cells_of_build, changed, changed_height, changed_of_build, costs, ghost,
    ghost_of_build, line_at, listing, listing_height, ruler, ruler_height, ruler_line, ruler_line_height, slabs, space,
    space_of_build, space_of_build_to, space_to, stack, stack_height, stack_of_build, tested, timeline,
    timeline_of_build, tree, tree_height, tree_of_build, work, work_of_build,
};
pub use stage::{
    Camera, Scenery, Shaded, axes, close_up, crop, inset_at, inset_size, is_label, is_nearer, labels, pointed_at,
    set_inset, shaded, stage, stage_around,
};
pub use theme::{Color, Dash, Face, Role, Stroke, Style, Theme, fonts, text_width};
pub use words::{
    Answer, Fact, ROUGH, Symbol, VolumeName, coordinate, counted, fill, number, sentence, short, told, value, veiled,
    whole,
};
pub use world::{Depth, Form, Nodes, Space, SpaceMark, circles, contour, faces, forms_of, lines};
