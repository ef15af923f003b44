//! Rays, trees and findings as the shader lays them out.

use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use raystep_accel::{Aabb, PrimId, Ray, Triangle};
use raystep_fast::{Below, Bvh2, Shot, Work};

use super::margins::BOX;

/// A ray; `Shot` of the shader.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(crate) struct Record {
    r: [f32; 3],
    t_min: f32,
    enter: [f32; 3],
    t_max: f32,
    leave: [f32; 3],
    flags: u32,
    o: [f32; 3],
    r_z: f32,
    shear: [f32; 2],
    rest: [f32; 2],
}

/// The bit of a ray's largest axis.
const ALONG: u32 = 8;
/// That a ray is not walked on the GPU.
const ASIDE: u32 = 32;

impl Record {
    /// The ray for a scene whose coordinates are at most `reach`; one that is not ordinary stands aside.
    pub(crate) fn new(ray: &Ray, reach: f32) -> Record {
        let Ok(shot) = Shot::with_margin(ray, reach, BOX) else {
            return Record { flags: ASIDE, ..Record::zeroed() };
        };
        let down: u32 = (0..3).map(|axis| u32::from(shot.down[axis]) << axis).sum();
        Record {
            r: shot.r,
            t_min: ray.t_min,
            enter: shot.enter,
            // Finite; no t of an ordinary ray comes near it.
            t_max: ray.t_max.clamp(-f32::MAX, f32::MAX),
            leave: shot.leave,
            flags: down | (shot.axes[2] as u32 * ALONG),
            o: shot.o,
            r_z: shot.sorted_r[2],
            shear: shot.shear,
            rest: [0.0; 2],
        }
    }
}

/// Both children of a node.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(crate) struct Node {
    low_0: [f32; 3],
    child_0: u32,
    high_0: [f32; 3],
    child_1: u32,
    low_1: [f32; 3],
    rest_0: u32,
    high_1: [f32; 3],
    rest_1: u32,
}

/// A triangle, and the longest side of its box; `Triangle` of the shader.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(crate) struct Corners {
    a: [f32; 3],
    prim: u32,
    b: [f32; 3],
    size: f32,
    c: [f32; 3],
    rest: u32,
}

impl Corners {
    fn new((prim, triangle): (PrimId, Triangle)) -> Corners {
        let Triangle { a, b, c } = triangle;
        // Rounded up.
        let size = triangle.bounds().extent().max_element().next_up();
        Corners { a: a.to_array(), prim: prim.0, b: b.to_array(), size, c: c.to_array(), rest: 0 }
    }
}

/// The bit of a leaf.
const LEAF: u32 = 1 << 31;
/// So many bits of a leaf say how many triangles it has.
const COUNT_BITS: u32 = 3;
/// A leaf without triangles.
const EMPTY: u32 = LEAF;

/// The nodes and triangles of a tree: at least one of each, as no buffer may be empty. Nothing where it has more of them
/// than can be told apart.
pub(crate) fn tree(tree: &Bvh2) -> Option<(Vec<Node>, Vec<Corners>)> {
    let (mut triangles, mut leaves) = (Vec::new(), Vec::new());
    for leaf in tree.leaves() {
        let count = leaf.len() as u32;
        let first = u32::try_from(triangles.len()).ok().filter(|first| first >> (31 - COUNT_BITS) == 0)?;
        leaves.push(LEAF | first << COUNT_BITS | count);
        triangles.extend(leaf.map(Corners::new));
    }
    if triangles.is_empty() {
        triangles.push(Corners::zeroed());
    }
    let side = |side: Option<(Aabb, Below)>| match side {
        None => (Vec3::ZERO, Vec3::ZERO, EMPTY),
        Some((bounds, Below::Node(node))) => (bounds.min, bounds.max, node as u32),
        Some((bounds, Below::Leaf(leaf))) => (bounds.min, bounds.max, leaves[leaf]),
    };
    let node = |sides: [_; 2]| {
        let [(low_0, high_0, child_0), (low_1, high_1, child_1)] = sides.map(side);
        let [low_0, high_0, low_1, high_1] = [low_0, high_0, low_1, high_1].map(|corner| corner.to_array());
        Node { low_0, child_0, high_0, child_1, low_1, rest_0: 0, high_1, rest_1: 0 }
    };
    Some((tree.nodes().map(node).collect(), triangles))
}

/// How a batch is asked.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(crate) struct Ask {
    pub(crate) rays: u32,
    pub(crate) any: u32,
}

/// What a walk found.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(crate) struct Found {
    prims: [u32; 4],
    state: u32,
    /// Nodes opened, leaves among them.
    nodes: u32,
    leaves: u32,
    tests: u32,
}

/// The number of no triangle.
const NONE: u32 = u32::MAX;

/// What a walk came to.
pub(crate) enum Outcome<'a> {
    /// One of these triangles is the answer, or there is none: let the judge say.
    Left(&'a [u32]),
    /// There is a hit.
    Sure,
    /// More triangles were left than there was room for.
    Many,
    /// It was not walked to its end.
    Again,
}

impl Found {
    pub(crate) fn outcome(&self) -> Outcome<'_> {
        match self.state {
            0 => Outcome::Left(&self.prims[..self.prims.iter().position(|prim| *prim == NONE).unwrap_or(4)]),
            1 => Outcome::Sure,
            2 => Outcome::Many,
            _ => Outcome::Again,
        }
    }

    /// What the walk did.
    pub(crate) fn work(&self) -> Work {
        Work {
            nodes: u64::from(self.nodes),
            boxes: u64::from(self.nodes - self.leaves) * 2,
            triangles: u64::from(self.tests),
            judged: self.prims.iter().filter(|prim| **prim != NONE).count() as u64,
        }
    }
}
