//! Of a long table, the rows that there is room for.

use std::collections::BTreeSet;

use glam::Vec2;

use crate::page::{CLOSE, Entry, Look};
use crate::theme::Role;
use crate::words::whole;

/// Letters of a long table are so small, in parts of the text; with smaller ones some of its rows are left out.
const SMALL: f32 = 0.8;

/// Fewest rows: the latest entry, the earliest exit, the current one, and before each how many are left out.
const LEAST: usize = 6;

/// The rows that are shown.
pub(super) struct Kept {
    rows: BTreeSet<usize>,
}

/// How many rows are left out before each that is kept.
fn left_out(rows: &BTreeSet<usize>) -> impl Iterator<Item = usize> + '_ {
    rows.iter().scan(0, |next, &row| Some(row - std::mem::replace(next, row + 1)))
}

/// How many rows a table has that says so, in a row of its own each time.
fn high(rows: &BTreeSet<usize>) -> usize {
    rows.len() + left_out(rows).filter(|left_out| *left_out > 0).count()
}

impl Kept {
    /// Of rows that tell where the ray comes in and goes out: all of them, or the one of the latest entry, the one of
    /// the earliest exit and the last ones, below `top` and above `lines` lines of words.
    pub(super) fn of(ends: &[[Option<f32>; 2]], top: f32, lines: f32, size: Vec2, look: &Look) -> Kept {
        let height = size.y - top - lines * look.line();
        // One row more holds the heads.
        let room = ((height / (look.text * CLOSE * SMALL)) as usize).saturating_sub(1).max(LEAST);
        if ends.len() <= room {
            return Kept { rows: (0..ends.len()).collect() };
        }
        let told = |end: usize| ends.iter().enumerate().filter_map(move |(row, ends)| Some((row, ends[end]?)));
        let entry = told(0).max_by(|(_, a), (_, b)| a.total_cmp(b));
        let exit = told(1).min_by(|(_, a), (_, b)| a.total_cmp(b));
        let ends_of_all = entry.into_iter().chain(exit).map(|(row, _)| row);
        let mut rows: BTreeSet<usize> = ends_of_all.chain([ends.len() - 1]).collect();
        for row in (0..ends.len()).rev() {
            let more: BTreeSet<usize> = rows.iter().copied().chain([row]).collect();
            if high(&more) > room {
                break;
            }
            rows = more;
        }
        Kept { rows }
    }

    /// The rows that are kept, and how many are left out where some are.
    pub(super) fn table(&self, mut all: Vec<Vec<Entry>>) -> Vec<Vec<Entry>> {
        let columns = all.first().map_or(0, Vec::len);
        let gap = |left_out: usize| {
            let mut gap = vec![Entry::none(); columns];
            if let [first, .., last] = &mut gap[..] {
                let says = format!("{} left out", whole(left_out as u64));
                (*first, *last) = (Entry::new("…", Role::Quiet), Entry::new(says, Role::Quiet));
            }
            gap
        };
        let rows = self.rows.iter().zip(left_out(&self.rows)).flat_map(|(&row, left_out)| {
            let gap = (left_out > 0).then(|| gap(left_out));
            gap.into_iter().chain([std::mem::take(&mut all[row])]).collect::<Vec<_>>()
        });
        rows.collect()
    }

    /// Where a row stands in that table.
    pub(super) fn position(&self, row: usize) -> Option<usize> {
        let upto: BTreeSet<usize> = self.rows.range(..=row).copied().collect();
        self.rows.contains(&row).then(|| high(&upto) - 1)
    }
}
