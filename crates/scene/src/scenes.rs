//! Scenes of somebody's own, beside the shipped ones: flat ones in TOML, solid ones as meshes in OBJ.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;

use crate::error::nearest;
use crate::shipped::{is_shipped, known};
use crate::{ObjError, Scene, SceneError, UnknownScene, scene_names};

/// Scenes by their names. A copy shares them.
#[derive(Clone, Debug, Default)]
pub struct Scenes(Arc<BTreeMap<String, Own>>);

/// A scene, and by what its file is known again.
#[derive(Clone, Debug)]
struct Own {
    scene: Arc<Scene>,
    file: String,
    print: u64,
}

/// The endings of files that are scenes.
pub const SCENE_ENDINGS: [&str; 2] = ["toml", "obj"];

impl Scenes {
    /// The scenes in these files, each called as its file without folder and ending; with what is wrong in the others.
    /// A file that is as it was `before` is not read again.
    pub fn read(files: impl IntoIterator<Item = (String, Vec<u8>)>, before: &Scenes) -> (Scenes, Vec<SceneError>) {
        let (mut scenes, mut wrong): (BTreeMap<String, Own>, _) = (BTreeMap::new(), Vec::new());
        for (file, bytes) in files {
            let name = name_of(&file).to_owned();
            let at_start = |message: String| SceneError::at_byte(&file, "", 0, message);
            if let Some(other) = scenes.get(&name) {
                wrong.push(at_start(format!("a scene is called `{name}` already, {}: rename one of them", other.file)));
                continue;
            }
            if is_shipped(&name) {
                wrong.push(at_start(format!("a scene of the lecture is called `{name}`: give the file another name")));
                continue;
            }
            let print = print(&bytes);
            let known = before.0.get(&name).filter(|own| own.print == print && own.file == file);
            let scene = match known {
                Some(own) => Ok(own.scene.clone()),
                None => read(&bytes, &file, &name).map(Arc::new),
            };
            match scene {
                Ok(scene) => _ = scenes.insert(name, Own { scene, file, print }),
                Err(error) => wrong.push(error),
            }
        }
        (Scenes(Arc::new(scenes)), wrong)
    }

    /// These, and of `before` those whose files are among `wrong` and cannot be read now.
    #[must_use]
    pub fn keeping(&self, before: &Scenes, wrong: impl Fn(&str) -> bool) -> Scenes {
        let lost = before.0.iter().filter(|(name, own)| !self.0.contains_key(*name) && wrong(&own.file));
        let lost: Vec<_> = lost.map(|(name, own)| (name.clone(), own.clone())).collect();
        if lost.is_empty() {
            return self.clone();
        }
        let mut all = BTreeMap::clone(&self.0);
        all.extend(lost);
        Scenes(Arc::new(all))
    }

    /// The scene of that name: one of these, else a shipped one.
    ///
    /// # Errors
    /// When there is none; the error knows the nearest name.
    pub fn named(&self, name: &str) -> Result<Arc<Scene>, UnknownScene> {
        if let Some(own) = self.own(name) {
            return Ok(own.clone());
        }
        Scene::named(name).map(Arc::new).map_err(|unknown| self.nearest(name, unknown))
    }

    /// Whether there is a scene of that name; large ones are not made to say so.
    ///
    /// # Errors
    /// There is none; the error knows the nearest name.
    pub fn knows(&self, name: &str) -> Result<(), UnknownScene> {
        if self.own(name).is_some() {
            return Ok(());
        }
        known(name).map_err(|unknown| self.nearest(name, unknown))
    }

    /// What is said of an unknown name, where a scene of these has a similar one.
    fn nearest(&self, name: &str, unknown: UnknownScene) -> UnknownScene {
        match nearest(name, self.0.keys().map(String::as_str)) {
            Some(near) => UnknownScene { advice: format!("did you mean `{near}`?"), ..unknown },
            None => unknown,
        }
    }

    /// The scene of that name, if it is one of these.
    pub fn own(&self, name: &str) -> Option<&Arc<Scene>> {
        self.0.get(name).map(|own| &own.scene)
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// A number by which what was made of the scene of this name is known again; of a shipped one always the same.
    pub fn print(&self, name: &str) -> u64 {
        self.0.get(name).map_or(0, |own| own.print)
    }

    /// The names, in alphabetical order, then those of the shipped ones.
    pub fn names(&self) -> Vec<String> {
        self.0.keys().cloned().chain(scene_names()).collect()
    }
}

impl PartialEq for Scenes {
    fn eq(&self, other: &Scenes) -> bool {
        let prints = |scenes: &Scenes| scenes.0.iter().map(|(name, own)| (name.clone(), own.print)).collect::<Vec<_>>();
        Arc::ptr_eq(&self.0, &other.0) || prints(self) == prints(other)
    }
}

/// `"scenes/flat-room.toml"` is `flat-room`.
fn name_of(file: &str) -> &str {
    let name = file.rsplit('/').next().unwrap_or(file);
    name.rsplit_once('.').map_or(name, |(name, _)| name)
}

fn print(bytes: &[u8]) -> u64 {
    let mut hasher = DefaultHasher::new();
    bytes.hash(&mut hasher);
    // Those that are shipped have none.
    hasher.finish().max(1)
}

fn read(bytes: &[u8], file: &str, name: &str) -> Result<Scene, SceneError> {
    let at_start = |message: &str| SceneError::at_byte(file, "", 0, message);
    let scene = if file.to_ascii_lowercase().ends_with(".obj") {
        Scene::from_obj(bytes, file, &mut |_| true).map_err(|error| match error {
            ObjError::Wrong(wrong) => wrong,
            ObjError::Cancelled => at_start("reading was cancelled"),
        })?
    } else {
        let text = std::str::from_utf8(bytes).map_err(|error| {
            let good = std::str::from_utf8(&bytes[..error.valid_up_to()]).unwrap_or_default();
            let byte = bytes.get(good.len()).copied().unwrap_or_default();
            let message = format!("the byte 0x{byte:02X} here is no text: save the file as UTF-8");
            SceneError::at_byte(file, good, good.len(), message)
        })?;
        Scene::from_toml(text, file)?
    };
    Ok(Scene { name: name.to_owned(), ..scene })
}
