//! A file being read, and the problems found in it.

use crate::{Plays, Problem, Spot, limits};

/// The text of one file and where to say what is wrong with it.
pub(crate) struct Reading<'a> {
    file: &'a str,
    text: &'a str,
    /// The byte where each line begins.
    starts: Vec<usize>,
    problems: Vec<Problem>,
    /// Whose events it names.
    pub(crate) plays: Plays,
    /// Whether something is played beside it.
    pub(crate) beside: bool,
    /// What the structures are called that are walked side by side.
    pub(crate) abreast: Vec<String>,
    /// What the numbers are called that are moved by hand.
    pub(crate) numbers: Vec<String>,
}

impl<'a> Reading<'a> {
    /// Begins to read a file.
    pub(crate) fn new(file: &'a str, text: &'a str) -> Reading<'a> {
        let starts = std::iter::once(0).chain(text.match_indices('\n').map(|(newline, _)| newline + 1)).collect();
        Reading {
            file,
            text,
            starts,
            problems: Vec::new(),
            plays: Plays::default(),
            beside: false,
            abreast: Vec::new(),
            numbers: Vec::new(),
        }
    }

    /// Says so if the file is larger than any slide or listing.
    pub(crate) fn is_too_large(&mut self) -> bool {
        let large = self.text.len() > limits::BYTES;
        if large {
            self.problem(0, limits::too_large(self.text.len() as u64));
        }
        large
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
        let line = self.starts.partition_point(|start| *start <= offset).max(1);
        let before = self.text.get(self.starts[line - 1]..offset).unwrap_or_default();
        Spot { line: line as u32, column: 1 + before.chars().count() as u32 }
    }

    /// Says what is wrong at a byte of the file.
    pub(crate) fn problem(&mut self, offset: usize, message: impl Into<String>) {
        let message = match self.problems.len() {
            less if less < limits::PROBLEMS => message.into(),
            limits::PROBLEMS => "more is wrong further on: mend this first".to_owned(),
            _ => return,
        };
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_byte_stands_on_a_line_and_in_a_column() {
        let text = "ab\n→x\n\nlast";
        let reading = Reading::new("file", text);
        let spots = [(0, 1, 1), (2, 1, 3), (3, 2, 1), (6, 2, 2), (7, 2, 3), (8, 3, 1), (9, 4, 1), (13, 4, 5)];
        for (byte, line, column) in spots {
            assert_eq!(reading.spot(byte), Spot { line, column }, "byte {byte}");
        }
    }
}
