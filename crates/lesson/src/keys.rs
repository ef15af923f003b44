//! A table of a slide's head, read key by key: a value of the wrong kind is told what is right, and a
//! key that nobody asked for is a misspelling.

use glam::{Vec2, Vec3};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::problem::{misspelt, nearest};
use crate::reading::Reading;

/// A value with the byte of the file where it stands.
pub(crate) type At<T> = (usize, T);

/// A table, and the keys it was asked for.
pub(crate) struct Keys<'t> {
    table: &'t DeTable<'t>,
    at: usize,
    asked: Vec<&'static str>,
    /// Keys that every such table has and this one lacks, with what to write.
    missing: Vec<(&'static str, &'static str)>,
}

/// What a value of the head can be.
pub(crate) trait FromToml: Sized {
    /// What a slide should write: `"a text in quotes"`.
    const WHAT: &'static str;

    /// The value, if it is one.
    fn from_toml(value: &DeValue<'_>) -> Option<Self>;
}

impl<'t> Keys<'t> {
    /// The keys of the table that begins at byte `at`.
    pub(crate) fn new(table: &'t DeTable<'t>, at: usize) -> Keys<'t> {
        Keys { table, at, asked: Vec::new(), missing: Vec::new() }
    }

    /// Where the table begins.
    pub(crate) fn at(&self) -> usize {
        self.at
    }

    /// Whether it has the key.
    pub(crate) fn has(&self, key: &str) -> bool {
        self.table.keys().any(|k| k.get_ref() == key)
    }

    /// The value of a key as it stands.
    pub(crate) fn raw(&mut self, key: &'static str) -> Option<&'t Spanned<DeValue<'t>>> {
        if !self.asked.contains(&key) {
            self.asked.push(key);
        }
        self.table.iter().find(|(k, _)| k.get_ref() == key).map(|(_, value)| value)
    }

    /// The value of a key that may be left out.
    pub(crate) fn get<T: FromToml>(&mut self, key: &'static str, reading: &mut Reading<'_>) -> Option<At<T>> {
        let value = self.raw(key)?;
        read(key, value, reading)
    }

    /// The value of a key that every such table has. That it is missing is said by [`Keys::finish`].
    pub(crate) fn need<T: FromToml>(&mut self, key: &'static str, reading: &mut Reading<'_>) -> Option<At<T>> {
        if self.raw(key).is_none() {
            self.missing.push((key, T::WHAT));
        }
        self.get(key, reading)
    }

    /// A table within this one.
    pub(crate) fn table(&mut self, key: &'static str, reading: &mut Reading<'_>) -> Option<Keys<'t>> {
        let value = self.raw(key)?;
        let table = value.get_ref().as_table();
        if table.is_none() {
            wrong(key, "a table: { key = value, ... }", value, reading);
        }
        table.map(|table| Keys::new(table, value.span().start))
    }

    /// The tables of an array of tables; none where the key is left out.
    pub(crate) fn tables(&mut self, key: &'static str, reading: &mut Reading<'_>) -> Vec<Keys<'t>> {
        const WHAT: &str = "a list of tables: [{ key = value, ... }]";
        let Some(value) = self.raw(key) else { return Vec::new() };
        let Some(list) = value.get_ref().as_array() else {
            wrong(key, WHAT, value, reading);
            return Vec::new();
        };
        let mut tables = Vec::new();
        for value in list {
            match value.get_ref().as_table() {
                Some(table) => tables.push(Keys::new(table, value.span().start)),
                None => wrong(key, WHAT, value, reading),
            }
        }
        tables
    }

    /// All keys that were not asked for, as text: the parameters of a structure.
    pub(crate) fn rest(&mut self, reading: &mut Reading<'_>) -> Vec<(At<String>, String)> {
        let mut rest = Vec::new();
        for (key, value) in self.table {
            if self.asked.iter().any(|asked| asked == key.get_ref()) {
                continue;
            }
            match text_of(value.get_ref()) {
                Some(text) => rest.push(((key.span().start, key.get_ref().to_string()), text)),
                None => wrong(key.get_ref(), "a word in quotes, a number, true or false", value, reading),
            }
        }
        rest
    }

    /// Says which keys nobody asked for, and which are missing: of a misspelling that is meant, only the one.
    pub(crate) fn finish(mut self, reading: &mut Reading<'_>) {
        for key in self.table.keys() {
            if !self.asked.iter().any(|asked| asked == key.get_ref()) {
                let meant = nearest(key.get_ref(), &self.asked);
                self.missing.retain(|(missing, _)| Some(*missing) != meant);
                reading.problem(key.span().start, misspelt("key here", key.get_ref(), &self.asked));
            }
        }
        self.say_missing(reading);
    }

    /// Says which keys are missing, in a table that may have any others.
    pub(crate) fn say_missing(&mut self, reading: &mut Reading<'_>) {
        for (key, what) in self.missing.drain(..) {
            reading.problem(self.at, format!("`{key}` is missing: write `{key} = ` and {what}"));
        }
    }
}

/// Reads a value, or says what it should be.
pub(crate) fn read<T: FromToml>(key: &str, value: &Spanned<DeValue<'_>>, reading: &mut Reading<'_>) -> Option<At<T>> {
    let found = T::from_toml(value.get_ref());
    if found.is_none() {
        wrong(key, T::WHAT, value, reading);
    }
    found.map(|found| (value.span().start, found))
}

/// Says that a value is of the wrong kind.
pub(crate) fn wrong(key: &str, what: &str, value: &Spanned<DeValue<'_>>, reading: &mut Reading<'_>) {
    let found = value.get_ref().type_str();
    let article = if found.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" };
    reading.problem(value.span().start, format!("`{key}` is {article} {found} here, but should be {what}"));
}

/// A number, word or flag as the text that a rule is set with.
fn text_of(value: &DeValue<'_>) -> Option<String> {
    match value {
        DeValue::String(text) => Some(text.to_string()),
        DeValue::Integer(number) => Some(number.to_string()),
        DeValue::Float(number) => Some(number.to_string()),
        DeValue::Boolean(flag) => Some(flag.to_string()),
        _ => None,
    }
}

impl FromToml for String {
    const WHAT: &'static str = "a text in quotes";

    fn from_toml(value: &DeValue<'_>) -> Option<String> {
        value.as_str().map(str::to_owned)
    }
}

impl FromToml for f32 {
    const WHAT: &'static str = "a number";

    fn from_toml(value: &DeValue<'_>) -> Option<f32> {
        match value {
            DeValue::Integer(number) => number.as_str().parse().ok(),
            DeValue::Float(number) => number.as_str().parse().ok(),
            _ => None,
        }
    }
}

/// All the values of an array, if each is of the right kind.
fn all<T: FromToml>(value: &DeValue<'_>) -> Option<Vec<T>> {
    value.as_array()?.iter().map(|value| T::from_toml(value.get_ref())).collect()
}

impl FromToml for Vec<String> {
    const WHAT: &'static str = "a text in quotes, or several in brackets";

    fn from_toml(value: &DeValue<'_>) -> Option<Vec<String>> {
        all(value).or_else(|| Some(vec![String::from_toml(value)?]))
    }
}

impl FromToml for bool {
    const WHAT: &'static str = "true or false";

    fn from_toml(value: &DeValue<'_>) -> Option<bool> {
        value.as_bool()
    }
}

impl FromToml for f64 {
    const WHAT: &'static str = "a number";

    fn from_toml(value: &DeValue<'_>) -> Option<f64> {
        match value {
            DeValue::Integer(number) => number.as_str().parse().ok(),
            DeValue::Float(number) => number.as_str().parse().ok(),
            _ => None,
        }
    }
}

impl FromToml for Vec<(f64, String)> {
    const WHAT: &'static str = "numbers with what stands there: [[1, \"1\"], [1e6, \"1 million\"]]";

    fn from_toml(value: &DeValue<'_>) -> Option<Vec<(f64, String)>> {
        let pair = |value: &DeValue<'_>| match value.as_array()?.iter().as_slice() {
            [number, text] => Some((f64::from_toml(number.get_ref())?, String::from_toml(text.get_ref())?)),
            _ => None,
        };
        value.as_array()?.iter().map(|value| pair(value.get_ref())).collect()
    }
}

impl FromToml for Vec2 {
    const WHAT: &'static str = "two numbers: [x, y]";

    fn from_toml(value: &DeValue<'_>) -> Option<Vec2> {
        match *all(value)?.as_slice() {
            [x, y] => Some(Vec2::new(x, y)),
            _ => None,
        }
    }
}

impl FromToml for Vec3 {
    const WHAT: &'static str = "two or three numbers: [x, y] or [x, y, z]";

    fn from_toml(value: &DeValue<'_>) -> Option<Vec3> {
        match *all(value)?.as_slice() {
            [x, y] => Some(Vec3::new(x, y, 0.0)),
            [x, y, z] => Some(Vec3::new(x, y, z)),
            _ => None,
        }
    }
}
