//! The words that slides print in bold, and what they mean: `terms.txt`.

use crate::reading::Reading;
use crate::{Problem, Spot, limits};

/// A word of the lecture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Term {
    /// What it is called, and how else it is written; at least one name.
    pub names: Vec<String>,
    /// The id of the slide that teaches it.
    pub slide: String,
    /// What it means, in a sentence or two.
    pub means: String,
    /// Where it stands.
    pub(crate) spot: Spot,
    /// Where its slide is named.
    pub(crate) slide_spot: Spot,
}

/// The file in the folder of lessons.
pub(crate) const FILE: &str = "terms.txt";

impl Term {
    /// The words of a file, a line each: `name, other name : slide : meaning`.
    pub(crate) fn read_all(path: &str, text: &str) -> (Vec<Term>, Vec<Problem>) {
        let mut reading = Reading::new(path, text);
        let mut terms: Vec<Term> = Vec::new();
        if !reading.is_too_large() {
            for (at, line) in reading.lines().filter(|(_, line)| !line.trim().is_empty()) {
                let Some(term) = read(at, line, &mut reading) else { continue };
                match term.names.iter().find(|name| terms.iter().any(|other| other.is(name))) {
                    Some(name) => reading.problem(at, format!("`{name}` is explained already, on a line before")),
                    None => terms.push(term),
                }
            }
        }
        (terms, reading.finish())
    }

    /// Whether a word is this one, small and capital letters alike.
    pub fn is(&self, word: &str) -> bool {
        let word = word.trim().to_lowercase();
        self.names.iter().any(|name| name.to_lowercase() == word)
    }

    /// Whether a text in Markdown says it in bold.
    pub(crate) fn is_bold_in(&self, markdown: &str) -> bool {
        markdown.split("**").skip(1).step_by(2).any(|bold| self.is(bold))
    }
}

fn read(at: usize, line: &str, reading: &mut Reading<'_>) -> Option<Term> {
    let mut parts = line.splitn(3, " : ");
    let (Some(names), Some(slide), Some(means)) = (parts.next(), parts.next(), parts.next()) else {
        reading.problem(at, "a line that explains a word is `name, other name : slide : meaning`");
        return None;
    };
    let slide_at = at + names.len() + " : ".len();
    let names: Vec<String> = names.split(',').map(|name| name.trim().to_owned()).collect();
    if names.iter().any(|name| name.is_empty() || name.chars().count() > limits::TITLE) {
        reading.problem(at, format!("a name has from 1 to {} letters", limits::TITLE));
        return None;
    }
    let means = means.trim();
    if means.is_empty() || means.chars().count() > limits::MEANING {
        let means_at = slide_at + slide.len() + " : ".len();
        reading.problem(means_at, format!("a meaning has from 1 to {} letters", limits::MEANING));
        return None;
    }
    let (spot, slide_spot) = (reading.spot(at), reading.spot(slide_at));
    Some(Term { names, slide: slide.trim().to_owned(), means: means.to_owned(), spot, slide_spot })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_explains_a_word() {
        let read = |text: &str| Term::read_all(FILE, text);
        let (terms, wrong) = read("leaf, leaves : 5/31 : A node : without children.\n\nbox : 5/29 : Around it all.\n");
        assert_eq!((terms.len(), wrong), (2, Vec::new()));
        assert_eq!((terms[0].slide.as_str(), terms[0].means.as_str()), ("5/31", "A node : without children."));
        for (word, is) in [("leaf", true), ("Leaves", true), (" LEAF ", true), ("leafs", false), ("", false)] {
            assert_eq!(terms[0].is(word), is, "{word}");
        }
        for (text, is) in [("a **leaf**", true), ("**a** leaf **b**", false), ("**Leaves** b", true), ("leaf", false)] {
            assert_eq!(terms[0].is_bold_in(text), is, "{text}");
        }
    }

    #[test]
    fn what_is_wrong_in_a_line_loses_that_line() {
        let check = |line: &str, says: &str| {
            let (terms, wrong) =
                Term::read_all(FILE, &format!("leaf : 5/31 : No children.\n{line}\nbox : 5/29 : A.\n"));
            assert_eq!(terms.len(), 2, "{line}");
            assert_eq!(wrong.iter().map(ToString::to_string).collect::<Vec<_>>(), [says], "{line}");
        };
        check("leaf", "terms.txt:2:1: a line that explains a word is `name, other name : slide : meaning`");
        check("cell : 3/16", "terms.txt:2:1: a line that explains a word is `name, other name : slide : meaning`");
        check(" : 3/16 : A box.", "terms.txt:2:1: a name has from 1 to 120 letters");
        check("cell, : 3/16 : A box.", "terms.txt:2:1: a name has from 1 to 120 letters");
        check("cell : 3/16 :  ", "terms.txt:2:15: a meaning has from 1 to 240 letters");
        check("cell, Leaf : 3/16 : A box.", "terms.txt:2:1: `Leaf` is explained already, on a line before");
    }
}
