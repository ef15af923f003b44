//! A heat map: what was counted, pixel by pixel.

use super::known::Known;

/// A heat map.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// When it comes to be seen.
    pub entry: usize,
    /// What it is called.
    pub name: String,
    /// Pixels across and down.
    pub size: [u32; 2],
    /// What was counted for each pixel's ray, rows from above; nothing as long as nothing was.
    pub counts: Vec<u32>,
    /// How well its counts are known.
    pub known: Known,
}
