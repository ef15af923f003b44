//! How a structure is to be built: its kind and its parameters.

mod bsp;
mod bvh;
mod by_hand;
mod grid;
mod kd;
mod nested;
mod octree;
mod parameter;
mod shared;

pub use bsp::{BspPlanes, BspRule, Straddlers};
pub use bvh::{BvhBuilder, BvhOrder, BvhRule, BvhSplit, BvhVolume};
pub use by_hand::{ByHand, HandCut};
pub use grid::{GridRule, Resolution};
pub use kd::{KdRule, KdSplit};
pub use nested::NestedRule;
pub use octree::OctreeRule;
pub use parameter::{Allowed, Parameter, RuleError};

use crate::{Axes, Measure};
use parameter::{Slot, nearest};

/// A kind of structure with its parameters. Slides, the command line and the window's controls all set
/// them by key and text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rule {
    /// No structure: brute force.
    List,
    /// Only the slab test of the box around everything.
    Slab,
    /// A uniform grid.
    Grid(GridRule),
    /// Grids within the crowded cells of a coarse grid.
    NestedGrid(NestedRule),
    /// A uniform grid of which only the occupied cells are stored.
    HashedGrid(GridRule),
    /// A kd-tree.
    Kd(KdRule),
    /// An octree, in a flat scene a quadtree.
    Octree(OctreeRule),
    /// A hierarchy of bounding volumes.
    Bvh(BvhRule),
    /// A BSP tree.
    Bsp(BspRule),
}

impl Rule {
    /// The kinds that answer rays, by the names that slides and the command line use. Slides know one more,
    /// `"slab"`, which only tests the box.
    pub const KINDS: [&'static str; 8] = ["list", "grid", "nested-grid", "hashed-grid", "kd", "octree", "bsp", "bvh"];

    /// The kind called `kind` with the parameters it has when nobody sets any.
    ///
    /// # Errors
    /// There is no such kind.
    pub fn default_for(kind: &str) -> Result<Rule, RuleError> {
        match kind {
            "list" => Ok(Rule::List),
            "slab" => Ok(Rule::Slab),
            "grid" => Ok(Rule::Grid(GridRule::default())),
            "nested-grid" => Ok(Rule::NestedGrid(NestedRule::default())),
            "hashed-grid" => Ok(Rule::HashedGrid(GridRule::default())),
            "kd" => Ok(Rule::Kd(KdRule::default())),
            "octree" => Ok(Rule::Octree(OctreeRule::default())),
            "bsp" => Ok(Rule::Bsp(BspRule::default())),
            "bvh" => Ok(Rule::Bvh(BvhRule::default())),
            _ => Err(RuleError::Kind { found: kind.to_owned(), nearest: nearest(kind, Rule::KINDS) }),
        }
    }

    /// One of [`Rule::KINDS`].
    pub fn kind(&self) -> &'static str {
        match self {
            Rule::List => "list",
            Rule::Slab => "slab",
            Rule::Grid(_) => "grid",
            Rule::NestedGrid(_) => "nested-grid",
            Rule::HashedGrid(_) => "hashed-grid",
            Rule::Kd(_) => "kd",
            Rule::Octree(_) => "octree",
            Rule::Bsp(_) => "bsp",
            Rule::Bvh(_) => "bvh",
        }
    }

    /// The same rule for a flat scene: no splits along z, and the perimeter measures a box.
    #[must_use]
    pub fn flat(mut self) -> Rule {
        let (axes, measure) = (Axes::Xy, Measure::Perimeter);
        match &mut self {
            Rule::List | Rule::Slab => {}
            Rule::Grid(rule) | Rule::HashedGrid(rule) => rule.axes = axes,
            Rule::NestedGrid(rule) => rule.grid.axes = axes,
            Rule::Kd(rule) => (rule.axes, rule.measure) = (axes, measure),
            Rule::Octree(rule) => rule.axes = axes,
            Rule::Bsp(rule) => (rule.axes, rule.measure) = (axes, measure),
            Rule::Bvh(rule) => (rule.axes, rule.measure) = (axes, measure),
        }
        self
    }

    /// The cuts that are chosen by hand, where a structure takes some: along the axes, from the top.
    pub fn by_hand(&self) -> Option<&ByHand> {
        match self {
            Rule::Kd(rule) => Some(&rule.cut),
            Rule::Bvh(rule) if rule.builder == BvhBuilder::TopDown => Some(&rule.cut),
            _ => None,
        }
    }

    /// What can be set, with the values it has now.
    pub fn parameters(&self) -> Vec<Parameter> {
        let mut rule = *self;
        // Cuts that nobody has chosen are no parameter.
        rule.slots().into_iter().filter(|slot| !slot.is_unset()).map(Slot::parameter).collect()
    }

    /// What must be set so that `from`, a rule of the same kind, becomes this one: keys and values.
    pub fn differences(&self, from: &Rule) -> Vec<(&'static str, String)> {
        let before = from.parameters();
        let is_new = |own: &Parameter| !before.iter().any(|old| old.key == own.key && old.value == own.value);
        self.parameters().into_iter().filter(is_new).map(|own| (own.key, own.value)).collect()
    }

    /// Sets the parameter called `key` to the value that `text` spells.
    ///
    /// # Errors
    /// This kind has no such parameter, or the value is not allowed; the rule stays as it was.
    pub fn set(&mut self, key: &str, text: &str) -> Result<(), RuleError> {
        let kind = self.kind();
        let slots = self.slots();
        let keys: Vec<&'static str> = slots.iter().map(|slot| slot.key).collect();
        match slots.into_iter().find(|slot| slot.key == key) {
            Some(slot) => slot.set(text),
            None => {
                Err(RuleError::Key { kind, found: key.to_owned(), nearest: nearest(key, keys.iter().copied()), keys })
            }
        }
    }

    fn slots(&mut self) -> Vec<Slot<'_>> {
        match self {
            Rule::List | Rule::Slab => Vec::new(),
            Rule::Grid(rule) | Rule::HashedGrid(rule) => rule.slots(),
            Rule::NestedGrid(rule) => rule.slots(),
            Rule::Kd(rule) => rule.slots(),
            Rule::Octree(rule) => rule.slots(),
            Rule::Bsp(rule) => rule.slots(),
            Rule::Bvh(rule) => rule.slots(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_parameter_takes_back_its_own_value() {
        for kind in Rule::KINDS {
            let rule = Rule::default_for(kind).unwrap();
            let mut copy = rule;
            for parameter in rule.parameters() {
                copy.set(parameter.key, &parameter.value).unwrap();
            }
            assert_eq!(copy, rule);
        }
    }

    #[test]
    fn wrong_rules_are_met_with_what_is_allowed() {
        let check = |rule: Result<Rule, RuleError>, key: &str, text: &str, says: &str| {
            let said = rule.and_then(|mut rule| rule.set(key, text)).unwrap_err().to_string();
            assert_eq!(said, says);
        };
        check(
            Rule::default_for("kt"),
            "",
            "",
            "there is no structure \"kt\"; did you mean \"kd\"? (list, grid, nested-grid, hashed-grid, kd, octree, bsp or bvh)",
        );
        check(
            Rule::default_for("kd"),
            "max_dept",
            "8",
            "kd has no parameter \"max_dept\"; did you mean \"max_depth\"? (split, max_depth, min_objects, \
             empty_bonus, mailbox, traversal_cost, intersection_cost or cut)",
        );
        check(Rule::default_for("kd"), "max_depth", "-1", "max_depth = -1: allowed is a whole number from 0 to 64");
        check(
            Rule::default_for("kd"),
            "split",
            "sahh",
            "split = sahh: allowed is middle, median or sah; did you mean \"sah\"?",
        );
        check(Rule::default_for("kd"), "empty_bonus", "NaN", "empty_bonus = NaN: allowed is a number from 0 to 1");
        check(
            Rule::default_for("kd"),
            "cut",
            "x=2",
            "cut = x=2: allowed is none, or cuts such as 0:x=2.5: the node, the axis, where",
        );
        check(Rule::default_for("grid"), "mailbox", "yes", "mailbox = yes: allowed is true or false");
    }
}
