//! A drawing in world space, for any camera: forms with a role and a place, and what bodies look like.

mod body;
pub(crate) mod convex;
mod faces;
mod globe;
mod levels;
mod nodes;
mod outlines;
mod space;

pub use body::lines;
pub use faces::faces;
pub(crate) use faces::ring;
pub use globe::{circles, contour};
pub(crate) use levels::{Levels, drawn, frontier};
pub use nodes::Nodes;
pub use outlines::forms_of;
pub(crate) use outlines::volume as forms_of_volume;
pub(crate) use space::edges;
pub use space::{Depth, Form, Space, SpaceMark};
