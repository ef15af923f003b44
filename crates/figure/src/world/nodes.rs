//! The nodes of a finished structure as pictures need them, worked out once.

use std::sync::OnceLock;

use raystep_accel::{Aabb, AnyBvh, NodeId, Structure};

use crate::world::{Form, Levels, outlines};

/// The boxes of a structure's nodes, and what they look like: a hull or a cell cut by planes takes longer to work
/// out than a picture may, so each is worked out when a picture first shows it.
#[derive(Debug)]
pub struct Nodes {
    bounds: Vec<Aabb>,
    reach: Aabb,
    looks: Vec<OnceLock<Vec<Form>>>,
    levels: Levels,
}

impl Nodes {
    /// Those of this structure.
    pub fn of(structure: &Structure) -> Nodes {
        // Boxes need no working out.
        let plain = !matches!(structure, Structure::Bsp(_) | Structure::Bvh(_))
            || matches!(structure, Structure::Bvh(AnyBvh::Aabb(_)));
        let looks = if plain { 0 } else { structure.node_count() };
        Nodes {
            bounds: structure.node_bounds(),
            reach: outlines::reach(structure),
            looks: (0..looks).map(|_| OnceLock::new()).collect(),
            levels: match structure.node_count() {
                0 => Levels::default(),
                _ => Levels::of(NodeId::ROOT, |node| structure.children(node)),
            },
        }
    }

    /// The box of a node; empty if there is no such node.
    pub fn bounds(&self, node: NodeId) -> Aabb {
        self.bounds.get(node.index()).copied().unwrap_or(Aabb::EMPTY)
    }

    /// Whether their boxes are all there is to see of them.
    pub(crate) fn are_boxes(&self) -> bool {
        self.looks.is_empty()
    }

    /// How they lie: on which level each, and how many below it.
    pub(crate) fn levels(&self) -> &Levels {
        &self.levels
    }

    /// The box around all that is drawn of the structure: some volumes reach out of the box of the primitives.
    pub(crate) fn reach(&self) -> Aabb {
        self.reach
    }

    /// What a node looks like. `bounds` is its box, which may still grow; of a node that is not in the structure,
    /// that is all there is to see.
    pub(crate) fn look(&self, structure: &Structure, node: NodeId, bounds: Aabb, flat: bool) -> Vec<Form> {
        let known = self.looks.get(node.index());
        let look = known.map(|look| look.get_or_init(|| outlines::node(structure, node, flat)));
        match look {
            Some(forms) if !forms.is_empty() => forms.clone(),
            _ if bounds.is_empty() => Vec::new(),
            _ => vec![Form::Box(bounds)],
        }
    }
}
