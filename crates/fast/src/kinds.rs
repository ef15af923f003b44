//! The fast structures by name, and any of them.

use raystep_accel::{Hit, Mesh, Ray, Want};

use crate::{Bvh2, Bvh8, Count, Fast, Grid, Isa, Kd, PacketWidth, Packets, Question, Settings};

/// The kinds of fast structures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FastKind {
    /// A uniform grid.
    Grid,
    /// A kd-tree.
    Kd,
    /// Two children to a node.
    Bvh2,
    /// Eight children to a node.
    Bvh8,
    /// Eight children to a node, and packets of 8 rays.
    Packets8,
    /// Eight children to a node, and packets of 16 rays.
    Packets16,
}

/// Any of the fast structures.
#[derive(Clone, Debug)]
pub enum AnyFast {
    /// A uniform grid.
    Grid(Grid),
    /// A kd-tree.
    Kd(Kd),
    /// Two children to a node.
    Bvh2(Bvh2),
    /// Eight children to a node.
    Bvh8(Bvh8),
    /// Packets of rays.
    Packets(Packets),
}

/// Does the same with any structure.
macro_rules! each {
    ($any:expr, $structure:ident => $do:expr) => {
        match $any {
            AnyFast::Grid($structure) => $do,
            AnyFast::Kd($structure) => $do,
            AnyFast::Bvh2($structure) => $do,
            AnyFast::Bvh8($structure) => $do,
            AnyFast::Packets($structure) => $do,
        }
    };
}

impl FastKind {
    /// All of them.
    pub const ALL: [FastKind; 6] =
        [FastKind::Grid, FastKind::Kd, FastKind::Bvh2, FastKind::Bvh8, FastKind::Packets8, FastKind::Packets16];

    /// Those that take one ray at a time.
    pub const ALONE: [FastKind; 4] = [FastKind::Grid, FastKind::Kd, FastKind::Bvh2, FastKind::Bvh8];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            FastKind::Grid => "fast-grid",
            FastKind::Kd => "fast-kd",
            FastKind::Bvh2 => "fast-bvh2",
            FastKind::Bvh8 => "fast-bvh8",
            FastKind::Packets8 => "fast-packets8",
            FastKind::Packets16 => "fast-packets16",
        }
    }

    /// The kind of a name.
    pub fn named(name: &str) -> Option<FastKind> {
        FastKind::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// Builds it over a mesh, on the threads of the current pool.
    pub fn build(self, mesh: &Mesh, settings: &Settings) -> AnyFast {
        match self {
            FastKind::Grid => AnyFast::Grid(Grid::build(mesh)),
            FastKind::Kd => AnyFast::Kd(Kd::build(mesh)),
            FastKind::Bvh2 => AnyFast::Bvh2(Bvh2::build(mesh, settings)),
            FastKind::Bvh8 => AnyFast::Bvh8(Bvh8::build(mesh, settings)),
            FastKind::Packets8 => AnyFast::Packets(Packets::build(mesh, PacketWidth::Eight, settings)),
            FastKind::Packets16 => AnyFast::Packets(Packets::build(mesh, PacketWidth::Sixteen, settings)),
        }
    }
}

impl AnyFast {
    /// The same with other instructions.
    #[must_use]
    pub fn with(self, isa: Isa) -> AnyFast {
        match self {
            AnyFast::Grid(grid) => AnyFast::Grid(grid.with(isa)),
            AnyFast::Kd(tree) => AnyFast::Kd(tree.with(isa)),
            AnyFast::Bvh2(tree) => AnyFast::Bvh2(tree.with(isa)),
            AnyFast::Bvh8(tree) => AnyFast::Bvh8(tree.with(isa)),
            AnyFast::Packets(packets) => AnyFast::Packets(packets.with(isa)),
        }
    }
}

impl Fast for AnyFast {
    #[inline]
    fn walk(&self, ray: &Ray, want: Want, count: &mut impl Count) -> Option<Hit> {
        each!(self, structure => structure.walk(ray, want, count))
    }

    fn ask_some<T>(&self, rays: &[Ray], answers: &mut [T], question: impl Question<T>) {
        each!(self, structure => structure.ask_some(rays, answers, question));
    }

    fn bytes(&self) -> usize {
        each!(self, structure => structure.bytes())
    }
}
