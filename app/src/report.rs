//! What is left when something breaks that never should: a report in a file, and a sentence that says where.

use std::any::Any;
use std::backtrace::Backtrace;
use std::fmt::Write;
use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind, set_hook};
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{SystemTime, UNIX_EPOCH};

use crate::files;
use crate::folders;

/// So many reports are written by one run; what goes on breaking says the same again.
const MOST: usize = 3;

static WRITTEN: AtomicUsize = AtomicUsize::new(0);

/// What was said last.
static SAID: Mutex<Option<String>> = Mutex::new(None);

/// From now on a panic, in whatever thread, writes a report and says so.
pub(crate) fn prepare() {
    set_hook(Box::new(told));
}

/// Does some work. If it breaks, that is a sentence to be shown.
pub(crate) fn guarded<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(work)).map_err(|panic| {
        let said = SAID.lock().unwrap_or_else(PoisonError::into_inner).clone();
        said.unwrap_or_else(|| format!("This should never happen: {}.", message(&*panic)))
    })
}

/// Writes a report of something that went wrong without an end of anything, says so, and returns the sentence.
pub(crate) fn file(what: &str, details: &str) -> String {
    let sentence = with_report(format!("{what}."), details, "");
    files::say(&sentence);
    capital(&sentence)
}

fn told(panic: &PanicHookInfo<'_>) {
    let message = message(panic.payload());
    let place = panic.location().map_or_else(String::new, |at| format!(" ({}:{})", at.file(), at.line()));
    let sentence = with_report(format!("this should never happen: {message}{place}."), &message, &place);
    files::say(&sentence);
    if let Ok(mut said) = SAID.try_lock() {
        *said = Some(capital(&sentence));
    }
}

/// The sentence with where its report is, if there are not enough of them.
fn with_report(mut sentence: String, what: &str, place: &str) -> String {
    if WRITTEN.fetch_add(1, Ordering::Relaxed) < MOST {
        let text = text(what, place);
        match write(&text) {
            Some(path) => _ = write!(sentence, " A report is in {}.", path.display()),
            None => _ = write!(sentence, " No report could be written; this is it:\n{text}"),
        }
    }
    sentence
}

fn capital(sentence: &str) -> String {
    let mut letters = sentence.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// What a panic says.
fn message(payload: &dyn Any) -> String {
    let text = payload.downcast_ref::<&str>().map(|text| (*text).to_owned());
    let text = text.or_else(|| payload.downcast_ref::<String>().cloned());
    text.unwrap_or_else(|| "no reason is given".to_owned())
}

fn text(message: &str, place: &str) -> String {
    let called: Vec<String> = std::env::args().collect();
    let thread = std::thread::current();
    format!(
        "In Raystep {} something went wrong that never should. Please send this to whoever mends it.\n\n\
         what: {message}{place}\nthread: {}\ncalled: {}\nsystem: {} {}\n\n{}\n",
        env!("CARGO_PKG_VERSION"),
        thread.name().unwrap_or("without a name"),
        called.join(" "),
        std::env::consts::OS,
        std::env::consts::ARCH,
        Backtrace::force_capture()
    )
}

/// Writes a report where reports lie, or where there is room for files that nobody misses.
fn write(text: &str) -> Option<PathBuf> {
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
    let folders = [folders::state(), Some(std::env::temp_dir())];
    folders.into_iter().flatten().find_map(|folder| {
        std::fs::create_dir_all(&folder).ok()?;
        let mut names = (0..100).map(|n| folder.join(format!("report-{seconds}-{}-{n}.txt", std::process::id())));
        names.find_map(|path| {
            let mut file = std::fs::File::create_new(&path).ok()?;
            std::io::Write::write_all(&mut file, text.as_bytes()).ok()?;
            Some(path)
        })
    })
}

#[cfg(test)]
mod tests {
    use std::process::Command;

    use super::*;

    /// Not a test: what the test below lets happen in a program of its own.
    #[test]
    #[ignore = "breaks off"]
    fn breaks_off() {
        prepare();
        let beside = std::thread::spawn(|| guarded(|| panic!("a corner is missing")));
        let sentence: Result<(), String> = beside.join().unwrap();
        files::say(&format!("told: {}", sentence.unwrap_err()));
        for _ in 0..10 {
            let _ = guarded(|| Vec::<u32>::new()[std::hint::black_box(3)]);
        }
        panic!("and this is the end");
    }

    #[test]
    fn a_panic_anywhere_leaves_a_report_and_a_sentence() {
        let folder = tempfile::tempdir().unwrap();
        let output = Command::new(std::env::current_exe().unwrap())
            .args(["--exact", "report::tests::breaks_off", "--ignored", "--nocapture"])
            .env("XDG_STATE_HOME", folder.path())
            .env("HOME", folder.path())
            .env("LOCALAPPDATA", folder.path())
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!output.status.success(), "{said}");
        let mut reports: Vec<PathBuf> = Vec::new();
        let mut folders = vec![folder.path().to_path_buf()];
        while let Some(next) = folders.pop() {
            for path in std::fs::read_dir(next).unwrap().map(|entry| entry.unwrap().path()) {
                let name = path.file_name().unwrap().to_string_lossy().into_owned();
                if path.is_dir() {
                    folders.push(path);
                } else if name.starts_with("report-") {
                    reports.push(path);
                }
            }
        }
        assert_eq!(reports.len(), MOST, "what goes on breaking fills no disk: {said}");
        let texts: Vec<String> = reports.iter().map(|path| std::fs::read_to_string(path).unwrap()).collect();
        let first = texts.iter().position(|text| text.contains("what: a corner is missing (app/src/report.rs:"));
        let first = first.unwrap_or_else(|| panic!("{texts:?}"));
        assert!(texts[first].contains("breaks_off"), "{}", texts[first]);
        let says = "raystep: this should never happen: a corner is missing (app/src/report.rs:";
        assert!(said.contains(says), "{said}");
        assert!(said.contains(&format!("A report is in {}.", reports[first].display())), "{said}");
        assert!(said.contains("told: This should never happen: a corner is missing"), "{said}");
        assert!(said.contains("and this is the end"), "{said}");
    }
}
