//! A picture that was made, with what its rays cost; and which part of its time is spent on them.

use std::collections::HashMap;
use std::sync::{Arc, LazyLock, Mutex, MutexGuard, PoisonError};

use raystep_accel::{Appraisal, Cancelled, Cost, Grow, Observer, Outline, Primitives, Prims, Structure, Want};
use raystep_scene::{Scene, Scenes, View};

use super::camera::{Camera, Seen};
use super::care::Care;
use super::picture::Picture;
use super::smooth::Smooth;
use super::standing;
use super::through::{Asked, Quick, Textbook, Through};
use super::timing::{Stopwatch, While};
use crate::Plan;

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

/// Pixels of a draft that a fast structure draws are so many times as large as those of the picture.
const QUICK: u32 = 2;

/// The pictures of which it is told in which part of the time rays are intersected.
const SHARED: [u32; 2] = [192, 120];
const SHARED_BY_ALL: [u32; 2] = [64, 40];
/// How often they are made.
const ROUNDS: usize = 5;

/// Pictures that were made, by what they show: slides share them.
static MADE: LazyLock<Mutex<HashMap<String, Rendered>>> = LazyLock::new(Mutex::default);

fn all_made() -> MutexGuard<'static, HashMap<String, Rendered>> {
    MADE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// What a picture shows.
fn key(picture: &Picture, board: &Scene, scenes: &Scenes, care: Care) -> String {
    let scene = picture.scene.as_deref().unwrap_or(&board.name);
    let settings: Vec<_> = picture.plan.settings.iter().map(|setting| (&setting.key, &setting.value)).collect();
    let (kind, seen) = (&picture.plan.kind, (picture.view, picture.size, picture.volume));
    format!("{scene} {} {kind} {settings:?} {seen:?} {care:?}", scenes.print(scene))
}

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
        let key = key(picture, board, scenes, care);
        if let Some(made) = all_made().get(&key) {
            return Ok(Some(made.clone()));
        }
        let Some(made) = Rendered::made(picture, scene, care, watch)? else { return Ok(None) };
        all_made().insert(key, made.clone());
        Ok(Some(made))
    }

    /// A picture that was made in full before, for whichever board.
    pub(super) fn known(picture: &Picture, board: &Scene, scenes: &Scenes) -> Option<Rendered> {
        all_made().get(&key(picture, board, scenes, Care::Full)).cloned()
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
        let (smooth, size) = (Smooth::of(&scene.prims), care.of(picture.size));
        let outline = picture.volume.map(|volume| Arc::new(Appraisal::outline(&scene.prims, volume)));
        let through = Textbook { structure: &structure, prims: &scene.prims };
        let camera = Camera::new(scene, &through, view, &smooth, size, care);
        let Seen { mut rgba, rays, tests } = camera.render(watch)?;
        // Of a draft only the counts are coarse, where a fast structure knows what is hit.
        let mut size = size;
        if let (Care::Draft, Some(fast)) = (care, standing::fast(scene)) {
            let through = Quick { fast: &fast };
            size = picture.size.map(|side| side / QUICK);
            rgba = camera.answered(&through).sized(size).render(watch)?.rgba;
        }
        let triangles = match &scene.prims {
            Prims::Instances(instances) => instances.triangles(),
            prims => prims.len() as u64,
        };
        Ok(Some(Rendered { size, view, outline, rgba: rgba.into(), triangles, rays, tests }))
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
        let smooth = Smooth::of(&scene.prims);
        let through = Textbook { structure: &structure, prims: &scene.prims };
        let asked = Asked::new(&through);
        let size = if matches!(*structure, Structure::List(_)) { SHARED_BY_ALL } else { SHARED };
        let camera = Camera::new(scene, &asked, view, &smooth, size, Care::Draft);
        std::hint::black_box(camera.colors(&watch)?);
        let camera = camera.answered(&through);
        let rays = asked.take();
        let mut shares = Vec::new();
        for _ in 0..ROUNDS {
            let begun = stopwatch.seconds();
            std::hint::black_box(camera.colors(&watch)?);
            let whole = stopwatch.seconds() - begun;
            let begun = stopwatch.seconds();
            let mut cost = Cost::default();
            for row in rays.chunks(size[0] as usize) {
                if watch.cancelled() {
                    return Err(Cancelled);
                }
                for (ray, want) in row {
                    match want {
                        Want::Nearest => _ = std::hint::black_box(through.nearest(ray, &mut cost)),
                        Want::Any => _ = std::hint::black_box(through.any(ray, &mut cost)),
                    }
                }
            }
            std::hint::black_box(cost);
            shares.push(((stopwatch.seconds() - begun) / whole.max(1e-9)).min(1.0));
        }
        shares.sort_by(f64::total_cmp);
        Ok(Some(shares[ROUNDS / 2]))
    }
}
