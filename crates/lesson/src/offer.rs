//! What a text in the window offers to do: `[Leave out the second look](set:prune=false)`.

use raystep_accel::Rule;

use crate::problem::misspelt;
use crate::reading::Reading;

/// A button under a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Offer {
    /// What stands on it.
    pub words: String,
    /// What it does.
    pub act: Act,
}

/// Something that the window does for a slide.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Act {
    /// Builds with other parameters: keys and values.
    Set(Vec<(String, String)>),
    /// Sets a structure of this kind beside, with the same ray.
    Compare(&'static str),
    /// Goes to the slide called so.
    Slide(String),
    /// Measures all structures over the scene or the mesh that is open.
    Best,
}

/// How they are written.
const KINDS: [&str; 4] = ["set:KEY=VALUE", "compare:KIND", "slide:ID", "best:all"];

/// Takes the offers out of a line that begins at byte `at`: what is left of it is said.
pub(crate) fn take(line: &str, at: usize, reading: &mut Reading<'_>) -> (String, Vec<Offer>) {
    let (mut said, mut offers, mut rest) = (String::new(), Vec::new(), line);
    while let Some((before, words, target, after)) = link(rest) {
        said.push_str(before);
        let target_at = at + (target.as_ptr() as usize - line.as_ptr() as usize);
        offers.extend(act(target, target_at, reading).map(|act| Offer { words: words.to_owned(), act }));
        rest = after;
    }
    said.push_str(rest);
    (said.trim().to_owned(), offers)
}

/// Whether a line offers something.
pub(crate) fn is_in(line: &str) -> bool {
    link(line).is_some_and(|(_, _, target, _)| KINDS.iter().any(|kind| target.starts_with(word(kind))))
}

/// The first `[words](target)`: what stands before it, its parts, and what stands behind it.
fn link(line: &str) -> Option<(&str, &str, &str, &str)> {
    let middle = line.find("](")?;
    let open = line[..middle].rfind('[')?;
    let close = middle + line[middle..].find(')')?;
    Some((&line[..open], &line[open + 1..middle], &line[middle + 2..close], &line[close + 1..]))
}

/// `set:` of `set:KEY=VALUE`.
fn word(kind: &str) -> &str {
    kind.split_inclusive(':').next().unwrap_or(kind)
}

/// Reads a target.
fn act(target: &str, at: usize, reading: &mut Reading<'_>) -> Option<Act> {
    let (kind, what) = target.split_once(':').unwrap_or((target, ""));
    match kind {
        "set" => {
            let pairs = what.split(',').map(|pair| pair.split_once('='));
            let pairs: Option<Vec<_>> =
                pairs.map(|pair| pair.map(|(key, value)| (key.trim().to_owned(), value.trim().to_owned()))).collect();
            if pairs.is_none() {
                reading.problem(at, "write `set:key=value`, several with commas between them");
            }
            pairs.map(Act::Set)
        }
        "compare" => {
            let known = Rule::KINDS.into_iter().find(|known| *known == what);
            if known.is_none() {
                reading.problem(at + kind.len() + 1, misspelt("structure", what, &Rule::KINDS));
            }
            known.map(Act::Compare)
        }
        "best" if what == "all" => Some(Act::Best),
        "slide" => Some(Act::Slide(what.to_owned())),
        _ => {
            reading.problem(at, misspelt("offer", target, &KINDS));
            None
        }
    }
}
