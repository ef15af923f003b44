//! How large lessons may be: a file that says more is no slide, and what it does say stays quick to read and to play.

/// Bytes of a slide, of a listing, of the names of sections.
pub(crate) const BYTES: usize = 128 * 1024;
/// Beats of a slide.
pub(crate) const BEATS: usize = 64;
/// Rays of a stage.
pub(crate) const RAYS: usize = 32;
/// Rays of a packet, the fewest and the most.
pub(crate) const LANES: [usize; 2] = [2, 16];
/// Promises of a ray, numbers of a slide, panes that it shows.
pub(crate) const ENTRIES: usize = 32;
/// Rows, points and lines of a board.
pub(crate) const BOARD: usize = 64;
/// Letters of a title, of a name, of what a button says.
pub(crate) const TITLE: usize = 120;
/// Letters of what a word means.
pub(crate) const MEANING: usize = 240;
/// Problems that are told of one file.
pub(crate) const PROBLEMS: usize = 50;
/// Files in a folder of lessons, all together.
#[cfg(not(target_arch = "wasm32"))]
pub(crate) const FILES: usize = 2000;

/// Bytes of a scene in a folder of lessons.
#[cfg(not(target_arch = "wasm32"))]
pub(crate) const SCENE: usize = 256 << 20;

/// What is said of a file with so many bytes.
pub(crate) fn too_large(bytes: u64) -> String {
    format!("the file has {} KB: a slide or a listing has at most {} KB", bytes.div_ceil(1024), BYTES / 1024)
}
