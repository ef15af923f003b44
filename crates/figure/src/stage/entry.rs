//! A ray that starts outside the picture: an arrow where it comes in, with a word that says so.

use glam::{Vec2, Vec3};

use super::HEAD;
use super::beside::beside_point;
use super::labels::outside;
use super::lens::Lens;
use super::obstacles::{HOPELESS, Obstacles};
use super::spot::{ASIDE, HALF, Spot, letters};
use crate::page::{Anchor, Figure, Ink};
use crate::theme::{Face, Role, text_width};
use crate::world::{Form, Space};

const SAYS: &str = "starts outside the picture";

/// A picture is so many times as wide as the word, or does without it.
const WIDER: f32 = 3.5;

/// So often the part of the ray that is outside is halved to find where it comes in.
const HALVINGS: usize = 32;

/// Marks where the ray comes into the picture, if it does not start in it.
pub(super) fn set(space: &Space, lens: &Lens, figure: &mut Figure, obstacles: &mut Obstacles) {
    let ray = space.marks.iter().find_map(|mark| match mark.form {
        Form::Arrow(from, to) if mark.role == Role::Ray => Some((from, to)),
        _ => None,
    });
    let Some([outer, inner]) = ray.and_then(|(from, to)| entry(from, to, lens, figure.size)) else { return };
    let along = (inner - outer).normalize_or_zero();
    let tip = outer + along * HEAD * 1.5;
    figure.add(Role::Live, None, Ink::Arrowhead { tip, along, length: HEAD });
    obstacles.spots.push((Spot::around(tip - along * HEAD * 0.5, Vec2::splat(HEAD * 0.5)), HOPELESS));
    let (size, face) = (letters(figure.size), Face::Medium);
    // In a small picture, one of several with the same ray, the arrow says enough.
    if text_width(SAYS, face, size) * WIDER > figure.size.x {
        return;
    }
    let half = Vec2::new(text_width(SAYS, face, size) * 0.5 + size * ASIDE, size * HALF);
    let spots = beside_point(Some(tip), half).into_iter().filter_map(|spot| spot.moved_into(figure.size));
    let cost = |spot: &Spot| obstacles.cost(*spot) + outside(*spot, figure.size);
    let Some(spot) = spots.min_by(|a, b| cost(a).total_cmp(&cost(b))).filter(|spot| cost(spot) < HOPELESS) else {
        return;
    };
    obstacles.spots.push((spot, HOPELESS));
    let (at, text, anchor) = (spot.center(), SAYS.to_owned(), Anchor::Middle);
    figure.add(Role::Quiet, None, Ink::Text { at, text, size, face, anchor, boxed: true });
}

/// Where a line that begins outside of a picture comes into it, and a point after that; nothing if it begins inside or
/// never comes in.
fn entry(from: Vec3, to: Vec3, lens: &Lens, size: Vec2) -> Option<[Vec2; 2]> {
    let seen = |share: f32| {
        let at = lens.point(from.lerp(to, share)).map(|(at, _)| at);
        at.filter(|at| at.cmpge(Vec2::ZERO).all() && at.cmple(size).all())
    };
    if seen(0.0).is_some() {
        return None;
    }
    let first = (1..=256).map(|step| step as f32 / 256.0).find(|share| seen(*share).is_some())?;
    let (mut out, mut inside) = (first - 1.0 / 256.0, first);
    for _ in 0..HALVINGS {
        let middle = (out + inside) * 0.5;
        if seen(middle).is_some() {
            inside = middle;
        } else {
            out = middle;
        }
    }
    let next = seen(inside + (1.0 - inside) * 0.05).or_else(|| seen(first));
    Some([seen(inside)?, next?])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stage::Camera;

    #[test]
    fn a_ray_comes_in_at_the_edge() {
        let size = Vec2::new(400.0, 200.0);
        let lens = Lens::new(&Camera::Flat { center: Vec2::ZERO, half_height: 1.0 }, size);
        // Two wide and one high to each side of the middle.
        let enters = |from: [f32; 2], to: [f32; 2]| {
            let [from, to] = [from, to].map(|[x, y]| Vec3::new(x, y, 0.0));
            entry(from, to, &lens, size).map(|[at, _]| at.round())
        };
        assert_eq!(enters([-4.0, 0.0], [4.0, 0.0]), Some(Vec2::new(0.0, 100.0)));
        assert_eq!(enters([0.0, 3.0], [0.0, 0.0]), Some(Vec2::new(200.0, 0.0)));
        assert_eq!(enters([0.0, 0.0], [4.0, 0.0]), None, "it starts inside");
        assert_eq!(enters([-4.0, 3.0], [4.0, 3.0]), None, "it passes by");
    }
}
