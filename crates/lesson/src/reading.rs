//! A file being read, and the problems found in it.

use crate::{Plays, Problem, Spot};

/// The text of one file and where to say what is wrong with it.
pub(crate) struct Reading<'a> {
    file: &'a str,
    text: &'a str,
    problems: Vec<Problem>,
    /// Whose events it names.
    pub(crate) plays: Plays,
    /// Whether something is played beside it.
    pub(crate) beside: bool,
}

impl<'a> Reading<'a> {
    /// Begins to read a file.
    pub(crate) fn new(file: &'a str, text: &'a str) -> Reading<'a> {
        Reading { file, text, problems: Vec::new(), plays: Plays::default(), beside: false }
    }

    /// Its lines without their ends, each with the byte where it begins.
    pub(crate) fn lines(&self) -> impl Iterator<Item = (usize, &'a str)> + use<'a> {
        let mut next = 0;
        self.text.split_inclusive('\n').map(move |line| {
            let offset = next;
            next += line.len();
            (offset, line.trim_end_matches(['\n', '\r']))
        })
    }

    /// Where a byte of the file stands.
    pub(crate) fn spot(&self, offset: usize) -> Spot {
        Spot::of(self.text, offset)
    }

    /// Says what is wrong at a byte of the file.
    pub(crate) fn problem(&mut self, offset: usize, message: impl Into<String>) {
        let spot = self.spot(offset);
        self.problems.push(Problem::new(self.file, spot, message));
    }

    /// How many problems there are so far.
    pub(crate) fn count(&self) -> usize {
        self.problems.len()
    }

    /// What was found wrong.
    pub(crate) fn finish(self) -> Vec<Problem> {
        self.problems
    }
}
