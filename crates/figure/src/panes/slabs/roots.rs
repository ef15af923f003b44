//! The equation of a sphere and a ray, a·t² + 2·b·t + c = 0, in numbers.

use glam::Vec2;
use raystep_accel::Visit;

use super::{left, verdict};
use crate::page::{Entry, Figure, Look, Table};
use crate::theme::Role;
use crate::words::number;

/// The equation put to the last sphere tested, its solutions, and what is left of the ray.
pub(super) fn table(done: &[Visit], hide: bool, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    let last = done.iter().rposition(|event| matches!(event, Visit::Roots { .. }));
    let Some((index, Visit::Roots { place, a, b, c, discriminant, t1, t2, t_near, t_far, empty })) =
        last.map(|index| (index, done[index]))
    else {
        return figure;
    };
    let empty = empty && !hide;
    let top = look.heading(&mut figure, &format!("Sphere of {place}"), "a·t² + 2·b·t + c = 0");
    let role = if index + 1 == done.len() { Role::Value } else { Role::Text };
    let none = discriminant < 0.0;
    let mut row = vec![Entry::new("", role)];
    row.extend([a, b, c, discriminant].map(|x| Entry::new(number(x), role)));
    row.extend([t1, t2].map(|t| if none { Entry::new("–", role) } else { Entry::new(number(t), role) }));
    row.push(left(t_near, t_far, empty, role));
    let heads = vec!["", "a", "b", "c", "b² − a·c", "t1", "t2", "left"];
    let current = (role == Role::Value).then_some(0);
    let room = if empty { look.line() } else { 0.0 };
    let end = Table { heads, rows: vec![row], current, place: Some(place) }.draw(&mut figure, top, size.y - room, look);
    if empty {
        let says = if none {
            format!("No root of {}.", number(discriminant))
        } else {
            format!("Empty: {} > {}.", number(t_near), number(t_far))
        };
        let missed = (role == Role::Text).then_some("sphere");
        verdict(&mut figure, Some(place), end, &says, missed, look);
    }
    figure
}
