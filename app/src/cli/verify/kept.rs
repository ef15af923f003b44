//! A ray that showed a difference: printed, kept as a file, and shot again.

use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use raystep_accel::{Hit, Prims, Ray};
use raystep_scene::Scene;

use super::contender::{Built, Contender};
use crate::cli::rays;
use crate::fault::Fault;
use crate::files;

/// What a structure answered instead.
pub(super) enum Found {
    /// Another nearest hit.
    Nearest(Option<Hit>),
    /// The right nearest hit, but another answer to whether there is any.
    Any(bool),
    /// Nothing: the walk broke off.
    Panic,
}

/// A structure's answers to a ray, against the answer of brute force.
pub(super) fn compare(structure: &Built, prims: &Prims, ray: &Ray, right: Option<Hit>) -> Result<(), Found> {
    let bits = |hit: Option<Hit>| hit.map(|hit| (hit.t.to_bits(), hit.prim, hit.inner));
    let answers = || structure.answers(prims, ray);
    let Ok((nearest, any)) = catch_unwind(AssertUnwindSafe(answers)) else { return Err(Found::Panic) };
    if bits(nearest) != bits(right) {
        return Err(Found::Nearest(nearest));
    }
    if any != right.is_some() { Err(Found::Any(any)) } else { Ok(()) }
}

/// A ray for which a structure does not answer as brute force does.
pub(super) struct Difference<'a> {
    pub(super) scene: &'a str,
    /// The structure: `kind key=value ...`.
    pub(super) line: &'a str,
    pub(super) ray: Ray,
    pub(super) right: Option<Hit>,
    pub(super) found: Found,
}

/// So many rays of a run are kept and printed; the others are only counted.
const MOST: usize = 20;
static KEPT: AtomicUsize = AtomicUsize::new(0);

impl Difference<'_> {
    /// Writes the ray to a file of its own in `folder` and says how to walk it.
    pub(super) fn keep(&self, folder: &Path) {
        if KEPT.fetch_add(1, Ordering::Relaxed) >= MOST {
            return;
        }
        let path = folder.join(self.file_name());
        let written = files::folder(folder).and_then(|()| files::write(&path, self.to_string().as_bytes()));
        let [kind, parameters @ ..] = &*self.line.split_whitespace().collect::<Vec<_>>() else { return };
        let rules: String = parameters.iter().map(|pair| format!(" --rule {pair}")).collect();
        let at = path.display();
        let again = match Contender::spelt(self.line) {
            Ok(Contender::Fast(_)) => format!("raystep verify --replay {at}"),
            _ => format!("raystep trace --scene {} --structure {kind}{rules} --rays {at}", self.scene),
        };
        files::tell(&format!("{self}  {again}\n"));
        if let Err(fault) = written {
            files::say(&fault.to_string());
        }
    }

    /// The same difference gets the same name.
    fn file_name(&self) -> String {
        let mut random = raystep_accel::Random::new(0);
        let text = format!("{}{:?}", self.line, self.ray);
        let mixed = text.bytes().fold(0, |mixed, byte| {
            random = raystep_accel::Random::new(mixed ^ u64::from(byte));
            random.bits()
        });
        let kind = self.line.split_whitespace().next().unwrap_or_default();
        format!("{kind}-{}-{:08x}.csv", self.scene.replace(':', "-"), mixed as u32)
    }
}

impl fmt::Display for Difference<'_> {
    /// The file: a table of one ray that `raystep trace` reads, under comments that say what it met.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let hit = |hit: Option<Hit>| {
            let Some(Hit { t, prim, inner }) = hit else { return "nothing".to_owned() };
            let of_model = inner.map_or(String::new(), |inner| format!(", primitive {inner} of its model"));
            format!("t = {t:?}, primitive {prim}{of_model}")
        };
        writeln!(f, "# scene {}", self.scene)?;
        writeln!(f, "# structure {}", self.line)?;
        writeln!(f, "# brute force: {}", hit(self.right))?;
        match self.found {
            Found::Nearest(found) => writeln!(f, "# found: {}", hit(found))?,
            Found::Any(found) => writeln!(f, "# found: occluded = {found}")?,
            Found::Panic => writeln!(f, "# found: the walk broke off")?,
        }
        let Ray { o, d, t_min, t_max } = self.ray;
        writeln!(f, "ox,oy,oz,dx,dy,dz,t_min,t_max")?;
        let numbers = [o.x, o.y, o.z, d.x, d.y, d.z, t_min, t_max].map(|number| format!("{number:?}"));
        writeln!(f, "{}", numbers.join(","))
    }
}

/// Shoots kept rays at all structures once more: those of one file, or of all files in a folder. Their number.
///
/// # Errors
/// A file that cannot be read, or a structure that still answers otherwise than brute force.
pub fn replay(path: &Path) -> Result<u64, Fault> {
    let mut paths = vec![path.to_owned()];
    if path.is_dir() {
        let entries = std::fs::read_dir(path).map_err(crate::fault::about(path))?;
        paths = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
        paths.retain(|path| path.extension().is_some_and(|ending| ending == "csv"));
        paths.sort();
    }
    let mut shot = 0;
    for path in paths {
        shot += replay_file(&path)?;
    }
    Ok(shot)
}

fn replay_file(path: &Path) -> Result<u64, Fault> {
    let file = path.display().to_string();
    let bytes = files::read(path)?;
    let text = String::from_utf8_lossy(&bytes);
    let noted = |key: &str| {
        let line = text.lines().find_map(|line| line.strip_prefix("# ")?.strip_prefix(key));
        line.map(str::trim).ok_or_else(|| Fault::new(format!("{file}: a line \"# {key} ...\" is missing")))
    };
    let scene = Scene::named(noted("scene")?).map_err(|error| Fault::new(format!("{file}: {error}")))?;
    let own = noted("structure")?;
    let own_rule = Contender::spelt(own).map_err(|fault| Fault::new(format!("{file}: {fault}")))?;
    let rays: Result<Vec<Ray>, String> = rays::read(&bytes, &file)?.into_iter().collect();
    let rays = rays.map_err(|why| Fault::new(format!("{file}: {why}")))?;
    // All rules of the structure that differed: another kind would have been kept by a ray of its own.
    let mut all: Vec<(&str, Contender)> = Contender::all().filter(|(_, rule)| rule.kind() == own_rule.kind()).collect();
    all.push((own, own_rule));
    for (line, rule) in all {
        let Some(structure) = rule.build(&scene) else {
            return Err(Fault::new(format!("{file}: {line} cannot be built over {}", scene.name)));
        };
        for &ray in &rays {
            let right = scene.prims.brute_force(&ray);
            if let Err(found) = compare(&structure, &scene.prims, &ray, right) {
                let difference = Difference { scene: &scene.name, line, ray, right, found };
                return Err(Fault::new(format!("{file} still shows a difference\n{difference}")));
            }
        }
    }
    Ok(rays.len() as u64)
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use raystep_accel::PrimId;

    use super::*;

    #[test]
    fn a_kept_ray_comes_back_to_the_bit() {
        let o = Vec3::new(-0.0, 1e-30, 0.1 + 0.2);
        let ray = Ray::new(o, Vec3::new(0.0, -0.0, 1.0 / 3.0)).unwrap().within(0.0, 16_777_217.0).unwrap();
        let (right, found) = (Some(Hit { t: 1.5, prim: PrimId(7), inner: None }), Found::Nearest(None));
        let difference = Difference { scene: "trial:slivers:2", line: "kd max_depth=8", ray, right, found };
        let file = difference.to_string();
        let [Ok(read)] = &rays::read(file.as_bytes(), "kept.csv").unwrap()[..] else { panic!("{file}") };
        assert_eq!(format!("{read:?}"), format!("{ray:?}"));

        let folder = std::env::temp_dir().join(format!("raystep-kept-{}", std::process::id()));
        difference.keep(&folder);
        assert_eq!(replay(&folder).unwrap(), 1);
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn what_cannot_be_shot_again_is_said() {
        let folder = std::env::temp_dir().join(format!("raystep-wrong-{}", std::process::id()));
        files::folder(&folder).unwrap();
        let path = folder.join("wrong.csv");
        let said = |text: &str| {
            files::write(&path, text.as_bytes()).unwrap();
            replay(&folder).unwrap_err().to_string()
        };
        assert!(said("ox,oy\n").ends_with("a line \"# scene ...\" is missing"));
        assert!(said("# scene trial:nothing:0\n").contains("there is no scene"));
        assert!(said("# scene trial:empty:0\n# structure kt\n").contains("did you mean"));
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
