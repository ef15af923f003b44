//! Pictures: a scene ray traced through one of our structures, with a sun, its shadows, and the sky's light.

use std::collections::HashMap;
use std::sync::{Arc, LazyLock, Mutex, PoisonError};

use glam::{Vec2, Vec3};
use raystep_accel::{
    Accel, Appraisal, BvhVolume, Cancelled, Cost, Grow, Hit, Observer, Outline, PrimId, Primitives, Prims, Ray, Shape,
    Structure, Want, pinhole,
};
use raystep_scene::{Scene, Scenes, View};

use super::care::Care;
use super::smooth::Smooth;
use super::timing::{Stopwatch, While};
use super::{rows, standing};
use crate::keys::Keys;
use crate::reading::Reading;
use crate::{Plan, head};

use super::table;

/// Pictures beside each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Pictures {
    /// What they are about, in a few words.
    pub title: String,
    /// What stands behind the title.
    pub about: String,
    /// Whether the seconds are told that they take.
    pub times: bool,
    /// The pictures.
    pub pictures: Vec<Picture>,
}

/// A picture to be made.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// What it is called.
    pub name: String,
    /// The name of its scene; the board's own if it has none.
    pub scene: Option<String>,
    /// Which structure its rays walk through.
    pub plan: Plan,
    /// Where it is seen from: the eye, what lies in the middle, the vertical angle in degrees. As the scene says,
    /// if it does not.
    pub view: Option<(Vec3, Vec3, f32)>,
    /// Its pixels across and down: fewer, the more pictures stand side by side.
    pub size: [u32; 2],
    /// The volume around everything that is drawn over it.
    pub volume: Option<BvhVolume>,
    /// When it comes to be seen, among everything on the board.
    pub(crate) step: Option<f32>,
    /// Where it stands.
    pub(crate) spot: crate::Spot,
}

/// A picture that was made.
#[derive(Clone, Debug, PartialEq)]
pub struct Rendered {
    /// Pixels across and down.
    pub size: [u32; 2],
    /// Where it is seen from.
    pub view: View,
    /// The volume around everything, if it is drawn over it.
    pub outline: Option<Arc<Outline>>,
    /// Four bytes for each pixel, rows from above.
    pub rgba: Arc<[u8]>,
    /// How many triangles a ray could meet.
    pub triangles: u64,
    /// Rays shot: to the eye and to the sun.
    pub rays: u64,
    /// Tests of primitives, a ray.
    pub tests: f64,
}

/// Pixels of one picture, of each of two, of each of three.
const SIZES: [[u32; 2]; 3] = [[720, 450], [480, 300], [400, 250]];

/// Rays for a pixel at an edge: a grid of so many by so many.
const FINE: u32 = 3;
/// Neighbours that differ by more than this lie at an edge.
const EDGE: f32 = 0.03;

/// Longer than any leaf or blade, in metres.
const LONG: f32 = 0.7;

/// The most pictures beside each other.
const MOST: usize = 6;

/// Reads `[[picture]]`.
pub(super) fn read(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Option<Pictures> {
    let (title, about) = (keys.need::<String>("title", reading), keys.get::<String>("about", reading));
    let times = keys.get::<bool>("times", reading).unwrap_or_default().1;
    let mut pictures = Vec::new();
    for mut keys in keys.tables("pictures", reading) {
        let spot = reading.spot(keys.at());
        let (name, step) = (keys.need::<String>("name", reading), keys.get::<f32>("step", reading));
        let scene = keys.get::<String>("scene", reading).map(|(_, scene)| scene);
        let plan = keys.table("structure", reading).and_then(|mut table| head::plan(&mut table, reading));
        let at = keys.at();
        table::moves(plan.as_ref(), false, at, reading);
        let (eye, target) = (keys.get::<Vec3>("eye", reading), keys.get::<Vec3>("target", reading));
        let fov = keys.get::<f32>("fov_degrees", reading).map_or(40.0, |(_, fov)| fov);
        let volume = table::volume(&mut keys, reading);
        let at = keys.at();
        keys.finish(reading);
        let view = match (eye, target) {
            (Some((_, eye)), Some((_, target))) => Some((eye, target, fov)),
            (None, None) => None,
            _ => {
                reading.problem(at, "a picture has both `eye` and `target`, or neither");
                None
            }
        };
        if let Some((_, name)) = name {
            let plan = plan.unwrap_or_else(Plan::boxes);
            let (size, step) = (SIZES[0], step.map(|(_, step)| step));
            pictures.push(Picture { name, scene, plan, view, size, volume, step, spot });
        }
    }
    if pictures.is_empty() || pictures.len() > MOST {
        reading.problem(keys.at(), format!("from one to {MOST} `pictures` stand beside each other"));
    }
    let size = SIZES[pictures.len().clamp(1, SIZES.len()) - 1];
    for picture in &mut pictures {
        picture.size = size;
    }
    Some(Pictures { title: title?.1, about: about.unwrap_or_default().1, times, pictures })
}

/// Pictures that were made, by what they show: slides share them.
static MADE: LazyLock<Mutex<HashMap<String, Rendered>>> = LazyLock::new(Mutex::default);

impl Rendered {
    /// Makes a picture.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub(crate) fn of(
        picture: &Picture,
        board: &Scene,
        scenes: &Scenes,
        care: Care,
        watch: &mut impl Observer<Grow>,
    ) -> Result<Option<Rendered>, Cancelled> {
        let named = match &picture.scene {
            Some(name) => match scenes.named(name) {
                Ok(scene) => Some(scene),
                Err(_) => return Ok(None),
            },
            None => None,
        };
        let scene = named.as_deref().unwrap_or(board);
        let settings: Vec<_> = picture.plan.settings.iter().map(|setting| (&setting.key, &setting.value)).collect();
        let (kind, seen) = (&picture.plan.kind, (picture.view, picture.size, picture.volume));
        let print = scenes.print(&scene.name);
        let key = format!("{} {print} {kind} {settings:?} {seen:?} {care:?}", scene.name);
        let known = || MADE.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(made) = known().get(&key) {
            return Ok(Some(made.clone()));
        }
        let Some(made) = Rendered::made(picture, scene, care, watch)? else { return Ok(None) };
        known().insert(key, made.clone());
        Ok(Some(made))
    }

    /// Makes a picture in full, also where it was made before.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub(super) fn anew(
        picture: &Picture,
        scene: &Scene,
        watch: &mut impl Observer<Grow>,
    ) -> Result<Option<Rendered>, Cancelled> {
        Rendered::made(picture, scene, Care::Full, watch)
    }

    fn made(
        picture: &Picture,
        scene: &Scene,
        care: Care,
        watch: &mut impl Observer<Grow>,
    ) -> Result<Option<Rendered>, Cancelled> {
        let Some(structure) = standing::structure(&picture.plan, scene, watch)? else { return Ok(None) };
        let mut view = scene.view;
        if let Some((eye, target, fov_degrees)) = picture.view {
            view = View { eye, target, up: scene.view.up, fov_degrees };
        }
        let (sun, smooth, size) = (sun(&view), Smooth::of(&scene.prims), care.of(picture.size));
        let outline = picture.volume.map(|volume| Arc::new(Appraisal::outline(&scene.prims, volume)));
        let through = Textbook { structure: &structure, prims: &scene.prims };
        let camera = Camera { scene, through: &through, view, sun, smooth: &smooth, size, care };
        let mut made = Rendered { outline, ..camera.render(watch)? };
        // Of a draft only the counts are coarse, where a fast structure knows what is hit.
        if let (Care::Draft, Some(fast)) = (care, standing::fast(scene)) {
            let through = Quick { fast: &fast };
            let size = picture.size.map(|side| side / QUICK);
            let sharp = Camera { size, ..camera.answered(&through) }.render(watch)?;
            (made.size, made.rgba) = (sharp.size, sharp.rgba);
        }
        Ok(Some(made))
    }

    /// Of the time of a small picture of a scene, made on one thread through what a plan says, the part in which rays are
    /// intersected: the same rays are shot once more without anything else being done. The median of a few rounds;
    /// nothing where there is nothing to build.
    ///
    /// # Errors
    /// Nobody waits any more.
    pub(super) fn share(plan: &Plan, scene: &Scene, stopwatch: &dyn Stopwatch) -> Result<Option<f64>, Cancelled> {
        let mut watch = While(stopwatch);
        let Some(structure) = standing::structure(plan, scene, &mut watch)? else { return Ok(None) };
        let view = scene.close_view();
        let (sun, smooth) = (sun(&view), Smooth::of(&scene.prims));
        let through = Textbook { structure: &structure, prims: &scene.prims };
        let asked = Asked { through: &through, rays: Mutex::default() };
        let size = if matches!(*structure, Structure::List(_)) { SHARED_BY_ALL } else { SHARED };
        let camera = Camera { scene, through: &asked, view, sun, smooth: &smooth, size, care: Care::Draft };
        std::hint::black_box(camera.colors());
        let camera = camera.answered(&through);
        let rays = std::mem::take(&mut *asked.rays.lock().unwrap_or_else(PoisonError::into_inner));
        let mut shares = Vec::new();
        for _ in 0..ROUNDS {
            if watch.cancelled() {
                return Err(Cancelled);
            }
            let begun = stopwatch.seconds();
            std::hint::black_box(camera.colors());
            let whole = stopwatch.seconds() - begun;
            let begun = stopwatch.seconds();
            let mut cost = Cost::default();
            for (ray, want) in &rays {
                match want {
                    Want::Nearest => _ = std::hint::black_box(through.nearest(ray, &mut cost)),
                    Want::Any => _ = std::hint::black_box(through.any(ray, &mut cost)),
                }
            }
            std::hint::black_box(cost);
            shares.push(((stopwatch.seconds() - begun) / whole.max(1e-9)).min(1.0));
        }
        shares.sort_by(f64::total_cmp);
        Ok(Some(shares[ROUNDS / 2]))
    }
}

/// Pixels of a draft that a fast structure draws are so many times as large as those of the picture.
const QUICK: u32 = 2;

/// The pictures of which it is told in which part of the time rays are intersected.
const SHARED: [u32; 2] = [192, 120];
const SHARED_BY_ALL: [u32; 2] = [64, 40];
/// How often they are made.
const ROUNDS: usize = 5;

/// What answers the rays of a picture.
trait Through: Sync {
    fn nearest(&self, ray: &Ray, cost: &mut Cost) -> Option<Hit>;
    fn any(&self, ray: &Ray, cost: &mut Cost) -> bool;
}

/// A structure of the textbook.
struct Textbook<'a> {
    structure: &'a Structure,
    prims: &'a Prims,
}

impl Through for Textbook<'_> {
    fn nearest(&self, ray: &Ray, cost: &mut Cost) -> Option<Hit> {
        self.structure.intersect(self.prims, ray, cost)
    }

    fn any(&self, ray: &Ray, cost: &mut Cost) -> bool {
        self.structure.occluded(self.prims, ray, cost)
    }
}

/// A fast structure: it answers as the textbook does, to the bit.
struct Quick<'a> {
    fast: &'a standing::Quick,
}

impl Through for Quick<'_> {
    fn nearest(&self, ray: &Ray, _: &mut Cost) -> Option<Hit> {
        self.fast.nearest(ray)
    }

    fn any(&self, ray: &Ray, _: &mut Cost) -> bool {
        self.fast.any(ray)
    }
}

/// Keeps what was asked.
struct Asked<'a> {
    through: &'a Textbook<'a>,
    rays: Mutex<Vec<(Ray, Want)>>,
}

impl Asked<'_> {
    fn keep(&self, ray: &Ray, want: Want) {
        self.rays.lock().unwrap_or_else(PoisonError::into_inner).push((*ray, want));
    }
}

impl Through for Asked<'_> {
    fn nearest(&self, ray: &Ray, cost: &mut Cost) -> Option<Hit> {
        self.keep(ray, Want::Nearest);
        self.through.nearest(ray, cost)
    }

    fn any(&self, ray: &Ray, cost: &mut Cost) -> bool {
        self.keep(ray, Want::Any);
        self.through.any(ray, cost)
    }
}

/// Where the sun stands: high, left of the eye and behind it.
fn sun(view: &View) -> Vec3 {
    let forward = (view.target - view.eye).normalize_or_zero();
    let right = forward.cross(view.up).normalize_or_zero();
    (view.up * 1.1 - right * 0.9 - forward * 0.35).normalize_or_zero()
}

/// A scene, how it is seen, and from where the sun shines.
struct Camera<'a, T> {
    scene: &'a Scene,
    through: &'a T,
    view: View,
    sun: Vec3,
    smooth: &'a Smooth,
    size: [u32; 2],
    care: Care,
}

/// What a row of pixels shows, and what its rays cost.
struct Line {
    colors: Vec<Vec3>,
    cost: Cost,
    rays: u64,
}

impl<'a, T: Through> Camera<'a, T> {
    /// The same camera, its rays answered otherwise.
    fn answered<O: Through>(&self, through: &'a O) -> Camera<'a, O> {
        let &Camera { scene, view, sun, smooth, size, care, .. } = self;
        Camera { scene, through, view, sun, smooth, size, care }
    }

    /// All pixels, one after the other.
    fn colors(&self) -> Vec<Vec3> {
        let [width, height] = self.size;
        let size = Vec2::new(width as f32, height as f32);
        let (mut cost, mut rays) = (Cost::default(), 0);
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| Vec2::new(x as f32 + 0.5, y as f32 + 0.5)));
        pixels.map(|middle| self.light(middle / size, &mut cost, &mut rays)).collect()
    }

    fn render(&self, watch: &impl Observer<Grow>) -> Result<Rendered, Cancelled> {
        let [width, height] = self.size;
        let size = Vec2::new(width as f32, height as f32);
        let first = rows::each(height, watch, |y| {
            let mut line = Line { colors: Vec::with_capacity(width as usize), cost: Cost::default(), rays: 0 };
            for x in 0..width {
                let middle = Vec2::new(x as f32 + 0.5, y as f32 + 0.5) / size;
                let color = self.light(middle, &mut line.cost, &mut line.rays);
                line.colors.push(color);
            }
            line
        })?;
        // Leaves are smaller than a pixel anyhow; smooth things get smooth edges.
        let edges = self.care == Care::Full && !matches!(self.scene.prims, Prims::Instances(_));
        let color_at = |x: u32, y: u32| first.get(y as usize)?.colors.get(x as usize).copied();
        let lines = rows::each(height, watch, |y| {
            let mut line = Line { colors: first[y as usize].colors.clone(), cost: Cost::default(), rays: 0 };
            for x in (0..width).filter(|_| edges) {
                let own = first[y as usize].colors[x as usize];
                let beside = [color_at(x + 1, y), color_at(x, y + 1)];
                if beside.into_iter().flatten().any(|other| (other - own).abs().max_element() > EDGE) {
                    line.colors[x as usize] = self.averaged(x, y, size, &mut line.cost, &mut line.rays);
                }
            }
            line
        })?;
        let (mut cost, mut rays) = (Cost::default(), 0);
        for line in first.iter().chain(&lines) {
            cost += line.cost;
            rays += line.rays;
        }
        // Bytes as screens have them: the square root is near enough, and the same everywhere.
        let byte = |channel: f32| (channel.clamp(0.0, 1.0).sqrt() * 255.0 + 0.5) as u8;
        let colors = lines.iter().flat_map(|line| &line.colors);
        let rgba: Vec<u8> = colors.flat_map(|color| [byte(color.x), byte(color.y), byte(color.z), 255]).collect();
        let triangles = match &self.scene.prims {
            Prims::Instances(instances) => instances.triangles(),
            prims => prims.len() as u64,
        };
        let tests = cost.prim_tests as f64 / rays.max(1) as f64;
        let (view, outline) = (self.view, None);
        Ok(Rendered { size: self.size, view, outline, rgba: rgba.into(), triangles, rays, tests })
    }

    /// The light that comes through a point of the page: (0, 0) is its upper left corner, (1, 1) its lower right one.
    fn light(&self, at: Vec2, cost: &mut Cost, rays: &mut u64) -> Vec3 {
        let at = (at * 2.0 - 1.0) * Vec2::new(1.0, -1.0);
        let View { eye, target, up, fov_degrees } = self.view;
        match pinhole(eye, target, up, fov_degrees, at, self.size[0] as f32 / self.size[1] as f32) {
            Ok(ray) => self.color(&ray, cost, rays),
            Err(_) => Vec3::ONE,
        }
    }

    /// The mean of several rays through a pixel.
    fn averaged(&self, x: u32, y: u32, size: Vec2, cost: &mut Cost, rays: &mut u64) -> Vec3 {
        let mut sum = Vec3::ZERO;
        for sample in 0..FINE * FINE {
            let within = (Vec2::new((sample % FINE) as f32, (sample / FINE) as f32) + 0.5) / FINE as f32;
            sum += self.light((Vec2::new(x as f32, y as f32) + within) / size, cost, rays);
        }
        sum / (FINE * FINE) as f32
    }

    /// The light that comes along a ray, red, green and blue, 1 being white.
    fn color(&self, ray: &Ray, cost: &mut Cost, rays: &mut u64) -> Vec3 {
        *rays += 1;
        let sky = sky(ray.d.dot(self.view.up));
        let Some(hit) = self.through.nearest(ray, cost) else { return sky };
        let shape = self.scene.prims.met(&hit);
        let from = ray.at(hit.t);
        let flat = normal(&shape, ray);
        let side = if flat.dot(ray.d) > 0.0 { -1.0 } else { 1.0 };
        let facing = side * self.smooth.normal(&shape, from).unwrap_or(flat);
        let surface = self.surface(&hit, facing);
        let lit = facing.dot(self.sun).max(0.0);
        let shadow = Ray::new(from, self.sun).and_then(|ray| ray.within(hit.t.max(1.0) * 1e-3, f32::INFINITY));
        let dark = lit > 0.0
            && shadow.is_ok_and(|ray| {
                *rays += 1;
                self.through.any(&ray, cost)
            });
        let sun = if dark { 0.0 } else { lit };
        // From above comes the sky's light, from below that of the ground.
        let above = 0.5 + 0.5 * facing.dot(self.view.up);
        let light = Vec3::new(1.0, 0.95, 0.86) * (sun * 0.95) + Vec3::new(0.36, 0.42, 0.52) * (0.25 + 0.75 * above);
        // What lies far behind the middle of the picture fades into the sky.
        let far = self.scene.bounds().extent().length().max(1e-6);
        let behind = hit.t - (self.view.target - self.view.eye).length();
        let haze = (behind / far).clamp(0.0, 0.75);
        (surface * light).lerp(sky, haze * haze)
    }

    /// The colour of what was hit: porcelain, or outdoors ground, bark and leaves, each plant a little different.
    fn surface(&self, hit: &Hit, facing: Vec3) -> Vec3 {
        let Prims::Instances(instances) = &self.scene.prims else { return Vec3::new(0.72, 0.70, 0.66) };
        // The ground is the last thing that is placed.
        if hit.prim == PrimId(instances.len() as u32 - 1) {
            return Vec3::new(0.26, 0.25, 0.15);
        }
        let own = hit.prim.0.wrapping_mul(2_654_435_761) >> 8;
        let part = |shift: u32| ((own >> shift) & 63) as f32 / 63.0;
        // Trunk and boughs are long, leaves and blades are not.
        let bark = hit.inner.is_some_and(|inner| {
            let triangle = instances.triangle(hit.prim, inner);
            (triangle.b - triangle.a).length().max((triangle.c - triangle.a).length()) > LONG
        });
        let leaves = Vec3::new(0.16 + 0.16 * part(0), 0.30 + 0.14 * part(6), 0.08 + 0.05 * part(12));
        // Leaves let some light through.
        if bark { Vec3::new(0.22, 0.17, 0.12) } else { leaves * (0.9 + 0.25 * facing.dot(self.view.up).abs()) }
    }
}

/// The sky in a direction so far up.
fn sky(up: f32) -> Vec3 {
    Vec3::new(0.80, 0.87, 0.93).lerp(Vec3::new(0.27, 0.46, 0.74), up.clamp(0.0, 1.0).sqrt())
}

fn normal(shape: &Shape<'_>, ray: &Ray) -> Vec3 {
    match shape {
        Shape::Triangle(triangle) => (triangle.b - triangle.a).cross(triangle.c - triangle.a).normalize_or_zero(),
        // Pictures are made of triangles; anything else looks back at the eye.
        _ => -ray.d.normalize_or_zero(),
    }
}
