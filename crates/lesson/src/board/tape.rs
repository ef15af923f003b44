//! A board being filled: what comes to be seen, with the numbers that were measured for it.

use std::sync::Arc;

use raystep_accel::{Appraisal, Cancelled, Grow, Observer, Reveal};
use raystep_scene::Scene;

use super::panel::Entry;
use super::{Board, Care, Column, Counted, Drawn, Measured, Numbers, Rendered, Row, Stroke};

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
    /// How carefully it was filled.
    pub care: Care,
}

impl BoardTape {
    /// Fills a board: what it measures is measured over `scene`.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub fn fill(
        board: &Arc<Board>,
        scene: &Scene,
        care: Care,
        watch: &mut impl Observer<Grow>,
    ) -> Result<BoardTape, Cancelled> {
        let (events, places, measured) = (Vec::new(), Vec::new(), Vec::new());
        let (counted, grown, rendered, appraised) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let (board, numbers) = (board.clone(), board.moved(&[]));
        let mut tape =
            BoardTape { board, numbers, events, places, measured, appraised, counted, grown, rendered, care };
        let board = tape.board.clone();
        for place in board.order() {
            let Some(entry) = board.entry(place) else { continue };
            let measured = match entry {
                Entry::Row(row) => {
                    let mut of = |scene: &Scene| match (&row.plan, row.fast) {
                        (Some(plan), _) => Measured::of(plan, row.how, scene, care, watch),
                        (None, Some(kind)) => Measured::of_fast(kind, scene, care, watch),
                        (None, None) => Ok(None),
                    };
                    match row.scene.as_deref().map(|name| board.scenes.named(name)) {
                        Some(Ok(own)) => of(&own)?,
                        Some(Err(_)) => None,
                        None => of(scene)?,
                    }
                }
                Entry::Drawn(_) | Entry::Map(..) | Entry::Picture(_) => None,
            };
            let appraised = match entry {
                Entry::Row(Row { volume: Some(volume), scene: own, .. }) => {
                    if watch.cancelled() {
                        return Err(Cancelled);
                    }
                    let of = |scene: &Scene| Appraisal::of(&scene.prims, *volume, RAYS, SEED);
                    match own.as_deref().map(|name| board.scenes.named(name)) {
                        Some(Ok(own)) => Some(of(&own)),
                        Some(Err(_)) => None,
                        None => Some(of(scene)),
                    }
                }
                _ => None,
            };
            let counted = match entry {
                Entry::Map(map, of) => Counted::of(&map.plan, of, scene, care, watch)?,
                Entry::Row(_) | Entry::Drawn(_) | Entry::Picture(_) => None,
            };
            let grown = match entry {
                Entry::Drawn(Drawn { stroke: Stroke::Growth { plan, of, scenes, through }, .. }) => {
                    Measured::growth(plan, *of, scenes, *through, &board.scenes, care, watch)?
                }
                _ => Vec::new(),
            };
            let rendered = match entry {
                Entry::Picture(picture) => Rendered::of(picture, scene, &board.scenes, care, watch)?,
                Entry::Row(_) | Entry::Drawn(_) | Entry::Map(..) => None,
            };
            tape.places.push(place);
            tape.measured.push(measured);
            tape.appraised.push(appraised);
            tape.counted.push(counted);
            tape.grown.push(grown);
            tape.rendered.push(rendered);
        }
        tape.tell();
        Ok(tape)
    }

    /// The same board over the same scene with all that is measured measured in full.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub fn in_full(
        self: Arc<BoardTape>,
        scene: &Scene,
        watch: &mut impl Observer<Grow>,
    ) -> Result<Arc<BoardTape>, Cancelled> {
        match self.care {
            Care::Full => Ok(self),
            Care::Draft => {
                let mut filled = BoardTape::fill(&self.board, scene, Care::Full, watch)?;
                filled.numbers.clone_from(&self.numbers);
                filled.tell();
                Ok(Arc::new(filled))
            }
        }
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
        match what {
            Entry::Picture(_) => {
                let told = |number: fn(&Rendered) -> f64| rendered.map_or(f32::NAN, |rendered| number(rendered) as f32);
                Reveal::Picture {
                    entry,
                    triangles: told(|rendered| rendered.triangles as f64),
                    rays: told(|rendered| rendered.rays as f64),
                    tests: told(|rendered| rendered.tests),
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
                }
            }
            Entry::Drawn(drawn) => match &drawn.stroke {
                Stroke::Point(x, y) => {
                    Reveal::Point { entry, x: x.at(0.0, numbers) as f32, y: y.at(0.0, numbers) as f32 }
                }
                Stroke::Growth { .. } => {
                    let dot = |dot: Option<&[f64; 2]>| dot.map_or([f32::NAN; 2], |dot| dot.map(|number| number as f32));
                    let ([from, first], [to, last]) = (dot(grown.first()), dot(grown.last()));
                    Reveal::Line { entry, from, to, first, last }
                }
                Stroke::Law { law, from, to, .. } => Reveal::Line {
                    entry,
                    from: *from as f32,
                    to: *to as f32,
                    first: law.at(*from, numbers) as f32,
                    last: law.at(*to, numbers) as f32,
                },
            },
        }
    }
}
