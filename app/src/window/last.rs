//! Where the window stands, kept in a file while it is open: the next time, also after a crash, it opens there again.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use raystep_lesson::Library;
use toml::{Table, Value};

use crate::fault::Fault;
use crate::shown::Link;
use crate::{fields, files};

/// Where a window stands.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Last {
    /// How often it was opened here and ended before it had stood for a while.
    ended: u32,
    /// The folder of the lessons, if they are not those in the program.
    lessons: Option<String>,
    /// The place, as it is copied and pasted.
    pub(super) link: Link,
}

/// Nobody opens a window more often.
const MOST_ENDED: i64 = 1 << 20;

impl Last {
    /// A window that stands at this place, in the lessons of this folder.
    pub(super) fn of(link: Link, lessons: Option<&Path>) -> Last {
        Last { ended: 0, lessons: lessons.and_then(named), link }
    }

    /// What a text says, and a sentence for whatever of it makes no sense.
    pub fn read(text: &str) -> (Last, Vec<String>) {
        let mut read = Last::default();
        let wrong = fields::read(text, |key, spelt| read.set(key, spelt));
        (read, wrong)
    }

    /// What the file says.
    pub fn text(&self) -> String {
        let mut table = Table::new();
        let mut add = |key: &str, value: Option<Value>| _ = value.map(|value| table.insert(key.to_owned(), value));
        add("ended", (self.ended > 0).then(|| i64::from(self.ended).into()));
        add("lessons", self.lessons.clone().map(Value::String));
        // Of a window that stood nowhere there is nothing to say.
        let link = Some(self.link.to_string()).filter(|link| !link.is_empty());
        add("link", link.map(Value::String));
        table.to_string()
    }

    /// Sets one field as it is spelt, or says what would be right.
    fn set(&mut self, key: &str, spelt: &str) -> Result<(), String> {
        let value = fields::value(spelt).ok_or("it cannot be read")?;
        let text = || value.as_str().map(str::to_owned).ok_or("a text is needed".to_owned());
        match key {
            "ended" => {
                let count = value.as_integer().filter(|count| (0..=MOST_ENDED).contains(count));
                self.ended = count.ok_or_else(|| format!("a number from 0 to {MOST_ENDED} is needed"))? as u32;
            }
            "lessons" => self.lessons = Some(text()?),
            "link" => {
                let (link, wrong) = Link::read(&text()?);
                // What is set on no slide is set nowhere.
                self.link = if link.slide.is_empty() { Link::default() } else { link };
                if !wrong.is_empty() {
                    return Err(wrong.join("; "));
                }
            }
            _ => return Err("nothing of that name is kept".to_owned()),
        }
        Ok(())
    }

    /// Where it stood, for whoever asks: `"5/34 Inner node, inner node, leaf, step 13"`; nothing where that is gone.
    pub fn place(&self, library: &Library) -> Option<String> {
        let slide = library.slide(&self.link.slide)?;
        let on = if self.link.mesh.is_some() { ", on your own mesh" } else { "" };
        let before = if self.link.present { ", before a class" } else { "" };
        Some(format!("{} {}, step {}{on}{before}", slide.id(), slide.title, self.link.step.unwrap_or(0)))
    }

    /// Whether these are its lessons.
    pub(super) fn is_of(&self, lessons: Option<&Path>) -> bool {
        self.lessons == lessons.and_then(named)
    }
}

/// A path by which it is found from everywhere; none that cannot be written down.
pub(super) fn named(path: &Path) -> Option<String> {
    std::path::absolute(path).ok()?.to_str().map(str::to_owned)
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
    /// Whether the file could not be written the last time.
    refused: bool,
    /// Why, until somebody has said so.
    wrong: Option<Fault>,
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
        Keeper { file, kept: None, written: None, opened: Instant::now(), ended: 0, refused: false, wrong: None }
    }

    /// The file.
    pub(super) fn file(self) -> PathBuf {
        self.file
    }

    /// The same, and what stands in the file: the window can go on there.
    pub(super) fn reopening(file: PathBuf) -> (Keeper, Found) {
        let keeper = Keeper::new(file);
        let Ok(bytes) = std::fs::read(&keeper.file) else { return (keeper, Found { last: None, wrong: Vec::new() }) };
        let (last, wrong) = Last::read(&String::from_utf8_lossy(&bytes));
        let mut wrong: Vec<String> =
            wrong.into_iter().map(|wrong| format!("{}:{wrong}", keeper.file.display())).collect();
        if last.ended >= TRIES {
            let Link { slide, step, .. } = &last.link;
            let step = step.unwrap_or(0);
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

    /// Why the place cannot be kept, the first time that it cannot.
    pub(super) fn complaint(&mut self) -> Option<Fault> {
        self.wrong.take()
    }

    /// What cannot be written is not remembered; nothing else is lost.
    fn put(&mut self, now: Last) {
        let written = files::renew(&self.file, &now.text());
        if !std::mem::replace(&mut self.refused, written.is_err()) {
            self.wrong = written.err();
        }
        self.kept = Some(now);
        self.written = Some(Instant::now());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GOOD: &str = "link = \"5/33?stage=solid&ray=both%20children&step=7&set=max_depth:3&present=yes\"\n";

    fn step_of(last: &Last) -> Option<usize> {
        last.link.step
    }

    fn at(step: usize) -> Last {
        let good = Last::read(GOOD).0;
        Last { link: Link { step: Some(step), ..good.link.clone() }, ..good }
    }

    #[test]
    fn what_is_kept_is_read_again() {
        let (good, wrong) = Last::read(GOOD);
        assert_eq!((step_of(&good), wrong), (Some(7), Vec::<String>::new()));
        let check = |last: Last| assert_eq!(Last::read(&last.text()), (last, Vec::new()));
        check(good.clone());
        check(Last { lessons: Some("/a/\"b\" ü".to_owned()), ended: 1, ..good });
    }

    #[test]
    fn a_bad_field_loses_only_itself() {
        let (good, _) = Last::read(GOOD);
        let check = |line: &str, says: &str| {
            let (read, wrong) = Last::read(&format!("{line}\n{GOOD}"));
            assert_eq!(read, good, "{line}");
            assert!(wrong.len() == 1 && wrong[0].starts_with(&format!("1: {says}")), "{line}: {wrong:?}");
        };
        check("ended = -1", "ended = -1: a number from 0 to 1048576 is needed");
        check("lesons = \"a\"", "lesons = \"a\": nothing of that name is kept");
        check("lessons = 3", "lessons = 3: a text is needed; it is left out");
        check("zoom =", "");
        let (read, wrong) = Last::read("link = \"%A3?step=7\"\n");
        assert_eq!((Last::read(&read.text()), wrong.len()), ((Last::default(), Vec::new()), 1), "{wrong:?}");
        let (read, wrong) = Last::read("link = \"5/33?step=x&grain=visit\"\n");
        assert_eq!((read.link.step, read.link.grain), (None, raystep_accel::Grain::Visit));
        assert!(wrong.len() == 1 && wrong[0].contains("step=x: a whole number"), "{wrong:?}");
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
            assert_eq!((found.last.as_ref().and_then(step_of), found.wrong.len()), (Some(7), 0));
            keeper.goes_on(&found.last.unwrap());
        }
        let (_, found) = Keeper::reopening(file.clone());
        assert!(found.last.is_none() && found.wrong[0].contains("at step 7 of slide 5/33"), "{:?}", found.wrong);

        // One that has stood for a while, or was closed, is opened again.
        let (mut keeper, _) = Keeper::reopening(file.clone());
        // Looking at it alone is no try.
        let (_, again) = Keeper::reopening(file.clone());
        assert_eq!(again.wrong.len(), 1);
        keeper.close(at(9));
        let (_, found) = Keeper::reopening(file);
        assert_eq!(found.last.as_ref().and_then(step_of), Some(9));
    }

    #[test]
    fn the_file_is_written_now_and_then() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("last.toml");
        let (mut keeper, _) = Keeper::reopening(file.clone());
        let step = || step_of(&Last::read(&std::fs::read_to_string(&file).unwrap()).0);
        assert_eq!((keeper.keep(at(1)), step()), (None, Some(1)));
        for next in 2..100 {
            assert!(keeper.keep(at(next)).is_some_and(|waits| waits <= BETWEEN));
        }
        assert_eq!(step(), Some(1));
        std::thread::sleep(BETWEEN);
        assert_eq!((keeper.keep(at(100)), step()), (None, Some(100)));
        assert_eq!((keeper.keep(at(100)), step()), (None, Some(100)));
    }
}
