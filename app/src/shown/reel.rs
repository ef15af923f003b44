//! What lessons play, as the figures take it.

use std::borrow::Cow;

use super::all_nodes::AllNodes;
use super::kind_name::kind_name;
use std::sync::Arc;

use raystep_accel::{Event, Grow, KdLayout, Mistake, Place, Prims, Rule, Structure, Value};
use raystep_figure::{
    Board, Build, Fact, Fitting, ListingLine, Nodes, PacketWalk, Pairs, Pane, Reel, Symbol, VolumeName, Walk, Walks,
    told,
};
use raystep_lesson::{Beat, Care, Facts, Listing, Medium, Plan, Play, Plays, Show, Tape, WalksTape};

/// What a play is shown as: the only place that knows which kind that is. `instead` is what a builder weighed where
/// another cut is tried.
pub(crate) fn reel<'a>(play: &'a Play, all: &'a AllNodes, instead: Option<Grow>) -> Reel<'a> {
    let nodes = &all.own;
    let (structure, prims, flat) = (&*play.structure, &play.scene.prims, play.scene.flat);
    match &play.tape {
        Tape::Walk(walk) => {
            let (ray, events, lost, layout) = (walk.ray, walk.events.as_slice(), walk.lost, play.layout);
            Reel::new(Walk { structure, prims, nodes, ray, events, lost, flat, layout })
        }
        Tape::Build(build) => Reel::new(Build {
            structure,
            nodes,
            prims,
            events: &build.events,
            lost: &build.lost,
            instead,
            changes: &all.changes,
            flat,
        }),
        Tape::Board(filled) => Reel::new(match &all.board {
            Some(panels) => panels.board(filled),
            None => Board { panels: &[], events: &filled.events, names: &[] },
        }),
        Tape::Pairs(pairs) => Reel::new(Pairs { cases: &pairs.cases, events: &pairs.events }),
        Tape::Fit(fit) => Reel::new(Fitting { prims, events: &fit.events, volume: fit.volume, flat }),
        Tape::Packet(packet) => {
            let (rays, events, lost, alone) = (&packet.rays[..], &packet.events[..], packet.lost, &packet.costs[..]);
            Reel::new(PacketWalk { structure, prims, nodes, rays, events, lost, alone, flat })
        }
        Tape::Walks(walks) => Reel::new(side_by_side(walks, &all.abreast, prims, flat)),
    }
}

/// Walks beside each other.
fn side_by_side<'a>(walks: &'a WalksTape, nodes: &'a [Nodes], prims: &'a Prims, flat: bool) -> Walks<'a> {
    let each = walks.walks.iter().zip(&walks.structures).zip(nodes).zip(&walks.plans);
    let walk = |(((tape, structure), nodes), plan): (((&'a Tape, &'a Arc<Structure>), &'a Nodes), &'a Plan)| {
        let Tape::Walk(walk) = tape else { return None };
        let settings: Vec<String> = plan
            .settings
            .iter()
            .map(|setting| format!("{}: {}", setting.key.replace('_', " "), setting.value))
            .collect();
        let (ray, events, lost) = (walk.ray, walk.events.as_slice(), walk.lost);
        let walk = Walk { structure, prims, nodes, ray, events, lost, flat, layout: KdLayout::Compact };
        Some((kind_name(&plan.kind).to_owned(), settings.join(", "), walk))
    };
    Walks { walks: each.filter_map(walk).collect(), order: &walks.order, reached: &walks.reached }
}

/// What is said before the first event.
pub(crate) fn beginning(plays: Plays) -> &'static str {
    match plays {
        Plays::Walk => "Before the walk: the ray has met nothing yet.",
        Plays::Build => "Before the build: the primitives lie there, and nothing is known of them yet.",
        Plays::Walks => "Before the walks: the ray has met nothing yet.",
        Plays::Packet => "Before the walk: the rays have met nothing yet.",
        Plays::Board => "Nothing is filled in yet.",
        Plays::Pairs => "Nothing is laid out yet.",
        Plays::Fit => "Before the fitting: the primitives lie there, and no volume holds them yet.",
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

    fn is_rough(&self, name: &str) -> bool {
        self.0.care(name) == Care::Draft
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

/// The lines of a listing, the one marked that shows the event of the step, and the one where a mistake is made beside.
/// A cut that the rule says by hand is not called the cheapest.
pub(crate) fn lines<'a>(
    code: Option<&'a Listing>,
    play: &Play,
    rule: &Rule,
    step: usize,
    mistake: Option<Mistake>,
) -> Vec<ListingLine<'a>> {
    let Some(code) = code else { return Vec::new() };
    let made = mistake.and_then(|mistake| {
        let (event, instead) = mistake.instead();
        Some((code.line_named(event)?, instead))
    });
    let current = Facts::at(play, step).and_then(|facts| code.line_of(&facts));
    let cuts = rule.by_hand().filter(|cuts| !cuts.is_empty());
    let by_hand = match play.event(step) {
        Some(Event::Build(Grow::Split { node, .. })) => cuts.is_some_and(|cuts| cuts.of(node).is_some()),
        _ => false,
    };
    let lines = code.lines.iter().enumerate();
    lines
        .map(|(index, line)| ListingLine {
            indent: line.indent,
            text: if by_hand && Some(index) == current { BY_HAND } else { &line.text },
            current: Some(index) == current,
            values: line.values.as_deref(),
            instead: made.filter(|(line, _)| *line == index).map(|(_, instead)| instead),
        })
        .collect()
}

/// What the listing says of a cut that somebody chose.
const BY_HAND: &str = "else: cut where it was set by hand";

/// The pane beside or below space that a slide asks for, if it has a say in it.
pub(crate) fn pane(show: &Show) -> Option<Pane> {
    match show {
        Show::Ruler => Some(Pane::Ruler),
        Show::Tree => Some(Pane::Tree),
        Show::Cells => Some(Pane::Cells),
        Show::Matrix => Some(Pane::Matrix),
        Show::Slabs => Some(Pane::Slabs),
        Show::Bytes => Some(Pane::Bytes),
        Show::Space | Show::Stack | Show::Listing | Show::Work => None,
    }
}
