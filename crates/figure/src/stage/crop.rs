//! What lies far off the page is cut off, so that the work for a mark is bounded by the page: a line that is dashed,
//! or an area that is hatched, may reach a million pages beyond it.

use glam::Vec2;

use crate::page::{Figure, Ink, Mark};

/// How many pages around the page are kept: enough that no cut edge, dash or corner shows.
const PAGES: f32 = 2.0;

/// The figure without what lies far off its page; marks that reach no further stay as they are.
pub(super) fn crop_far(figure: &mut Figure) {
    let pad = figure.size.max_element() * PAGES;
    crop(figure, pad);
}

/// The figure without what lies further than `pad` off its page.
pub fn crop(figure: &mut Figure, pad: f32) {
    let pad = Vec2::splat(pad);
    let (min, max) = (-pad, figure.size + pad);
    let marks = std::mem::take(&mut figure.marks);
    figure.marks = marks.into_iter().flat_map(|mark| cropped(mark, min, max)).collect();
}

fn cropped(mark: Mark, min: Vec2, max: Vec2) -> Vec<Mark> {
    let inside = |point: &Vec2| point.cmpge(min).all() && point.cmple(max).all();
    let again = |ink: Ink| Mark { ink, ..mark.clone() };
    match &mark.ink {
        Ink::Line { points } if !points.iter().all(inside) => {
            pieces(points, min, max).into_iter().map(|points| again(Ink::Line { points })).collect()
        }
        Ink::Area { points } if !points.iter().all(inside) => {
            let points = polygon(points, min, max);
            if points.len() < 3 { Vec::new() } else { vec![again(Ink::Area { points })] }
        }
        Ink::Rect { min: low, max: high, round } if !inside(low) || !inside(high) => {
            let (low, high) = (low.max(min), high.min(max));
            let seen = low.cmplt(high).all();
            if seen { vec![again(Ink::Rect { min: low, max: high, round: *round })] } else { Vec::new() }
        }
        Ink::Circle { center, radius } => {
            let (low, high) = (*center - *radius, *center + *radius);
            if inside(&low) && inside(&high) {
                return vec![mark];
            }
            if low.cmpgt(max).any() || high.cmplt(min).any() {
                return Vec::new();
            }
            let sides = if *radius < 2000.0 { 256 } else { 4096 };
            let turn = std::f64::consts::TAU / f64::from(sides);
            let at = |side: i32| {
                let (sin, cos) = (libm::sin(turn * f64::from(side)), libm::cos(turn * f64::from(side)));
                *center + Vec2::new(cos as f32, sin as f32) * *radius
            };
            let points = polygon(&(0..sides).map(at).collect::<Vec<_>>(), min, max);
            if points.len() < 3 { Vec::new() } else { vec![again(Ink::Area { points })] }
        }
        Ink::Arrowhead { tip: at, .. } | Ink::Text { at, .. } | Ink::Formula { at, .. } if !inside(at) => Vec::new(),
        _ => vec![mark],
    }
}

/// The parts of a polyline inside a rectangle (Liang and Barsky 1984), those that hang together in one.
fn pieces(points: &[Vec2], min: Vec2, max: Vec2) -> Vec<Vec<Vec2>> {
    let mut pieces: Vec<Vec<Vec2>> = Vec::new();
    for ends in points.windows(2) {
        let Some([from, to]) = segment(ends[0], ends[1], min, max) else { continue };
        match pieces.last_mut() {
            Some(piece) if piece.last() == Some(&from) => piece.push(to),
            _ => pieces.push(vec![from, to]),
        }
    }
    pieces
}

fn segment(from: Vec2, to: Vec2, min: Vec2, max: Vec2) -> Option<[Vec2; 2]> {
    let (o, d) = (from.as_dvec2(), to.as_dvec2() - from.as_dvec2());
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let (low, high) = (f64::from(min[axis]), f64::from(max[axis]));
        if d[axis] == 0.0 {
            if o[axis] < low || o[axis] > high {
                return None;
            }
            continue;
        }
        let (a, b) = ((low - o[axis]) / d[axis], (high - o[axis]) / d[axis]);
        enter = enter.max(a.min(b));
        leave = leave.min(a.max(b));
    }
    // An end that is not a number is not on the page.
    if enter.partial_cmp(&leave) != Some(std::cmp::Ordering::Less) {
        return None;
    }
    let at = |t: f64| (o + d * t).as_vec2();
    Some([if enter > 0.0 { at(enter) } else { from }, if leave < 1.0 { at(leave) } else { to }])
}

/// A polygon cut with the four sides of a rectangle (Sutherland and Hodgman 1974).
pub(super) fn polygon(points: &[Vec2], min: Vec2, max: Vec2) -> Vec<Vec2> {
    let mut points = points.to_vec();
    for axis in 0..2 {
        for (bound, sign) in [(min[axis], 1.0), (max[axis], -1.0)] {
            let depth = |point: Vec2| f64::from(point[axis] - bound) * sign;
            let mut kept = Vec::new();
            for (index, &a) in points.iter().enumerate() {
                let b = points[(index + 1) % points.len()];
                let (from, to) = (depth(a), depth(b));
                if from >= 0.0 {
                    kept.push(a);
                }
                if (from < 0.0) != (to < 0.0) {
                    let share = from / (from - to);
                    kept.push((a.as_dvec2() + (b.as_dvec2() - a.as_dvec2()) * share).as_vec2());
                }
            }
            points = kept;
        }
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::theme::Role;

    /// A figure of 100 by 100 with one ink after cropping: 200 points around it are kept.
    fn check(ink: Ink) -> Vec<Ink> {
        let mut figure = Figure::new(Vec2::splat(100.0));
        figure.add(Role::Seen, None, ink);
        crop_far(&mut figure);
        figure.marks.into_iter().map(|mark| mark.ink).collect()
    }

    #[test]
    fn what_lies_near_the_page_stays_as_it_is() {
        for ink in [
            Ink::Line { points: vec![Vec2::splat(-150.0), Vec2::splat(290.0)] },
            Ink::Rect { min: Vec2::splat(-199.0), max: Vec2::splat(299.0), round: 0.0 },
            Ink::Circle { center: Vec2::ZERO, radius: 90.0 },
        ] {
            assert_eq!(check(ink.clone()), [ink]);
        }
    }

    #[test]
    fn what_reaches_far_beyond_the_page_is_cut() {
        let far = 1e9;
        let ends = |inks: &[Ink]| match inks {
            [Ink::Line { points }] => points.clone(),
            other => panic!("{other:?}"),
        };
        let line = check(Ink::Line { points: vec![Vec2::new(-far, 50.0), Vec2::new(far, 50.0)] });
        assert_eq!(ends(&line), [Vec2::new(-200.0, 50.0), Vec2::new(300.0, 50.0)]);
        assert!(check(Ink::Line { points: vec![Vec2::new(-far, 500.0), Vec2::new(far, 500.0)] }).is_empty());
        let rect = check(Ink::Rect { min: Vec2::splat(-far), max: Vec2::splat(far), round: 0.0 });
        assert_eq!(rect, [Ink::Rect { min: Vec2::splat(-200.0), max: Vec2::splat(300.0), round: 0.0 }]);
        let corners = vec![Vec2::new(-far, -far), Vec2::new(far, -far), Vec2::new(far, far), Vec2::new(-far, far)];
        let [Ink::Area { points }] = &check(Ink::Area { points: corners })[..] else { panic!() };
        assert!(points.len() == 4 && points.iter().all(|point| point.abs().max_element() <= 300.0));
        let [Ink::Area { points }] = &check(Ink::Circle { center: Vec2::new(-far, 50.0), radius: far })[..] else {
            panic!("a circle through the page")
        };
        assert!(points.iter().all(|point| point.abs().max_element() <= 300.0));
        assert!(check(Ink::Circle { center: Vec2::splat(-far), radius: 5.0 }).is_empty());
    }
}
