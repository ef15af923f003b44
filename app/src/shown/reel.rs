//! What lessons play, as the figures take it.

use raystep_accel::Mistake;
use raystep_figure::{Build, Fact, ListingLine, Nodes, Pane, Reel, Walk};
use raystep_lesson::{Listing, Play, Plays, Show, Tape};

/// What a play is shown as: the only place that knows which kind that is.
pub(crate) fn reel<'a>(play: &'a Play, nodes: &'a Nodes) -> Reel<'a> {
    let (structure, prims, flat) = (&*play.structure, &play.scene.prims, play.scene.flat);
    match &play.tape {
        Tape::Walk(walk) => Reel::new(Walk { structure, prims, nodes, ray: walk.ray, events: &walk.events, flat }),
        Tape::Build(build) => {
            Reel::new(Build { structure, nodes, prims, events: &build.events, lost: build.lost, flat })
        }
    }
}

/// What is said before the first event.
pub(crate) fn beginning(plays: Plays) -> &'static str {
    match plays {
        Plays::Walk => "Before the walk: the ray has met nothing yet.",
        Plays::Build => "Before the build: the primitives lie there, and nothing is known of them yet.",
    }
}

/// The lines of a listing, the one marked that shows the event, and the one where a mistake is made beside.
pub(crate) fn lines<'a>(
    code: Option<&'a Listing>,
    event: Option<&dyn Fact>,
    mistake: Option<Mistake>,
) -> Vec<ListingLine<'a>> {
    let Some(code) = code else { return Vec::new() };
    let made = mistake.and_then(|mistake| {
        let (event, instead) = mistake.instead();
        Some((code.line_of(event)?, instead))
    });
    let current = event.and_then(|event| code.line_of(event.name()));
    let lines = code.lines.iter().enumerate();
    lines
        .map(|(index, line)| ListingLine {
            indent: line.indent,
            text: &line.text,
            current: Some(index) == current,
            values: line.values.as_deref(),
            instead: made.filter(|(line, _)| *line == index).map(|(_, instead)| instead),
        })
        .collect()
}

/// The pane beside or below space that a slide asks for, if it has a say in it.
pub(crate) fn pane(show: &Show) -> Option<Pane> {
    match show {
        Show::Ruler => Some(Pane::Ruler),
        Show::Tree => Some(Pane::Tree),
        Show::Cells => Some(Pane::Cells),
        Show::Slabs => Some(Pane::Slabs),
        Show::Bytes => Some(Pane::Bytes),
        Show::Space | Show::Stack | Show::Listing | Show::Work => None,
    }
}
