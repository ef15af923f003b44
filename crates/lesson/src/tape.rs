//! What is played, event by event: a ray's walk, the building of the structure, or a board that is filled.

use std::collections::BTreeMap;
use std::sync::Arc;

use raystep_accel::{Accel, Cancelled, Event, Grain, Grow, Hit, Observer, Ray, Rule, Structure, Trace, Visit};
use raystep_scene::Scene;

use crate::{Board, BoardTape, Plays, names};

/// How many events a tape keeps.
const MOST: usize = 200_000;

/// How much arithmetic of a build a tape keeps.
const FINE: usize = 60_000;

/// What happens, in order.
#[derive(Clone, Debug)]
pub enum Tape {
    /// A ray walks.
    Walk(WalkTape),
    /// A structure is built.
    Build(Arc<BuildTape>),
    /// A board is filled.
    Board(Arc<BoardTape>),
}

/// The walk of a ray.
#[derive(Clone, Debug)]
pub struct WalkTape {
    /// The ray.
    pub ray: Ray,
    /// What it does.
    pub events: Vec<Visit>,
    /// How many events more there were.
    pub lost: u64,
    /// The answer.
    pub hit: Option<Hit>,
}

/// The building of a structure. Of a large build the tape keeps what comes to be, and of the arithmetic as
/// much as the first nodes or cells need: folding it still gives the structure.
#[derive(Clone, Debug, Default)]
pub struct BuildTape {
    /// What the builder does.
    pub events: Vec<Grow>,
    /// How many events more there were, by their names.
    pub lost: BTreeMap<&'static str, u64>,
    fine: usize,
    last: Option<Grain>,
}

impl Tape {
    /// Lets a ray walk.
    pub fn walk(scene: &Scene, structure: &Structure, ray: Ray) -> Tape {
        let mut tape = Trace::new(MOST);
        let hit = structure.intersect(&scene.prims, &ray, &mut tape);
        Tape::Walk(WalkTape { ray, events: tape.events, lost: tape.lost, hit })
    }

    /// Which of them it is.
    pub fn plays(&self) -> Plays {
        match self {
            Tape::Walk(_) => Plays::Walk,
            Tape::Build(_) => Plays::Build,
            Tape::Board(_) => Plays::Board,
        }
    }

    /// How many events it holds.
    pub fn len(&self) -> usize {
        match self {
            Tape::Walk(walk) => walk.events.len(),
            Tape::Build(build) => build.events.len(),
            Tape::Board(board) => board.events.len(),
        }
    }

    /// Whether nothing happens.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// How many events more there were.
    pub fn lost(&self) -> u64 {
        match self {
            Tape::Walk(walk) => walk.lost,
            Tape::Build(build) => build.lost.values().sum(),
            Tape::Board(_) => 0,
        }
    }

    /// The event with this place on the tape, from 0.
    pub fn event(&self, index: usize) -> Option<Event> {
        match self {
            Tape::Walk(walk) => walk.events.get(index).copied().map(Event::Walk),
            Tape::Build(build) => build.events.get(index).copied().map(Event::Build),
            Tape::Board(board) => board.events.get(index).copied().map(Event::Board),
        }
    }

    /// All events, in order.
    pub fn events(&self) -> impl DoubleEndedIterator<Item = Event> + '_ {
        (0..self.len()).filter_map(|index| self.event(index))
    }

    /// How many events of that name there are among the first `step`. Nothing if some were not kept.
    pub(crate) fn count(&self, name: &str, step: usize) -> Option<u32> {
        let kept = match self {
            Tape::Walk(walk) => walk.lost == 0,
            Tape::Build(build) => !build.lost.keys().any(|lost| names(name, lost)),
            Tape::Board(_) => true,
        };
        let counted = || self.events().take(step).filter(|event| names(name, event.name())).count() as u32;
        kept.then(counted)
    }

    /// The same tape, if it is no ray's.
    pub fn without_ray(&self) -> Option<Tape> {
        (!self.plays().has_rays()).then(|| self.clone())
    }

    /// The ray that walks, if one does.
    pub fn ray(&self) -> Option<Ray> {
        match self {
            Tape::Walk(walk) => Some(walk.ray),
            Tape::Build(_) | Tape::Board(_) => None,
        }
    }
}

impl Tape {
    /// Builds what `rule` says over a scene. Keeps what happens, if that is to be played, and fills `board` if that
    /// is: nothing is kept for a ray that is still to walk.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub fn record(
        plays: Plays,
        board: Option<&Arc<Board>>,
        scene: &Scene,
        rule: &Rule,
        watch: &mut impl Observer<Grow>,
    ) -> Result<(Structure, Option<Tape>), Cancelled> {
        match (plays, board) {
            (Plays::Build, _) => {
                let mut tape = BuildTape::default();
                let structure = Structure::build(&scene.prims, rule, &mut (watch, &mut tape))?;
                Ok((structure, Some(Tape::Build(Arc::new(tape)))))
            }
            (Plays::Board, Some(board)) => {
                let filled = BoardTape::fill(board, scene, watch)?;
                Ok((Structure::build(&scene.prims, rule, watch)?, Some(Tape::Board(Arc::new(filled)))))
            }
            (Plays::Walk | Plays::Board, _) => Ok((Structure::build(&scene.prims, rule, watch)?, None)),
        }
    }
}

impl Observer<Grow> for BuildTape {
    fn on(&mut self, event: Grow) {
        // What was begun is kept to its end: the splits of a node, the cells of a primitive.
        let fine = event.grain() == Grain::Arithmetic;
        let begun = self.last == Some(Grain::Arithmetic);
        let room = self.events.len() < MOST && (!fine || begun || self.fine < FINE);
        if room {
            self.events.push(event);
            self.fine += usize::from(fine);
            self.last = Some(event.grain());
        } else {
            *self.lost.entry(event.name()).or_default() += 1;
        }
    }
}
