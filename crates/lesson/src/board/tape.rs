//! A board being filled: what comes to be seen, with the numbers that were measured for it.

use std::sync::Arc;

use raystep_accel::{Cancelled, Grow, Observer, Reveal};
use raystep_scene::Scene;

use super::panel::Entry;
use super::{Board, Column, Counted, Drawn, Measured, Rendered, Stroke};

/// A board, and what comes to be seen on it, in order.
#[derive(Clone, Debug)]
pub struct BoardTape {
    /// What it shows.
    pub board: Arc<Board>,
    /// What comes to be seen.
    pub events: Vec<Reveal>,
    /// Where on the board that is: the panel, and the place there.
    pub places: Vec<(usize, usize)>,
    /// What was measured for it.
    pub measured: Vec<Option<Measured>>,
    /// What was counted for it, pixel by pixel.
    pub counted: Vec<Option<Counted>>,
    /// The points that were measured for it.
    pub grown: Vec<Vec<[f64; 2]>>,
    /// The pictures that were made for it.
    pub rendered: Vec<Option<Rendered>>,
}

impl BoardTape {
    /// Fills a board: what it measures is measured over `scene`.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub fn fill(board: &Arc<Board>, scene: &Scene, watch: &mut impl Observer<Grow>) -> Result<BoardTape, Cancelled> {
        let (events, places, measured) = (Vec::new(), Vec::new(), Vec::new());
        let (counted, grown, rendered) = (Vec::new(), Vec::new(), Vec::new());
        let mut tape = BoardTape { board: board.clone(), events, places, measured, counted, grown, rendered };
        for (index, place) in board.order().into_iter().enumerate() {
            let Some(entry) = board.entry(place) else { continue };
            let measured = match entry {
                Entry::Row(row) => match &row.plan {
                    Some(plan) => match row.scene.as_deref().map(Scene::named) {
                        Some(Ok(own)) => Measured::of(plan, row.how, &own, watch)?,
                        Some(Err(_)) => None,
                        None => Measured::of(plan, row.how, scene, watch)?,
                    },
                    None => None,
                },
                Entry::Drawn(_) | Entry::Map(..) | Entry::Picture(_) => None,
            };
            let counted = match entry {
                Entry::Map(map, of) => Counted::of(&map.plan, of, scene, watch)?,
                Entry::Row(_) | Entry::Drawn(_) | Entry::Picture(_) => None,
            };
            let grown = match entry {
                Entry::Drawn(Drawn { stroke: Stroke::Growth { plan, of, scenes }, .. }) => {
                    Measured::growth(plan, *of, scenes, watch)?
                }
                _ => Vec::new(),
            };
            let rendered = match entry {
                Entry::Picture(picture) => Rendered::of(picture, scene, watch)?,
                Entry::Row(_) | Entry::Drawn(_) | Entry::Map(..) => None,
            };
            tape.events.push(reveal(
                index as u32,
                entry,
                measured.as_ref(),
                counted.as_ref(),
                &grown,
                rendered.as_ref(),
            ));
            tape.places.push(place);
            tape.measured.push(measured);
            tape.counted.push(counted);
            tape.grown.push(grown);
            tape.rendered.push(rendered);
        }
        Ok(tape)
    }
}

fn reveal(
    entry: u32,
    what: Entry<'_>,
    measured: Option<&Measured>,
    counted: Option<&Counted>,
    grown: &[[f64; 2]],
    rendered: Option<&Rendered>,
) -> Reveal {
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
                row.cells.iter().find(|(key, _)| *key == column).map_or(f32::NAN, |(_, cell)| cell.number() as f32)
            };
            let here = |count: fn(&Measured) -> f64| measured.map_or(f32::NAN, |measured| count(measured) as f32);
            Reveal::Row {
                entry,
                printed: own(Column::Printed),
                total: own(Column::Total),
                computed: own(Column::Computed),
                tests: here(|measured| measured.tests),
                visits: here(|measured| measured.visits),
                boxes: here(|measured| measured.boxes),
                nodes: here(|measured| measured.nodes as f64),
                bytes: here(|measured| measured.bytes as f64),
                alive: here(|measured| measured.alive),
            }
        }
        Entry::Drawn(drawn) => match &drawn.stroke {
            Stroke::Point(x, y) => Reveal::Point { entry, x: x.at(0.0) as f32, y: y.at(0.0) as f32 },
            Stroke::Growth { .. } => {
                let dot = |dot: Option<&[f64; 2]>| dot.map_or([f32::NAN; 2], |dot| dot.map(|number| number as f32));
                let ([from, first], [to, last]) = (dot(grown.first()), dot(grown.last()));
                Reveal::Line { entry, from, to, first, last }
            }
            Stroke::Law { law, from, to, .. } => Reveal::Line {
                entry,
                from: *from as f32,
                to: *to as f32,
                first: law.at(*from) as f32,
                last: law.at(*to) as f32,
            },
        },
    }
}
