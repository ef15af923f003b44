//! The pictures of every slide, at its beats and at steps between them: what a reader can take in at once.

use glam::Vec2;
use raystep_accel::{KdLayout, Place, Structure};
use raystep_figure::{
    Ask, Build, Depth, Figure, Fitting, Form, Ink, Look, Nodes, PacketWalk, Pane, Reel, Role, Space, VolumeName, Walk,
};
use raystep_lesson::{Library, Play, Plays, Slide, Stage, Tape};

/// Cells along a ray, in a grid within a cell too.
const CELLS: usize = 120;

/// Most boxes that a solid picture shows at once: more is a tangle of wires.
const WIRED: usize = 12;

/// The same of an octree: a node has eight children.
const WIRED_OF_EIGHT: usize = 21;

/// Most labels on them: a slab test has two planes and two t, beside where the walk is and what it tested.
const LABELS: usize = 6;

/// Of the steps between the beats, so many are tried on each ray.
const TRIED: usize = 60;

/// Calls `check` with every stage of every slide, each of its rays played, and what it shows.
fn every_play(check: &mut dyn FnMut(&Slide, &Stage, &Play, &Reel<'_>, &Nodes)) {
    let library = Library::embedded();
    // Walks side by side are flat, and boards have no stage: neither shows a tree in space.
    for slide in library.slides.iter().filter(|slide| matches!(slide.plays, Plays::Walk | Plays::Build)) {
        for stage in &slide.stages {
            let built = stage.build(slide.plays).expect("a shipped stage");
            let nodes = Nodes::of(&built.structure);
            let rays: Vec<_> = match slide.plays {
                Plays::Walk | Plays::Packet => stage.rays.iter().map(|ray| Some(ray.ray)).collect(),
                _ => vec![None],
            };
            for ray in rays {
                let play = built.play(ray, &slide.beats).expect("something is played");
                let (structure, prims, flat) = (&*play.structure, &play.scene.prims, play.scene.flat);
                let reel = match &play.tape {
                    Tape::Walk(walk) => {
                        let (ray, events, lost) = (walk.ray, &walk.events[..], walk.lost);
                        Reel::new(Walk {
                            structure,
                            prims,
                            nodes: &nodes,
                            ray,
                            events,
                            lost,
                            flat,
                            layout: KdLayout::Compact,
                        })
                    }
                    Tape::Build(build) => Reel::new(Build {
                        structure,
                        nodes: &nodes,
                        prims,
                        events: &build.events,
                        lost: &build.lost,
                        instead: None,
                        changes: &[],
                        flat,
                    }),
                    Tape::Packet(packet) => {
                        let (rays, events, lost) = (&packet.rays[..], &packet.events[..], packet.lost);
                        let alone = &packet.costs[..];
                        Reel::new(PacketWalk { structure, prims, nodes: &nodes, rays, events, lost, alone, flat })
                    }
                    Tape::Fit(fit) => Reel::new(Fitting { prims, events: &fit.events, volume: fit.volume, flat }),
                    Tape::Walks(_) | Tape::Board(_) | Tape::Pairs(_) => continue,
                };
                check(slide, stage, &play, &reel, &nodes);
            }
        }
    }
}

/// The steps of the beats, the first and the last one, and some between.
fn steps(play: &Play) -> Vec<usize> {
    let last = play.tape.len();
    let between = (0..=last).step_by(last.div_ceil(TRIED).max(1));
    let mut steps: Vec<usize> = play.beats.iter().flatten().copied().chain(between).chain([last]).collect();
    steps.sort_unstable();
    steps.dedup();
    steps
}

fn is_wired(form: &Form) -> bool {
    matches!(form, Form::Box(_) | Form::Body(_) | Form::Sphere(_))
}

/// The places whose boxes are drawn.
fn wired(space: &Space) -> usize {
    let boxes = space.marks.iter().filter(|mark| is_wired(&mark.form));
    boxes.map(|mark| mark.place).collect::<std::collections::BTreeSet<Option<Place>>>().len()
}

#[test]
fn solid_pictures_are_no_tangles_and_say_what_they_show() {
    let mut tried = 0;
    every_play(&mut |slide, stage, play, reel, _| {
        if reel.flat() {
            return;
        }
        let grid = play.structure.grid().is_some();
        for step in steps(play) {
            let instant = reel.at(step);
            let space = reel.still(&instant).space().expect("a walk and a build are in space");
            let what = format!("{} {:?} at step {step}", slide.id(), stage.kind);
            // Cells along a ray or under a box stand beside each other; boxes of a tree lie within each other.
            let most = match *play.structure {
                _ if grid => CELLS,
                Structure::Octree(_) => WIRED_OF_EIGHT,
                _ => WIRED,
            };
            let boxes = wired(&space);
            assert!(boxes <= most, "{what}: {boxes} boxes");
            let labels = space.marks.iter().filter_map(|mark| match &mark.form {
                Form::Label { text, .. } => Some(text.as_str()),
                _ => None,
            });
            let labels: Vec<&str> = labels.collect();
            assert!(labels.len() <= LABELS, "{what}: {labels:?}");
            let missed =
                space.marks.iter().filter(|mark| mark.role == Role::Missed && matches!(mark.form, Form::Prim(_)));
            assert!(missed.count() <= 70, "{what}: speckles");
            if reel.deepest().is_some() && step == play.tape.len() {
                let cells = matches!(*play.structure, Structure::Bsp(_));
                let drawn = if cells { "cells" } else { VolumeName::of(&play.structure).many };
                let says = |note: &String| note.strip_prefix(drawn).is_some_and(|rest| rest.starts_with(": "));
                assert!(space.notes.iter().any(says), "{what}: {:?}", space.notes);
            }
            tried += 1;
        }
    });
    assert!(tried > 500, "{tried} pictures");
}

#[test]
fn levels_are_added_to_a_solid_picture_one_by_one() {
    every_play(&mut |slide, stage, play, reel, _| {
        // The cells of a BSP tree are no boxes.
        let Some(deepest) = reel.deepest().filter(|_| !matches!(*play.structure, Structure::Bsp(_))) else { return };
        let instant = reel.at(play.tape.len());
        let boxes = |depth| wired(&reel.still(&instant).to_depth(depth).space().expect("there is space"));
        // A finished build shows its upper levels by itself, a walk the end of its path.
        let mut before = if play.tape.ray().is_some() { boxes(Depth::Path) } else { 0 };
        for level in 1..=deepest.min(6) {
            let now = boxes(Depth::Down(level));
            let what = format!("{} {:?} level {level}", slide.id(), stage.kind);
            assert!(now + WIRED >= before && now > level as usize, "{what}: {before}, then {now}");
            before = now;
        }
        // Trees that end above have fewer.
        assert!(before > WIRED || deepest < 6, "{} {:?}: level 6 has {before} boxes", slide.id(), stage.kind);
    });
}

/// The nodes that a tree's figure draws, with the size of their digits.
fn digits(figure: &Figure) -> Vec<(Place, f32)> {
    let mut digits: Vec<(Place, f32)> = Vec::new();
    for pair in figure.marks.windows(2) {
        let shape = matches!(pair[0].ink, Ink::Circle { .. } | Ink::Rect { .. });
        if let (Some(place @ Place::Node(node)), Ink::Text { text, size, .. }) = (pair[1].place, &pair[1].ink)
            && shape
            && pair[0].place == Some(place)
            && *text == node.0.to_string()
        {
            digits.push((place, *size));
        }
    }
    digits
}

#[test]
fn small_trees_stand_whole_in_windows_and_on_plates() {
    let mut small = 0;
    every_play(&mut |slide, stage, play, reel, nodes| {
        let count = play.structure.node_count();
        if !(1..=31).contains(&count) || matches!(*play.structure, Structure::Slab(_)) {
            return;
        }
        // The panes of a window of 1280 × 800, of one of 1600 × 1000, and of a plate.
        let plate = Look { text: 15.0, titles: true, least: 0.0 };
        for (width, page, look) in [(630.0, 672.0, Look::WINDOW), (790.0, 872.0, Look::WINDOW), (780.0, 0.0, plate)] {
            let whole = raystep_figure::tree_height(nodes, &look).expect("a small tree has a height");
            let height = if page > 0.0 { whole.min(page * 0.32).max(page * 0.2) } else { whole + 6.0 };
            for step in steps(play) {
                let instant = reel.at(step);
                let figure = reel.still(&instant).draw(Pane::Tree, &Ask::new(Vec2::new(width, height), look));
                let digits = digits(&figure);
                let what = format!("{} {:?} at step {step} in {width} × {height}", slide.id(), stage.kind);
                assert!(digits.iter().all(|(_, size)| *size >= 11.0), "{what}: {digits:?}");
                let closed = figure.marks.iter().any(|mark| matches!(mark.ink, Ink::Area { .. }));
                assert!(!closed, "{what}: a node is folded");
                if slide.plays == Plays::Walk {
                    assert_eq!(digits.len(), count, "{what}");
                }
                small += 1;
            }
        }
    });
    assert!(small > 100, "{small} trees");
}
