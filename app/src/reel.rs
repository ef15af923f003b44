//! What lessons play, as the figures take it.

use std::borrow::Cow;

use raystep_accel::{Place, Value};
use raystep_figure::{Build, Fact, ListingLine, Nodes, Reel, Symbol, VolumeName, Walk, told};
use raystep_lesson::{Beat, Facts, Listing, Medium, Play, Plays, Tape};

/// The walk or the build of a play.
pub(crate) fn reel<'a>(play: &'a Play, nodes: &'a Nodes) -> Reel<'a> {
    let (structure, prims, flat) = (&*play.structure, &play.scene.prims, play.scene.flat);
    match &play.tape {
        Tape::Walk(walk) => Reel::Walk(Walk { structure, prims, nodes, ray: walk.ray, events: &walk.events, flat }),
        Tape::Build(build) => {
            Reel::Build(Build { structure, nodes, prims, events: &build.events, lost: &build.lost, flat })
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

/// What a beat says at a step, its numbers filled in.
pub(crate) fn said(beat: &Beat, play: &Play, step: usize, medium: Medium) -> String {
    Facts::at(play, step).map_or_else(String::new, |facts| told(&beat.text(&facts, medium), &Known(facts)))
}

/// What a slide knows at a step, for the figures' templates.
struct Known<'a>(Facts<'a>);

impl Fact for Known<'_> {
    fn name(&self) -> &'static str {
        self.0.event().name()
    }

    fn place(&self) -> Place {
        self.0.event().place()
    }

    fn field(&self, name: &str) -> Option<Value> {
        self.0.field(name)
    }

    fn symbol(&self) -> Option<Symbol> {
        self.0.event().symbol()
    }

    fn short(&self, volume: VolumeName) -> Cow<'static, str> {
        self.0.event().short(volume)
    }

    fn sentence(&self, volume: VolumeName) -> String {
        self.0.event().sentence(volume)
    }
}

/// The lines of a listing, the one marked that shows the event of the step.
pub(crate) fn lines<'a>(code: Option<&'a Listing>, play: &Play, step: usize) -> Vec<ListingLine<'a>> {
    let Some(code) = code else { return Vec::new() };
    let current = Facts::at(play, step).and_then(|facts| code.line_of(&facts));
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
