//! Why a file could not be read or written.

use std::io::{Error, ErrorKind};

/// Why a file or folder could not be read or written, in words: what the user can mend, without numbers of the system's.
pub fn why(error: &Error) -> String {
    let words = match error.kind() {
        ErrorKind::NotFound => "there is no such file or folder",
        ErrorKind::PermissionDenied => "you are not allowed to",
        ErrorKind::StorageFull => "the disk is full",
        ErrorKind::QuotaExceeded => "your share of the disk is used up",
        ErrorKind::ReadOnlyFilesystem => "nothing can be written to this disk",
        ErrorKind::IsADirectory => "it is a folder; a file is needed",
        ErrorKind::NotADirectory => "a part of its path is no folder",
        ErrorKind::FileTooLarge => "no file may be that large here",
        ErrorKind::InvalidData => "it is no text in UTF-8",
        _ => return error.to_string().split(" (os error").next().unwrap_or_default().to_owned(),
    };
    words.to_owned()
}
