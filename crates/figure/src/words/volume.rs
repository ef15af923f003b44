//! What the volumes of a structure are called.

use raystep_accel::{AnyBvh, BvhVolume, Structure};

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

    /// A volume of this kind.
    pub fn named(volume: BvhVolume) -> VolumeName {
        let (one, many) = match volume {
            BvhVolume::Sphere => ("sphere", "spheres"),
            BvhVolume::Obb => ("oriented box", "oriented boxes"),
            BvhVolume::KDop14 | BvhVolume::KDop18 | BvhVolume::KDop26 => ("k-DOP", "k-DOPs"),
            BvhVolume::Hull => ("hull", "hulls"),
            // Six planes along the axes are a box, whatever they are called.
            BvhVolume::Aabb | BvhVolume::KDop6 => ("box", "boxes"),
        };
        VolumeName { one, many, cut: "way" }
    }

    /// What the nodes of this tree are drawn as, in a word for several.
    pub(crate) fn drawn(structure: &Structure) -> &'static str {
        if matches!(structure, Structure::Bsp(_)) { "cells" } else { VolumeName::of(structure).many }
    }

    /// What is tested in this structure.
    pub fn of(structure: &Structure) -> VolumeName {
        let Structure::Bvh(tree) = structure else { return VolumeName::BOX };
        VolumeName::named(match tree {
            AnyBvh::Sphere(_) => BvhVolume::Sphere,
            AnyBvh::Obb(_) => BvhVolume::Obb,
            AnyBvh::KDop14(_) => BvhVolume::KDop14,
            AnyBvh::KDop18(_) => BvhVolume::KDop18,
            AnyBvh::KDop26(_) => BvhVolume::KDop26,
            AnyBvh::Hull(_) => BvhVolume::Hull,
            AnyBvh::Aabb(_) | AnyBvh::KDop6(_) => BvhVolume::Aabb,
        })
    }
}
