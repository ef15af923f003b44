//! Building a tree of planes, slides 29-32: take a node, stop or choose a plane, deal out what it holds.

use super::{Node, Plane, PlaneTree};
use crate::{Aabb, ByHand, Cancelled, Grow, LeafReason, Margin, NodeId, Observer, Place, PrimId, Primitives, around};

/// There is room for so many references for each primitive, and for [`SPARE`] more: primitives that lie
/// on top of each other would be referred to from ever more leaves. Children share their parent's room.
const CROWD: usize = 32;
const SPARE: usize = 1 << 12;

/// When a node stays a leaf.
#[derive(Clone, Copy)]
pub(crate) struct Stops {
    /// Nodes this deep.
    pub(crate) max_depth: u32,
    /// Nodes with so few references.
    pub(crate) min_objects: u32,
    /// If planes are chosen by cost: what a test costs. Nodes that no plane makes cheaper stay leaves.
    pub(crate) test_cost: Option<f32>,
    /// The nodes that are cut by hand, whatever that costs.
    pub(crate) by_hand: ByHand,
    /// Whether rays remember what they tested.
    pub(crate) mailbox: bool,
}

/// One side of a cut: its space and the references that reach into it.
pub(crate) type Half<C> = (<C as Cutter>::Space, Vec<<C as Cutter>::Reference>);

/// The plane to take, and its cost.
type Taken<C> = (<<C as Cutter>::Node as Node>::Plane, f32);

/// What a builder of one kind of tree knows: how space is cut, and by which plane.
pub(crate) trait Cutter {
    type Node: Node;
    /// What of space a node covers.
    type Space;
    /// A primitive on its way down the tree.
    type Reference;

    /// The root's space, the references to all that lies in it, and the margin they are pruned with.
    fn root(
        &mut self,
        bounds: &Aabb,
        margin: &Margin,
        count: u32,
        watch: &impl Observer<Grow>,
    ) -> Result<Half<Self>, Cancelled>
    where
        Self: Sized;

    /// The box around a node's space.
    fn bounds(space: &Self::Space) -> Aabb;

    /// What a reference refers to.
    fn prim(reference: &Self::Reference) -> PrimId;

    /// Whether a reference goes to both sides of a plane.
    fn is_shared(&self, reference: &Self::Reference, plane: <Self::Node as Node>::Plane) -> bool;

    /// The plane to take and its cost; none if no plane separates the references.
    fn best(
        &mut self,
        node: NodeId,
        space: &Self::Space,
        refs: &[Self::Reference],
        watch: &mut impl Observer<Grow>,
    ) -> Result<Option<Taken<Self>>, Cancelled>
    where
        Self: Sized;

    /// What lies below the plane, and what above.
    fn cut(
        &mut self,
        space: &Self::Space,
        refs: &[Self::Reference],
        plane: <Self::Node as Node>::Plane,
        watch: &impl Observer<Grow>,
    ) -> Result<[Half<Self>; 2], Cancelled>
    where
        Self: Sized;
}

/// A node that waits to be split or to become a leaf.
struct Open<C: Cutter> {
    node: NodeId,
    half: Half<C>,
    depth: u32,
    /// How many references all leaves below may hold.
    room: usize,
}

impl<N: Node> PlaneTree<N> {
    /// Builds a tree over `prims` with planes of the cutter's choice.
    pub(crate) fn grow<C: Cutter<Node = N>>(
        prims: &impl Primitives,
        mut cutter: C,
        stops: Stops,
        watch: &mut impl Observer<Grow>,
    ) -> Result<PlaneTree<N>, Cancelled> {
        // The box around everything.
        let bounds = around(prims, watch)?;
        let margin = Margin::of(&bounds, prims.len());
        let root = cutter.root(&bounds, &margin, prims.len() as u32, watch)?;

        let room = root.1.len() * CROWD + SPARE;
        let nodes = vec![N::leaf(0, 0)];
        let mut tree = PlaneTree { bounds, margin, mailbox: stops.mailbox, nodes, refs: Vec::new() };
        let mut open: Vec<Open<C>> = vec![Open { node: NodeId::ROOT, half: root, depth: 0, room }];

        // Split one open node after the other, the one below the plane first.
        while let Some(Open { node, half: (space, refs), depth, room }) = open.pop() {
            if watch.cancelled() {
                return Err(Cancelled);
            }
            watch.on(Grow::Open { node, bounds: C::bounds(&space), prims: refs.len() as u32, depth });

            // Stop at few objects or at the maximum depth.
            if refs.len() <= stops.min_objects as usize {
                tree.settle::<C>(node, &refs, LeafReason::Few, watch);
                continue;
            }
            if depth >= stops.max_depth.min(Self::DEEPEST as u32) {
                tree.settle::<C>(node, &refs, LeafReason::Deep, watch);
                continue;
            }
            // Choose the plane.
            let Some((plane, cost)) = cutter.best(node, &space, &refs, watch)? else {
                tree.settle::<C>(node, &refs, LeafReason::Inseparable, watch);
                continue;
            };
            // Stop if testing everything here is cheaper.
            let by_hand = stops.by_hand.of(node).is_some_and(|cut| cut.divides(&C::bounds(&space)));
            if !by_hand && stops.test_cost.is_some_and(|test| cost >= test * refs.len() as f32) {
                tree.settle::<C>(node, &refs, LeafReason::Cheap, watch);
                continue;
            }

            // Both sides get what reaches into them.
            let [lower, upper] = cutter.cut(&space, &refs, plane, watch)?;
            let dealt = lower.1.len() + upper.1.len();
            if dealt > room || tree.nodes.len() + 2 > N::MOST as usize {
                tree.settle::<C>(node, &refs, LeafReason::Crowded, watch);
                continue;
            }

            let below = NodeId(tree.nodes.len() as u32);
            let above = NodeId(below.0 + 1);
            tree.nodes.extend([N::leaf(0, 0); 2]);
            tree.nodes[node.index()] = N::inner(plane, below);
            let (axis, at) = plane.stand();
            watch.on(Grow::Split { node, axis, plane: at, below, above, cost });
            for reference in refs.iter().filter(|reference| cutter.is_shared(reference, plane)) {
                watch.on(Grow::Share { node, prim: C::prim(reference) });
            }
            let share = |half: &Half<C>| (room as u64 * half.1.len() as u64 / dealt.max(1) as u64) as usize;
            let depth = depth + 1;
            open.push(Open { node: above, depth, room: share(&upper), half: upper });
            open.push(Open { node: below, depth, room: share(&lower), half: lower });
        }
        watch.on(Grow::End { nodes: tree.nodes.len() as u32, cells: 0, references: tree.refs.len() as u32 });
        Ok(tree)
    }

    /// Makes `node` a leaf: only leaves refer to geometry (slide 31).
    fn settle<C: Cutter<Node = N>>(
        &mut self,
        node: NodeId,
        refs: &[C::Reference],
        why: LeafReason,
        watch: &mut impl Observer<Grow>,
    ) {
        self.nodes[node.index()] = N::leaf(self.refs.len() as u32, refs.len() as u32);
        watch.on(Grow::Leaf { node, prims: refs.len() as u32, why });
        for prim in refs.iter().map(C::prim) {
            self.refs.push(prim);
            watch.on(Grow::Settle { prim, place: Place::Node(node) });
        }
    }
}
