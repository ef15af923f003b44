//! What is done beside the UI thread: walks being made, meshes being read, pictures being written.

mod bench;
pub(super) mod errands;
pub(super) mod exporting;
pub(super) mod second;
pub(super) mod task;
pub(super) mod workshop;
