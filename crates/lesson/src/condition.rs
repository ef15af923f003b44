//! When a paragraph is said, or a line of a listing shown: `verdict=hit`, `t<t_near and count.better>1`.

use raystep_accel::Value;

use crate::facts::check_fact;
use crate::problem::misspelt;
use crate::reading::Reading;
use crate::vocabulary::check_event;
use crate::{Facts, StageKind, names, wait};

/// Comparisons that must all hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Condition(Vec<Comparison>);

/// A fact compared with a word, a number or another fact.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Comparison {
    fact: String,
    relation: Relation,
    value: String,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Relation {
    Is,
    IsNot,
    Less,
    More,
    AtMost,
    AtLeast,
}

/// How they are written; those of two letters first.
const RELATIONS: [(&str, Relation); 6] = [
    ("!=", Relation::IsNot),
    ("<=", Relation::AtMost),
    (">=", Relation::AtLeast),
    ("<", Relation::Less),
    (">", Relation::More),
    ("=", Relation::Is),
];

impl Relation {
    /// Whether it compares with a word as it is written, and not numbers with each other.
    fn is_about_words(self) -> bool {
        matches!(self, Relation::Is | Relation::IsNot)
    }
}

impl Condition {
    /// Whether it holds where the facts are known.
    pub fn holds(&self, facts: &Facts<'_>) -> bool {
        self.0.iter().all(|comparison| comparison.holds(facts))
    }

    /// Reads a condition for a beat that waits for `event`; `at` is its first byte.
    pub(crate) fn read(text: &str, event: &str, at: usize, reading: &mut Reading<'_>) -> Option<Condition> {
        let byte_of = |part: &str| at + (part.as_ptr() as usize - text.as_ptr() as usize);
        // What else it asks is of that event.
        let event = text.split(" and ").find_map(|part| part.trim().strip_prefix("event=")).unwrap_or(event);
        let parts = text.split(" and ").map(|part| Comparison::read(part, event, byte_of(part), reading));
        parts.collect::<Option<_>>().map(Condition)
    }

    /// The event that it asks for, if it does.
    pub(crate) fn event(&self) -> Option<&str> {
        self.0
            .iter()
            .find(|comparison| comparison.fact == "event" && comparison.relation == Relation::Is)
            .map(|comparison| &*comparison.value)
    }

    /// The facts that must be a certain word, each with that word.
    pub(crate) fn words(&self) -> impl Iterator<Item = (&str, &str)> {
        let words = self.0.iter().filter(|comparison| comparison.relation.is_about_words());
        words.map(|comparison| (&*comparison.fact, &*comparison.value)).filter(|(fact, _)| !OWN.contains(fact))
    }

    /// The facts that are compared as numbers.
    pub(crate) fn numbers(&self) -> impl Iterator<Item = &str> {
        let compared = self.0.iter().filter(|comparison| !comparison.relation.is_about_words());
        compared.flat_map(|comparison| {
            let other = number(&comparison.value).is_none().then_some(&*comparison.value);
            std::iter::once(&*comparison.fact).chain(other)
        })
    }
}

/// What a condition can ask besides facts.
const OWN: [&str; 2] = ["event", "stage"];

impl Comparison {
    fn read(text: &str, event: &str, at: usize, reading: &mut Reading<'_>) -> Option<Comparison> {
        let found = text.char_indices().find_map(|(index, _)| {
            RELATIONS.iter().find(|(sign, _)| text[index..].starts_with(sign)).map(|relation| (index, *relation))
        });
        let Some((index, (sign, relation))) = found else {
            reading.problem(at, "a condition compares: `field=value`, `t<t_near`, several with ` and ` between them");
            return None;
        };
        let (fact, value) = (text[..index].trim(), text[index + sign.len()..].trim());
        let value_at = at + text.len() - text[index + sign.len()..].trim_start().len();
        match fact {
            "event" if relation.is_about_words() => {
                check_event(value, value_at, reading);
            }
            "stage" if relation.is_about_words() => {
                let known = StageKind::ALL.map(StageKind::name);
                if !known.contains(&value) {
                    reading.problem(value_at, misspelt("stage", value, &known));
                }
            }
            _ => check_fact(event, fact, at + text.len() - text.trim_start().len(), reading),
        }
        if !relation.is_about_words() && number(value).is_none() {
            check_fact(event, value, value_at, reading);
        }
        Some(Comparison { fact: fact.to_owned(), relation, value: value.to_owned() })
    }

    fn holds(&self, facts: &Facts<'_>) -> bool {
        if self.relation.is_about_words() {
            let is = match &*self.fact {
                "event" => names(&self.value, facts.event().name()),
                "stage" => self.value == facts.stage().name(),
                fact => match facts.field(fact) {
                    Some(value) => wait::says(&value, &self.value),
                    None => return false,
                },
            };
            return is == (self.relation == Relation::Is);
        }
        let known = |name: &str| facts.field(name).and_then(|value| number_of(&value));
        let (left, right) = (known(&self.fact), number(&self.value).or_else(|| known(&self.value)));
        let (Some(left), Some(right)) = (left, right) else { return false };
        match self.relation {
            Relation::Is | Relation::IsNot => false,
            Relation::Less => left < right,
            Relation::More => left > right,
            Relation::AtMost => left <= right,
            Relation::AtLeast => left >= right,
        }
    }
}

/// A number as it is written.
fn number(text: &str) -> Option<f64> {
    match text {
        "∞" => Some(f64::INFINITY),
        "−∞" | "-∞" => Some(f64::NEG_INFINITY),
        _ => text.parse().ok(),
    }
}

/// The number that a value is, if it is one.
pub(crate) fn number_of(value: &Value) -> Option<f64> {
    match *value {
        Value::Number(number) => Some(number.into()),
        Value::Count(count) => Some(count.into()),
        Value::Lanes(lanes) => Some(lanes.count().into()),
        _ => None,
    }
}
