//! A board being filled: nothing that takes long is done before it is shown, then each entry is measured in the order in
//! which it comes to be seen, coarsely first.

use std::sync::Arc;

use raystep_accel::{Appraisal, Cancelled, Grow, Observer};
use raystep_scene::Scene;

use super::panel::Entry;
use super::timing::{self, Stopwatch};
use super::{Board, BoardTape, Care, Counted, Drawn, Measured, Rendered, Stroke};

/// Rays that a volume is tried with, and the number from which they come.
const RAYS: u32 = 10_000;
const SEED: u64 = 52;

impl BoardTape {
    /// Fills a board: what it measures is measured over `scene`. Nothing is timed.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub fn fill(
        board: &Arc<Board>,
        scene: &Scene,
        care: Care,
        watch: &mut impl Observer<Grow>,
    ) -> Result<BoardTape, Cancelled> {
        let mut tape = BoardTape::bare(board, scene);
        tape.fill_up(scene, care, watch)?;
        tape.tell();
        Ok(tape)
    }

    /// The board before anything on it is measured; pictures that were made before stand.
    fn bare(board: &Arc<Board>, scene: &Scene) -> BoardTape {
        let places: Vec<(usize, usize)> = board.order().into_iter().filter(|at| board.entry(*at).is_some()).collect();
        let (numbers, many) = (board.moved(&[]), places.len());
        let known = |at: &(usize, usize)| match board.entry(*at) {
            Some(Entry::Picture(picture)) => Rendered::known(picture, scene, &board.scenes),
            _ => None,
        };
        let rendered: Vec<Option<Rendered>> = places.iter().map(known).collect();
        let waits = |(at, made): (&(usize, usize), &Option<Rendered>)| board.measures(*at) && made.is_none();
        let care = |waits: bool| if waits { Care::Bare } else { Care::Full };
        let filled = places.iter().zip(&rendered).map(waits).map(|waits| (care(waits), numbers.clone())).collect();
        BoardTape {
            board: board.clone(),
            events: Vec::new(),
            measured: vec![None; many],
            appraised: vec![None; many],
            counted: vec![None; many],
            grown: vec![Vec::new(); many],
            rendered,
            timed: vec![None; many],
            is_clocked: false,
            filled,
            numbers,
            places,
        }
    }

    /// Measures anew whatever was not measured with such care, or for other numbers of the meter. Says whether anything
    /// was.
    fn fill_up(&mut self, scene: &Scene, care: Care, watch: &mut impl Observer<Grow>) -> Result<bool, Cancelled> {
        let wants = |tape: &BoardTape, index: usize| tape.is_stale(index) || tape.filled[index].0 < care;
        let wanted: Vec<usize> = (0..self.places.len()).filter(|index| wants(self, *index)).collect();
        for index in &wanted {
            self.measure(*index, scene, care, watch)?;
        }
        Ok(!wanted.is_empty())
    }

    /// Measures what stands at an entry.
    fn measure(
        &mut self,
        index: usize,
        scene: &Scene,
        care: Care,
        watch: &mut impl Observer<Grow>,
    ) -> Result<(), Cancelled> {
        let board = self.board.clone();
        let Some(entry) = board.entry(self.places[index]) else { return Ok(()) };
        let numbers = self.numbers.clone();
        if self.is_stale(index) {
            self.timed[index] = None;
        }
        let mut reached = care;
        match entry {
            Entry::Row(row) => {
                let own = match row.scene.as_deref().map(|name| board.scenes.named(name)) {
                    Some(Ok(own)) => Some(own),
                    // Nobody can measure it.
                    Some(Err(_)) => {
                        self.filled[index] = (Care::Full, numbers);
                        return Ok(());
                    }
                    None => None,
                };
                let scene = own.as_deref().unwrap_or(scene);
                self.measured[index] = match (&row.plan, row.fast) {
                    (Some(plan), _) => Measured::of(&plan.at(&numbers), row.how, scene, care, watch)?,
                    (None, Some(kind)) => Measured::of_fast(kind, scene, care, watch)?,
                    (None, None) => None,
                };
                if let Some(volume) = row.volume {
                    if watch.cancelled() {
                        return Err(Cancelled);
                    }
                    self.appraised[index] = Some(Appraisal::of(&scene.prims, volume, RAYS, SEED));
                }
                // A volume is tried with all its rays at once.
                if self.measured[index].is_none() {
                    reached = Care::Full;
                }
            }
            Entry::Map(map, of) => {
                self.counted[index] = match (&map.plan, map.fast) {
                    (Some(plan), _) => Counted::of(&plan.at(&numbers), of, scene, care, watch)?,
                    (None, Some(kind)) => Counted::of_fast(kind, of, scene, care, watch)?,
                    (None, None) => None,
                };
            }
            Entry::Drawn(Drawn { stroke: Stroke::Growth { plan: Some(plan), of, scenes, through, .. }, .. }) => {
                self.grown[index] = Measured::growth(plan, *of, scenes, *through, &board.scenes, care, watch)?;
                // So are lines through a point.
                if through.is_some() {
                    reached = Care::Full;
                }
            }
            Entry::Drawn(_) => reached = Care::Full,
            Entry::Picture(picture) => {
                self.rendered[index] = Rendered::of(picture, scene, &board.scenes, care, watch)?;
            }
        }
        self.filled[index] = (reached, numbers);
        Ok(())
    }

    /// The same board over the same scene, measured anew as far as that was not done with such care, or for other numbers
    /// of the meter.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub fn filled(
        self: Arc<BoardTape>,
        scene: &Scene,
        care: Care,
        watch: &mut impl Observer<Grow>,
    ) -> Result<Arc<BoardTape>, Cancelled> {
        let mut tape = BoardTape::clone(&self);
        if !tape.fill_up(scene, care, watch)? {
            return Ok(self);
        }
        tape.tell();
        Ok(Arc::new(tape))
    }

    /// The same board, and what was measured for other numbers of the meter is measured for these, coarsely.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub fn followed(
        self: Arc<BoardTape>,
        scene: &Scene,
        watch: &mut impl Observer<Grow>,
    ) -> Result<Arc<BoardTape>, Cancelled> {
        let mut tape = BoardTape::clone(&self);
        for index in 0..tape.places.len() {
            if tape.is_stale(index) {
                tape.measure(index, scene, Care::Draft, watch)?;
            }
        }
        tape.tell();
        Ok(Arc::new(tape))
    }

    /// The same board, and the first of what was filled least carefully is measured with more care.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub fn filled_further(
        self: Arc<BoardTape>,
        scene: &Scene,
        watch: &mut impl Observer<Grow>,
    ) -> Result<Arc<BoardTape>, Cancelled> {
        let left = (0..self.places.len()).filter(|index| self.care_of(*index) < Care::Full);
        let Some(index) = left.min_by_key(|index| self.care_of(*index)) else { return Ok(self) };
        let care = if self.care_of(index) == Care::Bare { Care::Draft } else { Care::Full };
        let mut tape = BoardTape::clone(&self);
        tape.measure(index, scene, care, watch)?;
        tape.tell();
        Ok(Arc::new(tape))
    }

    /// The same board, and the first of what was not timed yet is.
    ///
    /// # Errors
    /// Nobody waits for it any more.
    pub fn timed_further(
        self: Arc<BoardTape>,
        scene: &Scene,
        stopwatch: &dyn Stopwatch,
    ) -> Result<Arc<BoardTape>, Cancelled> {
        let Some(index) = self.untimed() else { return Ok(self) };
        let (timing, grown) = timing::time(&self.board, self.places[index], &self.numbers, scene, stopwatch)?;
        let mut tape = BoardTape::clone(&self);
        if !grown.is_empty() {
            tape.grown[index] = grown;
        }
        tape.timed[index] = Some(timing);
        tape.tell();
        Ok(Arc::new(tape))
    }

    /// The same board, all timed that is to be.
    ///
    /// # Errors
    /// Nobody waits for it any more.
    pub fn timed(self: Arc<BoardTape>, scene: &Scene, stopwatch: &dyn Stopwatch) -> Result<Arc<BoardTape>, Cancelled> {
        let mut tape = self;
        while tape.untimed().is_some() {
            tape = tape.timed_further(scene, stopwatch)?;
        }
        Ok(tape)
    }
}
