//! How one figure becomes another: what is the same thing in both moves from its old place to its new one.

use std::collections::HashMap;
use std::mem::{Discriminant, discriminant};

use glam::Vec2;
use raystep_accel::Place;

use crate::page::{Figure, Ink, Mark};
use crate::theme::Role;

/// The way from one figure to another. What has no counterpart goes or comes at once; nothing is drawn that neither
/// figure has.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    old: Figure,
    new: Figure,
    /// For each mark of the new figure what it was.
    from: Vec<Option<Mark>>,
    /// The marks of the new figure that come from elsewhere on the page.
    aloft: Vec<usize>,
}

/// What a mark of the old figure is known by in the new one.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Name {
    /// What it is about and what it means.
    Same(Place, Role, Discriminant<Ink>),
    /// What it is about; it has come to mean something else.
    Turned(Place, Discriminant<Ink>),
    /// What it means, where only one mark does: the current cell, the live interval.
    Only(Role, Discriminant<Ink>),
}

impl Motion {
    /// The way from `old` to `new`; nothing if they are not of one size or nothing has to move. `coming` says of
    /// places where on the page of `new` they were before, in case `old` does not show them.
    pub fn between(old: &Figure, new: &Figure, coming: &[(Place, Vec2)]) -> Option<Motion> {
        if old.size != new.size || old == new {
            return None;
        }
        let mut from: Vec<Option<Mark>> = vec![None; new.marks.len()];
        let mut free: Vec<bool> = vec![true; old.marks.len()];
        let names: [fn(&Mark) -> Option<Name>; 3] = [
            |mark| Some(Name::Same(mark.place?, mark.role, discriminant(&mark.ink))),
            |mark| Some(Name::Turned(mark.place?, discriminant(&mark.ink))),
            |mark| Some(Name::Only(mark.role, discriminant(&mark.ink))),
        ];
        for (name, alone) in names.into_iter().zip([false, false, true]) {
            let mut known: HashMap<Name, Vec<usize>> = HashMap::new();
            for (index, mark) in old.marks.iter().enumerate().rev().filter(|(index, _)| free[*index]) {
                if let Some(name) = name(mark) {
                    known.entry(name).or_default().push(index);
                }
            }
            let mut wanted: HashMap<Name, usize> = HashMap::new();
            for mark in
                new.marks.iter().zip(&from).filter(|(_, from)| from.is_none()).filter_map(|(mark, _)| name(mark))
            {
                *wanted.entry(mark).or_default() += 1;
            }
            for (mark, from) in new.marks.iter().zip(&mut from).filter(|(_, from)| from.is_none()) {
                let Some(key) = name(mark) else { continue };
                let Some(old_marks) = known.get_mut(&key) else { continue };
                if alone && (old_marks.len() != 1 || wanted.get(&key) != Some(&1)) {
                    continue;
                }
                if old_marks.last().is_some_and(|index| becomes(&old.marks[*index].ink, &mark.ink))
                    && let Some(index) = old_marks.pop()
                {
                    free[index] = false;
                    *from = Some(old.marks[index].clone());
                }
            }
        }
        // What was shown elsewhere flies in from there, all its marks together.
        let known = |place: Place| old.marks.iter().any(|mark| mark.place == Some(place));
        let mut aloft = Vec::new();
        for (place, at) in coming.iter().filter(|(place, _)| !known(*place)) {
            let Some(home) = new.middle_of(*place) else { continue };
            for (index, mark) in new.marks.iter().enumerate().filter(|(_, mark)| mark.place == Some(*place)) {
                from[index] = Some(mark.clone().moved(*at - home));
                aloft.push(index);
            }
        }
        // Other words in the same place do not move.
        let on_its_way = |mark: &Mark, from: &Mark| between(&from.ink, &mark.ink, 0.5) != mark.ink;
        let moves = |(mark, from): (&Mark, &Option<Mark>)| from.as_ref().is_some_and(|from| on_its_way(mark, from));
        let moves = new.marks.iter().zip(&from).any(moves);
        moves.then(|| Motion { old: old.clone(), new: new.clone(), from, aloft })
    }

    /// The figure after a share of the way: at 0 the old one, at 1 the new one.
    pub fn at(&self, share: f32) -> Figure {
        if share <= 0.0 {
            return self.old.clone();
        }
        if share >= 1.0 {
            return self.new.clone();
        }
        let marks = (0..self.new.marks.len()).map(|index| self.mark(index, share));
        Figure { size: self.new.size, marks: marks.collect() }
    }

    /// Of that figure only what comes from elsewhere on the page: it crosses the edges of the figure.
    pub fn aloft(&self, share: f32) -> Figure {
        let marks = self.aloft.iter().filter(|_| share > 0.0 && share < 1.0).map(|index| self.mark(*index, share));
        Figure { size: self.new.size, marks: marks.collect() }
    }

    fn mark(&self, index: usize, share: f32) -> Mark {
        let mark = &self.new.marks[index];
        match &self.from[index] {
            Some(from) => Mark { ink: between(&from.ink, &mark.ink, share), ..mark.clone() },
            None => mark.clone(),
        }
    }
}

/// Whether ink can become other ink by moving its points.
fn becomes(old: &Ink, new: &Ink) -> bool {
    match (old, new) {
        (Ink::Line { points: old }, Ink::Line { points: new })
        | (Ink::Area { points: old }, Ink::Area { points: new }) => old.len() == new.len(),
        (Ink::Text { anchor: old, .. }, Ink::Text { anchor: new, .. }) => old == new,
        (Ink::Image { .. } | Ink::Formula { .. }, _) => false,
        _ => discriminant(old) == discriminant(new),
    }
}

/// Ink between old and new ink, which [`becomes`] says are alike.
fn between(old: &Ink, new: &Ink, share: f32) -> Ink {
    let mix = |a: Vec2, b: Vec2| a + (b - a) * share;
    let number = |a: f32, b: f32| a + (b - a) * share;
    let all = |a: &[Vec2], b: &[Vec2]| a.iter().zip(b).map(|(a, b)| mix(*a, *b)).collect::<Vec<Vec2>>();
    match (old, new) {
        (Ink::Line { points: a }, Ink::Line { points: b }) => Ink::Line { points: all(a, b) },
        (Ink::Area { points: a }, Ink::Area { points: b }) => Ink::Area { points: all(a, b) },
        (Ink::Rect { min: a, max: c, round: r }, Ink::Rect { min: b, max: d, round: s }) => {
            Ink::Rect { min: mix(*a, *b), max: mix(*c, *d), round: number(*r, *s) }
        }
        (Ink::Circle { center: a, radius: r }, Ink::Circle { center: b, radius: s }) => {
            Ink::Circle { center: mix(*a, *b), radius: number(*r, *s) }
        }
        (Ink::Arrowhead { tip: a, along: c, length: r }, Ink::Arrowhead { tip: b, along: d, length: s }) => {
            Ink::Arrowhead { tip: mix(*a, *b), along: mix(*c, *d).normalize_or(*d), length: number(*r, *s) }
        }
        (Ink::Text { at: a, .. }, Ink::Text { at: b, text, size, face, anchor, boxed }) => {
            Ink::Text { at: mix(*a, *b), text: text.clone(), size: *size, face: *face, anchor: *anchor, boxed: *boxed }
        }
        _ => new.clone(),
    }
}

#[cfg(test)]
mod tests {
    use raystep_accel::{CellId, NodeId};

    use super::*;
    use crate::page::{block, line};

    fn figure(marks: &[(Role, Option<Place>, Ink)]) -> Figure {
        let mut figure = Figure::new(Vec2::new(100.0, 50.0));
        for (role, place, ink) in marks {
            figure.add(*role, *place, ink.clone());
        }
        figure
    }

    fn boxed(x: f32, width: f32) -> Ink {
        block(Vec2::new(x, 0.0), Vec2::new(width, 10.0), 0.0)
    }

    /// Where a figure's mark begins and ends.
    fn spans(figure: &Figure) -> Vec<(f32, f32)> {
        let span = |mark: &Mark| match &mark.ink {
            Ink::Rect { min, max, .. } => (min.x, max.x),
            Ink::Line { points } => (points[0].x, points[1].x),
            _ => (f32::NAN, f32::NAN),
        };
        figure.marks.iter().map(span).collect()
    }

    #[test]
    fn what_is_the_same_thing_moves() {
        let [a, b] = [1, 2].map(|node| Some(Place::Node(NodeId(node))));
        let [c, d] = [1, 2].map(|cell| Some(Place::Cell(CellId(cell))));
        let check =
            |old: &[(Role, Option<Place>, Ink)], new: &[(Role, Option<Place>, Ink)], half: Option<&[(f32, f32)]>| {
                let (old, new) = (figure(old), figure(new));
                let motion = Motion::between(&old, &new, &[]);
                assert_eq!(motion.as_ref().map(|motion| spans(&motion.at(0.5))).as_deref(), half, "{old:?} {new:?}");
                if let Some(motion) = motion {
                    assert_eq!((motion.at(0.0), motion.at(1.0)), (old, new));
                    assert_eq!(motion.aloft(0.5).marks, []);
                }
            };
        let seen = |place, ink: Ink| (Role::Seen, place, ink);
        let here = |place, ink: Ink| (Role::Here, place, ink);
        // The same place, the same meaning.
        check(&[seen(a, boxed(0.0, 10.0))], &[seen(a, boxed(20.0, 6.0))], Some(&[(10.0, 18.0)]));
        // The same place with another meaning, in another order.
        check(
            &[seen(a, boxed(0.0, 10.0)), here(b, boxed(50.0, 10.0))],
            &[here(a, boxed(4.0, 10.0)), seen(b, boxed(50.0, 20.0))],
            Some(&[(2.0, 12.0), (50.0, 65.0)]),
        );
        // The one current cell slides to the next.
        check(&[here(c, boxed(0.0, 10.0))], &[here(d, boxed(10.0, 10.0))], Some(&[(5.0, 15.0)]));
        // Of two that mean the same nobody knows which is which.
        check(
            &[seen(c, boxed(0.0, 10.0)), seen(a, boxed(0.0, 1.0))],
            &[seen(d, boxed(10.0, 10.0)), seen(b, boxed(0.0, 2.0))],
            None,
        );
        // A line is no box.
        check(&[here(a, line(Vec2::ZERO, Vec2::X))], &[here(a, boxed(0.0, 10.0))], None);
        // What comes is there at once, and what goes is gone.
        check(
            &[seen(a, boxed(0.0, 10.0)), (Role::Best, b, boxed(1.0, 2.0))],
            &[seen(a, boxed(10.0, 10.0)), (Role::Hit, c, boxed(30.0, 10.0)), (Role::Hit, d, boxed(40.0, 10.0))],
            Some(&[(5.0, 15.0), (30.0, 40.0), (40.0, 50.0)]),
        );
        check(&[seen(a, boxed(0.0, 10.0))], &[seen(a, boxed(0.0, 10.0))], None);
        check(&[], &[seen(a, boxed(0.0, 10.0))], None);
        check(&[seen(a, boxed(0.0, 10.0))], &[], None);
    }

    #[test]
    fn pictures_of_two_sizes_have_nothing_between_them() {
        let place = Some(Place::World);
        let (old, mut new) =
            (figure(&[(Role::Here, place, boxed(0.0, 1.0))]), figure(&[(Role::Here, place, boxed(9.0, 1.0))]));
        assert!(Motion::between(&old, &new, &[]).is_some());
        new.size.x += 1.0;
        assert_eq!(Motion::between(&old, &new, &[]), None);
    }

    #[test]
    fn what_was_elsewhere_flies_in() {
        let [a, b] = [1, 2].map(|node| Place::Node(NodeId(node)));
        let row = |place: Place, y: f32| (Role::Waiting, Some(place), block(Vec2::new(0.0, y), Vec2::splat(10.0), 0.0));
        let (old, new) = (figure(&[row(a, 0.0)]), figure(&[row(a, 20.0), row(b, 0.0)]));
        let coming = [(a, Vec2::ZERO), (b, Vec2::new(-95.0, 45.0)), (Place::World, Vec2::ZERO)];
        let motion = Motion::between(&old, &new, &coming).unwrap();
        let corners = |figure: Figure| -> Vec<Vec2> {
            let corner = |mark: &Mark| if let Ink::Rect { min, .. } = mark.ink { min } else { Vec2::NAN };
            figure.marks.iter().map(corner).collect()
        };
        // What was there already moves within; what was not comes from where it was.
        assert_eq!(corners(motion.at(0.5)), [Vec2::new(0.0, 10.0), Vec2::new(-50.0, 20.0)]);
        assert_eq!(corners(motion.aloft(0.5)), [Vec2::new(-50.0, 20.0)]);
        assert_eq!((motion.at(0.0), motion.at(1.0)), (old, new));
    }
}
