//! The test of a volume as a table: each number appears when the walk has it.

mod clips;
mod kept;
mod roots;

use glam::Vec2;
use raystep_accel::{AnyBvh, Axis, Direction, Place, Structure, Visit};

use crate::moments::{Moment, Walk};
use crate::page::{Anchor, Entry, Figure, Look, Table, write};
use crate::theme::{Face, Role};
use crate::words::{VolumeName, number};

use kept::Kept;

/// The events of one direction of a slab test, as far as they have happened.
#[derive(Clone, Copy, Debug)]
struct Slab {
    axis: Direction,
    cut: Option<Visit>,
    order: Option<Visit>,
    narrow: Option<Visit>,
}

impl Slab {
    fn across(axis: Direction) -> Slab {
        Slab { axis, cut: None, order: None, narrow: None }
    }

    /// Where the line of the ray comes in and goes out, if it runs across.
    fn ends(&self) -> [Option<f32>; 2] {
        match self.cut {
            Some(Visit::Divide { t1, t2, .. }) => [Some(t1.min(t2)), Some(t1.max(t2))],
            _ => [None; 2],
        }
    }
}

/// Of the volume that was tested last, a row for each of its slabs: its planes, where they cut the ray, and what
/// is left of the ray. Of a sphere, its equation; of a hull, a row for each face. After a walk through many volumes
/// none of them is told of. While a question is open, `hide` leaves the numbers without what they come to.
pub fn slabs(walk: &Walk<'_>, moment: &Moment, hide: bool, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    if moment.ending.is_some() && !matches!(walk.structure, Structure::Slab(_)) {
        look.nothing(&mut figure, title(walk), "The walk is over.");
        return figure;
    }
    let done = &walk.events[..moment.step.min(walk.events.len())];
    match done
        .iter()
        .rfind(|event| matches!(event, Visit::Roots { .. } | Visit::Clip { .. }) || slab_of(event).is_some())
    {
        Some(Visit::Roots { .. }) => return roots::table(done, hide, size, look),
        Some(Visit::Clip { .. }) => return clips::table(walk.flat, done, hide, size, look),
        _ => {}
    }
    let last = done.iter().rposition(|event| slab_of(event).is_some());
    let Some((place, mut slabs)) = last.map(|last| test_up_to(done, last)) else {
        let ever = walk.events.iter().any(|event| slab_of(event).is_some());
        let tested = VolumeName::of(walk.structure);
        let says = match walk.structure {
            Structure::Bvh(AnyBvh::Sphere(_) | AnyBvh::Hull(_)) => format!("No {} has been tested yet.", tested.one),
            _ if ever => "No slab has been cut yet.".to_owned(),
            _ => "This walk cuts no slabs.".to_owned(),
        };
        look.nothing(&mut figure, title(walk), &says);
        return figure;
    };

    let top = look.heading(&mut figure, &format!("Slabs of {place}"), "");
    let now = moment.event.as_ref();
    slabs.retain(|slab| !walk.leaves_out(slab.axis));
    let nothing_left = slabs.iter().any(|slab| matches!(slab.narrow, Some(Visit::Narrow { empty: true, .. })));
    let ends: Vec<_> = slabs.iter().map(Slab::ends).collect();
    let kept = Kept::of(&ends, top, if nothing_left { 1.0 } else { 0.0 }, size, look);
    let rows = kept.table(slabs.iter().map(|slab| row(slab, now, hide)).collect());
    let current = now.and_then(slab_of).and_then(|(_, axis)| slabs.iter().position(|slab| slab.axis == axis));
    let current = current.and_then(|row| kept.position(row));
    let heads = vec!["", "low", "high", "o", "d", "t1", "t2", "swap", "so far"];
    let empty = slabs.iter().rev().find_map(|slab| match slab.narrow {
        Some(Visit::Narrow { empty: true, t_near, t_far, .. }) if !hide => Some((t_near, t_far)),
        _ => None,
    });
    let room = if empty.is_some() { look.line() } else { 0.0 };
    let table = Table { heads, rows, current, place: Some(place) };
    let end = table.draw(&mut figure, top, size.y - room, look);
    if let Some((t_near, t_far)) = empty {
        let says = format!("Empty: {} > {}.", number(t_near), number(t_far));
        let over = now.is_none_or(|event| slab_of(event).is_none());
        let missed = over.then(|| VolumeName::of(walk.structure).one);
        verdict(&mut figure, Some(place), end, &says, missed, look);
    }
    figure
}

/// What the pane is called while it has no volume to tell of.
fn title(walk: &Walk<'_>) -> &'static str {
    match walk.structure {
        Structure::Bvh(AnyBvh::Sphere(_)) => "Spheres",
        Structure::Bvh(AnyBvh::Hull(_)) => "Faces",
        _ => "Slabs",
    }
}

/// What a test that left nothing comes to, below its table; that the volume is missed only once its test is over.
fn verdict(figure: &mut Figure, place: Option<Place>, end: f32, says: &str, missed: Option<&str>, look: &Look) {
    let at = Vec2::new(look.margin(), end + look.line() * 0.4);
    let says = missed.map_or_else(|| says.to_owned(), |what| format!("{says} The {what} is missed."));
    write(figure, Role::Wrong, place, at, &says, look.text, Face::Medium, Anchor::Start);
}

/// What is left of the ray.
fn left(t_near: f32, t_far: f32, empty: bool, role: Role) -> Entry {
    if empty {
        return Entry::new("empty", Role::Wrong);
    }
    Entry::new(format!("[{}, {}]", number(t_near), number(t_far)), role)
}

/// The place and the direction of an event of a slab test.
fn slab_of(event: &Visit) -> Option<(Place, Direction)> {
    match *event {
        Visit::Parallel { place, axis, .. }
        | Visit::Divide { place, axis, .. }
        | Visit::Order { place, axis, .. }
        | Visit::Narrow { place, axis, .. } => Some((place, axis)),
        _ => None,
    }
}

/// The test that the event numbered `last` belongs to, up to that event: its slabs in order, and those of the
/// axes that are still to come.
fn test_up_to(events: &[Visit], last: usize) -> (Place, Vec<Slab>) {
    let mut slabs: Vec<Slab> = Vec::new();
    let (place, mut earliest) = slab_of(&events[last]).unwrap_or((Place::World, Axis::Z.into()));
    for event in events[..=last].iter().rev() {
        let Some((_, axis)) = slab_of(event).filter(|(other, axis)| *other == place && *axis <= earliest) else {
            break;
        };
        if slabs.last().is_none_or(|slab| slab.axis != axis) {
            slabs.push(Slab::across(axis));
        }
        let Some(slab) = slabs.last_mut() else { break };
        match event {
            // A second cut of the same direction belongs to an earlier test of the same volume.
            _ if slab.cut.is_some() => break,
            Visit::Order { .. } => slab.order = Some(*event),
            Visit::Narrow { .. } => slab.narrow = Some(*event),
            _ => slab.cut = Some(*event),
        }
        earliest = axis;
    }
    slabs.reverse();
    // An oriented box has directions of its own.
    let own = slabs.first().is_some_and(|slab| matches!(slab.axis, Direction::Own(_)));
    let missing = Axis::ALL.map(|axis| if own { Direction::Own(axis) } else { Direction::Along(axis) });
    slabs.extend(missing.into_iter().skip(slabs.len()).map(Slab::across));
    (place, slabs)
}

fn row(slab: &Slab, now: Option<&Visit>, hide: bool) -> Vec<Entry> {
    // What the current event says stands out.
    let role = |event: &Option<Visit>| if event.as_ref() == now { Role::Value } else { Role::Text };
    let (cut_role, narrow_role) = (role(&slab.cut), role(&slab.narrow));
    let mut row = vec![Entry::new(slab.axis.name(), Role::Text)];
    match slab.cut {
        Some(Visit::Divide { low, high, o, d, t1, t2, .. }) => {
            row.extend([low, high, o, d].map(|x| Entry::new(number(x), cut_role)));
            let ordered = match slab.order {
                Some(Visit::Order { t1, t2, swapped, .. }) => Some((t1, t2, swapped)),
                _ => None,
            };
            let order_role = role(&slab.order);
            match ordered {
                Some((t1, t2, swapped)) => {
                    row.extend([t1, t2].map(|t| Entry::new(number(t), order_role)));
                    row.push(Entry::new(if swapped { "yes" } else { "no" }, order_role));
                }
                None => {
                    row.extend([t1, t2].map(|t| Entry::new(number(t), cut_role)));
                    row.push(Entry::none());
                }
            }
        }
        Some(Visit::Parallel { low, high, o, inside, .. }) => {
            row.extend([low, high, o, 0.0].map(|x| Entry::new(number(x), cut_role)));
            let says = if inside { ["in", "in", "–"] } else { ["out", "out", "–"] };
            row.extend(says.map(|word| Entry::new(word, cut_role)));
        }
        _ => row.extend(vec![Entry::none(); 7]),
    }
    row.push(match slab.narrow {
        Some(Visit::Narrow { t_near, t_far, empty, .. }) => left(t_near, t_far, empty && !hide, narrow_role),
        _ => Entry::none(),
    });
    row
}
