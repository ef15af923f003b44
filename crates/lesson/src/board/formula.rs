//! A number that a slide has computed: a formula in the numbers that it names.

use exmex::Express;

use crate::reading::Reading;

/// A formula, as a slide writes it: `"3 / 8 * 5 * 10^10"`, of a law with `x` in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    text: String,
    parsed: exmex::FlatEx<f64>,
}

impl Formula {
    /// Reads a formula; says so if it is none, or names anything but `allowed`.
    pub(crate) fn read(text: &str, at: usize, allowed: &[&str], reading: &mut Reading<'_>) -> Option<Formula> {
        let Ok(parsed) = exmex::parse::<f64>(text) else {
            let short = crate::problem::short(text);
            reading.problem(
                at,
                format!("`{short}` is no formula: write numbers, + - * / ^ and brackets, as in 3 / 8 * 5 * 10^10"),
            );
            return None;
        };
        if let Some(other) = parsed.var_names().iter().find(|name| !allowed.contains(&name.as_str())) {
            let known =
                if allowed.is_empty() { "numbers alone".to_owned() } else { format!("`{}`", allowed.join("`, `")) };
            reading.problem(at, format!("the formula `{text}` names `{other}`: it may name {known}"));
            return None;
        }
        Some(Formula { text: text.to_owned(), parsed })
    }

    /// As the slide writes it.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Its value, with the one name that it may have standing for `x`.
    pub fn at(&self, x: f64) -> f64 {
        let x = vec![x; self.parsed.var_names().len()];
        self.parsed.eval(&x).unwrap_or(f64::NAN)
    }
}
