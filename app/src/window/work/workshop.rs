//! Where structures are built and rays walk: small ones at once, large ones beside the UI thread.

use std::sync::Arc;
use std::time::Instant;

use glam::Vec3;
use raystep_accel::{
    Aabb, BvhVolume, Cancelled, Grow, Mistake, Observer, PrimId, Primitives, Prims, Ray, Rule, Structure,
};
use raystep_lesson::{Board, BoardTape, Care, Library, PacketTape, Plan, Plays, Slide, Stage, Tape};
use raystep_paint::Mesh;
use raystep_scene::Scene;

use super::bench::{Bench, Broken};
use super::task::Task;
use crate::clock::Clock;
use crate::shown::all_nodes::AllNodes;
use crate::shown::playback::{Built, Playback};
use crate::shown::view::{RayChoice, View};

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
    stands: Option<Stands>,
    /// What was built before over the same scene.
    scene: Option<Stands>,
    /// How carefully a board is filled.
    care: Care,
    device: Option<wgpu::Device>,
}

/// A structure that was built, and its solid scene on the GPU, where there is one.
#[derive(Clone)]
struct Stands {
    built: Built,
    mesh: Option<Arc<Mesh>>,
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

impl Broken for Option<Arc<Mesh>> {
    /// The sentence stands on the standard error; the marks alone are drawn.
    fn broken(_: String) -> Option<Arc<Mesh>> {
        None
    }
}

/// Makes walks of views.
pub(crate) struct Workshop {
    bench: Bench<Wanted, Result<Made, Failure>>,
    /// Where a scene that is shown already goes to another device.
    uploads: Bench<Arc<Scene>, Option<Arc<Mesh>>>,
    kept: Vec<Stands>,
    device: Option<wgpu::Device>,
}

/// What is being made.
struct Wanted {
    view: View,
    /// Whether its structure stands already, so that only a ray walks.
    stands: bool,
    /// How carefully a board is filled.
    care: Care,
}

impl Workshop {
    pub(crate) fn new(context: egui::Context) -> Workshop {
        let (bench, uploads) = (Bench::new(context.clone()), Bench::new(context));
        Workshop { bench, uploads, kept: Vec::new(), device: None }
    }

    /// Uploads solid scenes to this device from now on, or to none. What was uploaded to another one is gone, and what
    /// is being made is asked for again.
    pub(crate) fn upload_to(&mut self, device: Option<wgpu::Device>) {
        self.bench.cancel();
        self.uploads.cancel();
        self.kept.iter_mut().for_each(|kept| kept.mesh = None);
        self.device = device;
    }

    /// Uploads a scene whose walk is there already.
    pub(crate) fn upload(&mut self, scene: &Arc<Scene>) {
        let Some(device) = self.device.clone().filter(|_| !scene.flat && !scene.prims.is_empty()) else { return };
        let (key, scene) = (scene.clone(), scene.clone());
        let quick = scene.prims.len() <= SHORT;
        let work = move |task: &Task| Mesh::new(&device, &scene.prims, &|| !task.is_stopped()).map(Arc::new);
        self.uploads.begin(key, Task::new("Uploading the scene", ""), quick, work);
    }

    /// The scene that was uploaded since the last call.
    pub(crate) fn uploaded(&mut self) -> Option<(Arc<Scene>, Arc<Mesh>)> {
        let (scene, mesh) = self.uploads.collect()?;
        let mesh = mesh?;
        for kept in self.kept.iter_mut().filter(|kept| Arc::ptr_eq(&kept.built.scene, &scene)) {
            kept.mesh = Some(mesh.clone());
        }
        Some((scene, mesh))
    }

    /// Asks for the walk of a view. It may be there at once; else it arrives some frames later. A board comes as a draft.
    pub(crate) fn ask(&mut self, view: &View, library: &Arc<Library>) {
        self.ask_for(view, library, Care::Draft);
    }

    /// Asks for the board of a view that is there as a draft, filled in full.
    pub(crate) fn refine(&mut self, view: &View, library: &Arc<Library>) {
        self.ask_for(view, library, Care::Full);
    }

    fn ask_for(&mut self, view: &View, library: &Arc<Library>, care: Care) {
        // What is being dragged waits for what was asked for before it to arrive: so it is seen to move.
        let busy = |wanted: &Wanted| {
            let held = wanted.view.same_but_held(view) && (wanted.stands || wanted.view.ray == view.ray);
            // A board whose meter is moved is measured coarsely for where it stood a moment ago.
            let metered = wanted.stands && wanted.care == Care::Draft && care == Care::Draft;
            let held = held || metered && wanted.view.same_scene(view) && plays_board(view, library);
            wanted.care >= care && (wanted.view.same_walk(view) || held)
        };
        if self.bench.wanted().is_some_and(busy) {
            return;
        }
        let enough = |kept: &&Stands| fits(&kept.built, view, library) && care_of(&kept.built) >= care;
        let stands = self.kept.iter().find(enough).cloned();
        let wanted = Wanted { view: view.clone(), stands: stands.is_some(), care };
        let task = match (wanted.stands, care) {
            (true, _) => Task::new("Walking the ray", ""),
            (false, Care::Draft) => Task::new("Building the structure", "references"),
            (false, Care::Full) => Task::new("Measuring with more rays", ""),
        };
        let task = match stands.as_ref().and_then(|stands| stands.built.told.as_ref()) {
            Some(Tape::Board(filled)) if care == Care::Full => measuring(filled, &view.settings),
            _ => task,
        };
        let scene = self.kept.iter().find(|kept| is_over(&kept.built, view, library)).cloned();
        let (view, library) = (view.clone(), library.clone());
        let order = Order { view, library, stands, scene, care, device: self.device.clone() };
        let quick = is_quick(&order);
        self.bench.begin(wanted, task, quick, move |task| make(order, task));
    }

    /// What has arrived since the last call.
    pub(crate) fn collect(&mut self) -> Option<Result<Made, Failure>> {
        let (_, made) = self.bench.collect()?;
        if let Ok(made) = &made {
            let built = made.playback.built();
            self.kept.retain(|kept| !same(&kept.built, &built));
            self.kept.insert(0, Stands { built, mesh: made.mesh.clone() });
            let mut bytes = 0;
            let many = self.kept.iter().position(|kept| {
                bytes += kept.built.structure.bytes();
                bytes > MOST_BYTES
            });
            self.kept.truncate(many.unwrap_or(8).clamp(1, 8));
        }
        Some(made)
    }

    /// What is being made.
    pub(crate) fn task(&self) -> Option<&Arc<Task>> {
        self.bench.task()
    }

    /// Whether no thread is at work any more.
    pub(crate) fn is_idle(&self) -> bool {
        self.bench.is_idle() && self.uploads.is_idle()
    }

    /// Gives up what is being made. Returns whether there was anything.
    pub(crate) fn cancel(&mut self) -> bool {
        self.bench.cancel()
    }
}

/// The ray that a view asks for; a build needs none.
pub(crate) fn ray_of(view: &View, slide: &Slide, stage: &Stage) -> Result<Option<Ray>, String> {
    match (&view.ray, slide.plays) {
        (_, plays) if !plays.has_rays() => Ok(None),
        (RayChoice::Own(ray), _) => Ok(Some(*ray)),
        (RayChoice::Named(index), _) => {
            let named = stage.rays.get(*index).ok_or("The slide has no such ray.")?;
            Ok(Some(named.ray))
        }
    }
}

/// The rule that a view asks for, over a scene that is flat or not; says so where a setting cannot be.
pub(crate) fn rule_of(view: &View, stage: &Stage, flat: bool) -> Result<Rule, String> {
    let mut rule = match view.example {
        Some(mistake) => mistake.example().rule,
        None => stage.plan.rule(flat).map_err(|error| error.to_string())?,
    };
    for (key, value) in &view.settings {
        match stage.own_setting(key, value) {
            // The rule knows nothing of it.
            Some(own) => own?,
            None => rule.set(key, value).map_err(|error| error.to_string())?,
        }
    }
    Ok(rule)
}

/// Whether the making takes less time than a frame.
fn is_quick(order: &Order) -> bool {
    let flat = |stage: &Stage| match stage.scenes.own(&stage.scene) {
        Some(own) => own.prims.len() <= SMALL,
        None => stage.scene.starts_with("flat"),
    };
    match (&order.stands, &order.view.mesh) {
        (Some(Stands { built: Built { told: Some(Tape::Board(filled)), .. }, .. }), _) => {
            order.care == Care::Draft && !filled.is_stale_at(&order.view.settings)
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

fn make(order: Order, task: &Task) -> Result<Made, Failure> {
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
            let built = build(scene, rule, slide.plays, Some(&stage), order.care, task)?;
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

/// A board measured as far as its order goes: coarsely where its meter was moved; of one that is refined the next that is
/// left, with all rays, and then times, one after the other.
fn further(built: Built, order: &Order, task: &Task) -> Result<Built, Failure> {
    let Some(Tape::Board(filled)) = &built.told else { return Ok(built) };
    let Tape::Board(moved) = Tape::Board(filled.clone()).moved(&order.view.settings) else { return Ok(built) };
    let cancelled = |Cancelled| Failure::Cancelled;
    let scene = built.scene.clone();
    let measured = match order.care {
        Care::Draft if moved.is_stale_at(&order.view.settings) => moved.filled(&scene, Care::Draft, &mut Watch(task)),
        Care::Draft => Ok(moved),
        Care::Full if moved.care() < Care::Full => moved.filled(&scene, Care::Full, &mut Watch(task)),
        Care::Full if order.stands.is_some() => {
            let goes_on = || !task.is_stopped();
            moved.timed_further(&scene, &Clock::new(&goes_on))
        }
        Care::Full => Ok(moved),
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
fn measuring(filled: &BoardTape, settings: &[(String, String)]) -> Arc<Task> {
    let (of, left) = filled.times();
    if filled.care() < Care::Full || filled.is_stale_at(settings) || left == 0 {
        return Task::new("Measuring with more rays", "");
    }
    let task = Task::new("Timing", "entries");
    task.expect(of);
    task.reach(of - left);
    task
}

/// Whether a view is of a slide that plays a board.
fn plays_board(view: &View, library: &Library) -> bool {
    library.slides.get(view.slide).is_some_and(|slide| slide.plays == Plays::Board)
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

/// Whether a kept structure is the one that a view asks for.
fn fits(built: &Built, view: &View, library: &Library) -> bool {
    let Some((slide, stage)) = slide_and_stage(view, library) else { return false };
    // How it was built is kept only where it is played, and a board is its own slide's.
    built.told.as_ref().map_or(Plays::Walk, Tape::plays) == slide.plays
        && (view.example.is_some() || is_of(built.told.as_ref(), stage))
        && is_over(built, view, library)
        && rule_of(view, stage, built.scene.flat).is_ok_and(|rule| rule == built.rule)
}

/// Whether a kept tape is no board's, or this stage's board's; and its packets are the stage's.
fn is_of(told: Option<&Tape>, stage: &Stage) -> bool {
    match told {
        Some(Tape::Board(filled)) => stage.board.as_ref() == Some(&filled.board),
        Some(Tape::Walks(walks)) => stage.abreast == walks.plans,
        Some(Tape::Pairs(pairs)) => stage.pairs == pairs.pairs,
        Some(Tape::Fit(fit)) => stage.volume == Some(fit.volume),
        Some(Tape::Packet(packet)) => PacketTape::packets_of(&stage.rays) == packet.packets,
        _ => true,
    }
}

/// Whether a kept structure stands over the scene that a view asks for.
fn is_over(built: &Built, view: &View, library: &Library) -> bool {
    if let Some(own) = &view.own {
        return Arc::ptr_eq(&own.scene, &built.scene);
    }
    match (&view.mesh, view.example) {
        (_, Some(mistake)) => built.scene.name == mistake.name(),
        (Some(mesh), None) => Arc::ptr_eq(mesh, &built.scene),
        (None, None) => slide_and_stage(view, library).is_some_and(|(_, stage)| stage.is_over(&built.scene)),
    }
}

fn slide_and_stage<'a>(view: &View, library: &'a Library) -> Option<(&'a Slide, &'a Stage)> {
    let slide = library.slides.get(view.slide)?;
    Some((slide, slide.stage(view.stage).or(slide.stages.first())?))
}

/// How carefully the board beside a structure was filled; where there is none, there is nothing to refine.
fn care_of(built: &Built) -> Care {
    built.told.as_ref().map_or(Care::Full, Tape::care)
}

/// What a kept structure has beside it.
#[derive(PartialEq)]
enum Others<'a> {
    Nothing,
    /// The board that it fills.
    Board(&'a Board),
    /// The structures that are walked with it.
    Walks(&'a [Plan]),
    /// Pairs of objects.
    Pairs(&'a [u32]),
    /// The volume that is fitted around everything.
    Fit(BvhVolume),
    /// The packets that walk it.
    Packets(&'a [Vec<Ray>]),
}

fn others(built: &Built) -> Others<'_> {
    match &built.told {
        Some(Tape::Board(filled)) => Others::Board(&filled.board),
        Some(Tape::Walks(walks)) => Others::Walks(&walks.plans),
        Some(Tape::Pairs(pairs)) => Others::Pairs(&pairs.pairs),
        Some(Tape::Fit(fit)) => Others::Fit(fit.volume),
        Some(Tape::Packet(packet)) => Others::Packets(&packet.packets),
        Some(Tape::Walk(_) | Tape::Build(_)) | None => Others::Nothing,
    }
}

fn same(a: &Built, b: &Built) -> bool {
    a.rule == b.rule
        && others(a) == others(b)
        && a.told.is_some() == b.told.is_some()
        && (Arc::ptr_eq(&a.scene, &b.scene) || a.scene.name == b.scene.name)
}
