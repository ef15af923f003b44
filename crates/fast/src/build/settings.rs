//! How a tree is built.

/// How a tree is built. More pains give a better tree and take longer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The most triangles in a leaf, 1 to 4.
    pub leaf: u32,
    /// How often nodes are taken out of the tree and put back where they cost least.
    pub reinsertions: u32,
    /// By how many hundredths references may become more than triangles, because nodes are split in space and triangles
    /// on both sides belong to both; 0 splits by triangles only.
    pub splits: u32,
}

impl Settings {
    /// Built as fast as can be.
    pub const QUICK: Settings = Settings { leaf: 4, reinsertions: 0, splits: 0 };
    /// Built with all pains. Leaves are whole before nodes are put elsewhere: what is put elsewhere triangle by triangle
    /// tears apart what one leaf of four would hold (peers/README.md).
    pub const DEAR: Settings = Settings { leaf: 4, reinsertions: 4, splits: 60 };
}

impl Default for Settings {
    fn default() -> Settings {
        Settings::QUICK
    }
}
