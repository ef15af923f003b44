//! Which panes there are, and what one is told that is to be drawn.

use glam::Vec2;
use raystep_accel::{Interval, Structure};

use super::{ListingLine, TreeView};
use crate::page::Look;
use crate::world::Space;

/// A part of the page that is a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pane {
    /// What fills the middle of the page where there is no space: a chart, a table, pictures side by side.
    Picture,
    /// The ray as a ruler of t; of a build, what its splits cost.
    Ruler,
    /// The same on one line, for the far end of a lecture hall.
    RulerLine,
    /// The tree of nodes.
    Tree,
    /// The cell where the walk stands, or the cells that a primitive is put into.
    Cells,
    /// The matrix of pairs.
    Matrix,
    /// The test of a volume.
    Slabs,
    /// A node, or a table of cells, as it lies in memory.
    Bytes,
    /// The algorithm with the line of this step.
    Listing,
    /// What is not as it was at the step before.
    Changed,
    /// What waits.
    Stack,
    /// What waits, as an open bin, for the far end of a lecture hall.
    Bin,
    /// The work so far.
    Work,
    /// What the marks of space mean.
    Legend,
    /// The track of all steps.
    Timeline,
    /// The charts of a board.
    Chart,
    /// The tables of a board.
    Table,
    /// The numbers of a board that are moved by hand.
    Meter,
    /// The heat maps of a board.
    Heat,
    /// The ray traced pictures of a board.
    Traced,
}

impl Pane {
    /// Every pane.
    pub const ALL: [Pane; 20] = [
        Pane::Picture,
        Pane::Ruler,
        Pane::RulerLine,
        Pane::Tree,
        Pane::Cells,
        Pane::Matrix,
        Pane::Slabs,
        Pane::Bytes,
        Pane::Listing,
        Pane::Changed,
        Pane::Stack,
        Pane::Bin,
        Pane::Work,
        Pane::Legend,
        Pane::Timeline,
        Pane::Chart,
        Pane::Table,
        Pane::Meter,
        Pane::Heat,
        Pane::Traced,
    ];

    /// The pane in which a structure is best seen beside space; nothing if it has no parts.
    pub fn best_of(structure: &Structure) -> Option<Pane> {
        match structure {
            Structure::Slab(_) => Some(Pane::Slabs),
            Structure::List(_) => None,
            structure if structure.grid().is_some() => Some(Pane::Cells),
            _ => Some(Pane::Tree),
        }
    }

    /// What stands on its tab.
    pub fn name(self) -> &'static str {
        match self {
            Pane::Picture => "Picture",
            Pane::Ruler | Pane::RulerLine => "t along the ray",
            Pane::Tree => "Tree",
            Pane::Cells => "Cells",
            Pane::Matrix => "Pairs",
            Pane::Slabs => "Slabs",
            Pane::Bytes => "Bytes",
            Pane::Listing => "Walk",
            Pane::Changed => "Changed",
            Pane::Stack | Pane::Bin => "Stack",
            Pane::Work => "Work",
            Pane::Legend => "Signs",
            Pane::Timeline => "Timeline",
            Pane::Chart => "Chart",
            Pane::Table => "Table",
            Pane::Meter => "Numbers",
            Pane::Heat => "Heat map",
            Pane::Traced => "Pictures",
        }
    }
}

/// What whoever wants a pane knows beside the step: how large it is to be, and what only some panes ask for.
#[derive(Clone, Copy, Debug)]
pub struct Ask<'a> {
    /// Width and height in points.
    pub size: Vec2,
    /// How large it is set.
    pub look: Look,
    /// Whether a question is open: what answers it is hidden.
    pub hide: bool,
    /// The last step that the timeline tells of: behind it a question is still to be asked.
    pub told: usize,
    /// What the user has zoomed to, opened and closed in the tree.
    pub view: Option<&'a TreeView>,
    /// The lines of the listing.
    pub lines: &'a [ListingLine<'a>],
    /// The name of a walk beside this one, and how many primitives it has tested.
    pub beside: Option<(&'a str, u64)>,
    /// The part of the ruler that is shown, where that is not all of it.
    pub part: Option<Interval>,
    /// What space shows at this step, where it is drawn already.
    pub space: Option<&'a Space>,
}

impl Ask<'_> {
    /// A pane of this size, and nothing else.
    pub fn new(size: Vec2, look: Look) -> Ask<'static> {
        Ask { size, look, hide: false, told: usize::MAX, view: None, lines: &[], beside: None, part: None, space: None }
    }
}
