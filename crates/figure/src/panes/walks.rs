//! Walks side by side: one ray through several structures, each with its picture, its counters, its tree or cells and
//! what waits, over one axis of t.

use glam::Vec2;
use raystep_accel::{Place, Structure, Visit};

use super::ruler::{extent, side_by_side};
use super::{Ask, Pane, TreeView, cells, space, stack, tree};
use crate::moments::{Moment, Walk};
use crate::page::{Anchor, Figure, Ink, Look, Ticks, line, write};
use crate::stage::{Camera, Scenery, crop, stage};
use crate::theme::fonts::elided;
use crate::theme::{Face, Role, text_width};
use crate::words::{number, whole};

/// One of the walks: the name of its structure, its walk, and how far that has come.
pub(crate) struct Walker<'a> {
    pub(crate) name: &'a str,
    pub(crate) note: &'a str,
    pub(crate) walk: &'a Walk<'a>,
    pub(crate) moment: &'a Moment,
}

/// All of them beside each other.
pub(crate) fn walks(walkers: &[Walker<'_>], t: f32, ask: &Ask<'_>) -> Figure {
    let mut figure = if walkers.len() > ABREAST { map(walkers, ask) } else { abreast(walkers, t, ask) };
    // All have the same primitives. Their nodes share no more than numbers: what lights up in one is another place in
    // the next.
    figure.marks.iter_mut().for_each(|mark| mark.place = mark.place.filter(|place| matches!(place, Place::Prim(_))));
    figure
}

/// Up to three, with their trees or cells over one axis of t.
fn abreast(walkers: &[Walker<'_>], t: f32, ask: &Ask<'_>) -> Figure {
    let mut figure = Figure::new(ask.size);
    let size = ask.size;
    let wide = size.x / walkers.len().max(1) as f32;
    let look = columns(walkers, ask);
    let u = look.text;
    let ruler = Vec2::new(size.x, u * (6.6 + 1.9 * walkers.len() as f32));
    let high = (size.y - ruler.y).max(u * 10.0);
    let top = below_heads(walkers, wide, &look);
    let waits = walkers.iter().any(|walker| walker.walk.structure.node_count() > 0);
    let counters = counts_height(walkers, wide - 2.0 * look.margin(), &look) - u * 0.2;
    for (index, walker) in walkers.iter().enumerate() {
        let mut column = column(walker, top, waits, counters, Vec2::new(wide, high), &look);
        crop(&mut column, 0.0);
        let corner = Vec2::new(wide * index as f32, 0.0);
        figure.marks.extend(column.marks.into_iter().map(|mark| mark.moved(corner)));
        if index > 0 {
            figure.add(Role::Panel, None, line(corner, corner + Vec2::new(0.0, high)));
        }
    }
    figure.add(Role::Panel, None, line(Vec2::new(0.0, high), Vec2::new(size.x, high)));
    let shared = shared(walkers, t, ruler, &look);
    figure.marks.extend(shared.marks.into_iter().map(|mark| mark.moved(Vec2::new(0.0, high))));
    figure
}

/// As many stand beside each other with their trees; of more, pictures and counts alone.
const ABREAST: usize = 3;

/// How many columns and rows of pictures there are, and the size of letters: as large as may be, then as large pictures.
fn rows(walkers: &[Walker<'_>], ask: &Ask<'_>) -> (usize, usize, Look) {
    let set = |across: usize| {
        let down = walkers.len().div_ceil(across);
        let size = ask.size / Vec2::new(across as f32, down as f32);
        (across, down, ask.look.text.min(size.x / ACROSS).min(size.y / DOWN))
    };
    // Four make a square.
    let usual = if walkers.len() == 4 { 2 } else { ABREAST };
    let first = set(usual);
    let others = (1..=ABREAST).rev().map(set);
    let (across, down, text) = others.fold(first, |best, next| if next.2 > best.2 { next } else { best });
    (across, down, Look { text, ..ask.look })
}

/// The least room of a picture with its name and counts, in letters.
const ACROSS: f32 = 18.0;
const DOWN: f32 = 16.0;

/// The letters of walks side by side, in those that are wished for.
pub(crate) fn worth(walkers: &[Walker<'_>], ask: &Ask<'_>) -> f32 {
    let look = if walkers.len() > ABREAST { rows(walkers, ask).2 } else { columns(walkers, ask) };
    look.text / ask.look.text.max(1.0)
}

/// How few walks are set beside each other: in a small window letters are smaller before anything is covered.
fn columns(walkers: &[Walker<'_>], ask: &Ask<'_>) -> Look {
    let wide = ask.size.x / walkers.len().max(1) as f32;
    Look { text: ask.look.text.min(wide / 22.0).min(ask.size.y / 44.0).max(7.0), ..ask.look }
}

/// The pictures and counts of many walks, in rows.
fn map(walkers: &[Walker<'_>], ask: &Ask<'_>) -> Figure {
    let mut figure = Figure::new(ask.size);
    let (across, rows, look) = rows(walkers, ask);
    let size = Vec2::new(ask.size.x / across as f32, ask.size.y / rows as f32);
    let top = below_heads(walkers, size.x, &look);
    let below = counts_height(walkers, size.x - 2.0 * look.margin(), &look);
    for (index, walker) in walkers.iter().enumerate() {
        let mut column = Figure::new(size);
        head(&mut column, walker, size, &look);
        let picture = Vec2::new(size.x - 2.0 * look.margin(), size.y - top - below);
        picture_and_counts(&mut column, walker, top, picture, &look);
        crop(&mut column, 0.0);
        let corner = Vec2::new((index % across) as f32, (index / across) as f32) * size;
        figure.marks.extend(column.marks.into_iter().map(|mark| mark.moved(corner)));
        if index % across > 0 {
            figure.add(Role::Panel, None, line(corner, corner + Vec2::new(0.0, size.y)));
        }
        if index % across == 0 && index > 0 {
            figure.add(Role::Panel, None, line(corner, corner + Vec2::new(ask.size.x, 0.0)));
        }
    }
    figure
}

/// The name of the structure, and how it was built.
fn head(figure: &mut Figure, walker: &Walker<'_>, size: Vec2, look: &Look) {
    let (u, left) = (look.text, look.margin());
    let at = Vec2::new(left, u * 1.5);
    let large = u * 1.25;
    let large = large * ((size.x - 2.0 * left) / text_width(walker.name, Face::Bold, large)).min(1.0);
    write(figure, Role::Text, None, at, walker.name, large, Face::Bold, Anchor::Start);
    for (row, note) in note(walker, size.x, look).iter().enumerate() {
        let under = at + Vec2::new(0.0, u * (1.6 + NOTE * row as f32));
        let note = elided(note, Face::Regular, look.small(), size.x - 2.0 * left);
        write(figure, Role::Quiet, None, under, &note, look.small(), Face::Regular, Anchor::Start);
    }
}

/// How it was built, in as many lines as that takes in a column so wide.
fn note(walker: &Walker<'_>, wide: f32, look: &Look) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for part in walker.note.split(", ") {
        match lines.last_mut() {
            Some(line) => {
                let longer = format!("{line}, {part}");
                // With the comma that follows.
                if text_width(&format!("{longer},"), Face::Regular, look.small()) <= wide - 2.0 * look.margin() {
                    *line = longer;
                } else {
                    line.push(',');
                    lines.push(part.to_owned());
                }
            }
            None => lines.push(part.to_owned()),
        }
    }
    lines
}

/// How high a further line of it is, in letters.
const NOTE: f32 = 1.3;

/// Where the pictures begin below the heads of all walks.
fn below_heads(walkers: &[Walker<'_>], wide: f32, look: &Look) -> f32 {
    let most = walkers.iter().map(|walker| note(walker, wide, look).len()).max().unwrap_or(1).max(1);
    look.text * (4.4 + NOTE * (most - 1) as f32)
}

/// How much of the growth of letters those in the pictures have: they need room beside each other.
const LARGER: f32 = 0.86;

/// The picture of a walk, and below it what the walk has paid so far.
fn picture_and_counts(figure: &mut Figure, walker: &Walker<'_>, top: f32, picture: Vec2, look: &Look) {
    let Walker { walk, moment, .. } = *walker;
    let (u, left) = (look.text, look.margin());
    let shown = space(walk, moment);
    let camera = Camera::frame(&walk.world(), picture.x / picture.y, true);
    // Where letters are large, those in the picture are so, too.
    let larger = (u / Look::WINDOW.text * LARGER).max(1.0);
    let mut part = stage(&shown, walk.prims, &camera, picture / larger, Scenery::Drawn).scaled(larger);
    crop(&mut part, u * 0.5);
    figure.marks.extend(part.marks.into_iter().map(|mark| mark.moved(Vec2::new(left, top))));
    let y = top + picture.y + u * 1.6;
    let counts = counts(walk, moment);
    let share = picture.x / COUNTS as f32;
    let first = COUNTS - counts.len();
    for (index, (count, what, role)) in (first..).zip(counts) {
        let at = Vec2::new(left + share * index as f32, y);
        write(figure, role, None, at, &whole(count), u * 1.9, Face::Bold, Anchor::Start);
        for (row, what) in lines_of(what, share, look).into_iter().enumerate() {
            let words = at + Vec2::new(0.0, u * (1.8 + COUNTED * row as f32));
            write(figure, Role::Quiet, None, words, what, look.small(), Face::Regular, Anchor::Start);
        }
    }
}

/// Most that is counted of a walk.
const COUNTS: usize = 3;

/// From line to line of what is counted, in letters.
const COUNTED: f32 = 1.15;

/// What is counted, in two lines where one is wider than its share.
fn lines_of<'a>(what: &'a str, share: f32, look: &Look) -> Vec<&'a str> {
    if text_width(what, Face::Regular, look.small()) <= share - look.text * 0.5 {
        return vec![what];
    }
    // At the blank that is nearest to its middle.
    let blanks = what.match_indices(' ').map(|(at, _)| at);
    let middle = blanks.min_by_key(|at| (at * 2).abs_diff(what.len()));
    middle.map_or(vec![what], |at| vec![&what[..at], &what[at + 1..]])
}

/// How high the counts of all walks are, below pictures of this width.
fn counts_height(walkers: &[Walker<'_>], wide: f32, look: &Look) -> f32 {
    let counts = walkers.iter().flat_map(|walker| counts(walker.walk, walker.moment)).map(|(_, what, _)| what);
    let lines = counts.map(|what| lines_of(what, wide / COUNTS as f32, look).len()).max().unwrap_or(1);
    look.text * (4.6 + COUNTED * (lines - 1) as f32)
}

/// One walk: from `top` on its picture over its `counters`, so high, over its tree or cells over its stack, for which
/// there is room if anything `waits` in any of the walks.
fn column(walker: &Walker<'_>, top: f32, waits: bool, counters: f32, size: Vec2, look: &Look) -> Figure {
    let Walker { walk, moment, .. } = *walker;
    let mut figure = Figure::new(size);
    let u = look.text;
    let left = look.margin();
    head(&mut figure, walker, size, look);
    let below = if waits { u * 4.6 } else { 0.0 };
    let picture = Vec2::new(size.x - 2.0 * left, ((size.y - top - counters - below) * 0.55).min(size.x * 0.75));
    picture_and_counts(&mut figure, walker, top, picture, look);

    let tree_top = top + picture.y + counters;
    let room = Vec2::new(size.x, (size.y - below - tree_top).max(u * 3.0));
    let bare = Look { titles: false, ..*look };
    let part = match Pane::best_of(walk.structure) {
        Some(Pane::Tree) => Some(tree(walk, moment, &TreeView::default(), room, &bare)),
        // A table of three rows, as large as a tree.
        Some(Pane::Cells) => {
            let text = (u * 1.35).min(room.y / 14.0).min(room.x / 28.0).max(u);
            Some(cells(walk, moment, false, room, &Look { text, ..*look }))
        }
        _ => None,
    };
    let part = part.into_iter().flat_map(|part| part.marks);
    figure.marks.extend(part.map(|mark| mark.moved(Vec2::new(0.0, tree_top))));
    if walk.structure.node_count() > 0 {
        let part = stack(walk, moment, Vec2::new(size.x, below), look);
        figure.marks.extend(part.marks.into_iter().map(|mark| mark.moved(Vec2::new(0.0, size.y - below))));
    }
    figure
}

/// What a walk has paid so far, in the same order for every structure: what it entered, what it tested on the way,
/// and primitives last.
fn counts(walk: &Walk<'_>, moment: &Moment) -> Vec<(u64, &'static str, Role)> {
    let cost = &moment.cost;
    let tests = (cost.prim_tests, "primitives tested", Role::Missed);
    match walk.structure {
        // There is nothing but primitives.
        Structure::List(_) => vec![tests],
        Structure::Bvh(_) => {
            vec![(cost.node_visits, "nodes entered", Role::Text), (cost.box_tests, "volumes tested", Role::Text), tests]
        }
        structure if structure.grid().is_some() => {
            vec![(cost.cell_steps, "steps to a cell", Role::Text), (cost.skips, "skipped", Role::Text), tests]
        }
        _ => {
            vec![
                (cost.node_visits, "nodes entered", Role::Text),
                (cost.plane_tests, "planes tested", Role::Text),
                tests,
            ]
        }
    }
}

/// The ray's t, the same for all: a row for each walk with the leaves or cells it has been in, where it is, what waits.
fn shared(walkers: &[Walker<'_>], t: f32, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    let u = look.text;
    let top = look.heading(&mut figure, "t along the ray", "the same for all") + u * 1.4;
    let names = walkers.iter().map(|walker| text_width(walker.name, Face::Medium, u)).fold(u * 4.0, f32::max);
    let (low, high) = walkers
        .iter()
        .map(|walker| extent(walker.walk, walker.moment))
        .fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), (from, to)| (low.min(from), high.max(to)));
    let axis = Ticks { low, high, left: look.margin() + names + u * 1.5, right: size.x - look.margin() - u };
    for (index, walker) in walkers.iter().enumerate() {
        let y = top + u * (1.0 + 1.9 * index as f32);
        let at = Vec2::new(look.margin(), y);
        write(&mut figure, Role::Text, None, at, walker.name, u, Face::Medium, Anchor::Start);
        for (place, near, far) in visited(walker) {
            bar(&mut figure, &axis, Role::Seen, place, [near, far], y, u);
        }
        for span in side_by_side(walker.walk, walker.moment) {
            let bars = matches!(span.role, Role::Here | Role::Waiting);
            if bars && !span.interval.is_empty() {
                bar(&mut figure, &axis, span.role, span.place, [span.interval.near, span.interval.far], y, u);
            }
        }
        if let Some(hit) = walker.moment.best.filter(|hit| axis.shows(hit.t)) {
            let center = Vec2::new(axis.x(hit.t), y);
            figure.add(Role::Best, Some(Place::Prim(hit.prim)), Ink::Circle { center, radius: u * 0.35 });
        }
    }
    let bottom = top + u * (1.0 + 1.9 * walkers.len() as f32);
    figure.add(Role::Edge, None, line(Vec2::new(axis.left, bottom), Vec2::new(axis.right, bottom)));
    for mark in axis.marks(u * 5.0) {
        let x = axis.x(mark);
        figure.add(Role::Edge, None, line(Vec2::new(x, bottom - u * 0.25), Vec2::new(x, bottom + u * 0.25)));
        let at = Vec2::new(x, bottom + u * 1.1);
        write(&mut figure, Role::Quiet, None, at, &number(mark), look.small(), Face::Regular, Anchor::Middle);
    }
    if axis.shows(t) {
        let x = axis.x(t);
        figure.add(Role::Ray, None, line(Vec2::new(x, top - u * 0.2), Vec2::new(x, bottom)));
        figure.add(Role::Tick, None, Ink::Circle { center: Vec2::new(x, bottom), radius: u * 0.45 });
        let label = format!("t = {}", number(t));
        let half = text_width(&label, Face::Bold, u) * 0.5;
        let at = Vec2::new(x.clamp(axis.left + half, axis.right - half), top - u * 0.7);
        write(&mut figure, Role::Value, None, at, &label, u, Face::Bold, Anchor::Middle);
    }
    figure
}

/// The leaves or cells that a walk has left again, with the part of the ray in each.
fn visited(walker: &Walker<'_>) -> Vec<(Option<Place>, f32, f32)> {
    let mut visited: Vec<(Option<Place>, f32, f32)> = Vec::new();
    for event in walker.walk.events.iter().take(walker.moment.step) {
        if let Visit::Enter { place, t_near, t_far, leaf, .. } = *event
            && (leaf || matches!(place, Place::Cell(_)))
            && Some(place) != walker.moment.here
        {
            visited.push((Some(place), t_near, t_far));
        }
    }
    visited
}

fn bar(figure: &mut Figure, axis: &Ticks, role: Role, place: Option<Place>, [near, far]: [f32; 2], y: f32, u: f32) {
    let (from, to) = (Vec2::new(axis.x(near), y), Vec2::new(axis.x(far), y));
    figure.add(role, place, line(from, to));
    let tall = Vec2::new(0.0, u * 0.4);
    let cap = if role == Role::Waiting { Role::Quiet } else { Role::Seen };
    figure.add(cap, place, line(from - tall, from + tall));
    figure.add(cap, place, line(to - tall, to + tall));
    let name = match place {
        Some(Place::Node(node)) => node.to_string(),
        Some(Place::Cell(cell)) => cell.to_string(),
        _ => return,
    };
    if to.x - from.x > text_width(&name, Face::Medium, u * 0.85) {
        let at = Vec2::new((from.x + to.x) * 0.5, y - u * 0.75);
        write(figure, role, place, at, &name, u * 0.85, Face::Medium, Anchor::Middle);
    }
}
