//! Points, rays and boxes: what everything else is said in.

mod aabb;
mod axis;
pub(crate) mod digits;
mod direction;
mod interval;
mod obb;
mod pinhole;
mod ray;

pub use aabb::Aabb;
pub use axis::{Axes, Axis, Measure};
pub use direction::Direction;
pub use interval::Interval;
pub use obb::Obb;
pub use pinhole::pinhole;
pub use ray::{Ray, RayError};
