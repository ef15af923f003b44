//! What is played, event by event: a ray's walk, a packet's, the building of the structure, a board that is filled,
//! pairs of objects that are tested, or a volume that is fitted.

use std::collections::BTreeMap;
use std::sync::Arc;

use raystep_accel::{
    Accel, Cancelled, Event, Grain, Grow, Hit, NodeId, Observer, Ray, Rule, Structure, Trace, Value, Visit,
};
use raystep_scene::Scene;

use crate::{BoardTape, Care, FitTape, PacketTape, PairsTape, Plays, Stage, Told, WalksTape, names};

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
    /// A ray walks through several structures.
    Walks(Arc<WalksTape>),
    /// Several rays walk together.
    Packet(Arc<PacketTape>),
    /// A board is filled.
    Board(Arc<BoardTape>),
    /// Pairs of objects are tested.
    Pairs(Arc<PairsTape>),
    /// A volume is fitted around everything.
    Fit(Arc<FitTape>),
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
/// much as the first nodes or cells need: folding it still gives the structure. On it a node has from the beginning the
/// number that it has in the end.
#[derive(Clone, Debug, Default)]
pub struct BuildTape {
    /// What the builder does.
    pub events: Vec<Grow>,
    /// How many events more there were, by their names.
    pub lost: BTreeMap<&'static str, u64>,
    /// What is done to the structure once it is built.
    pub changes: Vec<Told>,
    fine: usize,
    last: Option<Grain>,
    /// What nodes are called in the end that had other numbers before.
    finals: BTreeMap<NodeId, NodeId>,
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
            Tape::Walks(_) => Plays::Walks,
            Tape::Packet(_) => Plays::Packet,
            Tape::Board(_) => Plays::Board,
            Tape::Pairs(_) => Plays::Pairs,
            Tape::Fit(_) => Plays::Fit,
        }
    }

    /// How many events it holds.
    pub fn len(&self) -> usize {
        match self {
            Tape::Walk(walk) => walk.events.len(),
            Tape::Build(build) => build.events.len(),
            Tape::Walks(walks) => walks.order.len(),
            Tape::Packet(packet) => packet.events.len(),
            Tape::Board(board) => board.events.len(),
            Tape::Pairs(pairs) => pairs.events.len(),
            Tape::Fit(fit) => fit.events.len(),
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
            Tape::Walks(walks) => walks.walks.iter().map(Tape::lost).sum(),
            Tape::Packet(packet) => packet.lost,
            Tape::Fit(fit) => fit.lost,
            Tape::Board(_) | Tape::Pairs(_) => 0,
        }
    }

    /// The event with this place on the tape, from 0.
    pub fn event(&self, index: usize) -> Option<Event> {
        match self {
            Tape::Walk(walk) => walk.events.get(index).copied().map(Event::Walk),
            Tape::Build(build) => build.events.get(index).copied().map(Event::Build),
            Tape::Walks(walks) => {
                let (walker, index) = *walks.order.get(index)?;
                walks.walks.get(walker)?.event(index)
            }
            Tape::Packet(packet) => packet.events.get(index).copied().map(Event::Packet),
            Tape::Board(board) => board.events.get(index).copied().map(Event::Board),
            Tape::Pairs(pairs) => pairs.events.get(index).copied().map(Event::Pair),
            Tape::Fit(fit) => fit.events.get(index).copied().map(Event::Fit),
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
            Tape::Walks(_) | Tape::Packet(_) | Tape::Fit(_) => self.lost() == 0,
            Tape::Board(_) | Tape::Pairs(_) => true,
        };
        let counted = || self.events().take(step).filter(|event| names(name, event.name())).count() as u32;
        kept.then(counted)
    }

    /// The same tape for whichever ray comes next, if it is more than one ray's walk.
    pub fn without_ray(&self) -> Option<Tape> {
        match self {
            Tape::Walk(_) => None,
            Tape::Packet(packet) => Some(Tape::Packet(Arc::new(packet.again()))),
            Tape::Build(_) | Tape::Walks(_) | Tape::Board(_) | Tape::Pairs(_) | Tape::Fit(_) => Some(self.clone()),
        }
    }

    /// The tape once this ray walks.
    pub(crate) fn with_ray(&self, scene: &Scene, structure: &Structure, ray: Option<Ray>) -> Tape {
        match (self, ray) {
            (Tape::Walks(walks), Some(ray)) => Tape::Walks(Arc::new(walks.walk(scene, ray))),
            (Tape::Packet(packet), Some(ray)) => Tape::Packet(Arc::new(packet.walk(scene, structure, ray))),
            (tape, _) => tape.clone(),
        }
    }

    /// The number of that name, if it is of a board's meter.
    pub(crate) fn number(&self, name: &str) -> Option<Value> {
        let Tape::Board(board) = self else { return None };
        board.numbers.get(name).map(|number| Value::Number(number as f32))
    }

    /// The tape where these settings, keys and values, put the numbers of its meter and its bodies; the others stand
    /// where the slide has them.
    pub fn moved(self, settings: &[(String, String)]) -> Tape {
        match self {
            Tape::Board(board) => Tape::Board(BoardTape::moved(board, settings)),
            Tape::Pairs(pairs) => Tape::Pairs(Arc::new(PairsTape::new(&pairs.pairs, settings))),
            tape => tape,
        }
    }

    /// Whether an event is of the walk through this structure; every event is, where there is but one.
    pub(crate) fn is_of(&self, index: usize, name: &str) -> bool {
        match self {
            Tape::Walks(walks) => walks
                .order
                .get(index)
                .is_some_and(|(walker, _)| walks.names().get(*walker).is_some_and(|own| own == name)),
            _ => true,
        }
    }

    /// The ray that walks, if one does; of a packet the first.
    pub fn ray(&self) -> Option<Ray> {
        match self {
            Tape::Walk(walk) => Some(walk.ray),
            Tape::Walks(walks) => walks.walks.first()?.ray(),
            Tape::Packet(packet) => packet.rays.first().copied(),
            Tape::Build(_) | Tape::Board(_) | Tape::Pairs(_) | Tape::Fit(_) => None,
        }
    }
}

impl Tape {
    /// How carefully it was measured; only a board can be a draft.
    pub fn care(&self) -> Care {
        match self {
            Tape::Board(filled) => filled.care(),
            Tape::Walk(_) | Tape::Walks(_) | Tape::Packet(_) | Tape::Build(_) | Tape::Pairs(_) | Tape::Fit(_) => {
                Care::Full
            }
        }
    }

    /// Builds what `rule` says over a scene. Keeps what happens, if that is to be played, builds the other structures of
    /// `stage` and fills its board: nothing is kept for a ray that is still to walk.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub fn record(
        plays: Plays,
        stage: Option<&Stage>,
        scene: &Scene,
        rule: &Rule,
        care: Care,
        watch: &mut impl Observer<Grow>,
    ) -> Result<(Structure, Option<Tape>), Cancelled> {
        match (plays, stage) {
            (Plays::Build, Some(stage)) if !stage.changes.is_empty() => {
                let (structure, tape) = stage.build_and_change(scene, rule, watch)?;
                Ok((structure, Some(Tape::Build(Arc::new(tape)))))
            }
            (Plays::Build, _) => {
                let mut tape = BuildTape::default();
                let structure = Structure::build(&scene.prims, rule, &mut (watch, &mut tape))?;
                tape.name_finally();
                Ok((structure, Some(Tape::Build(Arc::new(tape)))))
            }
            (Plays::Walks, Some(stage)) => {
                let walks = WalksTape::build(&stage.abreast, scene, watch)?;
                Ok((Structure::build(&scene.prims, rule, watch)?, Some(Tape::Walks(Arc::new(walks)))))
            }
            (Plays::Board, Some(Stage { board: Some(board), .. })) => {
                let filled = BoardTape::fill(board, scene, care, watch)?;
                Ok((Structure::build(&scene.prims, rule, watch)?, Some(Tape::Board(Arc::new(filled)))))
            }
            (Plays::Pairs, Some(stage)) => {
                let pairs = Tape::Pairs(Arc::new(PairsTape::new(&stage.pairs, &[])));
                Ok((Structure::build(&scene.prims, rule, watch)?, Some(pairs)))
            }
            (Plays::Fit, Some(Stage { volume: Some(volume), .. })) => {
                let fitted = FitTape::record(scene, *volume, watch)?;
                Ok((Structure::build(&scene.prims, rule, watch)?, Some(Tape::Fit(Arc::new(fitted)))))
            }
            (Plays::Packet, Some(stage)) => {
                let packets = PacketTape::of(PacketTape::packets_of(&stage.rays));
                Ok((Structure::build(&scene.prims, rule, watch)?, Some(Tape::Packet(Arc::new(packets)))))
            }
            (Plays::Walk | Plays::Walks | Plays::Packet | Plays::Board | Plays::Pairs | Plays::Fit, _) => {
                Ok((Structure::build(&scene.prims, rule, watch)?, None))
            }
        }
    }
}

impl BuildTape {
    /// Calls each node by its final number wherever it is named: one name from the first step to the last. What a leaf
    /// took in is no node in the end and keeps its number.
    fn name_finally(&mut self) {
        let finals = std::mem::take(&mut self.finals);
        if finals.is_empty() {
            return;
        }
        for event in &mut self.events {
            *event = event.renamed(|node| finals.get(&node).copied().unwrap_or(node));
        }
    }
}

impl Observer<Grow> for BuildTape {
    fn on(&mut self, event: Grow) {
        if let Grow::Renumber { from, to } = event {
            self.finals.insert(from, to);
        }
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
