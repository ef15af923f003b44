//! Where the window stands, kept in a file while it is open: the next time, also after a crash, it opens there again.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

use glam::{Vec2, Vec3};
use raystep_accel::{Grain, Ray, Rule};
use raystep_figure::Camera;
use raystep_lesson::{Library, Slide, StageKind};
use raystep_scene::Scene;
use serde::Serialize;
use toml::{Table, Value};

use crate::shown::beside::{Beside, Rivals};
use crate::shown::command::QUARTERS;
use crate::shown::state::State;
use crate::shown::view::{RayChoice, View};
use crate::{fields, files};

/// Where a window stands.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Last {
    /// How often it was opened here and ended before it had stood for a while.
    ended: u32,
    /// The folder of the lessons, if they are not those in the program.
    lessons: Option<String>,
    /// The slide's id.
    slide: String,
    /// The stage's name.
    stage: String,
    /// The name of the slide's ray, unless it is one of the user's own.
    ray: Option<String>,
    step: usize,
    grain: String,
    /// In quarters of the usual speed.
    speed: u8,
    present: bool,
    by_hand: bool,
    /// The kind of the structure beside, or several with commas between them.
    beside: Option<String>,
    /// Where the mesh lies that is shown instead of the slide's scene.
    mesh: Option<String>,
    /// The aspect of the picture in which the camera was moved.
    aspect: f32,
    own: Option<OwnRay>,
    camera: Option<Seen>,
    /// The parameters of the structure that differ from the slide's.
    settings: Table,
    /// What was moved by hand: numbers of a meter, bodies of a pair.
    moved: Table,
}

/// Whether some structure has such a parameter, with such a value.
fn is_parameter(key: &str, value: &str) -> bool {
    let known = Rule::KINDS.iter().filter_map(|kind| Rule::default_for(kind).ok());
    known.into_iter().any(|mut rule| rule.set(key, value).is_ok())
}

/// A ray of the user's own.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
struct OwnRay {
    from: [f32; 3],
    direction: [f32; 3],
    t: [f32; 2],
}

/// Where space is seen from: of a flat one the last two are left out.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
struct Seen {
    eye: Option<[f32; 3]>,
    target: Option<[f32; 3]>,
    up: Option<[f32; 3]>,
    fov_degrees: Option<f32>,
    center: Option<[f32; 2]>,
    half_height: Option<f32>,
}

/// What a window shows besides its state.
pub(super) struct Around<'a> {
    pub(super) lessons: Option<&'a Path>,
    /// The mesh that was opened last, and where it lies.
    pub(super) mesh: Option<&'a (Arc<Scene>, PathBuf)>,
    pub(super) aspect: f32,
}

impl Last {
    /// Where the window stands: what is shown, not what is still being made.
    pub(super) fn of(state: &State, around: &Around<'_>) -> Last {
        let view = &state.view;
        let stage = state.stage();
        let shown =
            |(scene, _): &&(Arc<Scene>, PathBuf)| view.mesh.as_ref().is_some_and(|mesh| Arc::ptr_eq(mesh, scene));
        let ray = match view.ray {
            RayChoice::Named(index) => stage.and_then(|stage| stage.rays.get(index)).map(|ray| ray.name.clone()),
            RayChoice::Own(_) => None,
        };
        // The small scene of a mistake goes with the mistake.
        let own = match view.ray {
            RayChoice::Own(ray) if view.example.is_none() => Some(OwnRay::of(&ray)),
            _ => None,
        };
        let beside = match state.beside {
            Beside::Structure(kind) => Some(kind.to_owned()),
            Beside::Abreast(rivals) => Some(rivals.kinds().collect::<Vec<_>>().join(",")),
            Beside::Nothing | Beside::Mistake(_) => None,
        };
        let known = |(key, value): &(String, String)| is_parameter(key, value);
        let (settings, moved): (Vec<_>, Vec<_>) = view.settings.iter().cloned().partition(known);
        let table =
            |settings: Vec<(String, String)>| settings.into_iter().map(|(key, text)| (key, text.into())).collect();
        Last {
            ended: 0,
            lessons: around.lessons.and_then(named),
            slide: state.slide().map(Slide::id).unwrap_or_default(),
            stage: view.stage.name().to_owned(),
            ray,
            step: if view.example.is_none() { view.step } else { 0 },
            grain: state.grain.word().to_owned(),
            speed: state.speed,
            present: state.present,
            by_hand: state.by_hand,
            beside,
            mesh: around.mesh.filter(shown).and_then(|(_, path)| named(path)),
            aspect: around.aspect,
            own,
            camera: view.camera.filter(|_| view.example.is_none()).map(Seen::of),
            settings: table(settings),
            moved: table(moved),
        }
    }

    /// What a text says, and a sentence for whatever of it makes no sense.
    pub fn read(text: &str) -> (Last, Vec<String>) {
        let (stage, grain) = (StageKind::Flat.name().to_owned(), Grain::Decision.word().to_owned());
        let mut read = Last { stage, grain, speed: QUARTERS, aspect: 1.6, ..Last::default() };
        let wrong = fields::read(text, |key, spelt| read.set(key, spelt));
        (read, wrong)
    }

    /// What the file says.
    pub fn text(&self) -> String {
        toml::to_string(self).unwrap_or_default()
    }

    /// Sets one field as it is spelt, or says what would be right.
    fn set(&mut self, key: &str, spelt: &str) -> Result<(), String> {
        let value = fields::value(spelt).ok_or("it cannot be read")?;
        let text = || value.as_str().map(str::to_owned).ok_or("a text is needed".to_owned());
        let flag = || value.as_bool().ok_or("true or false is needed".to_owned());
        let count = |most: i64| {
            let count = value.as_integer().filter(|count| (0..=most).contains(count));
            count.ok_or_else(|| format!("a number from 0 to {most} is needed"))
        };
        let number = |least: f32, most: f32| {
            let number = fields::number(&value).filter(|number| (least..=most).contains(number));
            number.ok_or_else(|| format!("a number from {least} to {most} is needed"))
        };
        if let Some(parameter) = key.strip_prefix("settings.") {
            let text = text()?;
            if !is_parameter(parameter, &text) {
                return Err("no structure has such a parameter".to_owned());
            }
            self.settings.insert(parameter.to_owned(), Value::String(text));
            return Ok(());
        }
        if let Some(name) = key.strip_prefix("moved.") {
            // Which names there are is known once the slide is.
            let text = text()?;
            if text.is_empty() || !text.split(' ').all(|part| part.parse::<f64>().is_ok_and(f64::is_finite)) {
                return Err("numbers are needed".to_owned());
            }
            self.moved.insert(name.to_owned(), Value::String(text));
            return Ok(());
        }
        match key {
            "ended" => self.ended = count(1 << 20)? as u32,
            "lessons" => self.lessons = Some(text()?),
            "slide" => self.slide = text()?,
            "stage" => {
                let text = text()?;
                let known = StageKind::ALL.iter().any(|kind| kind.name() == text);
                self.stage = known.then_some(text).ok_or("there are \"flat\" and \"solid\"")?;
            }
            "ray" => self.ray = Some(text()?),
            "step" => self.step = count(1 << 40)? as usize,
            "grain" => {
                let text = text()?;
                let known = GRAINS.iter().any(|grain| grain.word() == text);
                self.grain = known.then_some(text).ok_or("there are \"arithmetic\", \"decision\" and \"visit\"")?;
            }
            "speed" => self.speed = count(i64::from(9 * QUARTERS))?.max(1) as u8,
            "present" => self.present = flag()?,
            "by_hand" => self.by_hand = flag()?,
            "beside" => {
                let text = text()?;
                let known = rivals(&text).is_some();
                self.beside =
                    Some(known.then_some(text).ok_or_else(|| format!("there are {}", Rule::KINDS.join(", ")))?);
            }
            "mesh" => self.mesh = Some(text()?),
            "aspect" => self.aspect = number(0.01, 100.0)?,
            "own.from" => self.own.get_or_insert_default().from = numbers(&value, f32::MAX)?,
            "own.direction" => self.own.get_or_insert_default().direction = numbers(&value, f32::MAX)?,
            "own.t" => self.own.get_or_insert_default().t = numbers(&value, f32::INFINITY)?,
            "camera.eye" => self.camera.get_or_insert_default().eye = Some(numbers(&value, LARGEST)?),
            "camera.target" => self.camera.get_or_insert_default().target = Some(numbers(&value, LARGEST)?),
            "camera.up" => self.camera.get_or_insert_default().up = Some(numbers(&value, LARGEST)?),
            "camera.fov_degrees" => self.camera.get_or_insert_default().fov_degrees = Some(number(0.01, 179.0)?),
            "camera.center" => self.camera.get_or_insert_default().center = Some(numbers(&value, LARGEST)?),
            "camera.half_height" => {
                self.camera.get_or_insert_default().half_height = Some(number(1.0 / LARGEST, LARGEST)?);
            }
            _ => return Err("nothing of that name is kept".to_owned()),
        }
        Ok(())
    }

    /// The view in these lessons; none where the slide is not in them.
    fn view(&self, library: &Library) -> Option<View> {
        let found = library.slide(&self.slide)?;
        let slide = library.slides.iter().position(|other| std::ptr::eq(other, found))?;
        let stage = found.stages.iter().find(|stage| stage.kind.name() == self.stage);
        // A mesh is solid, whatever the slide has.
        let kind = match (&self.mesh, stage) {
            (Some(_), _) => StageKind::Solid,
            (None, Some(stage)) => stage.kind,
            (None, None) => found.stages.first()?.kind,
        };
        let named = |name: &String| stage?.rays.iter().position(|ray| ray.name == *name);
        let ray = match (self.own.as_ref().and_then(OwnRay::ray), &self.ray) {
            (Some(own), _) => RayChoice::Own(own),
            (None, Some(name)) => RayChoice::Named(named(name).unwrap_or(0)),
            (None, None) => RayChoice::Named(0),
        };
        // What this structure has no such parameter for, and this stage no such number or body, is left out.
        let mut rule = stage.and_then(|stage| stage.plan.rule(kind == StageKind::Flat).ok());
        let mut setting = |(key, value): (&String, &Value)| {
            let value = value.as_str()?.to_owned();
            match stage.and_then(|stage| stage.own_setting(key, &value)) {
                Some(own) => own.ok()?,
                None => rule.as_mut()?.set(key, &value).ok()?,
            }
            Some((key.clone(), value))
        };
        let settings = self.settings.iter().chain(&self.moved).filter_map(&mut setting).collect();
        let camera = self.camera.as_ref().and_then(Seen::camera);
        Some(View { ray, settings, camera, step: self.step, ..View::of_slide(slide, kind) })
    }

    /// Where it stood, for whoever asks: `"5/34 Inner node, inner node, leaf, step 13"`; nothing where that is gone.
    pub fn place(&self, library: &Library) -> Option<String> {
        let slide = library.slide(&self.slide)?;
        let on = if self.mesh.is_some() { ", on your own mesh" } else { "" };
        let before = if self.present { ", before a class" } else { "" };
        Some(format!("{} {}, step {}{on}{before}", slide.id(), slide.title, self.step))
    }

    /// Opens where it stood, as far as that still is there; with the mesh, if it has been read.
    pub(super) fn reopen(&self, state: &mut State, mesh: Option<Arc<Scene>>) {
        let Some(view) = self.view(&state.library) else { return };
        // Without the mesh its ray and its step mean nothing.
        let view = match (&self.mesh, &mesh) {
            (Some(_), None) => View::of_slide(view.slide, view.stage),
            _ => View { mesh, ..view },
        };
        state.grain = GRAINS.into_iter().find(|grain| grain.word() == self.grain).unwrap_or(state.grain);
        (state.speed, state.present, state.by_hand) = (self.speed, self.present, self.by_hand);
        state.reopen(view);
        if let Some(rivals) = self.beside.as_deref().and_then(rivals) {
            state.compare_all(rivals);
        }
    }

    /// Whether these are its lessons.
    pub(super) fn is_of(&self, lessons: Option<&Path>) -> bool {
        self.lessons == lessons.and_then(named)
    }

    /// Where the mesh lies that was shown.
    pub(super) fn mesh(&self) -> Option<&Path> {
        self.mesh.as_deref().map(Path::new)
    }

    /// The aspect of the picture in which the camera was moved.
    pub(super) fn aspect(&self) -> f32 {
        self.aspect
    }
}

/// The kinds of structures beside: one, or several with commas between them.
fn rivals(text: &str) -> Option<Rivals> {
    let known = |word: &str| Rule::KINDS.into_iter().find(|kind| *kind == word.trim());
    let kinds: Option<Vec<&'static str>> = text.split(',').map(known).collect();
    kinds.filter(|kinds| kinds.len() <= Rivals::MOST).map(Rivals::of)
}

/// A path by which it is found from everywhere; none that cannot be written down.
fn named(path: &Path) -> Option<String> {
    std::path::absolute(path).ok()?.to_str().map(str::to_owned)
}

const GRAINS: [Grain; 3] = [Grain::Arithmetic, Grain::Decision, Grain::Visit];

/// So many numbers, none of them larger than `most`.
fn numbers<const N: usize>(value: &Value, most: f32) -> Result<[f32; N], String> {
    let all = value.as_array().map(|all| all.iter().filter_map(fields::number).collect::<Vec<f32>>());
    let all: Option<[f32; N]> = all.and_then(|all| all.try_into().ok());
    let all = all.ok_or_else(|| format!("{N} numbers are needed, as in [1.0, 2.0]"))?;
    let small = all.iter().all(|number| number.abs() <= most);
    small.then_some(all).ok_or_else(|| format!("numbers up to {most:e} are needed"))
}

/// Larger is nothing that is looked at.
const LARGEST: f32 = 1e30;

impl OwnRay {
    fn of(ray: &Ray) -> OwnRay {
        OwnRay { from: ray.o.to_array(), direction: ray.d.to_array(), t: [ray.t_min, ray.t_max] }
    }

    fn ray(&self) -> Option<Ray> {
        let ray = Ray::new(self.from.into(), self.direction.into()).ok()?;
        ray.within(self.t[0], self.t[1]).ok()
    }
}

impl Seen {
    fn of(camera: Camera) -> Seen {
        match camera {
            Camera::Flat { center, half_height } => {
                Seen { center: Some(center.to_array()), half_height: Some(half_height), ..Seen::default() }
            }
            Camera::Solid { eye, target, up, fov_degrees } => {
                let [eye, target, up] = [eye, target, up].map(|at| Some(at.to_array()));
                Seen { eye, target, up, fov_degrees: Some(fov_degrees), ..Seen::default() }
            }
        }
    }

    /// The camera, if all of it is there and it looks somewhere.
    fn camera(&self) -> Option<Camera> {
        if let (Some(center), Some(half_height)) = (self.center, self.half_height) {
            return Some(Camera::Flat { center: Vec2::from_array(center), half_height });
        }
        let [eye, target, up] = [self.eye?, self.target?, self.up?].map(Vec3::from_array);
        let looks = (target - eye).cross(up).try_normalize().is_some();
        looks.then_some(Camera::Solid { eye, target, up, fov_degrees: self.fov_degrees? })
    }
}

/// So long the file stays as it is while things go on changing.
const BETWEEN: Duration = Duration::from_secs(1);

/// So long a window must have stood before it is known to stand.
const STANDS: Duration = Duration::from_secs(3);

/// So often a window is opened at a place where it ends at once.
const TRIES: u32 = 2;

/// Keeps the file.
pub(super) struct Keeper {
    file: PathBuf,
    /// What stands in the file.
    kept: Option<Last>,
    /// When it was written.
    written: Option<Instant>,
    /// Since when the window is open.
    opened: Instant,
    /// How often it was opened at this place and ended at once, this time included; 0 once it stands.
    ended: u32,
}

/// What was kept.
pub(super) struct Found {
    /// Where the window stood.
    pub(super) last: Option<Last>,
    /// What of it made no sense, or why it is not opened again.
    pub(super) wrong: Vec<String>,
}

impl Keeper {
    /// Keeps where the window stands in this file from now on.
    pub(super) fn new(file: PathBuf) -> Keeper {
        Keeper { file, kept: None, written: None, opened: Instant::now(), ended: 0 }
    }

    /// The same, and what stands in the file: the window can go on there.
    pub(super) fn reopening(file: PathBuf) -> (Keeper, Found) {
        let keeper = Keeper::new(file);
        let Ok(bytes) = std::fs::read(&keeper.file) else { return (keeper, Found { last: None, wrong: Vec::new() }) };
        let (last, wrong) = Last::read(&String::from_utf8_lossy(&bytes));
        let mut wrong: Vec<String> =
            wrong.into_iter().map(|wrong| format!("{}:{wrong}", keeper.file.display())).collect();
        if last.ended >= TRIES {
            let Last { slide, step, .. } = &last;
            wrong.push(format!(
                "Raystep has ended at once at step {step} of slide {slide}, {TRIES} times: it opens elsewhere."
            ));
            return (keeper, Found { last: None, wrong });
        }
        (keeper, Found { last: Some(last), wrong })
    }

    /// The window goes on there: if it ends at once, that is known the next time.
    pub(super) fn goes_on(&mut self, last: &Last) {
        self.ended = last.ended + 1;
        self.opened = Instant::now();
        self.put(Last { ended: self.ended, ..last.clone() });
    }

    /// Keeps where the window stands now, but not more often than now and then. Says when it will, if it has not.
    pub(super) fn keep(&mut self, now: Last) -> Option<Duration> {
        if self.opened.elapsed() >= STANDS {
            self.ended = 0;
        }
        let now = Last { ended: self.ended, ..now };
        if self.kept.as_ref() == Some(&now) {
            return (self.ended > 0).then(|| STANDS.saturating_sub(self.opened.elapsed()));
        }
        let waits = self.written.map_or(Duration::ZERO, |written| BETWEEN.saturating_sub(written.elapsed()));
        if waits > Duration::ZERO {
            return Some(waits);
        }
        self.put(now);
        None
    }

    /// Keeps it at once: the window closes.
    pub(super) fn close(&mut self, now: Last) {
        if self.kept.as_ref() != Some(&now) {
            self.put(now);
        }
    }

    /// What cannot be written is not remembered; nothing else is lost.
    fn put(&mut self, now: Last) {
        let _ = files::renew(&self.file, &now.text());
        self.kept = Some(now);
        self.written = Some(Instant::now());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GOOD: &str = "slide = \"5/33\"\nstage = \"solid\"\nray = \"both children\"\nstep = 7\nspeed = 8\n\
        present = true\n[settings]\nmax_depth = \"3\"\n";

    #[test]
    fn what_is_kept_is_read_again() {
        let own = OwnRay { from: [0.1, -3.4e-7, 2.0], direction: [1.0, 0.3, -0.0], t: [0.0, f32::INFINITY] };
        let solid = Camera::Solid { eye: Vec3::new(1.0, 2.5, 3.1), target: Vec3::ZERO, up: Vec3::Y, fov_degrees: 33.3 };
        let flat = Camera::Flat { center: Vec2::new(0.7, -9.1), half_height: 0.01 };
        let (good, wrong) = Last::read(GOOD);
        assert_eq!(wrong, Vec::<String>::new());
        let check = |last: Last| assert_eq!(Last::read(&last.text()), (last, Vec::new()));
        check(good.clone());
        check(Last { own: Some(own.clone()), ray: None, ..good.clone() });
        check(Last { camera: Some(Seen::of(solid)), aspect: 0.1, ..good.clone() });
        check(Last { camera: Some(Seen::of(flat)), beside: Some("grid".to_owned()), ..good.clone() });
        check(Last { mesh: Some("/a/\"b\" ü.obj".to_owned()), lessons: Some("c".to_owned()), ended: 1, ..good });
        assert_eq!(Seen::of(solid).camera(), Some(solid));
        assert_eq!(Seen::of(flat).camera(), Some(flat));
        assert_eq!(OwnRay::of(&own.ray().unwrap()), own);
    }

    #[test]
    fn a_bad_field_loses_only_itself() {
        let (good, _) = Last::read(GOOD);
        let check = |line: &str, says: &str| {
            let (read, wrong) = Last::read(&format!("{line}\n{GOOD}"));
            assert_eq!(read, good, "{line}");
            assert!(wrong.len() == 1 && wrong[0].starts_with(&format!("1: {says}")), "{line}: {wrong:?}");
        };
        check("grain = 3", "grain = 3: a text is needed; it is left out");
        check("grain = \"finer\"", "grain = \"finer\": there are \"arithmetic\", \"decision\" and \"visit\"");
        check("beside = \"kdtree\"", "beside = \"kdtree\": there are list, grid");
        check("by_hand = 1", "by_hand = 1: true or false is needed");
        check("aspect = nan", "aspect = nan: a number from 0.01 to 100 is needed");
        check("ended = -1", "ended = -1: a number from 0 to 1048576 is needed");
        check("mesh = [\"a\"]", "mesh = [\"a\"]: a text is needed");
        check("lesons = \"a\"", "lesons = \"a\": nothing of that name is kept");
        check("camera = 3", "camera = 3: nothing of that name is kept");
        check("zoom =", "");
        // In a camera or a ray a bad part loses the whole, but no more.
        let (read, wrong) = Last::read(&format!("{GOOD}[camera]\neye = [0, 0]\ntarget = [0, 0, 1]\nup = [0, 1, 0]\n"));
        assert_eq!((read.camera.as_ref().unwrap().camera(), wrong.len()), (None, 1));
        assert_eq!(Last { camera: None, ..read }, good);
        let (read, wrong) = Last::read(&format!("{GOOD}[own]\nfrom = [0, 0, 0]\ndirection = [0, 0, 0]\n"));
        assert_eq!((read.own.as_ref().unwrap().ray(), wrong.len()), (None, 0));
        let (read, wrong) = Last::read(&format!("{GOOD}depth = \"4\"\n"));
        assert_eq!((read, wrong.len()), (good.clone(), 1));
        let (read, wrong) = Last::read(&format!("{GOOD}[moved]\nNx = \"many\"\n"));
        assert_eq!((read, wrong.len()), (good.clone(), 1));
        let (read, wrong) = Last::read(&format!("{GOOD}[moved]\nNx = \"640\"\n"));
        assert_eq!((read.moved.len(), Last { moved: good.moved.clone(), ..read }, wrong.len()), (1, good, 0));
    }

    #[test]
    fn a_window_that_ends_at_once_is_opened_elsewhere_the_third_time() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("deep/last.toml");
        let (mut keeper, found) = Keeper::reopening(file.clone());
        assert!(found.last.is_none() && found.wrong.is_empty());
        keeper.keep(Last::read(GOOD).0);
        for _ in 0..TRIES {
            let (mut keeper, found) = Keeper::reopening(file.clone());
            assert_eq!((found.last.as_ref().map(|last| last.step), found.wrong.len()), (Some(7), 0));
            keeper.goes_on(&found.last.unwrap());
        }
        let (_, found) = Keeper::reopening(file.clone());
        assert!(found.last.is_none() && found.wrong[0].contains("at step 7 of slide 5/33"), "{:?}", found.wrong);

        // One that has stood for a while, or was closed, is opened again.
        let (mut keeper, _) = Keeper::reopening(file.clone());
        // Looking at it alone is no try.
        let (_, again) = Keeper::reopening(file.clone());
        assert_eq!(again.wrong.len(), 1);
        keeper.close(Last { step: 9, ..Last::read(GOOD).0 });
        let (_, found) = Keeper::reopening(file);
        assert_eq!(found.last.map(|last| last.step), Some(9));
    }

    #[test]
    fn the_file_is_written_now_and_then() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("last.toml");
        let (mut keeper, _) = Keeper::reopening(file.clone());
        let at = |step: usize| Last { step, ..Last::read(GOOD).0 };
        let step = || Last::read(&std::fs::read_to_string(&file).unwrap()).0.step;
        assert_eq!((keeper.keep(at(1)), step()), (None, 1));
        for next in 2..100 {
            assert!(keeper.keep(at(next)).is_some_and(|waits| waits <= BETWEEN));
        }
        assert_eq!(step(), 1);
        std::thread::sleep(BETWEEN);
        assert_eq!((keeper.keep(at(100)), step()), (None, 100));
        assert_eq!((keeper.keep(at(100)), step()), (None, 100));
    }
}
