//! A structure as one line of text.

use raystep_accel::{Rule, RuleError};

use crate::fault::Fault;

/// The rule that `kind key=value ...` spells.
///
/// # Errors
/// It spells none.
pub fn rule(line: &str) -> Result<Rule, Fault> {
    let wrong = |error: RuleError| Fault::new(error.to_string());
    let mut words = line.split_whitespace();
    let mut rule = Rule::default_for(words.next().unwrap_or_default()).map_err(wrong)?;
    for word in words {
        let (key, value) = word.split_once('=').ok_or_else(|| Fault::new(format!("{word} is no key=value")))?;
        rule.set(key, value).map_err(wrong)?;
    }
    Ok(rule)
}
