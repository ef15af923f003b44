//! The rungs of the ladder, slide 64.

/// A rung: each has all that stands before it, or another structure over the same triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Rung {
    /// Brute force.
    List,
    /// The textbook's uniform grid.
    Grid,
    /// The textbook's kd-tree.
    Kd,
    /// The textbook's hierarchy of boxes.
    Bvh,
    /// Two children to a node in one cache line, a stack of our own, four triangles at once.
    Bvh2,
    /// Eight children to a node, tested at once.
    Bvh8,
    /// Rays that walk together.
    Packets,
    /// All threads.
    Threads,
    /// The graphics card.
    Gpu,
}

impl Rung {
    /// From the ground up.
    pub const ALL: [Rung; 9] =
        [Rung::List, Rung::Grid, Rung::Kd, Rung::Bvh, Rung::Bvh2, Rung::Bvh8, Rung::Packets, Rung::Threads, Rung::Gpu];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Rung::List => "list",
            Rung::Grid => "grid",
            Rung::Kd => "kd",
            Rung::Bvh => "bvh",
            Rung::Bvh2 => "bvh2",
            Rung::Bvh8 => "bvh8",
            Rung::Packets => "packets",
            Rung::Threads => "threads",
            Rung::Gpu => "gpu",
        }
    }

    /// What it is, in a few words.
    pub fn about(self) -> &'static str {
        match self {
            Rung::List => "brute force",
            Rung::Grid => "textbook, uniform grid",
            Rung::Kd => "textbook, kd-tree",
            Rung::Bvh => "textbook, boxes in boxes",
            Rung::Bvh2 => "own stack, cache lines, 4 triangles at once",
            Rung::Bvh8 => "8 boxes at once",
            Rung::Packets => "16 rays together",
            Rung::Threads => "on all threads",
            Rung::Gpu => "on the graphics card",
        }
    }
}
