//! A walk that was recorded, with what it went through.

use raystep_accel::{Aabb, AnyBvh, Axis, Direction, Place, Primitives, Prims, Ray, Structure, Visit};

use crate::reel::around;

/// Everything that the views of one walk need.
#[derive(Clone, Copy)]
pub struct Walk<'a> {
    /// What the ray walked through.
    pub structure: &'a Structure,
    /// What the structure was built over.
    pub prims: &'a Prims,
    /// The box of every node, in order; empty for structures without nodes.
    pub node_bounds: &'a [Aabb],
    /// The ray.
    pub ray: Ray,
    /// What happened, in order.
    pub events: &'a [Visit],
    /// Whether the scene is flat.
    pub flat: bool,
}

impl Walk<'_> {
    /// The box of a place.
    pub fn bounds(&self, place: Place) -> Aabb {
        match place {
            Place::World => self.world(),
            Place::Node(node) => self.node_bounds.get(node.index()).copied().unwrap_or(Aabb::EMPTY),
            Place::Cell(cell) => match self.structure.grid() {
                Some(grid) if cell.index() < grid.cell_count() => grid.cell_bounds(cell),
                _ => Aabb::EMPTY,
            },
            Place::Prim(prim) if prim.index() < self.prims.len() => self.prims.bounds(prim),
            Place::Prim(_) => Aabb::EMPTY,
        }
    }

    /// Whether a slab of a volume is that of the z axis in a flat scene, which leaves it out.
    pub(crate) fn leaves_out(&self, place: Place, across: Direction) -> bool {
        let level = match (self.structure, place, across) {
            (Structure::Bvh(AnyBvh::Obb(tree)), Place::Node(node), Direction::Own(axis)) => {
                tree.volume(node).axes[axis.index()].z.abs() > 0.999
            }
            _ => across == Axis::Z.into(),
        };
        self.flat && level
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
