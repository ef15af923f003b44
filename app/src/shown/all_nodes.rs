//! The nodes of everything that a play walks through.

use raystep_accel::Structure;
use raystep_figure::Nodes;
use raystep_lesson::Tape;

/// Nodes as pictures need them: of the structure, and of those that are walked side by side.
#[derive(Debug)]
pub struct AllNodes {
    /// Of the structure.
    pub(crate) own: Nodes,
    /// Of each structure that is walked side by side.
    pub(crate) abreast: Vec<Nodes>,
}

impl AllNodes {
    /// The nodes of a structure, and of those beside it in what is played.
    pub(crate) fn of(structure: &Structure, told: Option<&Tape>) -> AllNodes {
        let abreast = match told {
            Some(Tape::Walks(walks)) => walks.structures.iter().map(|structure| Nodes::of(structure)).collect(),
            _ => Vec::new(),
        };
        AllNodes { own: Nodes::of(structure), abreast }
    }
}
