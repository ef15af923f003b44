//! What is wrong in a lesson, said to whoever can mend it.

use std::fmt;

/// A line and a column of a file, both counted from 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Spot {
    /// The line.
    pub line: u32,
    /// The column, in characters.
    pub column: u32,
}

impl Spot {
    /// Where byte `offset` of `text` stands.
    pub fn of(text: &str, offset: usize) -> Spot {
        let before = text.get(..offset).unwrap_or(text);
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        Spot { line: 1 + before.matches('\n').count() as u32, column: 1 + before[line_start..].chars().count() as u32 }
    }
}

/// Something wrong in a lesson's file.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Problem {
    /// The file, as it was named when it was read.
    pub file: String,
    /// Its line, from 1.
    pub line: u32,
    /// The column in that line, in characters, from 1.
    pub column: u32,
    /// What was found, and what is allowed.
    pub message: String,
}

impl Problem {
    /// A problem at a spot of a file.
    pub fn new(file: &str, spot: Spot, message: impl Into<String>) -> Problem {
        Problem { file: file.to_owned(), line: spot.line, column: spot.column, message: message.into() }
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}: {}", self.file, self.line, self.column, self.message)
    }
}

impl std::error::Error for Problem {}
