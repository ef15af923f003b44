//! A walk that was recorded, with what it went through.

use raystep_accel::{Aabb, Direction, KdLayout, Place, PrimId, Primitives, Prims, Ray, Structure, Visit};

use crate::world::Nodes;

/// Everything that the views of one walk need.
#[derive(Clone, Copy)]
pub struct Walk<'a> {
    /// What the ray walked through.
    pub structure: &'a Structure,
    /// What the structure was built over.
    pub prims: &'a Prims,
    /// The structure's nodes, as pictures need them.
    pub nodes: &'a Nodes,
    /// The ray.
    pub ray: Ray,
    /// What happened, in order.
    pub events: &'a [Visit],
    /// How many events more there were than are kept.
    pub lost: u64,
    /// Whether the scene is flat.
    pub flat: bool,
    /// The last layout in which the bytes of a kd-tree's node are shown.
    pub layout: KdLayout,
}

impl Walk<'_> {
    /// The box of a place.
    pub fn bounds(&self, place: Place) -> Aabb {
        match place {
            Place::World => self.world(),
            Place::Node(node) => self.nodes.bounds(node),
            Place::Cell(cell) => match self.structure.grid() {
                Some(grid) if cell.index() < grid.cell_count() => grid.cell_bounds(cell),
                _ => Aabb::EMPTY,
            },
            Place::Prim(prim) if prim.index() < self.prims.len() => self.prims.bounds(prim),
            Place::Prim(_) => Aabb::EMPTY,
        }
    }

    /// Whether the scene is flat and leaves out what stands across this direction.
    pub(crate) fn leaves_out(&self, across: Direction) -> bool {
        self.flat && across.leaves_plane()
    }

    /// The box around the structure, or around the primitives where there is none.
    pub fn world(&self) -> Aabb {
        let bounds = self.structure.bounds();
        if !bounds.is_empty() {
            return bounds;
        }
        around(self.prims)
    }
}

/// The box around some primitives.
fn around(prims: &Prims) -> Aabb {
    (0..prims.len() as u32).fold(Aabb::EMPTY, |all, prim| all.union(prims.bounds(PrimId(prim))))
}
