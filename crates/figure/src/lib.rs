//! What a step looks like, as plain data.
//!
//! A [`Figure`] is a list of [`Mark`]s: ink with a [`Role`] and a [`Place`](raystep_accel::Place).
//! The window paints figures with egui, `print` writes them as SVG; both ask the one [`Theme`] which
//! colour and which line a role has. A solid scene is a [`Space`]: the same marks in world space, which a
//! [`Camera`] projects into a figure and `paint` draws on the GPU.

mod camera;
mod figure;
mod film;
pub mod fonts;
mod moment;
mod number;
mod role;
mod space;
mod theme;
mod walk;

pub use camera::Camera;
pub use figure::{Anchor, Face, Figure, Ink, Mark};
pub use film::Film;
pub use fonts::text_width;
pub use moment::{Cut, Moment, PrimTest, SlabCut, SlabTest, Stepping, Tested, Waiting};
pub use number::{fill, number, value};
pub use role::Role;
pub use space::{Form, Space, SpaceMark};
pub use theme::{Color, Dash, Stroke, Style, Theme};
pub use walk::Walk;
