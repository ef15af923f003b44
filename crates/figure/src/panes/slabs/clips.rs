//! A ray clipped against the faces of a hull, in numbers.

use glam::Vec2;
use raystep_accel::Visit;

use super::kept::Kept;
use super::{left, verdict};
use crate::page::{Entry, Figure, Look, Table};
use crate::theme::Role;
use crate::words::number;

/// A row for each face of the last hull tested, the latest at the end; of many, those that there is room for.
pub(super) fn table(flat: bool, done: &[Visit], hide: bool, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    let Some(last) = done.iter().rposition(|event| matches!(event, Visit::Clip { .. })) else { return figure };
    let place = done[last].place();
    let of_test = |event: &&Visit| matches!(event, Visit::Clip { .. }) && event.place() == place;
    let mut clips: Vec<Visit> = done[..=last].iter().rev().take_while(of_test).copied().collect();
    clips.reverse();
    // The same hull may have been tested just before.
    let first = clips.iter().rposition(|event| matches!(event, Visit::Clip { face: 0, .. })).unwrap_or(0);
    clips.drain(..first);
    clips.retain(|event| !(flat && event.concerns_z()));

    let top = look.heading(&mut figure, &format!("Faces of {place}"), "");
    let now = (last + 1 == done.len()).then(|| done[last]);
    let missed = !hide && matches!(done[last], Visit::Clip { empty: true, .. });
    let lines = if missed { 1.0 } else { 0.0 };
    let ends: Vec<_> = clips.iter().map(ends).collect();
    let kept = Kept::of(&ends, top, lines, size, look);
    let rows = kept.table(clips.iter().map(|event| row(event, now == Some(*event), hide)).collect());
    let current = clips.iter().position(|event| now == Some(*event)).and_then(|row| kept.position(row));
    let heads = vec!["face", "plane", "o", "d", "t", "ray comes", "left"];
    let end =
        Table { heads, rows, current, place: Some(place) }.draw(&mut figure, top, size.y - lines * look.line(), look);
    if let (Visit::Clip { t_near, t_far, .. }, true) = (done[last], missed) {
        let says = format!("Empty: {} > {}.", number(t_near), number(t_far));
        verdict(&mut figure, Some(place), end, &says, now.is_none().then_some("hull"), look);
    }
    figure
}

/// Where the ray comes in or goes out through the plane of a face.
fn ends(event: &Visit) -> [Option<f32>; 2] {
    match *event {
        Visit::Clip { d, t, entering: true, .. } if d != 0.0 => [Some(t), None],
        Visit::Clip { d, t, .. } if d != 0.0 => [None, Some(t)],
        _ => [None; 2],
    }
}

fn row(event: &Visit, now: bool, hide: bool) -> Vec<Entry> {
    let Visit::Clip { face, o, d, plane, t, entering, t_near, t_far, empty, .. } = *event else { return Vec::new() };
    let role = if now { Role::Value } else { Role::Text };
    let mut row = vec![Entry::new(face.to_string(), Role::Text)];
    row.extend([plane, o, d, t].map(|x| Entry::new(number(x), role)));
    row.push(Entry::new(
        if d == 0.0 {
            "along"
        } else if entering {
            "in"
        } else {
            "out"
        },
        role,
    ));
    row.push(left(t_near, t_far, empty && !hide, role));
    row
}
