//! A board as far as it is filled: what comes to be seen, with the numbers that were measured for it.

use std::sync::Arc;

use raystep_accel::{Appraisal, Reveal};

use super::panel::Entry;
use super::timing::{Timing, is_timed};
use super::{Board, Care, Counted, Measured, Numbers, Rendered};
use crate::Plan;

/// A board, and what comes to be seen on it, in order.
#[derive(Clone, Debug)]
pub struct BoardTape {
    /// What it shows.
    pub board: Arc<Board>,
    /// Where the numbers of its meter stand.
    pub numbers: Numbers,
    /// What comes to be seen.
    pub events: Vec<Reveal>,
    /// Where on the board that is: the panel, and the place there.
    pub places: Vec<(usize, usize)>,
    /// What was measured for it.
    pub measured: Vec<Option<Measured>>,
    /// What the volume around everything is worth that was measured for it.
    pub appraised: Vec<Option<Appraisal>>,
    /// What was counted for it, pixel by pixel.
    pub counted: Vec<Option<Counted>>,
    /// The points that were measured for it.
    pub grown: Vec<Vec<[f64; 2]>>,
    /// The pictures that were made for it.
    pub rendered: Vec<Option<Rendered>>,
    /// What was timed for it; nothing where nothing is, or not yet.
    pub timed: Vec<Option<Timing>>,
    /// Whether somebody is about to time what is not timed yet. Nobody does so for paper that is not to differ from
    /// machine to machine.
    pub is_clocked: bool,
    /// How carefully each was filled, and where the numbers of the meter stood then.
    pub(super) filled: Vec<(Care, Numbers)>,
}

impl BoardTape {
    /// Whether an entry was measured where the numbers of the meter do not stand any more.
    pub(super) fn is_stale(&self, index: usize) -> bool {
        let moves = match self.places.get(index).and_then(|place| self.board.entry(*place)) {
            Some(Entry::Row(row)) => row.plan.as_ref().is_some_and(Plan::is_moved),
            Some(Entry::Map(map, _)) => map.plan.as_ref().is_some_and(Plan::is_moved),
            Some(Entry::Drawn(_) | Entry::Picture(_)) | None => false,
        };
        let elsewhere = |(care, numbers): &(Care, Numbers)| *care > Care::Bare && *numbers != self.numbers;
        moves && self.filled.get(index).is_some_and(elsewhere)
    }

    /// How carefully an entry was filled: what was measured for other numbers of the meter is a draft.
    pub fn care_of(&self, entry: usize) -> Care {
        let care = self.filled.get(entry).map_or(Care::Full, |(care, _)| *care);
        if self.is_stale(entry) { Care::Draft } else { care }
    }

    /// How carefully it was filled: as what was filled least so.
    pub fn care(&self) -> Care {
        (0..self.filled.len()).map(|entry| self.care_of(entry)).min().unwrap_or(Care::Full)
    }

    /// How many of its entries were filled at least so carefully, and how many there are.
    pub fn filled_to(&self, care: Care) -> (usize, usize) {
        let all = self.filled.len();
        ((0..all).filter(|entry| self.care_of(*entry) >= care).count(), all)
    }

    /// Whether something on it would be measured anew where these settings, keys and values, put the numbers of its meter.
    pub fn is_stale_at(&self, settings: &[(String, String)]) -> bool {
        let numbers = self.board.moved(settings);
        if numbers == self.numbers {
            return (0..self.places.len()).any(|index| self.is_stale(index));
        }
        self.board.plans().into_iter().any(Plan::is_moved)
    }

    /// The first of what is to be timed and is not yet.
    pub fn untimed(&self) -> Option<usize> {
        let is_timed = |index: &usize| self.timed[*index].is_none() && is_timed(&self.board, self.places[*index]);
        (0..self.places.len()).find(is_timed)
    }

    /// How many there are that are to be timed, and how many of them are not yet.
    pub fn times(&self) -> (usize, usize) {
        let all = || (0..self.places.len()).filter(|index| is_timed(&self.board, self.places[*index]));
        (all().count(), all().filter(|index| self.timed[*index].is_none()).count())
    }

    /// Whether nothing is left to be measured.
    pub fn is_finished(&self) -> bool {
        self.care() == Care::Full && (!self.is_clocked || self.untimed().is_none())
    }

    /// How far the measuring is: of two fillings of one board the greater is the further.
    pub fn fineness(&self) -> (usize, usize) {
        let timed = self.timed.iter().filter(|timing| timing.is_some()).count();
        ((0..self.filled.len()).map(|entry| self.care_of(entry) as usize).sum(), timed)
    }

    /// The same board as paper has it: without what differs from machine to machine.
    #[must_use]
    pub fn untold(self: Arc<BoardTape>) -> Arc<BoardTape> {
        if !self.is_clocked && self.timed.iter().all(Option::is_none) {
            return self;
        }
        let mut tape = BoardTape::clone(&self);
        for index in 0..tape.places.len() {
            if tape.timed[index].take().is_some() {
                // Lines of seconds have no other dots.
                if matches!(tape.board.entry(tape.places[index]), Some(Entry::Drawn(_))) {
                    tape.grown[index].clear();
                }
            }
        }
        tape.is_clocked = false;
        tape.tell();
        Arc::new(tape)
    }

    /// The same board where these settings, keys and values, put the numbers of its meter. What was measured stands.
    pub(crate) fn moved(tape: Arc<BoardTape>, settings: &[(String, String)]) -> Arc<BoardTape> {
        let numbers = tape.board.moved(settings);
        if numbers == tape.numbers {
            return tape;
        }
        let mut tape = BoardTape::clone(&tape);
        tape.numbers = numbers;
        tape.tell();
        Arc::new(tape)
    }
}
