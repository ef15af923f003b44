//! How carefully a board is filled: first with nothing that takes long, then coarsely, then in full.

/// How many rays what is measured and drawn on a board is given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Care {
    /// None: what is measured or traced waits, and the rest of the board is there at once.
    Bare,
    /// A sixteenth of them: seen soon, and not yet to be quoted.
    Draft,
    /// All of them: what stands on paper.
    #[default]
    Full,
}

impl Care {
    /// The pixels across and down of a picture that has `size` in full.
    pub(super) fn of(self, size: [u32; 2]) -> [u32; 2] {
        match self {
            Care::Bare | Care::Draft => size.map(|side| (side / 4).max(4)),
            Care::Full => size,
        }
    }
}
