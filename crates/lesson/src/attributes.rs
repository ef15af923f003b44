//! `{at=split.both ray="both children"}` at the end of a heading or behind `ask`.

use crate::reading::Reading;

/// One `key=value`, each with the byte where it stands.
pub(crate) struct Attribute {
    pub(crate) key: String,
    pub(crate) key_at: usize,
    pub(crate) value: String,
    pub(crate) value_at: usize,
}

/// Reads what stands between the braces, unless something is wrong there; `at` is its first byte.
pub(crate) fn read(text: &str, at: usize, reading: &mut Reading<'_>) -> Option<Vec<Attribute>> {
    let mut attributes = Vec::new();
    let mut rest = text;
    loop {
        rest = rest.trim_start();
        if rest.is_empty() {
            return Some(attributes);
        }
        let key_at = at + text.len() - rest.len();
        let Some((key, after)) = rest.split_once('=').filter(|(key, _)| !key.contains(char::is_whitespace)) else {
            let word = rest.split_whitespace().next().unwrap_or_default();
            reading.problem(key_at, format!("`{word}` needs a value: write `key=value`, or `key=\"two words\"`"));
            return None;
        };
        let value_at = key_at + key.len() + 1;
        let (value, value_at, after) = match after.strip_prefix('"') {
            Some(quoted) => match quoted.split_once('"') {
                Some((value, after)) => (value, value_at + 1, after),
                None => {
                    reading.problem(value_at, "the quotation mark is not closed");
                    return None;
                }
            },
            None => {
                let end = after.find(char::is_whitespace).unwrap_or(after.len());
                (&after[..end], value_at, &after[end..])
            }
        };
        attributes.push(Attribute { key: key.to_owned(), key_at, value: value.to_owned(), value_at });
        rest = after;
    }
}
