//! What is done beside the UI thread: walks being made, meshes being read, pictures being written.

mod asked;
mod bench;
pub(super) mod errands;
pub(super) mod exporting;
pub(super) mod heating;
pub(super) mod judging;
mod kept;
mod making;
mod second;
pub(super) mod task;
pub(super) mod thumbs;
mod underway;
mod watch;
mod workshop;

pub(super) use underway::Underway;
