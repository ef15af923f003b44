//! What is wrong in a file, as a sentence to whoever can mend it.

use std::borrow::Cow;

use thiserror::Error;

/// A mistake in a scene or mesh file: where it is, what was found, what is allowed.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{file}:{line}:{column}: {}", sentence(message))]
pub struct SceneError {
    /// The file's name, as it was given.
    pub file: String,
    /// The line, from 1.
    pub line: usize,
    /// The column in characters, from 1.
    pub column: usize,
    /// What was found and what is allowed.
    pub message: String,
}

impl SceneError {
    /// What was found and what is allowed, without a word that would bury the rest.
    pub fn sentence(&self) -> Cow<'_, str> {
        sentence(&self.message)
    }

    /// A mistake at a byte of `text`.
    pub(crate) fn at_byte(file: &str, text: &str, byte: usize, message: impl Into<String>) -> SceneError {
        let before = text.get(..byte).unwrap_or(text);
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        SceneError {
            file: file.to_owned(),
            line: before.matches('\n').count() + 1,
            column: before[line_start..].chars().count() + 1,
            message: message.into(),
        }
    }
}

/// The letters of a word that are quoted, at most.
const LONGEST_WORD: usize = 60;

/// A message in which no word is so long that it buries the rest.
fn sentence(message: &str) -> Cow<'_, str> {
    if message.split(' ').all(|word| word.chars().count() <= 2 * LONGEST_WORD) {
        return Cow::Borrowed(message);
    }
    let short = |word: &str| match word.char_indices().nth(LONGEST_WORD) {
        Some((end, _)) => {
            let marks = word[end..].trim_end_matches(['`', '"', ';', ':', ',', '.']).len();
            format!("{}…{}", &word[..end], &word[end + marks..])
        }
        None => word.to_owned(),
    };
    Cow::Owned(message.split(' ').map(short).collect::<Vec<_>>().join(" "))
}

/// The allowed spelling closest to `found`, if one is close enough to be meant.
pub(crate) fn nearest<'a>(found: &str, allowed: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    // Longer words are no misspellings of anything.
    if found.len() > 200 {
        return None;
    }
    let alike = |word: &&str| strsim::damerau_levenshtein(found, word);
    allowed
        .into_iter()
        // Of two that are as near, the one that begins so.
        .min_by_key(|word| (alike(word), !word.starts_with(found)))
        .filter(|word| alike(word) <= (found.chars().count() / 2).max(1) || word.starts_with(found))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_word_does_not_bury_the_sentence() {
        let wrong = SceneError::at_byte("mesh.obj", "v", 0, format!("`{}` is not a number; so", "1".repeat(9000)));
        assert_eq!(wrong.to_string(), format!("mesh.obj:1:1: `{}…` is not a number; so", "1".repeat(59)));
        assert_eq!(sentence("`1x` is not a number"), "`1x` is not a number");
    }
}
