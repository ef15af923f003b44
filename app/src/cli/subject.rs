//! What rays are shot at: a scene or a mesh, and a structure over it.

use std::path::{Path, PathBuf};

use clap::Args;
use raystep_accel::{Rule, RuleError};
use raystep_fast::FastKind;
use raystep_scene::Scene;

use super::spelt;
use crate::fault::Fault;
use crate::files;

/// A scene or a mesh, and a structure.
#[derive(Args, Debug)]
pub(crate) struct Subject {
    /// A shipped scene: flat-twelve, teapot-6321 ...
    #[arg(long, value_name = "NAME", conflicts_with = "mesh", required_unless_present = "mesh")]
    scene: Option<String>,
    /// A mesh to read.
    #[arg(long, value_name = "FILE.obj")]
    pub(super) mesh: Option<PathBuf>,
    /// list, grid, nested-grid, hashed-grid, kd, octree, bsp or bvh; a heat map is also made of fast-grid, fast-kd,
    /// fast-bvh2, fast-bvh8.
    #[arg(long, value_name = "KIND")]
    structure: String,
    /// A parameter of the structure; may be repeated.
    #[arg(long, value_name = "KEY=VALUE")]
    rule: Vec<String>,
}

impl Subject {
    /// What is hit; what was odd in a mesh is said.
    pub(super) fn scene(&self) -> Result<Scene, Fault> {
        match &self.mesh {
            Some(path) => mesh(path),
            None => named(self.scene.as_deref().unwrap_or_default()),
        }
    }

    /// The structure of the last chapter that is named, if one is; it has no parameters.
    pub(super) fn fast(&self) -> Result<Option<FastKind>, Fault> {
        let fast = FastKind::named(&self.structure);
        match (fast, self.rule.first()) {
            (Some(_), Some(rule)) => {
                Err(Fault::new(format!("--rule {rule}: {} has no parameters: leave --rule out", self.structure)))
            }
            _ => Ok(fast),
        }
    }

    /// How the structure is built over a scene that is flat or not.
    pub(super) fn rule(&self, flat: bool) -> Result<Rule, Fault> {
        spelt(&self.structure, &self.rule, flat)
    }
}

/// The rule of a kind of structure with these parameters, each `key=value`, over a scene that is flat or not.
pub(super) fn spelt(kind: &str, parameters: &[String], flat: bool) -> Result<Rule, Fault> {
    let wrong = |error: RuleError| Fault::new(error.to_string());
    let mut rule = spelt::answering(kind)?;
    for (key, value) in pairs(parameters)? {
        rule.set(&key, &value).map_err(wrong)?;
    }
    Ok(if flat { rule.flat() } else { rule })
}

/// Keys and values of parameters.
pub(super) fn pairs(parameters: &[String]) -> Result<Vec<(String, String)>, Fault> {
    let pair = |written: &String| {
        let (key, value) = written
            .split_once('=')
            .ok_or_else(|| Fault::new(format!("--rule {written}: a parameter is written key=value")))?;
        Ok((key.trim().to_owned(), value.trim().to_owned()))
    };
    parameters.iter().map(pair).collect()
}

/// A shipped scene.
pub(super) fn named(name: &str) -> Result<Scene, Fault> {
    Scene::named(name).map_err(|error| Fault::new(error.to_string()))
}

/// A mesh of a file; what was odd in it is said.
pub(super) fn mesh(path: &Path) -> Result<Scene, Fault> {
    let bytes = files::read_mesh(path)?;
    let name = path.display().to_string();
    let scene = Scene::from_obj(&bytes, &name, &mut |_| true).map_err(|error| Fault::new(error.to_string()))?;
    for note in scene.note.lines() {
        files::say(&format!("{name}: {note}"));
    }
    Ok(scene)
}
