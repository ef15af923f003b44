//! How a tree is built.

/// How a tree is built. More pains give a better tree and take longer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The most triangles in a leaf, 1 to 4.
    pub leaf: u32,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings { leaf: 4 }
    }
}
