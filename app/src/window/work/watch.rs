//! Lessons in a folder, read again when they have been saved and nobody writes any more.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::time::{Duration, Instant, SystemTime};

use raystep_lesson::Library;
use raystep_scene::{SCENE_ENDINGS, Scenes};

use crate::texts::proofread;

/// How often the folder is looked at. A look asks for the sizes and times of some sixty files; it needs nothing of
/// the system that could be refused, and it does not mind when the folder is moved away and made anew.
const BETWEEN_LOOKS: Duration = Duration::from_millis(75);

/// So long nothing may change before files are taken for whole.
const QUIET: Duration = Duration::from_millis(150);

/// So long at least is waited between two looks that must be alike.
const MOMENT: Duration = Duration::from_millis(25);

/// So long an empty file is waited for: some programs empty a file well before they write it.
const EMPTY: Duration = Duration::from_secs(2);

/// Who never stops writing is read now and then all the same.
const LONGEST: Duration = Duration::from_secs(5);

/// The most files that are looked at, and how deep they may lie.
const MOST: (usize, usize) = (20_000, 8);

/// A folder that is looked at until this is dropped.
pub(super) struct Watch {
    _go_on: Sender<()>,
}

impl Watch {
    /// Looks at a folder from a thread of its own. `tell` gets the lessons each time they have changed, or a
    /// sentence why they cannot be read.
    pub(super) fn begin(
        folder: &Path,
        only: bool,
        tell: impl FnMut(Result<Library, String>) + Send + 'static,
    ) -> Watch {
        let (_go_on, gone) = channel();
        let (folder, seen) = (folder.to_path_buf(), look(folder));
        let reader = Reader { folder, only, known: Scenes::default() };
        std::thread::spawn(move || watch(reader, seen, &gone, tell));
        Watch { _go_on }
    }
}

/// Files with their sizes and times; nothing if there is no folder.
type Seen = Option<BTreeMap<PathBuf, (u64, Option<SystemTime>)>>;

/// Who reads the lessons.
struct Reader {
    folder: PathBuf,
    /// Whether the lecture is left out.
    only: bool,
    /// The scenes that were read last.
    known: Scenes,
}

fn watch(
    mut reader: Reader,
    mut seen: Seen,
    gone: &Receiver<()>,
    mut tell: impl FnMut(Result<Library, String>) + Send + 'static,
) {
    while gone.recv_timeout(BETWEEN_LOOKS) == Err(RecvTimeoutError::Timeout) {
        if look(&reader.folder) == seen {
            continue;
        }
        let (now, lessons) = quiet(&mut reader, &seen);
        seen = now;
        tell(lessons);
    }
}

/// Waits until nobody writes, and reads.
fn quiet(reader: &mut Reader, before: &Seen) -> (Seen, Result<Library, String>) {
    let begun = Instant::now();
    let mut now = look(&reader.folder);
    let mut known = before.clone();
    loop {
        std::thread::sleep(still(&now, &known));
        let waited = begun.elapsed();
        let patient = is_emptied(&now, before) && waited < EMPTY;
        let next = look(&reader.folder);
        if waited < LONGEST && (patient || next != now) {
            (known, now) = (now, next);
            continue;
        }
        let lessons = reader.read(&next);
        let after = look(&reader.folder);
        // Who wrote while it was read has perhaps not finished.
        if after == next || begun.elapsed() >= LONGEST {
            return (next, lessons);
        }
        (known, now) = (now, after);
    }
}

/// How long nothing must change any more: what was written a while ago has been quiet since.
fn still(now: &Seen, before: &Seen) -> Duration {
    let (Some(now), Some(before)) = (now, before) else { return QUIET };
    if now == before || before.keys().any(|file| !now.contains_key(file)) {
        return QUIET;
    }
    let fresh = now.iter().filter(|(file, known)| before.get(*file) != Some(known));
    let Some(last) = fresh.filter_map(|(_, (_, written))| *written).max() else { return QUIET };
    let since = SystemTime::now().duration_since(last).unwrap_or_default();
    QUIET.saturating_sub(since).max(MOMENT)
}

impl Reader {
    fn read(&mut self, seen: &Seen) -> Result<Library, String> {
        if seen.is_none() {
            return Err(format!("{} is not there any more: the lessons stay as they were.", self.folder.display()));
        }
        let own = Library::from_dir_knowing(&self.folder, &self.known);
        let own = own.map_err(|error| format!("The lessons cannot be read: {error}."))?;
        let own = proofread(own);
        self.known = own.scenes.clone();
        Ok(if self.only { own } else { Library::embedded().and(own) })
    }
}

/// Whether there is less than before: no folder, a file gone, or one with nothing in it.
fn is_emptied(now: &Seen, before: &Seen) -> bool {
    let Some(before) = before else { return false };
    let Some(now) = now else { return true };
    before.iter().any(|(file, (size, _))| *size > 0 && now.get(file).is_none_or(|(size, _)| *size == 0))
}

/// Whether a file may be a part of lessons.
fn is_wanted(path: &Path) -> bool {
    let endings = ["md", "txt"].into_iter().chain(SCENE_ENDINGS);
    path.extension().is_some_and(|own| endings.into_iter().any(|ending| own.eq_ignore_ascii_case(ending)))
}

fn look(folder: &Path) -> Seen {
    let mut seen = BTreeMap::new();
    let mut folders = vec![(folder.to_path_buf(), 0)];
    while let Some((next, depth)) = folders.pop() {
        let entries = match std::fs::read_dir(&next) {
            Ok(entries) => entries,
            Err(_) if depth == 0 => return None,
            Err(_) => continue,
        };
        for path in entries.filter_map(|entry| Some(entry.ok()?.path())) {
            let Ok(known) = std::fs::metadata(&path) else { continue };
            if known.is_dir() && depth < MOST.1 {
                folders.push((path, depth + 1));
            } else if known.is_file() && is_wanted(&path) {
                seen.insert(path, (known.len(), known.modified().ok()));
            }
            if seen.len() >= MOST.0 {
                return Some(seen);
            }
        }
    }
    Some(seen)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SLIDE: &str = include_str!("../../../../lessons/05-kd-tree/33-which-child-first.md");
    const LISTING: &str = include_str!("../../../../lessons/listings/kd-walk.txt");

    /// Lessons of one slide in a new folder.
    fn lessons(folder: &Path) {
        for (path, text) in [("05-kd-tree/33-a.md", SLIDE), ("listings/kd-walk.txt", LISTING)] {
            let path = folder.join(path);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        }
    }

    /// Waits for lessons whose slide has this title. What is told before must be good, too.
    fn until(told: &Receiver<Result<Library, String>>, title: &str, what: &str) {
        loop {
            let lessons =
                told.recv_timeout(Duration::from_secs(60)).unwrap_or_else(|_| panic!("{what}: nothing is told"));
            let lessons = lessons.unwrap_or_else(|sentence| panic!("{what}: {sentence}"));
            assert!(lessons.problems.is_empty(), "{what}: {:?}", lessons.problems);
            assert_eq!(lessons.slides.len(), 1, "{what}: the slide is gone");
            if lessons.slides[0].title == title {
                return;
            }
        }
    }

    #[test]
    fn however_a_slide_is_saved_only_whole_ones_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let lessons_folder = folder.path().join("lessons");
        lessons(&lessons_folder);
        let (sender, told) = channel();
        let _watch = Watch::begin(&lessons_folder, true, move |lessons| _ = sender.send(lessons));
        let slide = lessons_folder.join("05-kd-tree/33-a.md");
        let mut saves = 0;
        let mut check = |what: &str, save: &dyn Fn(&str)| {
            saves += 1;
            let title = format!("Saved {saves} times");
            save(&SLIDE.replace("Which child first?", &title));
            until(&told, &title, what);
        };
        let pause = |millis| std::thread::sleep(Duration::from_millis(millis));
        check("written", &|text| std::fs::write(&slide, text).unwrap());
        for millis in [1, 30, 120, 400, 900] {
            check("emptied, then written", &|text| {
                std::fs::write(&slide, "").unwrap();
                pause(millis);
                std::fs::write(&slide, text).unwrap();
            });
        }
        check("written piece by piece", &|text| {
            use std::io::Write;
            let mut file = std::fs::File::create(&slide).unwrap();
            for piece in text.as_bytes().chunks(text.len() / 12) {
                file.write_all(piece).unwrap();
                pause(40);
            }
        });
        check("renamed over it", &|text| {
            let fresh = slide.with_extension("new");
            std::fs::write(&fresh, text).unwrap();
            std::fs::rename(&fresh, &slide).unwrap();
        });
        check("moved away, then written", &|text| {
            std::fs::rename(&slide, slide.with_extension("md~")).unwrap();
            pause(300);
            std::fs::write(&slide, text).unwrap();
        });
        check("the folder made anew", &|text| {
            std::fs::remove_dir_all(&lessons_folder).unwrap();
            pause(300);
            lessons(&lessons_folder);
            std::fs::write(&slide, text).unwrap();
        });
        check("the folder made anew at once", &|text| {
            std::fs::rename(&lessons_folder, folder.path().join("before")).unwrap();
            lessons(&lessons_folder);
            std::fs::write(&slide, text).unwrap();
        });
        check("written after that", &|text| std::fs::write(&slide, text).unwrap());
        std::fs::remove_dir_all(&lessons_folder).unwrap();
        let gone = told.recv_timeout(Duration::from_secs(60)).unwrap();
        assert!(gone.is_err_and(|sentence| sentence.contains("is not there any more")));
        lessons(&lessons_folder);
        until(&told, "Which child first?", "there again");
    }
}
