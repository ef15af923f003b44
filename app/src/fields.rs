//! Small files of fields that the program keeps for itself, read field by field: one that makes no sense is left out,
//! and the others stay.

use toml::de::{DeTable, DeValue};
use toml::{Spanned, Table, Value};

/// Reads the fields of a text in TOML, those of inner tables as `outer.inner`. Each goes to `set` as it is spelt, and if
/// that refuses it, or a line cannot be read, there is a sentence with its line.
pub(crate) fn read(text: &str, mut set: impl FnMut(&str, &str) -> Result<(), String>) -> Vec<String> {
    let mut wrong = Vec::new();
    let whole = text.strip_prefix('\u{feff}').unwrap_or(text);
    let text = match DeTable::parse(whole) {
        Ok(_) => whole.to_owned(),
        Err(_) => without_broken_lines(whole, &mut wrong),
    };
    let table = DeTable::parse(&text).map(Spanned::into_inner).unwrap_or_default();
    for (key, spelt, at) in fields(&text, &table, "") {
        if let Err(why) = set(&key, spelt) {
            wrong.push((line_of(&text, at), format!("{key} = {spelt}: {why}; it is left out")));
        }
    }
    wrong.sort();
    wrong.into_iter().map(|(line, sentence)| format!("{}: {sentence}", line + 1)).collect()
}

/// The value of a field as it is spelt.
pub(crate) fn value(spelt: &str) -> Option<Value> {
    format!("value = {spelt}").parse::<Table>().ok()?.remove("value")
}

/// A number, whichever way it is written.
pub(crate) fn number(value: &Value) -> Option<f32> {
    match value {
        Value::Float(number) => Some(*number as f32),
        Value::Integer(number) => Some(*number as f32),
        _ => None,
    }
}

/// The most lines of a text with an error that are looked at.
const MOST: usize = 400;

/// The text with every line empty that does not go with those before it; says of each why.
fn without_broken_lines(text: &str, wrong: &mut Vec<(usize, String)>) -> String {
    let mut good = String::new();
    for (number, line) in text.lines().take(MOST).enumerate() {
        let before = good.len();
        good.push_str(line);
        if let Err(error) = DeTable::parse(&good) {
            wrong.push((number, format!("{}; this line is left out", error.message())));
            good.truncate(before);
        }
        good.push('\n');
    }
    good
}

/// The line of a byte, from 0.
fn line_of(text: &str, at: usize) -> usize {
    text.bytes().take(at).filter(|byte| *byte == b'\n').count()
}

/// The fields of a table and of those in it: the key, how its value is spelt, and where.
fn fields<'a>(text: &'a str, table: &DeTable<'_>, around: &str) -> Vec<(String, &'a str, usize)> {
    let mut all = Vec::new();
    for (key, value) in table {
        let name = format!("{around}{}", key.get_ref());
        match value.get_ref() {
            DeValue::Table(table) => all.extend(fields(text, table, &format!("{name}."))),
            _ => all.push((name, spelt(text, value), key.span().start)),
        }
    }
    all
}

fn spelt<'a>(text: &'a str, value: &Spanned<DeValue<'_>>) -> &'a str {
    text.get(value.span()).unwrap_or_default()
}
