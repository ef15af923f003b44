//! What the user can mend: a sentence.

use std::fmt;

/// Why a command could not do what it was asked: a sentence that says what to do. Exit code 2.
#[derive(Debug)]
pub struct Fault(String);

impl Fault {
    /// The sentence.
    pub fn new(sentence: impl Into<String>) -> Fault {
        Fault(sentence.into())
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Fault {}

/// Names the file that could not be read or written, and why.
pub(crate) fn about(path: &std::path::Path) -> impl FnOnce(std::io::Error) -> Fault + '_ {
    move |error| Fault::new(format!("{}: {}", path.display(), raystep_lesson::why(&error)))
}
