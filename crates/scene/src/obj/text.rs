//! Bytes to lines: encodings, line ends and continuations.

use std::borrow::Cow;

use crate::SceneError;

/// A logical line: physical lines that `\` joins are one.
pub(super) struct Line<'a> {
    /// The number of its first physical line, from 1.
    number: usize,
    pub(super) text: Cow<'a, str>,
    /// Where in the text the other physical lines begin.
    joints: Vec<usize>,
}

impl Line<'_> {
    /// A mistake at `word`, a part of the line's text; at its beginning if `word` is not.
    pub(super) fn wrong(&self, file: &str, word: &str, message: impl Into<String>) -> SceneError {
        let byte = word.as_ptr().addr().wrapping_sub(self.text.as_ptr().addr());
        let byte = if byte < self.text.len() { byte } else { 0 };
        let joined = self.joints.partition_point(|joint| *joint <= byte);
        let begin = joined.checked_sub(1).map_or(0, |last| self.joints[last]);
        let column = self.text.get(begin..byte).map_or(1, |before| before.chars().count() + 1);
        SceneError { file: file.to_owned(), line: self.number + joined, column, message: message.into() }
    }

    /// The number of its first physical line, from 1.
    pub(super) fn number(&self) -> usize {
        self.number
    }
}

/// The text of a file, lines ending in `\n`; says in `notes` what it had to change.
pub(super) fn decode<'a>(bytes: &'a [u8], file: &str, notes: &mut Vec<String>) -> Result<Cow<'a, str>, SceneError> {
    if bytes.is_empty() {
        return Err(whole_file(file, "the file is empty; an OBJ file holds `v` and `f` lines"));
    }
    let mut text: Cow<'a, str> = match bytes {
        [0xEF, 0xBB, 0xBF, rest @ ..] => {
            notes.push("byte order mark skipped".to_owned());
            String::from_utf8_lossy(rest)
        }
        [0xFF, 0xFE, rest @ ..] => utf16(rest, u16::from_le_bytes, notes),
        [0xFE, 0xFF, rest @ ..] => utf16(rest, u16::from_be_bytes, notes),
        _ => match std::str::from_utf8(bytes) {
            Ok(text) => Cow::Borrowed(text),
            Err(_) => {
                notes.push("not UTF-8, read as Latin-1".to_owned());
                Cow::Owned(bytes.iter().map(|&byte| char::from(byte)).collect())
            }
        },
    };
    // Old programs mark the end of a text by Ctrl-Z or fill it up with zeros.
    let padding = |c: char| c == '\u{1A}' || c == '\0';
    let end = text.trim_end_matches(|c: char| padding(c) || c.is_whitespace()).len();
    if text[end..].contains(padding) {
        notes.push("Ctrl-Z or zeros at the end left out".to_owned());
        text = match text {
            Cow::Borrowed(text) => Cow::Borrowed(&text[..end]),
            Cow::Owned(mut text) => {
                text.truncate(end);
                Cow::Owned(text)
            }
        };
    }
    let lone_returns = text.matches('\r').count() - text.matches("\r\n").count();
    if lone_returns > 0 {
        notes.push("lines end in a carriage return only".to_owned());
        return Ok(Cow::Owned(text.replace("\r\n", "\n").replace('\r', "\n")));
    }
    Ok(text)
}

fn utf16(bytes: &[u8], unit: impl Fn([u8; 2]) -> u16, notes: &mut Vec<String>) -> Cow<'static, str> {
    notes.push("read as UTF-16".to_owned());
    let units: Vec<u16> = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]])).collect();
    Cow::Owned(String::from_utf16_lossy(&units))
}

/// What shows that a file is no text, if it holds such a thing.
pub(super) fn not_text(file: &str, text: &str) -> Option<SceneError> {
    let (at, found) = text.char_indices().find(|&(_, c)| c.is_ascii_control() && !c.is_ascii_whitespace())?;
    let code = u32::from(found);
    let message = format!("found the byte or character {code:#04x}: this is not text, so not an OBJ file");
    Some(SceneError::at_byte(file, text, at, message))
}

/// The logical lines of `text`, comments removed.
pub(super) fn lines(text: &str) -> impl Iterator<Item = Line<'_>> {
    let mut physical = text.lines().enumerate();
    std::iter::from_fn(move || {
        let (i, first) = physical.next()?;
        let (mut line, mut joints) = (Cow::Borrowed(without_comment(first)), Vec::new());
        while let Some(part) = line.trim_end().strip_suffix('\\') {
            let end = part.len();
            let next = physical.next().map_or("", |(_, next)| without_comment(next));
            let line = line.to_mut();
            line.truncate(end);
            line.push(' ');
            joints.push(line.len());
            line.push_str(next);
        }
        Some(Line { number: i + 1, text: line, joints })
    })
}

/// A comment begins where a word could begin: the `#` in `-1.#IND` is a part of that word.
fn without_comment(line: &str) -> &str {
    let begins = |at: &usize| line[..*at].chars().next_back().is_none_or(char::is_whitespace);
    let comment = line.match_indices('#').map(|(at, _)| at).find(begins);
    comment.map_or(line, |at| &line[..at])
}

/// A mistake that no single line has.
pub(super) fn whole_file(file: &str, message: impl Into<String>) -> SceneError {
    SceneError { file: file.to_owned(), line: 1, column: 1, message: message.into() }
}

/// `1 face`, `2 faces`.
pub(super) fn count(n: usize, noun: &str) -> String {
    match noun {
        _ if n == 1 => format!("1 {noun}"),
        "vertex" => format!("{n} vertices"),
        _ => format!("{n} {noun}s"),
    }
}

/// A word as sentences show it: not too long, and without anything that is no sign.
pub(super) fn shown(word: &str) -> String {
    const MOST: usize = 32;
    let sign = |c: char| if c.is_control() || c == '`' { char::REPLACEMENT_CHARACTER } else { c };
    let end = if word.chars().nth(MOST).is_some() { "…" } else { "" };
    format!("`{}{end}`", word.chars().take(MOST).map(sign).collect::<String>())
}
