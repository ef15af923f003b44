//! The numbers by which text and lists call what a flat picture shows.

use raystep_accel::{NodeId, Place, PrimId, Primitives, Structure};

use super::Drawing;
use crate::theme::Role;
use crate::world::{Form, SpaceMark};

/// More primitives than this are not numbered.
const FEW: u32 = 256;

/// Of a long walk, so many of the places last left carry their numbers.
const TRAIL: usize = 256;

impl Drawing<'_> {
    /// The numbers of the primitives, and of the places that the walk has met. Where it is, and what waits, has a
    /// label.
    pub(super) fn numbers(&mut self) {
        if !self.walk.flat || self.is_one_test() {
            return;
        }
        let best = self.moment.best.map(|hit| hit.prim);
        let role = |prim| if best == Some(prim) { Role::Best } else { Role::Text };
        self.marks.extend(numbers_of(self.walk.prims, role));
        let labelled = |place: Place| {
            let of_place = |mark: &SpaceMark| mark.place == Some(place) && matches!(mark.form, Form::Label { .. });
            self.marks.iter().any(of_place)
        };
        // A number without an outline would name nothing.
        let outlined = |place: Place| {
            let of_place = |mark: &SpaceMark| mark.place == Some(place) && !matches!(mark.form, Form::Label { .. });
            self.marks.iter().any(of_place)
        };
        let trail = |places: &[Place]| places[places.len().saturating_sub(TRAIL)..].to_vec();
        let seen = trail(&self.moment.seen).into_iter().map(|place| (Role::Seen, place));
        let within = self.moment.within.iter().map(|cell| (Role::Seen, Place::Cell(*cell)));
        let dropped = trail(&self.moment.dropped).into_iter().map(|place| (Role::Quiet, place));
        let met: Vec<(Role, Place)> =
            seen.chain(within).chain(dropped).filter(|(_, place)| !labelled(*place) && outlined(*place)).collect();
        for (role, place) in met {
            let text = match place {
                Place::Cell(cell) => cell.to_string(),
                // The box of a parent is that of its children.
                Place::Node(node) if !self.is_divided(node) || role == Role::Quiet => node.to_string(),
                _ => continue,
            };
            let within = self.walk.bounds(place);
            if !within.is_empty() {
                self.add(role, Some(place), Form::Number { within, text, scale: 1.0 });
            }
        }
    }

    /// Whether the space of a node is that of its children.
    fn is_divided(&self, node: NodeId) -> bool {
        match self.walk.structure {
            Structure::Octree(_) => !self.walk.structure.children(node).is_empty(),
            structure => structure.split(node).is_some(),
        }
    }

    /// How the outline of a cell or a leaf is drawn that nothing has happened to: what it refers to tints it.
    pub(super) fn ground(&self, place: Place) -> Role {
        let filled = match place {
            Place::Cell(cell) => self.walk.structure.grid().is_some_and(|grid| !grid.cell_prims(cell).is_empty()),
            // The volumes of a hierarchy are never empty.
            Place::Node(node) => {
                !matches!(self.walk.structure, Structure::Bvh(_)) && !self.walk.structure.leaf_prims(node).is_empty()
            }
            _ => false,
        };
        if filled { Role::Filled } else { Role::Edge }
    }
}

/// The numbers of all primitives of a flat scene, unless they are too many.
pub(super) fn numbers_of(prims: &impl Primitives, role: impl Fn(PrimId) -> Role) -> Vec<SpaceMark> {
    let count = prims.len() as u32;
    let number = |prim: PrimId| {
        let form = Form::Number { within: prims.bounds(prim), text: prim.to_string(), scale: 1.0 };
        SpaceMark { form, role: role(prim), place: Some(Place::Prim(prim)) }
    };
    (0..count).map(PrimId).filter(|_| count <= FEW).map(number).collect()
}
