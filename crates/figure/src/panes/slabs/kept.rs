//! Of a long table, the rows that there is room for.

use std::collections::BTreeSet;

use glam::Vec2;

use crate::page::{CLOSE, Entry, Look};
use crate::theme::Role;
use crate::words::whole;

/// Letters of a long table are so small, in parts of the text; with smaller ones some of its rows are left out.
const SMALL: f32 = 0.8;

/// Fewest rows: the latest entry, the earliest exit, the current one, and how many more there are.
const LEAST: usize = 4;

/// The rows that are shown, and how many are not.
pub(super) struct Kept {
    pub(super) rows: BTreeSet<usize>,
    pub(super) left_out: usize,
}

impl Kept {
    /// Of rows that tell where the ray comes in and goes out: all of them, or the one of the latest entry, the one of
    /// the earliest exit and the last ones, below `top` and above `lines` lines of words.
    pub(super) fn of(ends: &[[Option<f32>; 2]], top: f32, lines: f32, size: Vec2, look: &Look) -> Kept {
        let high = size.y - top - lines * look.line();
        // One row more holds the heads.
        let room = ((high / (look.text * CLOSE * SMALL)) as usize).saturating_sub(1).max(LEAST);
        if ends.len() <= room {
            return Kept { rows: (0..ends.len()).collect(), left_out: 0 };
        }
        let told = |end: usize| ends.iter().enumerate().filter_map(move |(row, ends)| Some((row, ends[end]?)));
        let entry = told(0).max_by(|(_, a), (_, b)| a.total_cmp(b));
        let exit = told(1).min_by(|(_, a), (_, b)| a.total_cmp(b));
        let mut rows: BTreeSet<usize> = entry.into_iter().chain(exit).map(|(row, _)| row).collect();
        for row in (0..ends.len()).rev() {
            if rows.len() + 1 == room {
                break;
            }
            rows.insert(row);
        }
        Kept { left_out: ends.len() - rows.len(), rows }
    }

    /// The rows that are kept; above them, if there are more, how many those are.
    pub(super) fn table(&self, all: Vec<Vec<Entry>>) -> Vec<Vec<Entry>> {
        let columns = all.first().map_or(0, Vec::len);
        let says = format!("{} left out", whole(self.left_out as u64));
        let mut more = vec![Entry::none(); columns];
        if let [first, .., last] = &mut more[..] {
            (*first, *last) = (Entry::new("…", Role::Quiet), Entry::new(says, Role::Quiet));
        }
        let kept = all.into_iter().enumerate().filter(|(row, _)| self.rows.contains(row)).map(|(_, row)| row);
        (self.left_out > 0).then_some(more).into_iter().chain(kept).collect()
    }

    /// Where a row stands in that table.
    pub(super) fn position(&self, row: usize) -> Option<usize> {
        Some(self.rows.iter().position(|kept| *kept == row)? + usize::from(self.left_out > 0))
    }
}
