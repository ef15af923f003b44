//! Any of the structures, with what views ask of them.

use crate::{
    Aabb, Accel, AnyBvh, AnyGrid, Bsp, Cancelled, Direction, Grid, Grow, HandCut, HashedGrid, Hit, Kd, List,
    NestedGrid, NodeId, Observer, Octree, OneBox, PlaneTest, PrimId, Primitives, Ray, Rule, Visit, Want,
};

/// Hears what a builder weighs at a node, and the last of it.
struct Weighing {
    node: NodeId,
    told: Option<Grow>,
    over: bool,
}

impl Observer<Grow> for Weighing {
    fn on(&mut self, event: Grow) {
        match event {
            Grow::Weigh { node, .. } if node == self.node => self.told = Some(event),
            Grow::Split { node, .. } | Grow::Leaf { node, .. } if node == self.node => self.over = true,
            _ => {}
        }
    }

    fn cancelled(&self) -> bool {
        self.over
    }
}

/// A structure of any kind.
#[derive(Clone, Debug, PartialEq)]
pub enum Structure {
    /// No structure: brute force.
    List(List),
    /// Only the box around everything.
    Slab(OneBox),
    /// A uniform grid.
    Grid(Grid),
    /// Grids within the crowded cells of a coarse grid.
    NestedGrid(NestedGrid),
    /// A uniform grid of which only the occupied cells are stored.
    HashedGrid(HashedGrid),
    /// A kd-tree.
    Kd(Kd),
    /// An octree, in a flat scene a quadtree.
    Octree(Octree),
    /// A BSP tree.
    Bsp(Bsp),
    /// A hierarchy of bounding volumes.
    Bvh(AnyBvh),
}

impl Structure {
    /// Builds what `rule` says over `prims`.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub fn build(
        prims: &impl Primitives,
        rule: &Rule,
        watch: &mut impl Observer<Grow>,
    ) -> Result<Structure, Cancelled> {
        Ok(match rule {
            Rule::List => Structure::List(List),
            Rule::Slab => Structure::Slab(OneBox::around(prims)),
            Rule::Grid(rule) => Structure::Grid(Grid::build(prims, rule, watch)?),
            Rule::NestedGrid(rule) => Structure::NestedGrid(NestedGrid::build(prims, rule, watch)?),
            Rule::HashedGrid(rule) => Structure::HashedGrid(HashedGrid::build(prims, rule, watch)?),
            Rule::Kd(rule) => Structure::Kd(Kd::build(prims, rule, watch)?),
            Rule::Octree(rule) => Structure::Octree(Octree::build(prims, rule, watch)?),
            Rule::Bsp(rule) => Structure::Bsp(Bsp::build(prims, rule, watch)?),
            Rule::Bvh(rule) => Structure::Bvh(AnyBvh::build(prims, rule, watch)?),
        })
    }

    /// What a builder tells when it weighs a cut that somebody chose by hand, as the last one of its node. Nothing if
    /// it does not come to weigh that node, or if the cut leaves nothing on one side.
    pub fn weigh(prims: &impl Primitives, rule: &Rule, cut: HandCut) -> Option<Grow> {
        let mut rule = *rule;
        let cuts = rule.by_hand()?.with(cut)?;
        rule.set("cut", &cuts.to_string()).ok()?;
        let mut weighing = Weighing { node: cut.node, told: None, over: false };
        // It gives up once the node is divided: nothing after that is asked for.
        let _ = Structure::build(prims, &rule, &mut weighing);
        let own = |event: &Grow| match *event {
            Grow::Weigh { axis, plane, .. } => axis == cut.axis.into() && plane == cut.at,
            _ => false,
        };
        weighing.told.filter(own)
    }

    /// The box around everything; empty for a list, which keeps none.
    pub fn bounds(&self) -> Aabb {
        match self {
            Structure::List(_) => Aabb::EMPTY,
            Structure::Slab(one) => one.bounds,
            Structure::Grid(grid) => grid.lattice.bounds,
            Structure::NestedGrid(grid) => grid.lattice.bounds,
            Structure::HashedGrid(grid) => grid.lattice.bounds,
            Structure::Kd(tree) => tree.bounds(),
            Structure::Octree(tree) => tree.bounds(),
            Structure::Bsp(tree) => tree.bounds(),
            Structure::Bvh(tree) => tree.bounds(),
        }
    }

    /// Its cells, if it is a grid of any kind.
    pub fn grid(&self) -> Option<&dyn AnyGrid> {
        match self {
            Structure::Grid(grid) => Some(grid),
            Structure::NestedGrid(grid) => Some(grid),
            Structure::HashedGrid(grid) => Some(grid),
            _ => None,
        }
    }

    /// How many nodes a tree has; 0 in what is no tree.
    pub fn node_count(&self) -> usize {
        match self {
            Structure::List(_)
            | Structure::Slab(_)
            | Structure::Grid(_)
            | Structure::NestedGrid(_)
            | Structure::HashedGrid(_) => 0,
            Structure::Kd(tree) => tree.node_count(),
            Structure::Octree(tree) => tree.node_count(),
            Structure::Bsp(tree) => tree.node_count(),
            Structure::Bvh(tree) => tree.node_count(),
        }
    }

    /// The children of a node, the lower or left one first; none of a leaf.
    pub fn children(&self, node: NodeId) -> Vec<NodeId> {
        let pair = match self {
            Structure::List(_)
            | Structure::Slab(_)
            | Structure::Grid(_)
            | Structure::NestedGrid(_)
            | Structure::HashedGrid(_) => None,
            Structure::Kd(tree) => tree.children(node),
            Structure::Octree(tree) => return tree.children(node),
            Structure::Bsp(tree) => tree.children(node),
            Structure::Bvh(tree) => tree.children(node),
        };
        pair.map_or(Vec::new(), Vec::from)
    }

    /// What a leaf refers to, in order; nothing in an inner node.
    pub fn leaf_prims(&self, node: NodeId) -> &[PrimId] {
        match self {
            Structure::List(_)
            | Structure::Slab(_)
            | Structure::Grid(_)
            | Structure::NestedGrid(_)
            | Structure::HashedGrid(_) => &[],
            Structure::Kd(tree) => tree.leaf_prims(node),
            Structure::Octree(tree) => tree.leaf_prims(node),
            Structure::Bsp(tree) => tree.leaf_prims(node),
            Structure::Bvh(tree) => tree.leaf_prims(node),
        }
    }

    /// The plane that splits a node's space: only inner nodes of a kd-tree or a BSP tree have one.
    pub fn split(&self, node: NodeId) -> Option<(Direction, f32)> {
        match self {
            Structure::Kd(tree) => tree.split(node).map(|(axis, plane)| (axis.into(), plane)),
            Structure::Bsp(tree) => tree.plane(node).map(|plane| (Direction::Normal, plane.at)),
            _ => None,
        }
    }

    /// The boxes of all nodes, by id.
    pub fn node_bounds(&self) -> Vec<Aabb> {
        match self {
            Structure::List(_)
            | Structure::Slab(_)
            | Structure::Grid(_)
            | Structure::NestedGrid(_)
            | Structure::HashedGrid(_) => Vec::new(),
            Structure::Kd(tree) => tree.node_bounds(),
            Structure::Octree(tree) => tree.node_bounds(),
            Structure::Bsp(tree) => tree.node_bounds(),
            Structure::Bvh(tree) => tree.node_bounds(),
        }
    }

    /// What it takes to cut a ray by one plane, where planes cut space.
    pub fn plane_test(&self) -> Option<PlaneTest> {
        match self {
            Structure::Kd(_) => Some(Kd::PLANE_TEST),
            Structure::Bsp(_) => Some(Bsp::PLANE_TEST),
            _ => None,
        }
    }

    /// How many bytes the structure takes.
    pub fn bytes(&self) -> usize {
        match self {
            Structure::List(_) => 0,
            Structure::Slab(one) => size_of_val(one),
            Structure::Grid(grid) => grid.bytes(),
            Structure::NestedGrid(grid) => grid.bytes(),
            Structure::HashedGrid(grid) => grid.bytes(),
            Structure::Kd(tree) => tree.bytes(),
            Structure::Octree(tree) => tree.bytes(),
            Structure::Bsp(tree) => tree.bytes(),
            Structure::Bvh(tree) => tree.bytes(),
        }
    }
}

impl Accel for Structure {
    fn walk(&self, prims: &impl Primitives, ray: &Ray, want: Want, watch: &mut impl Observer<Visit>) -> Option<Hit> {
        match self {
            Structure::List(list) => list.walk(prims, ray, want, watch),
            Structure::Slab(one) => one.walk(prims, ray, want, watch),
            Structure::Grid(grid) => grid.walk(prims, ray, want, watch),
            Structure::NestedGrid(grid) => grid.walk(prims, ray, want, watch),
            Structure::HashedGrid(grid) => grid.walk(prims, ray, want, watch),
            Structure::Kd(tree) => tree.walk(prims, ray, want, watch),
            Structure::Octree(tree) => tree.walk(prims, ray, want, watch),
            Structure::Bsp(tree) => tree.walk(prims, ray, want, watch),
            Structure::Bvh(tree) => tree.walk(prims, ray, want, watch),
        }
    }
}
