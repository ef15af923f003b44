//! The folder of lessons on a disk. What cannot be read there is named and left out; the rest is read.

use std::fs::{File, Metadata};
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use raystep_scene::{SCENE_ENDINGS, Scenes};

use crate::library::wanted;
use crate::{Library, Problem, Spot, limits, why};

impl Library {
    /// The lessons in a folder. A file or folder in it that cannot be read, or that a link leads out of it to, is
    /// left out and named among the [`problems`](Library::problems); names that begin with a dot are passed over.
    ///
    /// # Errors
    /// When the folder itself cannot be read.
    pub fn from_dir(folder: &Path) -> io::Result<Library> {
        Library::from_dir_knowing(folder, &Scenes::default())
    }

    /// The same, but scenes that are `known` and have not changed are not read again.
    ///
    /// # Errors
    /// When the folder itself cannot be read.
    pub fn from_dir_knowing(folder: &Path, known: &Scenes) -> io::Result<Library> {
        let mut found = Found { root: folder.canonicalize()?, ..Found::default() };
        found.folder(folder, "")?;
        let mut library = Library::from_files(found.files).with_scenes(found.scenes, known);
        library.problems.extend(found.problems);
        Ok(library)
    }

    /// The text of one file of lessons.
    ///
    /// # Errors
    /// Why there is none: it cannot be read, is no plain file, is too large, or is no text.
    pub fn text_of(path: &Path) -> Result<String, Problem> {
        read(path, &path.display().to_string())
    }
}

/// What lies in a folder of lessons.
#[derive(Default)]
struct Found {
    /// The folder, wherever links to it lead.
    root: PathBuf,
    files: Vec<(String, String)>,
    scenes: Vec<(String, Vec<u8>)>,
    problems: Vec<Problem>,
    /// How many entries were looked at.
    seen: usize,
}

impl Found {
    /// Reads what lies in a folder; `inside` is its name within the folder of lessons, nothing for that itself.
    fn folder(&mut self, folder: &Path, inside: &str) -> io::Result<()> {
        let mut names = Vec::new();
        for name in std::fs::read_dir(folder)?.filter_map(|entry| Some(entry.ok()?.file_name())) {
            match name.into_string() {
                Ok(name) => names.push(name),
                Err(name) if wanted(Path::new(&name)) || has_lessons(&folder.join(&name)) => {
                    let shown = name.to_string_lossy();
                    let shown = if inside.is_empty() { shown.into_owned() } else { format!("{inside}/{shown}") };
                    self.leave_out(&shown, "its name is no text (UTF-8): rename it; it is left out");
                }
                // Of what is no lesson nobody asks.
                Err(_) => {}
            }
        }
        names.retain(|name| !name.starts_with('.'));
        names.sort();
        for name in names {
            self.seen += 1;
            if self.seen > limits::FILES {
                if self.seen == limits::FILES + 1 {
                    let most = limits::FILES;
                    self.leave_out(
                        inside,
                        &format!("the lessons have more than {most} files: this one and what follows is left out"),
                    );
                }
                return Ok(());
            }
            let path = folder.join(&name);
            let name = if inside.is_empty() { name } else { format!("{inside}/{name}") };
            self.entry(&path, &name, !inside.is_empty());
        }
        Ok(())
    }

    /// Reads what has this name; `deep` says that it lies in a section.
    fn entry(&mut self, path: &Path, name: &str, deep: bool) {
        let is_link = path.symlink_metadata().is_ok_and(|data| data.is_symlink());
        let data = match self.target(path, is_link) {
            Ok(data) => data,
            // Of what is no lesson nobody asks.
            Err(_) if !is_link && !wanted(path) && !is_scene(name) => return,
            Err(why) => return self.leave_out(name, &why),
        };
        if data.is_dir() {
            if is_link {
                self.leave_out(name, "a link to a folder is left out: put the folder itself here");
            } else if deep {
                if wanted(path) || has_lessons(path) {
                    self.leave_out(name, "slides lie in a section's folder, none deeper: this folder is left out");
                }
            } else if let Err(error) = self.folder(path, name) {
                self.leave_out(name, &format!("the folder cannot be read: {error}; it is left out"));
            }
        } else if is_scene(name) {
            match read_bytes(path, name, limits::SCENE, too_large_a_scene) {
                Ok(bytes) => self.scenes.push((name.to_owned(), bytes)),
                Err(problem) => self.problems.push(problem),
            }
        } else if wanted(path) && !name.starts_with(SCENES) {
            match read(path, name) {
                Ok(text) => self.files.push((name.to_owned(), text)),
                Err(problem) => {
                    let message = format!("{}; it is left out", problem.message);
                    self.problems.push(Problem { message, ..problem });
                }
            }
        }
    }

    /// What lies at a path, or behind the link there if that stays in the folder of lessons.
    fn target(&self, path: &Path, is_link: bool) -> Result<Metadata, String> {
        let wrong = |error: io::Error| format!("cannot be read: {}; it is left out", why(&error));
        if is_link {
            let target = path.canonicalize().map_err(|error| match error.kind() {
                io::ErrorKind::NotFound => "a link to nothing; it is left out".to_owned(),
                _ => format!("a link that leads nowhere: {}; it is left out", why(&error)),
            })?;
            if !target.starts_with(&self.root) {
                return Err("a link out of the folder of lessons; it is left out".to_owned());
            }
        }
        path.metadata().map_err(wrong)
    }

    fn leave_out(&mut self, name: &str, why: &str) {
        self.problems.push(Problem::new(name, Spot::START, why));
    }
}

/// Whether something in a folder looks like a slide.
fn has_lessons(folder: &Path) -> bool {
    let entries = std::fs::read_dir(folder).into_iter().flatten();
    entries.take(limits::FILES).any(|entry| entry.is_ok_and(|entry| wanted(&entry.path())))
}

/// The folder of scenes beside the sections.
const SCENES: &str = "scenes/";

/// Whether a name within the folder of lessons is a scene's.
fn is_scene(name: &str) -> bool {
    let ending = |name: &str| {
        Path::new(name).extension().is_some_and(|own| SCENE_ENDINGS.iter().any(|e| own.eq_ignore_ascii_case(e)))
    };
    name.strip_prefix(SCENES).is_some_and(ending)
}

fn too_large_a_scene(bytes: u64) -> String {
    format!("the file has {} MB: a scene beside lessons has at most {} MB", bytes >> 20, limits::SCENE >> 20)
}

/// The bytes of a plain file of at most so many, or why there are none.
fn read_bytes(path: &Path, name: &str, most: usize, too_large: fn(u64) -> String) -> Result<Vec<u8>, Problem> {
    let wrong = |why: String| Problem::new(name, Spot::START, why);
    let unread = |error: io::Error| wrong(format!("cannot be read: {}", why(&error)));
    // A pipe would never end, a device neither.
    let data = path.metadata().map_err(unread)?;
    if !data.is_file() {
        return Err(wrong("is no plain file".to_owned()));
    }
    let mut bytes = Vec::new();
    let room = most as u64 + 1;
    File::open(path).and_then(|file| file.take(room).read_to_end(&mut bytes)).map_err(unread)?;
    if bytes.len() > most {
        return Err(wrong(too_large(data.len().max(room))));
    }
    Ok(bytes)
}

/// The text of a plain file, or why there is none.
fn read(path: &Path, name: &str) -> Result<String, Problem> {
    let bytes = read_bytes(path, name, limits::BYTES, limits::too_large)?;
    String::from_utf8(bytes).map_err(|error| {
        let good = error.utf8_error().valid_up_to();
        let (before, after) = error.as_bytes().split_at(good);
        let before = String::from_utf8_lossy(before);
        let line = before.rsplit('\n').next().unwrap_or_default();
        let spot = Spot { line: 1 + before.matches('\n').count() as u32, column: 1 + line.chars().count() as u32 };
        Problem::new(name, spot, format!("the byte 0x{:02X} here is no text: save the file as UTF-8", after[0]))
    })
}
