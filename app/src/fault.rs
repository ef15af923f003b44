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
    move |error| Fault::new(format!("{}: {}", path.display(), why(&error)))
}

/// Why it could not be read or written, in words where there are some.
pub(crate) fn why(error: &std::io::Error) -> String {
    use std::io::ErrorKind;
    let words = match error.kind() {
        ErrorKind::NotFound => "there is no such file or folder",
        ErrorKind::PermissionDenied => "you are not allowed to",
        ErrorKind::StorageFull => "the disk is full",
        ErrorKind::QuotaExceeded => "your share of the disk is used up",
        ErrorKind::ReadOnlyFilesystem => "nothing can be written to this disk",
        ErrorKind::IsADirectory => "it is a folder; a file is needed",
        ErrorKind::NotADirectory => "a part of its path is no folder",
        ErrorKind::FileTooLarge => "this disk takes no file that large",
        ErrorKind::InvalidData => "it is no text in UTF-8",
        _ => return error.to_string(),
    };
    words.to_owned()
}
