//! Where structures are built and rays walk: small ones at once, large ones beside the UI thread.

use std::sync::Arc;
use std::time::Instant;

use glam::Vec3;
use raystep_accel::{Aabb, Cancelled, Grow, Mistake, Observer, PrimId, Primitives, Prims, Ray, Rule, Structure};
use raystep_figure::Nodes;
use raystep_lesson::{BuildTape, Library, Plays, Slide, Stage};
use raystep_paint::Mesh;
use raystep_scene::Scene;

use super::bench::{Bench, Broken};
use super::playback::{Built, Playback};
use super::task::Task;
use super::view::{RayChoice, View};

/// Scenes with at most so many primitives are built at once.
const SMALL: usize = 512;
/// Brute force over at most so many primitives is walked at once.
const FEW: usize = 4000;
/// A structure over at most so many primitives is walked at once.
const SHORT: usize = 100_000;
/// Structures are kept while all together have at most so many bytes.
const MOST_BYTES: usize = 1 << 28;

/// A view to be made into a walk.
struct Order {
    view: View,
    library: Arc<Library>,
    built: Option<Built>,
    /// What was built before over the same scene.
    scene: Option<Built>,
    device: Option<wgpu::Device>,
}

/// Why there is no walk.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Failure {
    /// It was given up.
    Cancelled,
    /// It cannot be made: a sentence.
    Wrong(String),
}

impl Broken for Result<Playback, Failure> {
    fn broken(sentence: String) -> Result<Playback, Failure> {
        Err(Failure::Wrong(sentence))
    }
}

/// Makes walks of views.
pub(super) struct Workshop {
    bench: Bench<Wanted, Result<Playback, Failure>>,
    kept: Vec<Built>,
    device: Option<wgpu::Device>,
}

/// What is being made.
struct Wanted {
    view: View,
    /// Whether its structure stands already, so that only a ray walks.
    stands: bool,
}

impl Workshop {
    pub(super) fn new(context: egui::Context) -> Workshop {
        Workshop { bench: Bench::new(context), kept: Vec::new(), device: None }
    }

    /// Uploads solid scenes to this device from now on.
    pub(super) fn upload_to(&mut self, device: &wgpu::Device) {
        self.device = Some(device.clone());
    }

    /// Asks for the walk of a view. It may be there at once; else it arrives some frames later.
    pub(super) fn ask(&mut self, view: &View, library: &Arc<Library>) {
        // A ray that is being dragged waits for the one before it to arrive: so it is seen to move.
        let busy = |wanted: &Wanted| wanted.view.same_walk(view) || wanted.stands && wanted.view.same_but_own_ray(view);
        if self.bench.wanted().is_some_and(busy) {
            return;
        }
        let built = self.kept.iter().find(|built| fits(built, view, library)).cloned();
        let wanted = Wanted { view: view.clone(), stands: built.is_some() };
        let task = match wanted.stands {
            true => Task::new("Walking the ray", ""),
            false => Task::new("Building the structure", "references"),
        };
        let scene = self.kept.iter().find(|built| is_over(built, view, library)).cloned();
        let order = Order { view: view.clone(), library: library.clone(), built, scene, device: self.device.clone() };
        let quick = is_quick(&order);
        self.bench.begin(wanted, task, quick, move |task| make(order, task));
    }

    /// What has arrived since the last call.
    pub(super) fn collect(&mut self) -> Option<Result<Playback, Failure>> {
        let (_, made) = self.bench.collect()?;
        if let Ok(playback) = &made {
            let built = playback.built();
            self.kept.retain(|kept| !same(kept, &built));
            self.kept.insert(0, built);
            let mut bytes = 0;
            let many = self.kept.iter().position(|kept| {
                bytes += kept.structure.bytes();
                bytes > MOST_BYTES
            });
            self.kept.truncate(many.unwrap_or(8).clamp(1, 8));
        }
        Some(made)
    }

    /// What is being made.
    pub(super) fn task(&self) -> Option<&Arc<Task>> {
        self.bench.task()
    }

    /// Whether no thread is at work any more.
    pub(super) fn is_idle(&self) -> bool {
        self.bench.is_idle()
    }

    /// Gives up what is being made. Returns whether there was anything.
    pub(super) fn cancel(&mut self) -> bool {
        self.bench.cancel()
    }
}

/// The ray that a view asks for; a build needs none.
pub(super) fn ray_of(view: &View, slide: &Slide, stage: &Stage) -> Result<Option<Ray>, String> {
    match (&view.ray, slide.plays) {
        (_, Plays::Build) => Ok(None),
        (RayChoice::Own(ray), _) => Ok(Some(*ray)),
        (RayChoice::Named(index), _) => {
            let named = stage.rays.get(*index).ok_or("The slide has no such ray.")?;
            Ok(Some(named.ray))
        }
    }
}

/// The rule that a view asks for, over a scene that is flat or not.
pub(super) fn rule_of(view: &View, stage: &Stage, flat: bool) -> Result<Rule, String> {
    let mut rule = match view.example {
        Some(mistake) => mistake.example().rule,
        None => stage.plan.rule(flat).map_err(|error| error.to_string())?,
    };
    for (key, value) in &view.settings {
        rule.set(key, value).map_err(|error| error.to_string())?;
    }
    Ok(rule)
}

/// Whether the making takes less time than a frame.
fn is_quick(order: &Order) -> bool {
    let flat = |stage: &Stage| stage.scene.starts_with("flat");
    match (&order.built, &order.view.mesh) {
        (Some(built), _) => walks_quickly(&built.structure, built.scene.prims.len()),
        (None, Some(mesh)) => mesh.prims.len() <= SMALL,
        (None, None) => order.view.example.is_some() || order.stage().is_none_or(flat),
    }
}

/// Whether a ray walks through so many primitives in less time than a frame takes.
pub(super) fn walks_quickly(structure: &Structure, prims: usize) -> bool {
    let all = matches!(structure, Structure::List(_));
    prims <= if all { FEW } else { SHORT }
}

/// Whether such a structure is built and walked in less time than a frame takes.
pub(super) fn builds_quickly(prims: usize) -> bool {
    prims <= SMALL
}

impl Order {
    fn stage(&self) -> Option<&Stage> {
        slide_and_stage(&self.view, &self.library).map(|(_, stage)| stage)
    }
}

fn make(order: Order, task: &Task) -> Result<Playback, Failure> {
    let wrong = |sentence: String| Failure::Wrong(sentence);
    let library = order.library.clone();
    let slide = library.slides.get(order.view.slide).ok_or_else(|| wrong("There is no such slide.".to_owned()))?;
    let stage = order.stage().cloned().ok_or_else(|| wrong("The slide has no stage.".to_owned()))?;
    let ray = ray_of(&order.view, slide, &stage).map_err(wrong)?;
    let built = match &order.built {
        Some(built) => built.clone(),
        None => {
            let scene = match (&order.scene, &order.view.mesh, order.view.example) {
                (Some(built), ..) => built.scene.clone(),
                (None, _, Some(mistake)) => Arc::new(scene_of(mistake)),
                (None, Some(mesh), None) => mesh.clone(),
                (None, None, None) => Arc::new(Scene::named(&stage.scene).map_err(|error| wrong(error.to_string()))?),
            };
            let rule = rule_of(&order.view, &stage, scene.flat).map_err(wrong)?;
            let built = build(scene, rule, slide.plays, task)?;
            Built { mesh: mesh(&order, &built.scene, task), ..built }
        }
    };
    if task.is_stopped() {
        return Err(Failure::Cancelled);
    }
    Playback::new(order.view, built, ray, slide, &stage).ok_or_else(|| wrong("The slide has no ray.".to_owned()))
}

/// A solid scene on the GPU; once for all structures over it.
fn mesh(order: &Order, scene: &Scene, task: &Task) -> Option<Arc<Mesh>> {
    let device = order.device.as_ref().filter(|_| !scene.flat)?;
    let known = order.scene.as_ref().and_then(|built| built.mesh.clone());
    known.or_else(|| Mesh::new(device, &scene.prims, &|| !task.is_stopped()).map(Arc::new))
}

/// Builds a structure, unless the task is stopped; how it was built is kept where that is to be played.
pub(super) fn build(scene: Arc<Scene>, rule: Rule, plays: Plays, task: &Task) -> Result<Built, Failure> {
    let start = Instant::now();
    let built = BuildTape::record(plays, &scene, &rule, &mut Watch(task));
    let (structure, growth) = built.map_err(|Cancelled| Failure::Cancelled)?;
    let seconds = start.elapsed().as_secs_f32();
    let nodes = Arc::new(Nodes::of(&structure));
    Ok(Built { scene, rule, structure: Arc::new(structure), nodes, growth, seconds, mesh: None })
}

/// The small scene in which a mistake shows.
fn scene_of(mistake: Mistake) -> Scene {
    let prims = Prims::Few(mistake.example().shapes);
    let bounds = (0..prims.len() as u32).fold(Aabb::EMPTY, |all, prim| all.union(prims.bounds(PrimId(prim))));
    let view = raystep_scene::View::fitting(&bounds, Vec3::Z, Vec3::Y);
    let (name, title) = (mistake.name().to_owned(), mistake.title().to_owned());
    Scene { name, title, prims, flat: true, view, note: String::new() }
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

/// Whether a kept structure is the one that a view asks for.
fn fits(built: &Built, view: &View, library: &Library) -> bool {
    let Some((slide, stage)) = slide_and_stage(view, library) else { return false };
    // How it was built is kept only where it is played.
    built.growth.is_some() == (slide.plays == Plays::Build)
        && is_over(built, view, library)
        && rule_of(view, stage, built.scene.flat).is_ok_and(|rule| rule == built.rule)
}

/// Whether a kept structure stands over the scene that a view asks for.
fn is_over(built: &Built, view: &View, library: &Library) -> bool {
    match (&view.mesh, view.example) {
        (_, Some(mistake)) => built.scene.name == mistake.name(),
        (Some(mesh), None) => Arc::ptr_eq(mesh, &built.scene),
        (None, None) => slide_and_stage(view, library).is_some_and(|(_, stage)| built.scene.name == stage.scene),
    }
}

fn slide_and_stage<'a>(view: &View, library: &'a Library) -> Option<(&'a Slide, &'a Stage)> {
    let slide = library.slides.get(view.slide)?;
    Some((slide, slide.stage(view.stage).or(slide.stages.first())?))
}

fn same(a: &Built, b: &Built) -> bool {
    a.rule == b.rule
        && a.growth.is_some() == b.growth.is_some()
        && (Arc::ptr_eq(&a.scene, &b.scene) || a.scene.name == b.scene.name)
}
