//! A board being filled: what comes to be seen, with the numbers that were measured for it.

use std::sync::Arc;

use raystep_accel::{Appraisal, Cancelled, Grow, Observer, Reveal};
use raystep_scene::Scene;

use super::panel::Entry;
use super::timing::{self, Stopwatch, Timed, Timing, is_timed};
use super::{Board, Care, Column, Counted, Drawn, Measured, Numbers, Rendered, Stroke};
use crate::Plan;

/// Rays that a volume is tried with, and the number from which they come.
const RAYS: u32 = 10_000;
const SEED: u64 = 52;

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
    filled: Vec<(Care, Numbers)>,
}

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
        let places: Vec<(usize, usize)> = board.order().into_iter().filter(|at| board.entry(*at).is_some()).collect();
        let (numbers, many) = (board.moved(&[]), places.len());
        let mut tape = BoardTape {
            board: board.clone(),
            events: Vec::new(),
            measured: vec![None; many],
            appraised: vec![None; many],
            counted: vec![None; many],
            grown: vec![Vec::new(); many],
            rendered: vec![None; many],
            timed: vec![None; many],
            is_clocked: false,
            filled: vec![(care, numbers.clone()); many],
            numbers,
            places,
        };
        for index in 0..many {
            tape.measure(index, scene, care, watch)?;
        }
        tape.tell();
        Ok(tape)
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
        let place = self.places[index];
        let Some(entry) = board.entry(place) else { return Ok(()) };
        let numbers = self.numbers.clone();
        match entry {
            Entry::Row(row) if board.measures(place) => {
                let own = match row.scene.as_deref().map(|name| board.scenes.named(name)) {
                    Some(Ok(own)) => Some(own),
                    Some(Err(_)) => return Ok(()),
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
            }
            Entry::Row(_) => {}
            Entry::Map(map, of) => {
                self.counted[index] = match (&map.plan, map.fast) {
                    (Some(plan), _) => Counted::of(&plan.at(&numbers), of, scene, care, watch)?,
                    (None, Some(kind)) => Counted::of_fast(kind, of, scene, care, watch)?,
                    (None, None) => None,
                };
            }
            Entry::Drawn(Drawn { stroke: Stroke::Growth { plan: Some(plan), of, scenes, through, .. }, .. })
                if !of.is_timed() =>
            {
                self.grown[index] = Measured::growth(plan, *of, scenes, *through, &board.scenes, care, watch)?;
            }
            Entry::Drawn(_) => {}
            Entry::Picture(picture) => {
                self.rendered[index] = Rendered::of(picture, scene, &board.scenes, care, watch)?;
            }
        }
        self.filled[index] = (care, numbers);
        Ok(())
    }

    /// Whether an entry was measured where the numbers of the meter do not stand any more.
    fn is_stale(&self, index: usize) -> bool {
        let moves = match self.places.get(index).and_then(|place| self.board.entry(*place)) {
            Some(Entry::Row(row)) => row.plan.as_ref().is_some_and(Plan::is_moved),
            Some(Entry::Map(map, _)) => map.plan.as_ref().is_some_and(Plan::is_moved),
            Some(Entry::Drawn(_) | Entry::Picture(_)) | None => false,
        };
        moves && self.filled.get(index).is_some_and(|(_, numbers)| *numbers != self.numbers)
    }

    /// How carefully it was filled: what was measured for other numbers of the meter is a draft.
    pub fn care(&self) -> Care {
        let care = |(index, (care, _)): (usize, &(Care, Numbers))| {
            if self.is_stale(index) { Care::Draft } else { *care }
        };
        self.filled.iter().enumerate().map(care).min().unwrap_or(Care::Full)
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
        let full = |index: &usize| self.filled[*index].0 == Care::Full && !self.is_stale(*index);
        let timed = self.timed.iter().filter(|timing| timing.is_some()).count();
        ((0..self.places.len()).filter(full).count(), timed)
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
        let wants = |tape: &BoardTape, index: usize| tape.is_stale(index) || tape.filled[index].0 < care;
        if !(0..self.places.len()).any(|index| wants(&self, index)) {
            return Ok(self);
        }
        let mut tape = BoardTape::clone(&self);
        for index in 0..tape.places.len() {
            if wants(&tape, index) {
                if tape.is_stale(index) {
                    tape.timed[index] = None;
                }
                tape.measure(index, scene, care, watch)?;
            }
        }
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

    /// Tells what comes to be seen, with its numbers.
    fn tell(&mut self) {
        let entries = self.places.iter().enumerate();
        let events = entries.filter_map(|(index, place)| Some(self.reveal(index, self.board.entry(*place)?)));
        self.events = events.collect();
    }

    fn reveal(&self, index: usize, what: Entry<'_>) -> Reveal {
        let (entry, numbers) = (index as u32, &self.numbers);
        let measured = self.measured.get(index).and_then(Option::as_ref);
        let appraised = self.appraised.get(index).and_then(Option::as_ref);
        let counted = self.counted.get(index).and_then(Option::as_ref);
        let rendered = self.rendered.get(index).and_then(Option::as_ref);
        let grown = self.grown.get(index).map_or(&[][..], Vec::as_slice);
        let timed = self.timed.get(index).and_then(Option::as_ref).and_then(|timing| timing.as_ref().ok());
        let time = |of: fn(&Timed) -> f64| timed.map_or(f32::NAN, |timed| of(timed) as f32);
        match what {
            Entry::Picture(_) => {
                let told = |number: fn(&Rendered) -> f64| rendered.map_or(f32::NAN, |rendered| number(rendered) as f32);
                Reveal::Picture {
                    entry,
                    triangles: told(|rendered| rendered.triangles as f64),
                    rays: told(|rendered| rendered.rays as f64),
                    tests: told(|rendered| rendered.tests),
                    seconds: time(|timed| timed.seconds),
                    timed: timed.is_some(),
                }
            }
            Entry::Map(..) => {
                let [least, most] = counted.map_or([f32::NAN; 2], |counted| counted.range().map(|count| count as f32));
                let mean = counted.map_or(f32::NAN, |counted| counted.mean() as f32);
                Reveal::Map { entry, mean, least, most }
            }
            Entry::Row(row) => {
                let own = |column: Column| {
                    row.cells
                        .iter()
                        .find(|(key, _)| *key == column)
                        .map_or(f32::NAN, |(_, cell)| cell.number(numbers) as f32)
                };
                let here = |count: fn(&Measured) -> f64| measured.map_or(f32::NAN, |measured| count(measured) as f32);
                let around =
                    |number: fn(&Appraisal) -> f64| appraised.map_or(f32::NAN, |appraised| number(appraised) as f32);
                Reveal::Row {
                    entry,
                    printed: own(Column::Printed),
                    total: own(Column::Total),
                    computed: own(Column::Computed),
                    tests: here(|measured| measured.tests),
                    visits: here(|measured| measured.visits),
                    boxes: here(|measured| measured.boxes),
                    nodes: here(|measured| measured.nodes as f64),
                    bytes: match appraised {
                        Some(appraised) => appraised.bytes as f32,
                        None => here(|measured| measured.bytes as f64),
                    },
                    alive: here(|measured| measured.alive),
                    content: around(|appraised| appraised.content),
                    area: around(|appraised| f64::from(appraised.area)),
                    cuts: around(|appraised| appraised.cuts),
                    planes: around(|appraised| f64::from(appraised.planes)),
                    vain: around(|appraised| f64::from(appraised.vain_share())),
                    speed: time(|timed| timed.speed),
                    time: time(Timed::time),
                    build: time(|timed| timed.build),
                    share: time(|timed| timed.share * 100.0),
                    seconds: time(|timed| timed.seconds),
                    timed: timed.is_some(),
                }
            }
            Entry::Drawn(drawn) => match &drawn.stroke {
                Stroke::Point(x, y) => {
                    Reveal::Point { entry, x: x.at(0.0, numbers) as f32, y: y.at(0.0, numbers) as f32 }
                }
                Stroke::Growth { .. } => {
                    let dot = |dot: Option<&[f64; 2]>| dot.map_or([f32::NAN; 2], |dot| dot.map(|number| number as f32));
                    let ([from, first], [to, last]) = (dot(grown.first()), dot(grown.last()));
                    Reveal::Line { entry, from, to, first, last, timed: timed.is_some() }
                }
                Stroke::Law { law, from, to, .. } => Reveal::Line {
                    entry,
                    from: *from as f32,
                    to: *to as f32,
                    first: law.at(*from, numbers) as f32,
                    last: law.at(*to, numbers) as f32,
                    timed: false,
                },
            },
        }
    }
}
