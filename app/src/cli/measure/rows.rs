//! The rows of the lecture's tables, and what was printed there.

use raystep_accel::{Allowed, Rule};
use raystep_scene::trial::rules::rule;

/// One row of one table.
#[derive(Clone, Debug)]
pub(super) struct Row {
    /// The slide that prints it, or a word.
    pub(super) table: &'static str,
    /// What it is called.
    pub(super) name: String,
    /// The structure: `kind key=value ...`.
    pub(super) line: String,
    /// The lecture's tests per ray and their total.
    pub(super) printed: Option<(f64, Option<u64>)>,
}

/// Slide, row, structure, tests per ray as printed, their total as printed.
type Printed = (&'static str, &'static str, &'static str, f64, Option<u64>);

/// As printed on the slides; the structures are ours, with the same other parameters in all rows. The
/// lecture ends a kd-tree's branch by depth and by count alone: where a step costs nothing, no other rule ends it.
#[expect(clippy::approx_constant, reason = "the lecture prints 6.28 tests per ray, which is not a circle's")]
const LECTURE: &[Printed] = &[
    ("22", "list", "list", 6321.0, Some(3_710_882_127)),
    ("22", "grid", "grid resolution=3n", 44.86, Some(26_336_575)),
    ("24", "list", "list", 6321.0, Some(3_710_882_127)),
    ("24", "grid", "grid resolution=3n", 44.86, Some(26_336_575)),
    ("24", "nested-grid", "nested-grid", 12.05, Some(7_072_774)),
    ("41", "list", "list", 6321.0, Some(9_986_402_697)),
    ("41", "kd-8-10", "kd max_depth=8 min_objects=10 traversal_cost=0", 70.38, Some(111_204_795)),
    ("41", "kd-16-8", "kd max_depth=16 min_objects=8 traversal_cost=0", 7.19, Some(11_361_140)),
    ("41", "kd-24-8", "kd max_depth=24 min_objects=8 traversal_cost=0", 6.28, Some(9_930_604)),
    ("41", "kd-24-4", "kd max_depth=24 min_objects=4 traversal_cost=0", 4.02, Some(6_350_655)),
    ("41", "kd-32-2", "kd max_depth=32 min_objects=2 traversal_cost=0", 2.80, Some(4_426_580)),
    ("57", "list", "list", 6321.0, None),
    ("57", "bvh", "bvh", 2.6, None),
];

/// The lecture's rows, then every other kind of structure, then a hierarchy's volumes and builders.
pub(super) fn rows() -> Vec<Row> {
    let built = |line: &str| line.split_whitespace().next().is_some_and(|kind| Rule::KINDS.contains(&kind));
    let printed = LECTURE.iter().filter(|(_, _, line, ..)| built(line));
    let mut rows: Vec<Row> = printed
        .map(|&(table, name, line, tests, total)| Row {
            table,
            name: name.to_owned(),
            line: line.to_owned(),
            printed: Some((tests, total)),
        })
        .collect();
    let kind_of = |row: &Row| row.line.split_whitespace().next().unwrap_or_default().to_owned();
    let known: Vec<String> = rows.iter().map(kind_of).collect();
    let unknown = Rule::KINDS.into_iter().filter(|kind| !known.iter().any(|known| known == kind));
    rows.extend(unknown.map(|kind| Row {
        table: "other",
        name: kind.to_owned(),
        line: kind.to_owned(),
        printed: None,
    }));
    for volume in words("volume") {
        rows.extend(words("builder").iter().map(|builder| Row {
            table: "volumes",
            name: format!("{volume}, {builder}"),
            line: format!("bvh volume={volume} builder={builder}"),
            printed: None,
        }));
    }
    rows
}

/// What a parameter of a hierarchy may be.
fn words(key: &str) -> Vec<&'static str> {
    match rule("bvh").parameters().into_iter().find(|parameter| parameter.key == key) {
        Some(parameter) => match parameter.allowed {
            Allowed::Words(words) => words.to_vec(),
            _ => Vec::new(),
        },
        None => Vec::new(),
    }
}

/// All parameters of a structure, with the values that nobody set.
pub(super) fn spelt_out(line: &str) -> String {
    let rule = rule(line);
    let parameters: String = rule.parameters().iter().map(|p| format!(" {}={}", p.key, p.value)).collect();
    format!("{}{parameters}", rule.kind())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_can_be_built() {
        let rows = rows();
        assert!(rows.len() >= 12);
        for row in rows {
            assert!(spelt_out(&row.line).starts_with(&row.line[..3]), "{row:?}");
        }
    }
}
