//! Walks of many rays on the GPU, slide 64, which answer exactly as brute force does.
//!
//! A GPU has single precision only, so it rules out, and is sure of what is certain; why it may be stands in `margins`.
//! Of each ray it says which few triangles are left for the nearest hit. `accel`'s own operations decide between
//! them on the CPU. Where more are left than there is room for, or the ray is not an ordinary one, all of the ray is walked on
//! the CPU; [`Judged`] tells how many those were.

mod batch;
#[cfg(test)]
mod doubt;
mod fault;
mod gpu;
mod layout;
mod margins;
mod walker;

pub use fault::Fault;
pub use gpu::Gpu;
pub use walker::{Judged, Walker};
