//! A parameter as text: what it is called, what it is now, what it may be.

use std::borrow::Cow;
use std::fmt;

use super::ByHand;

/// One parameter of a rule, as a control or a help page shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// What slides and the command line call it.
    pub key: &'static str,
    /// Its value now, as text that [`Rule::set`](crate::Rule::set) takes back.
    pub value: String,
    /// What it may be.
    pub allowed: Allowed,
    /// What it does, in a few words.
    pub about: &'static str,
}

/// What a parameter may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Allowed {
    /// One of some words.
    Words(&'static [&'static str]),
    /// A whole number.
    Count {
        /// The smallest.
        min: u32,
        /// The largest.
        max: u32,
    },
    /// A number.
    Real {
        /// The smallest.
        min: f32,
        /// The largest.
        max: f32,
    },
    /// `true` or `false`.
    Flag,
    /// Cuts that are chosen by hand.
    Cuts,
}

/// A rule that cannot be followed.
#[derive(Clone, Debug, PartialEq)]
pub enum RuleError {
    /// There is no such kind of structure.
    Kind {
        /// What was asked for.
        found: String,
        /// What was perhaps meant.
        nearest: Option<&'static str>,
    },
    /// The kind has no such parameter.
    Key {
        /// The kind.
        kind: &'static str,
        /// What was asked for.
        found: String,
        /// What was perhaps meant.
        nearest: Option<&'static str>,
        /// What there is.
        keys: Vec<&'static str>,
    },
    /// The value is not allowed.
    Value {
        /// The parameter.
        key: &'static str,
        /// What was asked for.
        found: String,
        /// What is allowed.
        allowed: Allowed,
    },
}

/// A parameter's place in its rule: one table of these per rule serves reading, writing and help.
pub(super) struct Slot<'a> {
    pub(super) key: &'static str,
    pub(super) about: &'static str,
    pub(super) field: Field<'a>,
}

/// The field behind a slot.
pub(super) enum Field<'a> {
    Word(&'a mut dyn Choice),
    Count(&'a mut u32, u32, u32),
    Real(&'a mut f32, f32, f32),
    Flag(&'a mut bool),
    Cuts(&'a mut ByHand),
}

/// An enum whose values are words.
pub(super) trait Choice {
    fn words(&self) -> &'static [&'static str];
    fn chosen(&self) -> &'static str;
    fn choose(&mut self, index: usize);
}

/// Makes an enum declared by `words!` a [`Choice`].
macro_rules! choice {
    ($($Name:ident),*) => { $(
        impl $crate::rule::parameter::Choice for $Name {
            fn words(&self) -> &'static [&'static str] {
                $Name::WORDS
            }

            fn chosen(&self) -> &'static str {
                self.word()
            }

            fn choose(&mut self, index: usize) {
                *self = $Name::ALL[index];
            }
        }
    )* };
}
pub(super) use choice;

impl Slot<'_> {
    /// Whether it holds what nobody has chosen.
    pub(super) fn is_unset(&self) -> bool {
        matches!(&self.field, Field::Cuts(cuts) if cuts.is_empty())
    }

    pub(super) fn parameter(self) -> Parameter {
        let allowed = self.allowed();
        let value = match self.field {
            Field::Word(word) => word.chosen().to_owned(),
            Field::Count(count, ..) => count.to_string(),
            Field::Real(real, ..) => real.to_string(),
            Field::Flag(flag) => flag.to_string(),
            Field::Cuts(cuts) => cuts.to_string(),
        };
        Parameter { key: self.key, value, allowed, about: self.about }
    }

    pub(super) fn set(self, text: &str) -> Result<(), RuleError> {
        let wrong = RuleError::Value { key: self.key, found: text.to_owned(), allowed: self.allowed() };
        match self.field {
            Field::Word(word) => {
                let index = word.words().iter().position(|&known| known == text).ok_or(wrong)?;
                word.choose(index);
            }
            Field::Count(count, min, max) => {
                *count = text.parse().ok().filter(|n| (min..=max).contains(n)).ok_or(wrong)?;
            }
            Field::Real(real, min, max) => {
                *real = text.parse().ok().filter(|x| (min..=max).contains(x)).ok_or(wrong)?;
            }
            Field::Flag(flag) => *flag = text.parse().map_err(|_| wrong)?,
            Field::Cuts(cuts) => *cuts = ByHand::read(text).ok_or(wrong)?,
        }
        Ok(())
    }

    fn allowed(&self) -> Allowed {
        match &self.field {
            Field::Word(word) => Allowed::Words(word.words()),
            &Field::Count(_, min, max) => Allowed::Count { min, max },
            &Field::Real(_, min, max) => Allowed::Real { min, max },
            Field::Flag(_) => Allowed::Flag,
            Field::Cuts(_) => Allowed::Cuts,
        }
    }
}

impl fmt::Display for Allowed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Allowed::Words(words) => f.write_str(&one_of(words)),
            Allowed::Count { min, max } => write!(f, "a whole number from {min} to {max}"),
            Allowed::Real { min, max } => write!(f, "a number from {min} to {max}"),
            Allowed::Flag => f.write_str("true or false"),
            Allowed::Cuts => f.write_str("none, or cuts such as 0:x=2.5: the node, the axis, where"),
        }
    }
}

impl fmt::Display for RuleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RuleError::Kind { found, nearest } => {
                let (found, kinds) = (quoted(found), one_of(&crate::Rule::KINDS));
                write!(f, "there is no structure \"{found}\"{} ({kinds})", meant(*nearest))
            }
            RuleError::Key { kind, found, nearest, keys } if keys.is_empty() => {
                write!(f, "{kind} has no parameter \"{}\"{}: it has none", quoted(found), meant(*nearest))
            }
            RuleError::Key { kind, found, nearest, keys } => {
                write!(f, "{kind} has no parameter \"{}\"{} ({})", quoted(found), meant(*nearest), one_of(keys))
            }
            RuleError::Value { key, found, allowed } => {
                write!(f, "{key} = {}: allowed is {allowed}", quoted(found))?;
                match allowed {
                    Allowed::Words(words) => f.write_str(&meant(nearest(found, words.iter().copied()))),
                    _ => Ok(()),
                }
            }
        }
    }
}

impl std::error::Error for RuleError {}

/// A sentence quotes so many letters of what was asked for.
const QUOTED: usize = 60;

/// What was asked for, as far as a sentence quotes it.
fn quoted(found: &str) -> Cow<'_, str> {
    match found.char_indices().nth(QUOTED) {
        Some((end, _)) => format!("{}…", &found[..end]).into(),
        None => found.into(),
    }
}

/// `a, b or c`
fn one_of(words: &[&str]) -> String {
    match words {
        [first @ .., last] if !first.is_empty() => format!("{} or {last}", first.join(", ")),
        _ => words.concat(),
    }
}

fn meant(nearest: Option<&str>) -> String {
    nearest.map(|word| format!("; did you mean \"{word}\"?")).unwrap_or_default()
}

/// The word that `found` may be a misspelling of: at most a third of its letters, and two, are wrong.
pub(super) fn nearest(found: &str, known: impl IntoIterator<Item = &'static str>) -> Option<&'static str> {
    let (far, word) = known.into_iter().map(|word| (edits(found, word), word)).min()?;
    (far <= 1 || (far <= 2 || far * 3 <= found.len()) && far < word.len()).then_some(word)
}

/// How many letters must be added, dropped or changed to turn one word into the other (Levenshtein 1966).
fn edits(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, letter) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, &other) in b.iter().enumerate() {
            let changed = diagonal + usize::from(letter != other);
            diagonal = row[j + 1];
            row[j + 1] = changed.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}
