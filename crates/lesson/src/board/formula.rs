//! A number that a slide has computed: a formula in the numbers that it names.

use exmex::Express;

use crate::reading::Reading;

use super::Numbers;

/// A formula, as a slide writes it: `"3 / 8 * 5 * 10^10"`, of a law with `x` in it. It may name numbers of the board's
/// meter.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    text: String,
    parsed: exmex::FlatEx<f64>,
}

impl Formula {
    /// Reads a formula; says so if it is none, or names anything but `allowed` and the numbers of the meter.
    pub(crate) fn read(text: &str, at: usize, allowed: &[&str], reading: &mut Reading<'_>) -> Option<Formula> {
        let Ok(parsed) = exmex::parse::<f64>(text) else {
            let short = crate::problem::short(text);
            reading.problem(
                at,
                format!("`{short}` is no formula: write numbers, + - * / ^ and brackets, as in 3 / 8 * 5 * 10^10"),
            );
            return None;
        };
        let allowed: Vec<&str> = allowed.iter().copied().chain(reading.numbers.iter().map(String::as_str)).collect();
        if let Some(other) = parsed.var_names().iter().find(|name| !allowed.contains(&name.as_str())) {
            let known =
                if allowed.is_empty() { "numbers alone".to_owned() } else { format!("`{}`", allowed.join("`, `")) };
            let message = format!("the formula `{text}` names `{other}`: it may name {known}");
            reading.problem(at, message);
            return None;
        }
        Some(Formula { text: text.to_owned(), parsed })
    }

    /// As the slide writes it.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Whether it names a number that is moved by hand.
    pub fn is_moved(&self) -> bool {
        self.parsed.var_names().iter().any(|name| name != ACROSS)
    }

    /// Its value where the numbers stand, `x` being this.
    pub fn at(&self, x: f64, numbers: &Numbers) -> f64 {
        let value = |name: &String| if name == ACROSS { x } else { numbers.get(name).unwrap_or(f64::NAN) };
        let values: Vec<f64> = self.parsed.var_names().iter().map(value).collect();
        self.parsed.eval(&values).unwrap_or(f64::NAN)
    }
}

/// What a law calls the number along the axis.
const ACROSS: &str = "x";
