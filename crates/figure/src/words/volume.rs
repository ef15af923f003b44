//! What the volumes of a structure are called.

use raystep_accel::{AnyBvh, Structure};

/// What a structure bounds things with, in a word: what is tested before anything in it. And what its builder
/// weighs to divide a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VolumeName {
    /// One of them.
    pub one: &'static str,
    /// Several.
    pub many: &'static str,
    /// A tree of planes is cut by one, a hierarchy shares out its primitives one way or another.
    pub cut: &'static str,
}

impl VolumeName {
    /// A box along the axes.
    pub const BOX: VolumeName = VolumeName { one: "box", many: "boxes", cut: "plane" };

    /// What is tested in this structure.
    pub fn of(structure: &Structure) -> VolumeName {
        let (one, many) = match structure {
            Structure::Bvh(AnyBvh::Sphere(_)) => ("sphere", "spheres"),
            Structure::Bvh(AnyBvh::Obb(_)) => ("oriented box", "oriented boxes"),
            Structure::Bvh(AnyBvh::KDop14(_) | AnyBvh::KDop18(_) | AnyBvh::KDop26(_)) => ("k-DOP", "k-DOPs"),
            Structure::Bvh(AnyBvh::Hull(_)) => ("hull", "hulls"),
            // Six planes along the axes are a box, whatever they are called.
            _ => ("box", "boxes"),
        };
        let cut = if let Structure::Bvh(_) = structure { "way" } else { "plane" };
        VolumeName { one, many, cut }
    }
}
