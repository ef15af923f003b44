//! The fields of a node, in order, and how many bytes they take together.

/// What a field is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Word {
    /// A whole number of 32 bits.
    Int,
    /// A number of single precision.
    Float,
    /// The address of something.
    Pointer,
    /// Yes or no, in a byte of its own.
    Flag,
}

/// One field of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NodeField {
    /// What it says.
    pub name: &'static str,
    /// What it is.
    pub word: Word,
    /// What its bits say apart, from the lowest on: a name and how many they are; empty if they say one thing.
    pub bits: &'static [(&'static str, u32)],
}

impl NodeField {
    /// A field that says one thing.
    pub(super) const fn new(name: &'static str, word: Word) -> NodeField {
        NodeField { name, word, bits: &[] }
    }
}

/// Who lays the fields out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Machine {
    /// The slide: pointers of 32 bits, and nothing between the fields.
    Printed,
    /// A compiler for pointers of 32 bits.
    Bits32,
    /// A compiler for pointers of 64 bits.
    Bits64,
}

impl Machine {
    /// The three, as they are told apart.
    pub const ALL: [Machine; 3] = [Machine::Printed, Machine::Bits32, Machine::Bits64];

    /// How many bytes a field takes.
    pub const fn bytes(self, word: Word) -> usize {
        match (word, self) {
            (Word::Flag, _) => 1,
            (Word::Pointer, Machine::Bits64) => 8,
            _ => 4,
        }
    }

    /// Where each field begins, and where the next node does.
    ///
    /// A compiler puts every field at a multiple of its own size, so that one access reads it, and leaves what
    /// lies between unused; the node ends at a multiple of its widest field, so that the next one begins well.
    pub fn places(self, fields: &[NodeField]) -> (Vec<usize>, usize) {
        let align = |word| if self == Machine::Printed { 1 } else { self.bytes(word) };
        let (mut places, mut end, mut widest) = (Vec::new(), 0_usize, 1);
        for field in fields {
            let at = end.next_multiple_of(align(field.word));
            places.push(at);
            end = at + self.bytes(field.word);
            widest = widest.max(align(field.word));
        }
        (places, end.next_multiple_of(widest))
    }
}
