//! A heat map: what was counted, pixel by pixel.

/// A heat map.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// When it comes to be seen.
    pub entry: usize,
    /// What it is called.
    pub name: String,
    /// Pixels across and down.
    pub size: [u32; 2],
    /// What was counted for each pixel's ray, rows from above.
    pub counts: Vec<u32>,
}
