//! What the window remembers from one time to the next: sizes of panes, theme, zoom. Written whole or not at all.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::shown::pictures::Pane;

/// What is remembered.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Remembered {
    /// The theme's name.
    pub theme: String,
    /// The factor of the whole window.
    pub zoom: f32,
    /// Whether questions are asked.
    pub predict: bool,
    /// The width of the lesson, once it was dragged.
    pub lesson: Option<f32>,
    /// The width of the column at the right.
    pub walk: Option<f32>,
    /// The heights of the panes, once they were dragged.
    pub heights: Heights,
    /// The chosen tab.
    #[serde(skip)]
    pub(crate) tab: Pane,
    #[serde(skip)]
    file: Option<PathBuf>,
    #[serde(skip)]
    written: Option<String>,
}

/// The heights of the panes that were dragged, in points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Heights {
    /// Of the work done.
    pub work: Option<f32>,
    /// Of the stack.
    pub stack: Option<f32>,
    /// Of the tree or the cell table.
    pub tree: Option<f32>,
    /// Of the t ruler.
    pub ruler: Option<f32>,
    /// Of a node's bytes, where they stand in the ruler's place.
    pub bytes: Option<f32>,
    /// Of what changed.
    pub changed: Option<f32>,
    /// Of what stands behind tabs.
    pub tabs: Option<f32>,
}

impl Default for Remembered {
    fn default() -> Remembered {
        Remembered {
            theme: "light".to_owned(),
            zoom: 1.0,
            predict: true,
            lesson: None,
            walk: None,
            heights: Heights::default(),
            tab: Pane::Changed,
            file: None,
            written: None,
        }
    }
}

impl Remembered {
    /// What the user's own file says, as far as it can be read.
    pub fn of_user() -> Remembered {
        let file = folder().map(|folder| folder.join("window.toml"));
        let text = file.as_deref().and_then(|file| std::fs::read_to_string(file).ok());
        let read = text.as_deref().map(Remembered::read).unwrap_or_default();
        Remembered { file, written: text, ..read }
    }

    /// What a text says, as far as it makes sense.
    fn read(text: &str) -> Remembered {
        let read: Remembered = toml::from_str(text).unwrap_or_default();
        let sound = |size: Option<f32>| size.filter(|size| (1.0..1e5).contains(size));
        let Heights { work, stack, tree, ruler, bytes, changed, tabs } = read.heights;
        Remembered {
            zoom: if read.zoom.is_finite() { read.zoom.clamp(0.5, 3.0) } else { 1.0 },
            lesson: sound(read.lesson),
            walk: sound(read.walk),
            heights: Heights {
                work: sound(work),
                stack: sound(stack),
                tree: sound(tree),
                ruler: sound(ruler),
                bytes: sound(bytes),
                changed: sound(changed),
                tabs: sound(tabs),
            },
            ..read
        }
    }

    /// Remembers this zoom, and whether questions are asked.
    pub(crate) fn keep(&mut self, zoom: f32, predict: bool) {
        (self.zoom, self.predict) = (zoom, predict);
        self.write();
    }

    /// Writes the file if it would differ. What cannot be written is not remembered; nothing else is lost.
    fn write(&mut self) {
        let (Some(file), Ok(text)) = (&self.file, toml::to_string(&*self)) else { return };
        if self.written.as_ref() != Some(&text) && replace(file, &text).is_ok() {
            self.written = Some(text);
        }
    }
}

/// Puts a new file in the place of an old one; a reader sees either, never a part.
fn replace(file: &Path, text: &str) -> std::io::Result<()> {
    if let Some(folder) = file.parent() {
        std::fs::create_dir_all(folder)?;
    }
    let fresh = file.with_extension(format!("{}.new", std::process::id()));
    std::fs::write(&fresh, text)?;
    std::fs::rename(&fresh, file)
}

/// Where the user's settings lie.
fn folder() -> Option<PathBuf> {
    let of = |name: &str| std::env::var_os(name).filter(|value| !value.is_empty()).map(PathBuf::from);
    let base = if cfg!(windows) {
        of("APPDATA")
    } else if cfg!(target_os = "macos") {
        of("HOME").map(|home| home.join("Library/Application Support"))
    } else {
        of("XDG_CONFIG_HOME").or_else(|| of("HOME").map(|home| home.join(".config")))
    };
    base.map(|base| base.join("raystep"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_again() {
        let folder = std::env::temp_dir().join(format!("raystep-remember-{}", std::process::id()));
        let file = folder.join("window.toml");
        let mut kept = Remembered {
            theme: "dark".to_owned(),
            lesson: Some(300.0),
            file: Some(file.clone()),
            ..Remembered::default()
        };
        kept.heights.tree = Some(200.0);
        kept.write();
        let read: Remembered = toml::from_str(&std::fs::read_to_string(&file).unwrap()).unwrap();
        assert_eq!((read.theme.as_str(), read.lesson, read.heights.tree), ("dark", Some(300.0), Some(200.0)));
        assert_eq!(Remembered::read(&std::fs::read_to_string(&file).unwrap()).heights, kept.heights);
        assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 1, "no half-written file is left");
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn a_broken_file_does_no_harm() {
        for broken in ["", "{", "\u{0}\u{1}", "zoom = \"large\"", "zoom = nan", "lesson = -5.0", "walk = inf"] {
            assert_eq!(Remembered::read(broken), Remembered::default(), "{broken}");
        }
        let read = Remembered::read("zoom = 1e9\nlesson = 300.0\n[heights]\ntree = nan\nstack = 90.0");
        assert_eq!((read.zoom, read.lesson, read.heights.tree), (3.0, Some(300.0), None));
        assert_eq!(read.heights.stack, Some(90.0), "what makes sense is kept");
    }
}
