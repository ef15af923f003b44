//! The primitives to which something has happened.

use std::collections::BTreeMap;

use raystep_accel::{Aabb, Place, PrimId, Primitives, Prims, Shape, Triangle, Visit};

use super::Drawing;
use crate::theme::Role;
use crate::words::number;
use crate::world::Form;

/// Of a long walk, so many of the primitives last tested are marked.
const TRAIL: usize = 256;

/// Of a solid scene, marks of so many missed primitives are seen as what they are; more would be speckles.
const SPECKLES: usize = 64;

/// A primitive is large from this part of the scene's diagonal on.
const LARGE: f32 = 0.15;

impl Drawing<'_> {
    pub(super) fn prims(&mut self) {
        let moment = self.moment;
        if let Prims::Instances(all) = self.walk.prims {
            return self.instances(all);
        }
        let mut roles = BTreeMap::new();
        // A cell that holds thousands of primitives is no news.
        let crowded = self.held().len() > SPECKLES;
        // What the current leaf or cell holds stands out from a mesh; but edges that run through many cells tell nothing.
        if !self.walk.flat {
            let in_cell = self.walk.structure.grid().is_some();
            let held = self.held().iter().filter(|prim| !(in_cell && self.is_large(**prim)));
            roles.extend(held.take(TRAIL).map(|&prim| (prim, Role::Seen)));
        }
        let first = moment.tested.len().saturating_sub(TRAIL);
        let speckled = self.speckled();
        for (index, test) in moment.tested.iter().enumerate() {
            let marked =
                if speckled { self.is_news(test.prim, crowded) } else { index >= first && !self.shouts(test.prim) };
            match test.t {
                Some(_) => roles.insert(test.prim, Role::Hit),
                None if marked => roles.insert(test.prim, Role::Missed),
                None => None,
            };
        }
        let missed = moment.tested.iter().filter(|test| test.t.is_none()).count();
        if speckled && missed > 1 {
            let none = roles.values().all(|role| *role != Role::Missed);
            let marked = if none { "none marked" } else { "not all marked" };
            self.notes.push(format!("tested and missed {missed} times, {marked}"));
        }
        if let Some(hit) = moment.best {
            roles.insert(hit.prim, Role::Best);
        }
        for (prim, role) in roles {
            self.primitive(role, prim);
        }
    }

    /// A primitive; a large one of a solid scene by its edges, for its surface would hide where the walk is.
    fn primitive(&mut self, role: Role, prim: PrimId) {
        let place = Some(Place::Prim(prim));
        match self.walk.prims.shape(prim) {
            Shape::Triangle(Triangle { a, b, c }) if !self.walk.flat && self.is_large(prim) => {
                for (from, to) in [(a, b), (b, c), (c, a)] {
                    self.add(role, place, Form::Segment(from, to));
                }
            }
            _ => self.add(role, place, Form::Prim(prim)),
        }
    }

    /// Whether this walk through a solid scene misses so many primitives that their marks would cover it.
    fn speckled(&self) -> bool {
        let missed = self.walk.events.iter().filter(|event| matches!(event, Visit::Test { hit: false, .. }));
        !self.walk.flat && missed.take(SPECKLES + 1).count() > SPECKLES
    }

    /// Whether a primitive was just tested, or belongs to where the walk stands.
    fn is_news(&self, prim: PrimId, crowded: bool) -> bool {
        self.is_tested_now(prim) || !crowded && self.held().contains(&prim) && !self.shouts(prim)
    }

    fn is_tested_now(&self, prim: PrimId) -> bool {
        matches!(self.moment.event, Some(Visit::Test { prim: tested, .. }) if tested == prim)
    }

    /// Whether a primitive of a solid scene would drown the others if it stayed marked after its test: a floor that
    /// was missed is no news.
    fn shouts(&self, prim: PrimId) -> bool {
        !self.walk.flat && !self.is_tested_now(prim) && self.is_large(prim)
    }

    fn is_large(&self, prim: PrimId) -> bool {
        let extent = |bounds: Aabb| bounds.extent().length();
        extent(self.walk.prims.bounds(prim)) > LARGE * extent(self.walk.world())
    }

    /// The references of the current leaf or cell.
    fn held(&self) -> &[PrimId] {
        match self.moment.here {
            Some(Place::Node(node)) => self.walk.structure.leaf_prims(node),
            Some(Place::Cell(cell)) => self.walk.structure.grid().map_or(&[], |grid| grid.cell_prims(cell)),
            _ => &[],
        }
    }

    /// Where the ray meets what it hit, and what the last test found.
    pub(super) fn hits(&mut self) {
        let moment = self.moment;
        if let Some(hit) = moment.best {
            // In space a test that is under way needs the room; the ruler tells this t at every step.
            let room = self.walk.flat || moment.under_test().is_none();
            let text = room.then(|| format!("t = {}", number(hit.t)));
            self.ring(Role::Best, Some(Place::Prim(hit.prim)), hit.t, text);
        }
        match moment.event {
            Some(Visit::Test { prim, t, hit: true }) if moment.best.is_none_or(|best| best.prim != prim) => {
                self.ring(Role::Hit, Some(Place::Prim(prim)), t, Some(format!("t = {}", number(t))));
            }
            Some(Visit::Test { prim, hit: false, .. }) => {
                let name = if self.names_both() { Place::Prim(prim).to_string() } else { prim.to_string() };
                self.title(Role::Missed, Place::Prim(prim), format!("{name} missed"));
            }
            _ => {}
        }
    }
}
