//! A meter: numbers that are moved by hand, and what follows from them.

use exmex::Express;

use crate::keys::Keys;
use crate::problem::misspelt;
use crate::reading::Reading;
use crate::{Spot, limits};

use super::Formula;

/// Numbers that are moved by hand, and what follows from them.
#[derive(Clone, Debug, PartialEq)]
pub struct Meter {
    /// What it is about, in a few words.
    pub title: String,
    /// What stands behind the title.
    pub about: String,
    /// What is moved.
    pub numbers: Vec<Number>,
    /// What follows.
    pub gives: Vec<Given>,
}

/// A number that is moved by hand.
#[derive(Clone, Debug, PartialEq)]
pub struct Number {
    /// What formulas and texts call it.
    pub name: String,
    /// What it counts.
    pub note: String,
    /// The least that it can be.
    pub from: f64,
    /// The most that it can be.
    pub to: f64,
    /// What it is until somebody moves it.
    pub is: f64,
    /// Whether equal ways are equal factors.
    pub log: bool,
    /// Whether it is always a whole number: its ends and its own are.
    pub whole: bool,
    /// Where it stands.
    pub(crate) spot: Spot,
}

/// What follows from the numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Given {
    /// What it is called.
    pub name: String,
    /// A few words below the name.
    pub note: String,
    /// How it follows.
    pub formula: Formula,
    /// What stands behind it.
    pub unit: String,
}

/// Numbers where somebody has put them, by their names.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Numbers(Vec<(String, f64)>);

impl Numbers {
    /// The number of that name.
    pub fn get(&self, name: &str) -> Option<f64> {
        self.0.iter().find(|(known, _)| known == name).map(|(_, number)| *number)
    }
}

impl Meter {
    /// Its numbers where the settings put them; those that no setting names stand where the slide has them, and so do
    /// those that a setting puts where they cannot be.
    pub(crate) fn moved(&self, settings: &[(String, String)]) -> Numbers {
        let set = |number: &Number| {
            let (_, value) = settings.iter().rev().find(|(key, _)| *key == number.name)?;
            number.read(value).ok()
        };
        Numbers(self.numbers.iter().map(|number| (number.name.clone(), set(number).unwrap_or(number.is))).collect())
    }
}

impl Meter {
    /// Its numbers as they stand at first, all at their lower ends, and all at their upper ones.
    pub(crate) fn ends(&self) -> Vec<Numbers> {
        let all = |of: fn(&Number) -> f64| {
            Numbers(self.numbers.iter().map(|number| (number.name.clone(), of(number))).collect())
        };
        vec![all(|number| number.is), all(|number| number.from), all(|number| number.to)]
    }
}

impl Number {
    /// What a text sets it to.
    ///
    /// # Errors
    /// The text is no number, or one beyond its ends: a sentence that says what is allowed.
    pub fn read(&self, text: &str) -> Result<f64, String> {
        let allowed = || {
            let whole = if self.whole { "a whole number" } else { "a number" };
            format!("`{}` is `{}`: it can be {whole} from {} to {}", self.name, text.trim(), self.from, self.to)
        };
        let number = text.trim().parse::<f64>().ok().filter(|number| (self.from..=self.to).contains(number));
        number.filter(|number| !self.whole || number.fract() == 0.0).ok_or_else(allowed)
    }
}

/// What every chart calls its own number.
const ACROSS: &str = "x";

/// The most letters of a number's name.
const LETTERS: usize = 8;

/// The most numbers of a meter, and the most that follows from them.
const MOST: usize = 6;

/// Reads `[meter]`: the formulas that are read after it may name its numbers.
pub(super) fn read(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Option<Meter> {
    let (title, about) = (keys.need::<String>("title", reading), keys.get::<String>("about", reading));
    reading.numbers.clear();
    let mut numbers: Vec<Number> = Vec::new();
    for keys in keys.tables("numbers", reading) {
        let at = keys.at();
        let Some(number) = number(keys, reading) else { continue };
        if numbers.iter().any(|other| other.name == number.name) {
            reading.problem(at, format!("the number `{}` is there twice", number.name));
        }
        numbers.push(number);
    }
    let gives: Vec<Given> = keys.tables("gives", reading).into_iter().filter_map(|keys| given(keys, reading)).collect();
    let at = keys.at();
    if numbers.is_empty() && !keys.has("numbers") {
        reading.problem(at, "a meter has numbers: write `numbers = [{ name = \"N\", from = 1, to = 1000, is = 10 }]`");
    }
    if numbers.len() > MOST || gives.len() > MOST {
        reading.problem(at, format!("a meter has at most {MOST} numbers, and gives at most {MOST}"));
    }
    Some(Meter { title: title?.1, about: about.unwrap_or_default().1, numbers, gives })
}

/// `{ name = "Nx", note = "pixels across", from = 1, to = 4096, is = 1000, scale = "log" }`
fn number(mut keys: Keys<'_>, reading: &mut Reading<'_>) -> Option<Number> {
    const SCALES: [&str; 2] = ["linear", "log"];
    let (name, note) = (keys.need::<String>("name", reading), keys.get::<String>("note", reading));
    let (from, to) = (keys.need::<f64>("from", reading), keys.need::<f64>("to", reading));
    let is = keys.need::<f64>("is", reading);
    let scale = keys.get::<String>("scale", reading);
    let at = keys.at();
    let spot = reading.spot(at);
    keys.finish(reading);
    if let Some((at, scale)) = scale.as_ref().filter(|(_, scale)| !SCALES.contains(&scale.as_str())) {
        reading.problem(*at, misspelt("scale", scale, &SCALES));
    }
    let log = scale.is_some_and(|(_, scale)| scale == "log");
    let ((name_at, name), (_, from), (_, to), (is_at, is)) = (name?, from?, to?, is?);
    if !can_be_named(&name) {
        let name = crate::problem::short(&name);
        reading.problem(
            name_at,
            format!(
                "`{name}` cannot name a number: write a letter and up to {} letters and digits behind it, as in Nx, \
                 other than `{ACROSS}` and the names of functions and constants",
                LETTERS - 1
            ),
        );
        return None;
    }
    // Also one that is wrong elsewhere may be named.
    if !reading.numbers.contains(&name) {
        reading.numbers.push(name.clone());
    }
    if !(from < to && (to - from).is_finite() && (!log || from > 0.0)) {
        let zero = if log { ", both above 0 on a scale of factors" } else { "" };
        reading.problem(at, format!("`{name}` runs from {from} to {to}: `from` lies below `to`{zero}"));
        return None;
    }
    if !(from..=to).contains(&is) {
        reading.problem(is_at, format!("`{name}` is {is}: it lies from {from} to {to}"));
        return None;
    }
    let whole = [from, to, is].iter().all(|number| number.fract() == 0.0);
    Some(Number { name, note: note.unwrap_or_default().1, from, to, is, log, whole, spot })
}

/// Whether a formula can call a number so.
fn can_be_named(name: &str) -> bool {
    let letters = name.len() <= LETTERS
        && name.starts_with(|first: char| first.is_ascii_alphabetic())
        && name.bytes().all(|letter| letter.is_ascii_alphanumeric());
    // A function's or a constant's name is no number of its own.
    let free = exmex::parse::<f64>(name).is_ok_and(|parsed| parsed.var_names() == [name]);
    letters && free && name != ACROSS
}

/// `{ name = "tests", note = "Nx · Ny · No", computed = "Nx * Ny * No" }`
fn given(mut keys: Keys<'_>, reading: &mut Reading<'_>) -> Option<Given> {
    let (name, note) = (keys.need::<String>("name", reading), keys.get::<String>("note", reading));
    let computed = keys.need::<String>("computed", reading);
    let unit = keys.get::<String>("unit", reading).unwrap_or_default().1;
    keys.finish(reading);
    let ((name_at, name), (at, computed)) = (name?, computed?);
    if name.chars().count() > limits::TITLE {
        reading.problem(name_at, format!("a name has at most {} letters", limits::TITLE));
    }
    let formula = Formula::read(&computed, at, &[], reading)?;
    if !formula.is_moved() {
        reading.problem(at, format!("`{computed}` follows from none of the meter's numbers"));
    }
    Some(Given { name, note: note.unwrap_or_default().1, formula, unit })
}
