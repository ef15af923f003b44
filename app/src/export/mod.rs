//! Steps of walks as files: the one way that the command line and the window's dialog both go.

mod drawing;
mod film;
mod ground;
mod job;
mod names;
mod order;
mod session;
mod size;
mod span;
mod standing;
mod telling;
mod there;
mod video;
mod view;

pub(crate) use ground::{Changes, Ground, rays_of_beats};
pub(crate) use job::{Which, jobs, pictures, write};
pub(crate) use names::of_linked_camera;
pub(crate) use order::{Format, Order, STEP_MILLIS, delay};
pub(crate) use session::Session;
pub use size::Size;
pub(crate) use span::span;
pub(crate) use standing::Changed;
pub(crate) use telling::{Asked, Telling};
pub(crate) use there::There;
pub(crate) use video::has_ffmpeg;
pub(crate) use view::Piece;
pub use view::View;
