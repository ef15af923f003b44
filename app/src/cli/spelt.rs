//! A structure as one line of text.

use std::fmt::Display;
use std::ops::{Bound, RangeBounds};
use std::str::FromStr;

use raystep_accel::{Rule, RuleError};

use crate::fault::Fault;

/// A kind of structure that answers rays, with the parameters it has when nobody sets any.
pub(crate) fn answering(kind: &str) -> Result<Rule, Fault> {
    match Rule::default_for(kind).map_err(|error| Fault::new(error.to_string()))? {
        Rule::Slab => Err(Fault::new(format!(
            "the structure \"slab\" only tests the box around everything and meets no primitive, so it answers no \
             ray; there are {}",
            Rule::KINDS.join(", ")
        ))),
        rule => Ok(rule),
    }
}

/// Reads a whole number of these: from one to another, or from one on.
pub(crate) fn whole<N>(allowed: impl RangeBounds<N> + Clone) -> impl Fn(&str) -> Result<N, String> + Clone
where
    N: FromStr + PartialOrd + Display,
{
    move |text| {
        let number = text.trim().parse().ok().filter(|number| allowed.contains(number));
        number.ok_or_else(|| match (allowed.start_bound(), allowed.end_bound()) {
            (Bound::Included(least), Bound::Included(most)) => format!("write a whole number from {least} to {most}"),
            (Bound::Included(least), _) => format!("write a whole number from {least} on"),
            _ => "write a whole number".to_owned(),
        })
    }
}

/// The rule that `kind key=value ...` spells.
///
/// # Errors
/// It spells none.
pub fn rule(line: &str) -> Result<Rule, Fault> {
    let wrong = |error: RuleError| Fault::new(error.to_string());
    let mut words = line.split_whitespace();
    let mut rule = answering(words.next().unwrap_or_default())?;
    for word in words {
        let (key, value) = word.split_once('=').ok_or_else(|| Fault::new(format!("{word} is no key=value")))?;
        rule.set(key, value).map_err(wrong)?;
    }
    Ok(rule)
}
