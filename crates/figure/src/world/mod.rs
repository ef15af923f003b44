//! A drawing in world space, for any camera: forms with a role and a place, and what bodies look like.

mod body;
pub(crate) mod convex;
mod faces;
mod globe;
mod nodes;
mod outlines;
mod space;

pub use body::lines;
pub use faces::faces;
pub(crate) use faces::ring;
pub use globe::{circles, contour};
pub use nodes::Nodes;
pub(crate) use space::corners;
pub use space::{Form, Space, SpaceMark};
