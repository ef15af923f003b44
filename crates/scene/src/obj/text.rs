//! Bytes to lines: encodings, line ends and continuations.

use std::borrow::Cow;

use crate::SceneError;

/// A logical line: physical lines that `\` joins are one.
pub(super) struct Line<'a> {
    /// The number of its first physical line, from 1.
    pub(super) number: usize,
    pub(super) text: Cow<'a, str>,
}

/// The text of a file, lines ending in `\n`; says in `notes` what it had to change.
pub(super) fn decode<'a>(bytes: &'a [u8], file: &str, notes: &mut Vec<String>) -> Result<Cow<'a, str>, SceneError> {
    if bytes.is_empty() {
        return Err(whole_file(file, "the file is empty; an OBJ file holds `v` and `f` lines"));
    }
    let text: Cow<'a, str> = match bytes {
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
    if let Some((at, found)) = text.char_indices().find(|&(_, c)| c.is_ascii_control() && !c.is_ascii_whitespace()) {
        let code = u32::from(found);
        let message = format!("found the byte or character {code:#04x}: this is not text, so not an OBJ file");
        return Err(SceneError::at_byte(file, &text, at, message));
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

/// The logical lines of `text`, comments removed.
pub(super) fn lines(text: &str) -> impl Iterator<Item = Line<'_>> {
    let mut physical = text.lines().enumerate();
    std::iter::from_fn(move || {
        let (i, first) = physical.next()?;
        let mut line = Cow::Borrowed(without_comment(first));
        while let Some(part) = line.trim_end().strip_suffix('\\') {
            let next = physical.next().map_or("", |(_, next)| without_comment(next));
            line = Cow::Owned(format!("{part} {next}"));
        }
        Some(Line { number: i + 1, text: line })
    })
}

fn without_comment(line: &str) -> &str {
    line.split('#').next().unwrap_or(line)
}

/// A mistake that no single line has.
pub(super) fn whole_file(file: &str, message: impl Into<String>) -> SceneError {
    SceneError { file: file.to_owned(), line: 1, column: 1, message: message.into() }
}

/// `1 face`, `2 faces`.
pub(super) fn count(n: usize, noun: &str) -> String {
    if n == 1 { format!("1 {noun}") } else { format!("{n} {noun}s") }
}
