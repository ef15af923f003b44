//! What a step looks like, as plain data.
//!
//! A [`Figure`] is a list of [`Mark`]s: ink with a [`Role`] and a [`Place`](raystep_accel::Place).
//! The window paints figures with egui, `print` writes them as SVG; both ask the one [`Theme`] which
//! colour and which line a role has. A solid scene is a [`Space`]: the same marks in world space, which a
//! [`Camera`] projects into a figure and `paint` draws on the GPU.

mod camera;
mod figure;
mod role;
mod space;

pub use camera::Camera;
pub use figure::{Anchor, Face, Figure, Ink, Mark};
pub use role::Role;
pub use space::{Form, Space, SpaceMark};
