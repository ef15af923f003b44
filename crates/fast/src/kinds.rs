//! The fast structures by name, and any of them.

use raystep_accel::{Hit, Mesh, Ray, Want};

use crate::{Bvh2, Bvh8, Count, Fast, Isa, Question, Settings};

/// The kinds of fast structures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FastKind {
    /// Two children to a node.
    Bvh2,
    /// Eight children to a node.
    Bvh8,
}

impl FastKind {
    /// All of them.
    pub const ALL: [FastKind; 2] = [FastKind::Bvh2, FastKind::Bvh8];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            FastKind::Bvh2 => "fast-bvh2",
            FastKind::Bvh8 => "fast-bvh8",
        }
    }

    /// Builds it over a mesh, on the threads of the current pool.
    pub fn build(self, mesh: &Mesh, settings: &Settings) -> AnyFast {
        match self {
            FastKind::Bvh2 => AnyFast::Bvh2(Bvh2::build(mesh, settings)),
            FastKind::Bvh8 => AnyFast::Bvh8(Bvh8::build(mesh, settings)),
        }
    }
}

/// Any of the fast structures.
#[derive(Clone, Debug)]
pub enum AnyFast {
    /// Two children to a node.
    Bvh2(Bvh2),
    /// Eight children to a node.
    Bvh8(Bvh8),
}

impl AnyFast {
    /// The same with other instructions.
    #[must_use]
    pub fn with(self, isa: Isa) -> AnyFast {
        match self {
            AnyFast::Bvh2(tree) => AnyFast::Bvh2(tree.with(isa)),
            AnyFast::Bvh8(tree) => AnyFast::Bvh8(tree.with(isa)),
        }
    }
}

impl Fast for AnyFast {
    #[inline]
    fn walk(&self, ray: &Ray, want: Want, count: &mut impl Count) -> Option<Hit> {
        match self {
            AnyFast::Bvh2(tree) => tree.walk(ray, want, count),
            AnyFast::Bvh8(tree) => tree.walk(ray, want, count),
        }
    }

    fn ask_some<T>(&self, rays: &[Ray], answers: &mut [T], question: impl Question<T>) {
        match self {
            AnyFast::Bvh2(tree) => tree.ask_some(rays, answers, question),
            AnyFast::Bvh8(tree) => tree.ask_some(rays, answers, question),
        }
    }

    fn bytes(&self) -> usize {
        match self {
            AnyFast::Bvh2(tree) => tree.bytes(),
            AnyFast::Bvh8(tree) => tree.bytes(),
        }
    }
}
