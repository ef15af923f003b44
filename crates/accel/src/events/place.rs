//! Names for the things a walk meets.

use std::fmt;

/// A primitive: its zero-based position in the scene's order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PrimId(pub u32);

/// A node: its index in the finished structure's array of nodes. The root is 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(pub u32);

/// A grid cell: `x + nx·(y + ny·z)`. Cells of grids within cells come after those of the coarse grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CellId(pub u32);

/// What an event, a mark or a number is about. Views that name the same place light up together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Place {
    /// The whole scene, or the one box of a slab test.
    World,
    /// A node of a tree.
    Node(NodeId),
    /// A cell of a grid.
    Cell(CellId),
    /// A primitive.
    Prim(PrimId),
}

impl PrimId {
    /// The id as an index into an array.
    #[inline]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

impl NodeId {
    /// The root of every tree.
    pub const ROOT: NodeId = NodeId(0);

    /// The id as an index into an array.
    #[inline]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

impl CellId {
    /// The id as an index into an array.
    #[inline]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

impl fmt::Display for PrimId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0)
    }
}

impl fmt::Display for NodeId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0)
    }
}

impl fmt::Display for CellId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0)
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Place::World => write!(f, "the box"),
            Place::Node(node) => write!(f, "node {node}"),
            Place::Cell(cell) => write!(f, "cell {cell}"),
            Place::Prim(prim) => write!(f, "primitive {prim}"),
        }
    }
}
