//! Steps of walks as files: the one way that the command line and the window's dialog both go.

mod ground;
mod job;
mod names;
mod session;
mod size;
mod telling;

pub(crate) use ground::{Changes, Ground, rays_of_beats};
pub(crate) use job::{Format, Order, Which, jobs, pictures, write};
pub(crate) use session::Session;
pub use session::View;
pub use size::Size;
pub(crate) use telling::{Asked, Telling};
