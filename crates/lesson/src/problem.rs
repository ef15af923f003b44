//! What is wrong in a lesson, said to whoever can mend it.

use std::fmt;

/// A line and a column of a file, both counted from 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Spot {
    /// The line.
    pub line: u32,
    /// The column, in characters.
    pub column: u32,
}

impl Spot {
    /// Where a file begins.
    pub(crate) const START: Spot = Spot { line: 1, column: 1 };
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
        let mut message = message.into();
        // Whatever it quotes: it stays a sentence.
        if let Some((end, _)) = message.char_indices().nth(LONGEST_MESSAGE) {
            message.truncate(end);
            message.push('…');
        }
        Problem { file: file.to_owned(), line: spot.line, column: spot.column, message }
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}: {}", self.file, self.line, self.column, self.message)
    }
}

impl std::error::Error for Problem {}

/// The letters of a message, at most.
const LONGEST_MESSAGE: usize = 1500;

/// Longer words are no misspellings of anything.
const LONGEST_WORD: usize = 60;

/// The allowed spelling nearest to what was found; none if nothing is near.
pub(crate) fn nearest<'a>(found: &str, allowed: &[&'a str]) -> Option<&'a str> {
    let letters = found.chars().count();
    if letters > LONGEST_WORD {
        return None;
    }
    let limit = 2.max(letters / 2);
    let distances = allowed.iter().map(|word| (strsim::damerau_levenshtein(found, word), *word));
    distances.filter(|(distance, _)| *distance <= limit).min().map(|(_, word)| word)
}

/// "`split.bth` is no event of a walk: did you mean `split.both`?" or, with nothing near, all that is allowed.
pub(crate) fn misspelt(what: &str, found: &str, allowed: &[&str]) -> String {
    let near = nearest(found, allowed);
    let found = &short(found);
    match near {
        Some(word) => format!("`{found}` is no {what}: did you mean `{word}`?"),
        None if allowed.is_empty() => format!("`{found}` is no {what}: there are none here"),
        None => format!("`{found}` is no {what}: allowed are {}", listed(allowed)),
    }
}

/// What was found, as far as a sentence has room for it.
pub(crate) fn short(found: &str) -> String {
    match found.char_indices().nth(LONGEST_WORD) {
        Some((end, _)) => format!("{}…", &found[..end]),
        None => found.to_owned(),
    }
}

/// "`a`, `b`, `c`"
pub(crate) fn listed(words: &[&str]) -> String {
    words.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", ")
}
