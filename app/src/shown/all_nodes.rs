//! The nodes of everything that a play walks through, and what else its pictures are made of once.

use raystep_accel::Structure;
use raystep_figure::Nodes;
use raystep_lesson::Tape;

use super::board::Panels;

/// Nodes as pictures need them: of the structure, and of those that are walked side by side. And the panels of a board.
#[derive(Debug)]
pub struct AllNodes {
    /// Of the structure.
    pub(crate) own: Nodes,
    /// Of each structure that is walked side by side.
    pub(crate) abreast: Vec<Nodes>,
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
        AllNodes { own: Nodes::of(structure), abreast, board }
    }
}
