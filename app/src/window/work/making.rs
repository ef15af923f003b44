//! The making of a walk: its structure is built, its ray walks, its board is filled as far as it is asked for.

use std::sync::Arc;
use std::time::Instant;

use glam::Vec3;
use raystep_accel::{Aabb, Cancelled, Grow, Mistake, Observer, PrimId, Primitives, Prims, Rule, Structure};
use raystep_lesson::{BoardTape, Care, Library, PacketTape, Plays, Stage, Tape};
use raystep_paint::Mesh;
use raystep_scene::Scene;

use super::asked::{ray_of, rule_of, slide_and_stage};
use super::bench::Broken;
use super::kept::Stands;
use super::task::Task;
use crate::clock::Clock;
use crate::shown::all_nodes::AllNodes;
use crate::shown::playback::{Built, Playback};
use crate::shown::view::View;

/// Scenes with at most so many primitives are built at once.
const SMALL: usize = 512;
/// Brute force over at most so many primitives is walked at once.
const FEW: usize = 4000;
/// A structure over at most so many primitives is walked at once.
pub(super) const SHORT: usize = 100_000;

/// How far a view is to be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Goal {
    /// So that it can be shown: what is measured on a board waits.
    Shown,
    /// The next of what is left to be measured on a board that is shown.
    Further,
}

/// A view to be made into a walk.
pub(super) struct Order {
    pub(super) view: View,
    pub(super) library: Arc<Library>,
    pub(super) stands: Option<Stands>,
    /// What was built before over the same scene.
    pub(super) scene: Option<Stands>,
    /// How far it is to be made.
    pub(super) goal: Goal,
    pub(super) device: Option<wgpu::Device>,
}

/// A walk that was made.
pub(crate) struct Made {
    /// The walk.
    pub(crate) playback: Playback,
    /// Its solid scene on the GPU, where there is one.
    pub(crate) mesh: Option<Arc<Mesh>>,
}

/// Why there is no walk.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Failure {
    /// It was given up.
    Cancelled,
    /// It cannot be made: a sentence.
    Wrong(String),
}

impl<T> Broken for Result<T, Failure> {
    fn broken(sentence: String) -> Result<T, Failure> {
        Err(Failure::Wrong(sentence))
    }
}

/// Whether the making takes less time than a frame.
pub(super) fn is_quick(order: &Order) -> bool {
    let flat = |stage: &Stage| match stage.scenes.own(&stage.scene) {
        Some(own) => own.prims.len() <= SMALL,
        None => stage.scene.starts_with("flat"),
    };
    match (&order.stands, &order.view.mesh) {
        (Some(Stands { built: Built { told: Some(Tape::Board(filled)), .. }, .. }), _) => {
            order.goal == Goal::Shown && !filled.is_stale_at(&order.view.settings)
        }
        (Some(Stands { built, .. }), _) => walks_quickly(&built.structure, built.scene.prims.len()),
        (None, Some(mesh)) => mesh.prims.len() <= SMALL,
        (None, None) => order.view.example.is_some() || order.stage().is_none_or(flat),
    }
}

/// Whether a ray walks through so many primitives in less time than a frame takes.
pub(crate) fn walks_quickly(structure: &Structure, prims: usize) -> bool {
    let all = matches!(structure, Structure::List(_));
    prims <= if all { FEW } else { SHORT }
}

/// Whether such a structure is built and walked in less time than a frame takes.
pub(crate) fn builds_quickly(prims: usize) -> bool {
    prims <= SMALL
}

impl Order {
    fn stage(&self) -> Option<&Stage> {
        slide_and_stage(&self.view, &self.library).map(|(_, stage)| stage)
    }
}

/// Makes a walk, unless the task is stopped.
pub(super) fn make(order: Order, task: &Task) -> Result<Made, Failure> {
    let wrong = |sentence: String| Failure::Wrong(sentence);
    let library = order.library.clone();
    let slide = library.slides.get(order.view.slide).ok_or_else(|| wrong("There is no such slide.".to_owned()))?;
    let stage = order.stage().cloned().ok_or_else(|| wrong("The slide has no stage.".to_owned()))?;
    let ray = ray_of(&order.view, slide, &stage).map_err(wrong)?;
    let built = match &order.stands {
        Some(stands) => stands.built.clone(),
        None => {
            let View { mesh: opened, example, own, .. } = &order.view;
            let own = own.as_ref().map(|own| &own.scene);
            let scene = match (order.scene.as_ref().map(|stands| &stands.built.scene).or(own), opened, example) {
                (Some(scene), ..) => scene.clone(),
                (None, _, Some(mistake)) => Arc::new(scene_of(*mistake)),
                (None, Some(mesh), None) => mesh.clone(),
                (None, None, None) => stage.scenes.named(&stage.scene).map_err(|error| wrong(error.to_string()))?,
            };
            let rule = rule_of(&order.view, &stage, scene.flat).map_err(wrong)?;
            let built = build(scene, rule, slide.plays, Some(&stage), Care::Bare, task)?;
            match (slide.plays, example) {
                // A mistake's own scene has rays of its own.
                (Plays::Packet, Some(mistake)) => Built { told: Some(rays_of(*mistake)), ..built },
                _ => built,
            }
        }
    };
    let built = further(built, &order, task)?;
    let mesh = mesh(&order, &built.scene, task);
    if task.is_stopped() {
        return Err(Failure::Cancelled);
    }
    let playback = Playback::new(order.view, built, ray, slide, &stage);
    let playback = playback.ok_or_else(|| wrong("The slide has no ray.".to_owned()))?;
    Ok(Made { playback, mesh })
}

/// A board measured as far as its order goes: coarsely where its meter was moved; of one that is shown the next that is
/// left, and at the end times, one after the other.
fn further(built: Built, order: &Order, task: &Task) -> Result<Built, Failure> {
    let Some(Tape::Board(filled)) = &built.told else { return Ok(built) };
    let Tape::Board(moved) = Tape::Board(filled.clone()).moved(&order.view.settings) else { return Ok(built) };
    let cancelled = |Cancelled| Failure::Cancelled;
    let scene = built.scene.clone();
    let measured = match order.goal {
        Goal::Shown if moved.is_stale_at(&order.view.settings) => moved.followed(&scene, &mut Watch(task)),
        Goal::Shown => Ok(moved),
        Goal::Further if moved.care() < Care::Full => moved.filled_further(&scene, &mut Watch(task)),
        Goal::Further => {
            let goes_on = || !task.is_stopped();
            moved.timed_further(&scene, &Clock::new(&goes_on))
        }
    };
    let mut measured = measured.map_err(cancelled)?;
    if !measured.is_clocked && measured.untimed().is_some() {
        Arc::make_mut(&mut measured).is_clocked = true;
    }
    let told = Some(Tape::Board(measured));
    let nodes = Arc::new(AllNodes::of(&built.structure, told.as_ref()));
    Ok(Built { told, nodes, ..built })
}

/// What is said while a board is measured further.
pub(super) fn measuring(filled: &BoardTape) -> Arc<Task> {
    let counted = |name: &str, done: usize, of: usize| {
        let task = Task::new(name, "entries");
        task.expect(of);
        task.reach(done);
        task
    };
    match filled.care() {
        Care::Bare => {
            let (done, of) = filled.filled_to(Care::Draft);
            counted("Measuring with few rays", done, of)
        }
        Care::Draft => {
            let (done, of) = filled.filled_to(Care::Full);
            counted("Measuring with more rays", done, of)
        }
        Care::Full => {
            let (of, left) = filled.times();
            counted("Timing", of - left, of)
        }
    }
}

/// A solid scene on the GPU; once for all structures over it.
fn mesh(order: &Order, scene: &Scene, task: &Task) -> Option<Arc<Mesh>> {
    let device = order.device.as_ref().filter(|_| !scene.flat && !scene.prims.is_empty())?;
    let known = [&order.stands, &order.scene].into_iter().flatten().find_map(|stands| stands.mesh.clone());
    known.or_else(|| Mesh::new(device, &scene.prims, &|| !task.is_stopped()).map(Arc::new))
}

/// Builds a structure, unless the task is stopped; how it was built is kept where that is to be played, and what
/// `stage` has beside it: more structures, a board.
pub(crate) fn build(
    scene: Arc<Scene>,
    rule: Rule,
    plays: Plays,
    stage: Option<&Stage>,
    care: Care,
    task: &Task,
) -> Result<Built, Failure> {
    let start = Instant::now();
    let built = Tape::record(plays, stage, &scene, &rule, care, &mut Watch(task));
    let (structure, told) = built.map_err(|Cancelled| Failure::Cancelled)?;
    let seconds = start.elapsed().as_secs_f32();
    let nodes = Arc::new(AllNodes::of(&structure, told.as_ref()));
    Ok(Built { scene, rule, structure: Arc::new(structure), nodes, told, seconds })
}

/// The small scene in which a mistake shows.
fn scene_of(mistake: Mistake) -> Scene {
    let prims = Prims::Few(mistake.example().shapes);
    let bounds = (0..prims.len() as u32).fold(Aabb::EMPTY, |all, prim| all.union(prims.bounds(PrimId(prim))));
    let view = raystep_scene::View::fitting(&bounds, Vec3::Z, Vec3::Y);
    let (name, title) = (mistake.name().to_owned(), mistake.title().to_owned());
    Scene { name, title, prims, flat: true, view, note: String::new(), origin: glam::DVec3::ZERO }
}

/// The rays with which a packet makes a mistake there.
fn rays_of(mistake: Mistake) -> Tape {
    let example = mistake.example();
    let rays = [&[example.ray], example.others.as_slice()].concat();
    Tape::Packet(Arc::new(PacketTape::of(vec![rays])))
}

/// Counts what a builder has settled and asks it to give up.
struct Watch<'a>(&'a Task);

impl Observer<Grow> for Watch<'_> {
    fn on(&mut self, event: Grow) {
        if let Grow::Settle { .. } = event {
            self.0.count();
        }
    }

    fn cancelled(&self) -> bool {
        self.0.is_stopped()
    }
}
