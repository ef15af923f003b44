//! What a picture shows: a whole plate, a plate of one's own choice, or one pane.

use std::str::FromStr;

use clap::ValueEnum;
use raystep_figure::Pane;
use raystep_print::Part;

/// What a picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum View {
    /// A page with all of it.
    Plate,
    /// The scene with the walk in it, or what stands in its place.
    Space,
    /// The tree of nodes.
    Tree,
    /// The ray as a ruler of t; of a build, what its splits cost.
    T,
    /// The cell of the step.
    Cells,
    /// The matrix of pairs.
    Matrix,
    /// The test of a volume, slab by slab.
    Slabs,
    /// A node, or a table of cells, in memory.
    Bytes,
    /// What waits.
    Stack,
    /// The algorithm with the line of the step.
    Listing,
    /// The work so far.
    Work,
    /// What is not as it was at the step before.
    Changed,
    /// The track of all steps.
    Timeline,
    /// The charts of a board.
    Chart,
    /// The tables of a board.
    Table,
    /// The numbers of a board that are moved by hand.
    Numbers,
    /// The heat maps of a board; of a solid scene, what each ray of the picture costs.
    Heat,
    /// The ray traced pictures of a board.
    Pictures,
}

impl View {
    /// How the command line calls it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            View::Plate => "plate",
            View::Space => "space",
            View::Tree => "tree",
            View::T => "t",
            View::Cells => "cells",
            View::Matrix => "matrix",
            View::Slabs => "slabs",
            View::Bytes => "bytes",
            View::Stack => "stack",
            View::Listing => "listing",
            View::Work => "work",
            View::Changed => "changed",
            View::Timeline => "timeline",
            View::Chart => "chart",
            View::Table => "table",
            View::Numbers => "numbers",
            View::Heat => "heat",
            View::Pictures => "pictures",
        }
    }

    /// The pane that it shows; a plate has many, and space is drawn in its own way.
    pub(super) fn pane(self) -> Option<Pane> {
        Some(match self {
            View::Plate | View::Space => return None,
            View::Tree => Pane::Tree,
            View::T => Pane::Ruler,
            View::Cells => Pane::Cells,
            View::Matrix => Pane::Matrix,
            View::Slabs => Pane::Slabs,
            View::Bytes => Pane::Bytes,
            View::Stack => Pane::Stack,
            View::Listing => Pane::Listing,
            View::Work => Pane::Work,
            View::Changed => Pane::Changed,
            View::Timeline => Pane::Timeline,
            View::Chart => Pane::Chart,
            View::Table => Pane::Table,
            View::Numbers => Pane::Meter,
            View::Heat => Pane::Heat,
            View::Pictures => Pane::Traced,
        })
    }
}

/// What can stand on a plate of one's own choice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Piece {
    /// The title, and where it belongs.
    Title,
    /// What is said.
    Text,
    /// What the marks of space mean.
    Legend,
    /// A pane, or space.
    View(View),
}

impl Piece {
    /// How the command line calls it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Piece::Title => "title",
            Piece::Text => "text",
            Piece::Legend => "legend",
            Piece::View(view) => view.name(),
        }
    }

    /// The part of a plate that has its own place; nothing for panes below space.
    pub(super) fn part(self) -> Option<Part> {
        Some(match self {
            Piece::Title => Part::Title,
            Piece::Text => Part::Text,
            Piece::Legend => Part::Legend,
            Piece::View(View::Space) => Part::Space,
            Piece::View(View::Listing) => Part::Listing,
            Piece::View(View::Stack) => Part::Stack,
            Piece::View(View::Work) => Part::Work,
            Piece::View(View::Timeline) => Part::Timeline,
            Piece::View(_) => return None,
        })
    }

    /// All that there are.
    pub(crate) fn all() -> impl Iterator<Item = Piece> {
        let views = View::value_variants().iter().copied().filter(|view| *view != View::Plate);
        [Piece::Title, Piece::Text, Piece::Legend].into_iter().chain(views.map(Piece::View))
    }
}

impl FromStr for Piece {
    type Err = String;

    fn from_str(text: &str) -> Result<Piece, String> {
        Piece::all().find(|piece| piece.name() == text.trim()).ok_or_else(|| {
            let known: Vec<&str> = Piece::all().map(Piece::name).collect();
            format!("there is no pane \"{text}\"; there are {}", known.join(", "))
        })
    }
}
