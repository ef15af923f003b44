//! Nouns behind counts: nothing that a slide says or draws reads "1 nodes".

use std::borrow::Cow;

use glam::Vec2;
use raystep_accel::{KdLayout, Place, Value};
use raystep_figure::{
    Ask, Build, Fact, Figure, Fitting, Form, Ink, Look, Nodes, PacketWalk, Pairs, Pane, Reel, Symbol, VolumeName, Walk,
    told,
};
use raystep_lesson::{Facts, Library, Medium, Play, Plays, Slide, Tape};

/// Of the steps of a play, so many are drawn and told.
const TRIED: usize = 20;

/// What is counted on slides, as many of it.
const MANY: [&str; 40] = [
    "boxes",
    "bytes",
    "candidates",
    "cells",
    "children",
    "corners",
    "cuts",
    "directions",
    "discs",
    "events",
    "faces",
    "hulls",
    "instances",
    "lanes",
    "leaves",
    "levels",
    "lists",
    "lookups",
    "nodes",
    "objects",
    "pairs",
    "pixels",
    "planes",
    "points",
    "primitives",
    "rays",
    "references",
    "regions",
    "rounds",
    "sets",
    "slabs",
    "slots",
    "spheres",
    "steps",
    "tests",
    "times",
    "triangles",
    "visits",
    "volumes",
    "ways",
];

/// The first count of one in a text that has a noun for many behind it.
fn wrong(text: &str) -> Option<&str> {
    text.match_indices("1 ").map(|(at, _)| at).find_map(|at| {
        let before = &text[..at];
        // Part of a longer number, or of a product or a difference.
        let digit = before.trim_end().ends_with(|letter: char| ".,−-/·×".contains(letter))
            || before.ends_with(|letter: char| letter.is_ascii_digit());
        // A number after a noun is a name: node 1 tests nothing.
        let named = ["node ", "primitive ", "cell ", "level ", "depth ", "slide ", "ray ", "face ", "point "];
        let named = named.iter().any(|noun| before.to_lowercase().ends_with(noun));
        let rest = &text[at + 2..];
        let noun = rest.split(|letter: char| !letter.is_alphabetic()).next().unwrap_or_default();
        let noun = match rest.strip_prefix("**") {
            Some(bold) => bold.split(|letter: char| !letter.is_alphabetic()).next()?,
            None => noun,
        };
        (!digit && !named && MANY.contains(&noun)).then(|| &text[at..])
    })
}

#[test]
fn a_count_of_one_is_found() {
    let table = [
        ("It has 1 nodes.", true),
        ("1 **tests** so far", true),
        ("It has 1 node.", false),
        ("It has 21 nodes, 0.1 tests a ray, 3 × 1 cells.", false),
        ("Node 1 tests nothing; 1 of 7 tests hit; 2n − 1 nodes.", false),
    ];
    for (text, found) in table {
        assert_eq!(wrong(text).is_some(), found, "{text}");
    }
}

/// What a slide knows at a step.
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

/// Everything that the beats of a slide say in a play: texts, questions, answers and reasons.
fn said(slide: &Slide, play: &Play) -> Vec<String> {
    let mut texts = Vec::new();
    for (beat, step) in slide.beats.iter().zip(&play.beats) {
        let Some(step) = *step else { continue };
        let Some(facts) = Facts::at(play, step) else { continue };
        let mut templates: Vec<String> = [Medium::Window, Medium::Paper].map(|medium| beat.text(&facts, medium)).into();
        templates.push(beat.title.clone());
        if let Some(ask) = &beat.ask {
            templates.push(ask.question.clone());
            let choices = ask.choices(play, step - 1);
            templates.extend(choices.into_iter().flat_map(|choice| [choice.label, choice.reason]).flatten());
        }
        let known = Known(facts);
        texts.extend(templates.iter().map(|template| told(template, &known)));
    }
    texts
}

/// The steps of the beats, the first and the last one, and some between.
fn steps(play: &Play) -> Vec<usize> {
    let last = play.tape.len();
    let between = (0..=last).step_by(last.div_ceil(TRIED).max(1));
    play.beats.iter().flatten().copied().chain(between).chain([last]).collect()
}

/// What a picture says in letters.
fn written(figure: &Figure) -> impl Iterator<Item = String> + '_ {
    figure.marks.iter().filter_map(|mark| match &mark.ink {
        Ink::Text { text, .. } => Some(text.clone()),
        _ => None,
    })
}

/// What is drawn and told at the steps of a play, in letters.
fn drawn(reel: &Reel<'_>, play: &Play) -> Vec<String> {
    let mut texts = Vec::new();
    for step in steps(play) {
        let instant = reel.at(step);
        let still = reel.still(&instant);
        let labels = still.space().into_iter().flat_map(|space| space.marks).filter_map(|mark| match mark.form {
            Form::Label { text, .. } => Some(text),
            _ => None,
        });
        texts.extend(labels);
        for pane in Pane::ALL.into_iter().filter(|pane| reel.has(*pane)) {
            texts.extend(written(&still.draw(pane, &Ask::new(Vec2::new(640.0, 400.0), Look::WINDOW))));
        }
        texts.extend(play.event(step).map(|event| event.sentence(VolumeName::of(&play.structure))));
    }
    texts
}

#[test]
fn no_slide_counts_one_as_many() {
    let (mut tried, mut found) = (0, Vec::new());
    for slide in &Library::embedded().slides {
        for stage in &slide.stages {
            let built = stage.draft(slide.plays).expect("a shipped stage");
            let beside = stage.build_beside(&built.scene, slide.plays).expect("what stands beside");
            let nodes = Nodes::of(&built.structure);
            let rays: Vec<_> = match slide.plays {
                Plays::Walk | Plays::Walks | Plays::Packet => stage.rays.iter().map(|ray| Some(ray.ray)).collect(),
                _ => vec![None],
            };
            for ray in rays {
                let play = built.play_with(beside.as_ref(), ray, &slide.beats).expect("something is played");
                let (structure, prims, flat) = (&*play.structure, &play.scene.prims, play.scene.flat);
                let nodes = &nodes;
                let reel = match &play.tape {
                    Tape::Walk(walk) => {
                        let (ray, events, lost) = (walk.ray, &walk.events[..], walk.lost);
                        let layout = KdLayout::Compact;
                        Some(Reel::new(Walk { structure, prims, nodes, ray, events, lost, flat, layout }))
                    }
                    Tape::Build(build) => Some(Reel::new(Build {
                        structure,
                        nodes,
                        prims,
                        events: &build.events,
                        lost: &build.lost,
                        instead: None,
                        changes: &[],
                        flat,
                    })),
                    Tape::Packet(packet) => {
                        let (rays, events, lost) = (&packet.rays[..], &packet.events[..], packet.lost);
                        let alone = &packet.costs[..];
                        Some(Reel::new(PacketWalk { structure, prims, nodes, rays, events, lost, alone, flat }))
                    }
                    Tape::Fit(fit) => Some(Reel::new(Fitting { prims, events: &fit.events, volume: fit.volume, flat })),
                    Tape::Pairs(pairs) => Some(Reel::new(Pairs { cases: &pairs.cases, events: &pairs.events })),
                    Tape::Walks(_) | Tape::Board(_) => None,
                };
                let told = said(slide, &play).into_iter().chain(reel.iter().flat_map(|reel| drawn(reel, &play)));
                for text in told {
                    tried += 1;
                    if let Some(count) = wrong(&text) {
                        found.push(format!("{} {:?}: {count}", slide.id(), stage.kind));
                    }
                }
            }
        }
    }
    found.sort();
    found.dedup();
    assert!(found.is_empty(), "{found:#?}");
    assert!(tried > 10_000, "{tried} texts");
}
