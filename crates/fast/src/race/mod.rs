//! The ladder of slide 64: brute force, the textbook's structures, and what the last chapter adds step by step, all over
//! the same mesh and the same rays, on this machine. The clock is given: nothing here knows one.

mod entrant;
mod order;
mod pace;
mod rung;
mod runner;

use rayon::prelude::*;
use raystep_accel::{Accel, Grow, Hit, Mesh, Observer, Ray, Rule, Structure};

use crate::{FastKind, Settings};
use entrant::Entrant;
pub use order::tile_order;
pub use pace::Pace;
pub use rung::Rung;
pub use runner::Runner;

/// A race over a mesh.
pub struct Race<'a> {
    mesh: &'a Mesh,
    rays: &'a [Ray],
    pace: Pace<'a>,
    /// What the textbook's hierarchy answers: whoever answers otherwise is not timed.
    right: Vec<Option<Hit>>,
}

/// A rung, and what it reached or why nobody stands there.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The rung.
    pub rung: Rung,
    /// What was measured, or a sentence that says why nothing was.
    pub told: Result<Told, String>,
}

/// What was measured on a rung.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Told {
    /// Millions of rays a second: the median of the rounds.
    pub mrays_per_s: f64,
    /// The slowest and the quickest round.
    pub spread: [f64; 2],
    /// How many rounds there were.
    pub rounds: usize,
    /// How many rays were shot in each round: fewer than there are where they take long.
    pub rays: usize,
    /// Tests of triangles, a ray; of rays in packets, as many as each makes alone.
    pub tests_per_ray: f64,
    /// Milliseconds of its building: the textbook's on one thread, the others' on all.
    pub build_ms: f64,
    /// What it takes in memory, in bytes: the textbook's beside the mesh, the others' with its triangles.
    pub bytes: u64,
}

/// What can come of a rung.
enum Outcome {
    Told(Told),
    Absent(&'static str),
}

impl<'a> Race<'a> {
    /// Makes ready: the textbook's hierarchy answers all rays once. `clock` counts seconds from any moment; each rung is
    /// timed for `seconds`, or as long as a few rounds take. Nothing if `go_on` says so.
    pub fn new(
        mesh: &'a Mesh,
        rays: &'a [Ray],
        seconds: f64,
        clock: &'a dyn Fn() -> f64,
        go_on: &'a (dyn Fn() -> bool + Sync),
    ) -> Option<Race<'a>> {
        let pace = Pace { clock, go_on, seconds };
        let mut race = Race { mesh, rays, pace, right: Vec::new() };
        let textbook = race.built(&Rule::default_for("bvh").ok()?)?;
        race.right = rays.par_iter().map(|ray| textbook.intersect(mesh, ray, &mut ())).collect();
        Some(race)
    }

    /// Measures a rung; nothing if it shall not go on.
    pub fn run(&self, rung: Rung) -> Option<Row> {
        let told = match self.reached(rung)? {
            Outcome::Told(told) => Ok(told),
            Outcome::Absent(why) => Err(why.to_owned()),
        };
        Some(Row { rung, told })
    }

    /// Measures a rung that runs elsewhere: `ask` puts its answers to rays in their order, as many as there are rays, or
    /// says why it cannot. Nothing if it shall not go on.
    pub fn run_elsewhere(&self, rung: Rung, elsewhere: &Elsewhere<'_>) -> Option<Row> {
        let told = self.elsewhere(elsewhere)?;
        Some(Row { rung, told })
    }

    fn elsewhere(&self, elsewhere: &Elsewhere<'_>) -> Option<Result<Told, String>> {
        let mut answers = match (elsewhere.ask)(self.rays) {
            Ok(answers) => answers,
            Err(why) => return Some(Err(why)),
        };
        if !self.agree(self.rays, &answers) {
            return Some(Err(DISAGREES.to_owned()));
        }
        let mut failed = None;
        let ([median, least, most], rounds) =
            self.pace.rounds(self.rays.len(), || match (elsewhere.ask)(self.rays) {
                Ok(again) => answers = again,
                Err(why) => failed = Some(why),
            })?;
        if let Some(why) = failed {
            return Some(Err(why));
        }
        Some(Ok(Told {
            mrays_per_s: median * 1e-6,
            spread: [least * 1e-6, most * 1e-6],
            rounds,
            rays: self.rays.len(),
            tests_per_ray: elsewhere.tests_per_ray,
            build_ms: elsewhere.build_ms,
            bytes: elsewhere.bytes,
        }))
    }

    fn reached(&self, rung: Rung) -> Option<Outcome> {
        let packets = FastKind::ALL.into_iter().find(|kind| kind.name() == PACKETS);
        let (entrant, build_ms) = match rung {
            Rung::List | Rung::Grid | Rung::Kd | Rung::Bvh => self.textbook(rung.name())?,
            Rung::Bvh2 => self.fast(FastKind::Bvh2, Entrant::Alone)?,
            Rung::Bvh8 => self.fast(FastKind::Bvh8, Entrant::Alone)?,
            Rung::Packets => match packets {
                Some(kind) => self.fast(kind, Entrant::Alone)?,
                None => return Some(Outcome::Absent("no packets in this build")),
            },
            Rung::Threads if rayon::current_num_threads() < 2 => {
                return Some(Outcome::Absent("this machine has one thread"));
            }
            Rung::Threads => self.fast(packets.unwrap_or(FastKind::Bvh8), Entrant::Together)?,
            Rung::Gpu => return Some(Outcome::Absent("it runs elsewhere: `raystep race` asks for a GPU")),
        };
        self.timed(&entrant, build_ms)
    }

    /// A structure of the textbook, and the milliseconds of its building.
    fn textbook(&self, kind: &str) -> Option<(Entrant, f64)> {
        let begun = (self.pace.clock)();
        let structure = self.built(&Rule::default_for(kind).ok()?)?;
        Some((Entrant::Textbook(structure), ((self.pace.clock)() - begun) * 1e3))
    }

    /// A structure of the textbook; nothing if it shall not go on.
    fn built(&self, rule: &Rule) -> Option<Structure> {
        Structure::build(self.mesh, rule, &mut While(self.pace.go_on)).ok()
    }

    /// A fast structure, and the milliseconds of its building.
    fn fast(&self, kind: FastKind, run: impl Fn(crate::AnyFast) -> Entrant) -> Option<(Entrant, f64)> {
        let begun = (self.pace.clock)();
        let built = kind.build(self.mesh, &Settings::default());
        let build_ms = ((self.pace.clock)() - begun) * 1e3;
        (self.pace.go_on)().then(|| (run(built), build_ms))
    }

    fn timed(&self, entrant: &Entrant, build_ms: f64) -> Option<Outcome> {
        let mut answers = Vec::new();
        let all = self.pace.some(self.rays, |rays| entrant.ask(self.mesh, rays, &mut answers))?;
        entrant.ask(self.mesh, &all, &mut answers);
        if !self.agree(&all, &answers) {
            return Some(Outcome::Absent(DISAGREES));
        }
        let ([median, least, most], rounds) =
            self.pace.rounds(all.len(), || entrant.ask(self.mesh, &all, &mut answers))?;
        // Counts are the same on every machine, so they are of all rays; brute force tests everything with any of them.
        let is_list = matches!(entrant, Entrant::Textbook(Structure::List(_)));
        let counted = if is_list { &all } else { self.rays };
        let told = Told {
            mrays_per_s: median * 1e-6,
            spread: [least * 1e-6, most * 1e-6],
            rounds,
            rays: all.len(),
            tests_per_ray: entrant.tests_per_ray(self.mesh, counted),
            build_ms,
            bytes: entrant.bytes(),
        };
        Some(Outcome::Told(told))
    }

    /// Whether these answers to some of the rays, in their order, are the textbook's.
    fn agree(&self, some: &[Ray], answers: &[Option<Hit>]) -> bool {
        let bits = |hit: Option<Hit>| hit.map(|hit| (hit.t.to_bits(), hit.prim));
        let mut all = self.rays.iter().zip(&self.right);
        some.len() == answers.len()
            && some.iter().zip(answers).all(|(ray, found)| {
                all.find(|(own, _)| *own == ray).is_some_and(|(_, right)| bits(*right) == bits(*found))
            })
    }
}

/// Why a rung is not timed that answers otherwise.
const DISAGREES: &str = "it does not answer as the textbook does, and so is not timed";

/// The hits of rays in their order, or why there are none.
pub type Answered = Result<Vec<Option<Hit>>, String>;

/// A structure that is walked elsewhere, ready to be asked.
pub struct Elsewhere<'a> {
    /// Answers rays in their order, or says why not.
    pub ask: &'a dyn Fn(&[Ray]) -> Answered,
    /// Tests of triangles, a ray.
    pub tests_per_ray: f64,
    /// Milliseconds of its building.
    pub build_ms: f64,
    /// What it takes in memory there, in bytes.
    pub bytes: u64,
}

/// The packets that run.
const PACKETS: &str = "fast-packets16";

/// Lets a builder give up.
struct While<'a>(&'a (dyn Fn() -> bool + Sync));

impl Observer<Grow> for While<'_> {
    fn on(&mut self, _: Grow) {}

    fn cancelled(&self) -> bool {
        !(self.0)()
    }
}
