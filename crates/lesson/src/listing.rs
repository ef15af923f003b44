//! A listing: pseudocode of our own, its lines labelled with the events they show.

use crate::{Spot, wait};

/// An algorithm in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Listing {
    /// Its name: the file without its ending.
    pub name: String,
    /// Its lines.
    pub lines: Vec<Line>,
    /// The file it was read from.
    pub file: String,
}

/// A line of a listing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// The pseudocode, with its indentation.
    pub code: String,
    /// The events it shows.
    pub labels: Vec<Label>,
}

/// An event that a line shows, and its numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// The event's name or the beginning of it.
    pub event: String,
    /// The line again with this step's numbers: text with `{{field}}`. May be empty.
    pub values: String,
    /// Where the label stands.
    pub(crate) spot: Spot,
}

impl Listing {
    /// The line that shows an event, and the template of its values; of several, the longest label wins.
    pub fn line_of(&self, event: &str) -> Option<(usize, &str)> {
        let labels =
            self.lines.iter().enumerate().flat_map(|(index, line)| line.labels.iter().map(move |l| (index, l)));
        let fits = labels.filter(|(_, label)| wait::names(&label.event, event));
        // The first of the longest.
        fits.reduce(|best, other| if other.1.event.len() > best.1.event.len() { other } else { best })
            .map(|(index, label)| (index, label.values.as_str()))
    }
}
