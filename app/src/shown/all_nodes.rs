//! The nodes of everything that a play walks through, and what else its pictures are made of once.

use raystep_accel::Structure;
use raystep_figure::{Changed, Nodes};
use raystep_lesson::{Tape, Told};

use super::board::Panels;
use super::kind_name::kind_name;

/// Nodes as pictures need them: of the structure, and of those that are walked side by side. And the panels of a board.
#[derive(Debug)]
pub struct AllNodes {
    /// Of the structure.
    pub(crate) own: Nodes,
    /// Of each structure that is walked side by side.
    pub(crate) abreast: Vec<Nodes>,
    /// What is done to the structure once it is built.
    pub(crate) changes: Vec<Changed>,
    /// What stands on the board that is filled.
    pub(crate) board: Option<Panels>,
}

impl AllNodes {
    /// The nodes of a structure, and of those beside it in what is played.
    pub(crate) fn of(structure: &Structure, told: Option<&Tape>) -> AllNodes {
        let abreast = match told {
            Some(Tape::Walks(walks)) => walks.structures.iter().map(|structure| Nodes::of(structure)).collect(),
            _ => Vec::new(),
        };
        let board = match told {
            Some(Tape::Board(filled)) => Some(Panels::of(filled)),
            _ => None,
        };
        let changes = match told {
            Some(Tape::Build(build)) => build.changes.iter().map(changed).collect(),
            _ => Vec::new(),
        };
        AllNodes { own: Nodes::of(structure), abreast, changes, board }
    }
}

/// A change with the name of what is built anew beside it.
fn changed(told: &Told) -> Changed {
    let anew = told.anew.as_ref().map(|(kind, made)| (kind_name(kind).to_owned(), *made));
    Changed { change: told.change, from: told.from, done: told.done, anew }
}
