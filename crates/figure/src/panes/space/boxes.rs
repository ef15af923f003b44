//! The boxes of a tree's nodes, by what became of them.

use std::collections::{BTreeMap, BTreeSet};

use raystep_accel::{NodeId, Place, Structure, Verdict, Visit};

use super::Drawing;
use crate::theme::Role;
use crate::words::number;
use crate::world::{Form, convex};

/// A tree with more nodes than this shows only the way to the current node and what waits.
const FEW_FLAT: usize = 256;
const FEW_SOLID: usize = 24;

/// Of the way to the current node, so many levels.
const LEVELS: usize = 3;

/// Of what waits, so many nodes.
const NEXT: usize = 8;

impl Drawing<'_> {
    /// Every node that matters now, and the boundaries of the rest where they are few.
    pub(super) fn nodes(&mut self) {
        let few = self.walk.structure.node_count() <= if self.walk.flat { FEW_FLAT } else { FEW_SOLID };
        if few {
            self.edges();
        }
        let way = self.way();
        let on_the_way = |place: &Place| few || way.contains(place);
        let moment = self.moment;
        for &place in moment.dropped.iter().filter(|place| on_the_way(place)) {
            self.outline(Role::Dropped, place);
        }
        for &place in moment.seen.iter().filter(|place| on_the_way(place)) {
            // The outline of an inner node of a flat kd-tree is made of those of its children.
            let parted = matches!(place, Place::Node(node) if self.walk.structure.split(node).is_some());
            if !(self.walk.flat && parted) {
                self.outline(Role::Seen, place);
            }
        }
        let waiting = moment.stack.iter().rev().take(if few { usize::MAX } else { NEXT });
        for waiting in waiting.rev() {
            self.outline(Role::Waiting, Place::Node(waiting.node));
        }
        if let Some(here @ Place::Node(node)) = moment.here {
            let role = if moment.inside.is_some() { Role::Seen } else { Role::Here };
            self.outline(role, here);
            self.titled(role, here, format!("{node} here"));
        }
        self.volumes();
        self.stack_titles();
        self.farewell();
    }

    /// Thin outlines of everything. The inner nodes of a kd-tree are made of its leaves.
    fn edges(&mut self) {
        for node in (0..self.walk.structure.node_count() as u32).map(NodeId) {
            if self.walk.structure.split(node).is_none() {
                let place = Place::Node(node);
                let role = if self.walk.flat { self.ground(place) } else { Role::Edge };
                self.outline(role, place);
            }
        }
    }

    /// The current node, the last few it was reached through, and all their children.
    fn way(&self) -> BTreeSet<Place> {
        let mut parents = BTreeMap::new();
        let opened = self.moment.seen.iter().chain(&self.moment.here);
        for &place in opened {
            let Place::Node(node) = place else { continue };
            for child in self.walk.structure.children(node) {
                parents.insert(Place::Node(child), place);
            }
        }
        let mut way = BTreeSet::new();
        let mut at = self.moment.here;
        for _ in 0..LEVELS {
            let Some(place) = at else { break };
            way.insert(place);
            at = parents.get(&place).copied();
            if let Some(Place::Node(parent)) = at {
                way.extend(self.walk.structure.children(parent).into_iter().map(Place::Node));
            }
        }
        way
    }

    /// Children whose volumes were tested and that were not opened yet.
    fn volumes(&mut self) {
        for tested in &self.moment.volumes {
            let Place::Node(node) = tested.place else { continue };
            let waits = self.moment.waiting(node).is_some();
            if tested.verdict == Verdict::Hit && Some(tested.place) != self.moment.here && !waits {
                self.outline(Role::Seen, tested.place);
                let (near, far) = (number(tested.interval.near), number(tested.interval.far));
                self.titled(Role::Seen, tested.place, format!("{node} met: {near} – {far}"));
            }
        }
        let Some(place) = self.moment.under_test() else { return };
        if let (Place::Node(node), false) = (place, matches!(self.moment.event, Some(Visit::Volume { .. }))) {
            self.outline(Role::Plane, place);
            self.titled(Role::Plane, place, format!("{node} tested"));
        }
    }

    /// Which node on the stack is next, and which are later.
    fn stack_titles(&mut self) {
        let stack = &self.moment.stack;
        for (index, waiting) in stack.iter().rev().take(NEXT).enumerate() {
            let word = match index {
                _ if stack.len() == 1 => "waits",
                0 => "waits next",
                _ => "later",
            };
            self.titled(Role::Waiting, Place::Node(waiting.node), format!("{} {word}", waiting.node));
        }
    }

    /// What has just been thrown away says why.
    fn farewell(&mut self) {
        let (node, why) = match self.moment.event {
            Some(Visit::Drop { node, .. }) => (node, "dropped"),
            Some(Visit::Volume { place: Place::Node(node), verdict: Verdict::Miss, .. }) => (node, "missed"),
            Some(Visit::Volume { place: Place::Node(node), verdict: Verdict::Cut, .. }) => (node, "too far"),
            _ => return,
        };
        self.outline(Role::Dropped, Place::Node(node));
        self.titled(Role::Dropped, Place::Node(node), format!("{node} {why}"));
    }

    /// A label, unless the open question labels the place.
    fn titled(&mut self, role: Role, place: Place, text: String) {
        if self.moment.guesses.iter().all(|(guess, _)| *guess != place) {
            self.title(role, place, text);
        }
    }

    /// The box of a single slab test.
    pub(super) fn the_box(&mut self) {
        if matches!(self.walk.structure, Structure::List(_)) {
            return;
        }
        let tested = self.moment.slab.as_ref().is_some_and(|slab| slab.place == Place::World);
        if self.moment.dropped.contains(&Place::World) {
            self.outline(Role::Dropped, Place::World);
        } else if tested || matches!(self.walk.structure, Structure::Slab(_)) {
            self.outline(Role::Here, Place::World);
        } else if self.moment.here.is_none() {
            self.outline(Role::Edge, Place::World);
        }
    }

    /// The plane that splits the current node, and where the ray crosses it.
    pub(super) fn split(&mut self) {
        let Some(cut) = self.moment.cut else { return };
        let place = Place::Node(cut.node);
        if let Structure::Bsp(tree) = self.walk.structure {
            let plane = tree.plane(cut.node);
            let sheet = plane.and_then(|plane| convex::sheet(&tree.cell(cut.node), plane, self.walk.flat));
            if let Some(sheet) = sheet {
                self.add(Role::Plane, Some(place), sheet);
            }
            return;
        }
        let mut sheet = self.walk.bounds(place);
        if let Some(axis) = cut.axis.axis() {
            sheet.min[axis] = cut.plane;
            sheet.max[axis] = cut.plane;
        }
        if !sheet.is_empty() {
            self.add(Role::Plane, Some(place), Form::Sheet(sheet));
        }
    }

    /// The places among which the open question asks to choose.
    pub(super) fn guesses(&mut self) {
        for (place, word) in &self.moment.guesses {
            let text = match place {
                // An answer that is the place's own name says it once.
                place if *word == place.to_string() => format!("{word}?"),
                Place::Node(node) => format!("{node} {word}?"),
                Place::Cell(cell) => format!("{cell} {word}?"),
                Place::Prim(prim) => format!("{prim} {word}?"),
                Place::World => format!("{word}?"),
            };
            self.outline(Role::Guess, *place);
            self.title(Role::Guess, *place, text);
        }
    }
}
