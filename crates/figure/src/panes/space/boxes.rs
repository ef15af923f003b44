//! The boxes of a tree's nodes, by what became of them.

use std::collections::{BTreeMap, BTreeSet};

use raystep_accel::{NodeId, Place, Structure, Verdict, Visit};

use super::Drawing;
use crate::theme::Role;
use crate::words::{VolumeName, number};
use crate::world::{Depth, Form, convex, drawn, frontier};

/// A flat tree with more nodes than this shows only the way to the current node and what waits, as a solid one does.
const FEW: usize = 256;

/// Most boxes of a level in one picture.
const BOXES: usize = 2000;

/// Of the way to the current node, so many levels.
const LEVELS: usize = 3;

/// Of what waits, so many nodes; in space more would be a tangle, and only the next one has a label there.
const NEXT: usize = 8;
const NEXT_SOLID: usize = 4;
const LABELLED: usize = 1;

impl Drawing<'_> {
    /// Every node that matters now, and the boundaries of the rest where they are few.
    pub(super) fn nodes(&mut self) {
        let few = self.walk.flat && self.walk.structure.node_count() <= FEW;
        if few {
            self.edges();
        }
        if !self.walk.flat {
            self.levels();
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
        let most = match few {
            true => usize::MAX,
            false if self.walk.flat => NEXT,
            false => NEXT_SOLID,
        };
        let waiting = moment.stack.iter().rev().take(most);
        for waiting in waiting.rev() {
            self.outline(Role::Waiting, Place::Node(waiting.node));
        }
        if let Some(here @ Place::Node(node)) = moment.here {
            let role = if moment.inside.is_some() { Role::Seen } else { Role::Here };
            self.outline(role, here);
            self.titled(role, here, self.here(&node.to_string()));
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

    /// Of a tree in space the box around everything, and those of the level that is asked for.
    fn levels(&mut self) {
        let levels = self.walk.nodes.levels();
        if levels.deepest() == 0 {
            return;
        }
        self.outline(Role::Edge, Place::Node(NodeId::ROOT));
        if let Depth::Down(level) = self.depth {
            let children = |node: NodeId| self.walk.structure.children(node);
            for node in frontier(level as usize, BOXES, children) {
                self.outline(Role::Edge, Place::Node(node));
            }
        }
        self.notes.push(drawn(VolumeName::drawn(self.walk.structure), self.depth, levels.deepest()));
    }

    /// The node that the picture is about: where the walk stands, in the end the leaf that refers to the hit.
    fn stands(&self) -> Option<Place> {
        let leaf = |place: &&Place| match (place, self.moment.best) {
            (Place::Node(node), Some(hit)) => self.walk.structure.leaf_prims(*node).contains(&hit.prim),
            (Place::Node(_), None) => true,
            _ => false,
        };
        self.moment.here.or_else(|| self.moment.seen.iter().rev().find(leaf).copied())
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
        let mut at = self.stands();
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
                // In space, where there is less room, not twice: the ends of the interval have labels of their own.
                let now = matches!(self.moment.event, Some(Visit::Volume { place, .. }) if place == tested.place);
                let says =
                    if now && !self.walk.flat { format!("{node} met") } else { format!("{node} met: [{near}, {far}]") };
                // Nor beside a test that is under way: its planes and their t need the room.
                let under_way = self.moment.under_test().is_some();
                let others = (under_way || matches!(self.moment.event, Some(Visit::Volume { .. }))) && !now;
                if self.walk.flat || !others {
                    self.titled(Role::Seen, tested.place, says);
                }
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
        // In space a test that is under way needs the room.
        let most = match self.moment.under_test() {
            _ if self.walk.flat => NEXT,
            Some(_) => 0,
            None => LABELLED,
        };
        for (index, waiting) in stack.iter().rev().take(most).enumerate() {
            let word = match index {
                _ if stack.len() == 1 => "waits",
                0 => "waits next",
                _ => "later",
            };
            self.titled(Role::Waiting, Place::Node(waiting.node), format!("{} {word}", waiting.node));
        }
    }

    /// Whether nodes are missed as primitives are.
    pub(super) fn names_both(&self) -> bool {
        matches!(self.walk.structure, Structure::Bvh(_))
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
        // Where primitives are missed, too, it says which.
        let name = if self.names_both() { Place::Node(node).to_string() } else { node.to_string() };
        self.titled(Role::Dropped, Place::Node(node), format!("{name} {why}"));
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
