//! The structures that must agree: every kind with the parameters that change what it does.

use raystep_accel::Rule;

/// `kind key=value ...`, one structure a line.
const RULES: &[&str] = &[
    "grid",
    "grid resolution=3n",
    "grid resolution=density factor=1",
    "grid mailbox=false prune=false",
    "grid nx=1 ny=7 nz=2",
    "nested-grid",
    "nested-grid levels=1 resolution=3n",
    "nested-grid levels=4 more_than=1 factor=1 inner_factor=1.5",
    "nested-grid mailbox=false prune=false nx=3 ny=1 nz=2 inner_resolution=3n",
    "hashed-grid",
    "hashed-grid resolution=3n mailbox=false",
    "kd",
    "kd mailbox=false min_objects=0 max_depth=64",
    "kd max_depth=8 min_objects=10 empty_bonus=0",
    "kd split=middle max_depth=16 min_objects=1",
    "kd split=median max_depth=12 min_objects=2",
    "kd traversal_cost=0 empty_bonus=0.9 min_objects=1",
    "octree",
    "bsp",
    "bsp straddlers=both mailbox=false",
    "bsp planes=candidates samples=4 min_objects=1",
    "bsp planes=candidates straddlers=both max_depth=12",
    "bvh",
    "bvh order=printed",
    "bvh split=middle leaf_size=1",
    "bvh split=median leaf_size=4",
    "bvh split=sweep leaf_size=1",
    "bvh volume=sphere leaf_size=1",
    "bvh volume=obb leaf_size=1",
    "bvh volume=kdop14 leaf_size=1",
    "bvh volume=kdop18 leaf_size=1",
    "bvh volume=kdop26 leaf_size=1",
    "bvh volume=hull leaf_size=1",
    "bvh volume=kdop6 split=median",
    "bvh builder=bottom-up volume=aabb leaf_size=1",
    "bvh builder=bottom-up volume=sphere leaf_size=1",
    "bvh builder=bottom-up volume=obb leaf_size=2",
    "bvh builder=bottom-up volume=hull leaf_size=1",
    "bvh builder=bottom-up volume=kdop14 leaf_size=1",
    "bvh builder=ploc volume=aabb leaf_size=1",
    "bvh builder=ploc volume=sphere leaf_size=2",
    "bvh builder=ploc volume=obb leaf_size=1",
    "bvh builder=ploc volume=kdop26 leaf_size=1",
    "bvh builder=ploc volume=hull leaf_size=2",
    "bvh builder=insertion volume=aabb leaf_size=1",
    "bvh builder=insertion volume=sphere leaf_size=1",
    "bvh builder=insertion volume=obb leaf_size=1",
    "bvh builder=insertion volume=kdop18 leaf_size=1",
    "bvh builder=insertion volume=hull leaf_size=2",
    "bvh volume=sphere order=printed",
];

/// All of them, with the line that spells each.
pub fn rules() -> impl Iterator<Item = (&'static str, Rule)> {
    RULES.iter().map(|&line| (line, rule(line)))
}

/// The rule that `kind key=value ...` spells.
///
/// # Panics
/// When it spells none.
pub fn rule(line: &str) -> Rule {
    let mut words = line.split_whitespace();
    let mut rule = Rule::default_for(words.next().unwrap_or_default()).unwrap_or_else(|error| panic!("{error}"));
    for word in words {
        let (key, value) = word.split_once('=').unwrap_or_else(|| panic!("{word} is no key=value"));
        rule.set(key, value).unwrap_or_else(|error| panic!("{error}"));
    }
    rule
}
