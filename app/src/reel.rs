//! What lessons play, as the figures take it.

use raystep_accel::Event;
use raystep_figure::{Build, ListingLine, Nodes, Reel, Walk};
use raystep_lesson::{Listing, Play, Plays, Tape};

/// The walk or the build of a play.
pub(crate) fn reel<'a>(play: &'a Play, nodes: &'a Nodes) -> Reel<'a> {
    let (structure, prims, flat) = (&*play.structure, &play.scene.prims, play.scene.flat);
    match &play.tape {
        Tape::Walk(walk) => {
            Reel::Walk(Walk { structure, prims, nodes, ray: walk.ray, events: &walk.events, lost: walk.lost, flat })
        }
        Tape::Build(build) => {
            Reel::Build(Build { structure, nodes, prims, events: &build.events, lost: build.lost, flat })
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

/// The lines of a listing, the one marked that shows the event.
pub(crate) fn lines(code: Option<&Listing>, event: Option<Event>) -> Vec<ListingLine<'_>> {
    let Some(code) = code else { return Vec::new() };
    let current = event.and_then(|event| code.line_of(event.name()));
    let lines = code.lines.iter().enumerate();
    lines
        .map(|(index, line)| ListingLine {
            indent: line.indent,
            text: &line.text,
            current: Some(index) == current,
            values: line.values.as_deref(),
        })
        .collect()
}
