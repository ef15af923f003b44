//! What the marks of a picture mean, in words.

use glam::Vec2;

use crate::page::{Anchor, Figure, Ink, Look, block, line, write};
use crate::theme::{Face, Role, text_width};
use crate::world::{Form, Space};

/// The marks of a walk, each with its meaning.
type Signs = [(Role, &'static str); 19];

/// What the marks of a walk mean, in the order of the story they tell.
pub(crate) const OF_WALK: Signs = [
    (Role::Scene, "primitive"),
    (Role::Ray, "ray"),
    (Role::Line, "its line, behind its start"),
    (Role::Live, "part under consideration"),
    (Role::Filled, "holds primitives"),
    (Role::Here, "where the walk is"),
    (Role::Ground, "the slab"),
    (Role::Ghost, "where it was before"),
    (Role::Guess, "possible answer"),
    (Role::Waiting, "waits on the stack"),
    (Role::Seen, "visited"),
    (Role::Dropped, "left out"),
    (Role::Plane, "plane"),
    (Role::Candidate, "weighed"),
    (Role::Tick, "t on the ray"),
    (Role::Missed, "tested, missed"),
    (Role::Hit, "hit"),
    (Role::Best, "nearest hit so far"),
    (Role::Wrong, "goes wrong here"),
];

/// What they mean in a solid scene, where the primitives of the current leaf or cell stand out from the mesh.
pub(crate) const OF_SOLID_WALK: Signs = saying(OF_WALK, 10, "visited, or held here");

/// What they mean where spheres are tested, which have no planes.
pub(crate) const OF_SPHERES: Signs = saying(OF_WALK, 12, "sphere tested");
pub(crate) const OF_SOLID_SPHERES: Signs = saying(OF_SOLID_WALK, 12, "sphere tested");

/// What the marks of a packet mean.
pub(crate) const OF_PACKET: &[(Role, &str)] = &[
    (Role::Scene, "primitive"),
    (Role::Thread1, "a ray; each has its dashes"),
    (Role::Strand1, "its part in the node, if it takes part"),
    (Role::Filled, "holds primitives"),
    (Role::Here, "where the packet is"),
    (Role::Ghost, "where it was before"),
    (Role::Guess, "possible answer"),
    (Role::Waiting, "waits on the stack"),
    (Role::Seen, "visited"),
    (Role::Dropped, "left out, or not needed"),
    (Role::Plane, "plane"),
    (Role::Missed, "tested, missed"),
    (Role::Hit, "hit"),
    (Role::Best, "nearest hit of a ray"),
];

/// What the marks of a build mean.
pub(crate) const OF_BUILD: [(Role, &str); 13] = [
    (Role::Scene, "primitive"),
    (Role::Ray, "its box"),
    (Role::Filled, "holds primitives"),
    (Role::Here, "under consideration"),
    (Role::Ghost, "where it was before"),
    (Role::Best, "sets a side of the box"),
    (Role::Guess, "possible answer"),
    (Role::Waiting, "still to be built"),
    (Role::Candidate, "weighed"),
    (Role::Plane, "taken"),
    (Role::Hit, "on both sides"),
    (Role::Seen, "done"),
    (Role::Dropped, "not reached"),
];

/// What they mean where cells are divided in their middle.
pub(crate) const OF_OCTREE: [(Role, &str); 13] = saying(OF_BUILD, 9, "where it is divided");

/// What they mean where planes are proposed before they are weighed.
pub(crate) const OF_BSP: [(Role, &str); 13] = saying(OF_BUILD, 8, "proposed");

/// What they mean where sets on a curve are joined.
pub(crate) const OF_CURVE: &[(Role, &str)] = &[
    (Role::Scene, "primitive"),
    (Role::Here, "under consideration"),
    (Role::Ghost, "where it was before"),
    (Role::Best, "sets a side of the box"),
    (Role::Guess, "possible answer"),
    (Role::Line, "Morton curve"),
    (Role::Tick, "middle of a set on it"),
    (Role::Plane, "where the code leads"),
    (Role::Candidate, "chosen neighbour"),
    (Role::Seen, "a set"),
];

/// What they mean where a tree is built and then changed.
pub(crate) const OF_CHANGE: &[(Role, &str)] = &[
    (Role::Scene, "primitive"),
    (Role::Filled, "holds primitives"),
    (Role::Here, "under consideration"),
    (Role::Ghost, "where it was before"),
    (Role::Best, "sets a side of the box"),
    (Role::Guess, "possible answer"),
    (Role::Waiting, "still to come"),
    (Role::Plane, "divided, or looked at by the change"),
    (Role::Seen, "done"),
    (Role::Dropped, "deleted"),
];

/// What they mean where a grid is built.
pub(crate) const OF_GRID: &[(Role, &str)] = &[
    (Role::Scene, "primitive"),
    (Role::Ray, "its box"),
    (Role::Here, "under consideration"),
    (Role::Ghost, "where it was before"),
    (Role::Best, "sets a side of the box"),
    (Role::Guess, "possible answer"),
    (Role::Waiting, "still to be decided"),
    (Role::Filled, "cell with a reference"),
    (Role::Seen, "cell with a reference"),
    (Role::Dropped, "not reached"),
];

/// The same signs, but for one that means something else.
const fn saying<const N: usize>(
    mut signs: [(Role, &'static str); N],
    at: usize,
    says: &'static str,
) -> [(Role, &'static str); N] {
    signs[at].1 = says;
    signs
}

/// A sample and a few words for each kind of mark in `space`, in as many rows as needed. Where those do not fit into
/// the figure, the letters are smaller; then what explains itself is left out.
pub(crate) fn legend(space: &Space, words: &[(Role, &'static str)], size: Vec2, look: &Look) -> Figure {
    let mut all = meanings(space, words);
    let fits = |figure: &Figure, u: f32| size.y <= 0.0 || foot(figure) + u * 0.5 <= size.y;
    loop {
        for part in [1.0, 0.92, 0.85] {
            let figure = rows(&all, size, look, part);
            if fits(&figure, look.text * part) {
                return figure;
            }
        }
        let plain = |(role, _): &(Role, &str)| matches!(role, Role::Scene | Role::Ray | Role::Tick | Role::Ghost);
        match all.iter().position(plain) {
            Some(index) => all.remove(index),
            None => return rows(&all, size, look, 0.8),
        };
    }
}

fn rows(all: &[(Role, &'static str)], size: Vec2, look: &Look, part: f32) -> Figure {
    let mut figure = Figure::new(size);
    let (u, small) = (look.text * part, look.small() * part);
    let (sample, gap) = (u * 1.5, u * 0.5);
    let (mut x, mut y) = (look.margin(), look.margin() + u * 0.5);
    for &(role, words) in all {
        let width = sample + gap + text_width(words, Face::Regular, small);
        if x > look.margin() && x + width > size.x - look.margin() {
            (x, y) = (look.margin(), y + look.line() * part);
        }
        figure.add(role, None, shape(role, Vec2::new(x, y), sample, u));
        let at = Vec2::new(x + sample + gap, y);
        write(&mut figure, Role::Text, None, at, words, small, Face::Regular, Anchor::Start);
        x += width + u * 1.6;
    }
    figure
}

/// The middle of the lowest line.
fn foot(figure: &Figure) -> f32 {
    let lines = figure.marks.iter().filter_map(|mark| match mark.ink {
        Ink::Text { at, .. } => Some(at.y),
        _ => None,
    });
    lines.fold(0.0, f32::max)
}

/// How high a legend of this width becomes.
pub(crate) fn legend_height(space: &Space, words: &[(Role, &'static str)], width: f32, look: &Look) -> f32 {
    let figure = legend(space, words, Vec2::new(width, 0.0), look);
    foot(&figure) + look.margin() + look.text * 0.5
}

/// The room that a legend of this width has, whatever it has to explain.
pub(crate) fn legend_room(width: f32, look: &Look) -> f32 {
    let rows = if width > look.text * 42.0 { 2.0 } else { 3.0 };
    look.margin() + look.line() * rows + look.text * 0.3
}

/// The kinds of marks that occur.
fn meanings(space: &Space, words: &[(Role, &'static str)]) -> Vec<(Role, &'static str)> {
    let occurs = |role| {
        role == Role::Scene
            || space.marks.iter().any(|mark| mark.role == role && !matches!(mark.form, Form::Label { .. }))
    };
    words.iter().copied().filter(|(role, _)| occurs(*role)).collect()
}

/// A small sample of what the role draws.
fn shape(role: Role, at: Vec2, width: f32, u: f32) -> Ink {
    match role {
        Role::Ray | Role::Line | Role::Live | Role::Plane | Role::Candidate | Role::Thread1 | Role::Strand1 => {
            line(at, at + Vec2::new(width, 0.0))
        }
        Role::Tick => Ink::Circle { center: at + Vec2::new(width / 2.0, 0.0), radius: u * 0.35 },
        Role::Scene | Role::Missed | Role::Hit | Role::Best => {
            Ink::Circle { center: at + Vec2::new(width / 2.0, 0.0), radius: u * 0.5 }
        }
        _ => block(at - Vec2::new(0.0, u * 0.42), Vec2::new(width, u * 0.84), 0.0),
    }
}
