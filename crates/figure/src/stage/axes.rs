//! Which way x, y and z run in a solid picture: three short arrows in its lower left corner.

use glam::{Vec2, Vec3};

use super::Camera;
use super::lens::Lens;
use super::spot::letters;
use crate::page::{Anchor, Figure, Ink};
use crate::theme::{Face, Role};

/// Length of an axis that lies across the line of sight, in points.
const LENGTH: f32 = 26.0;

/// Distance of the arrows' foot from the corner, in points.
const CORNER: f32 = 44.0;

/// Size of the letters in a picture that is not large, in points: all of it grows with what else is written there.
const LETTERS: f32 = 12.5;

fn grown(size: Vec2) -> f32 {
    (letters(size) / LETTERS).max(1.0)
}

/// An axis that is seen shorter than this, in parts of its length, points at the eye or away from it.
const SHORT: f32 = 0.2;

/// Where they stand in a picture of this size: its corners.
pub(super) fn room(size: Vec2) -> [Vec2; 2] {
    let reach = (LENGTH + 22.0) * grown(size);
    let foot = foot(size);
    [foot - reach, foot + reach]
}

fn foot(size: Vec2) -> Vec2 {
    let corner = CORNER * grown(size);
    Vec2::new(corner, size.y - corner)
}

/// The three axes as this camera sees them; in a flat scene, whose rulers say it, nothing.
pub fn axes(camera: &Camera, size: Vec2) -> Figure {
    let mut figure = Figure::new(size);
    let Camera::Solid { .. } = camera else { return figure };
    let lens = Lens::new(camera, size);
    let (foot, grown) = (foot(size), grown(size));
    for (axis, name) in [(Vec3::X, "x"), (Vec3::Y, "y"), (Vec3::Z, "z")] {
        let along = lens.across(axis);
        let tip = foot + along * LENGTH * grown;
        figure.add(Role::Edge, None, Ink::Line { points: vec![foot, tip] });
        let away = along.length();
        if away > SHORT {
            let along = along / away;
            figure.add(Role::Edge, None, Ink::Arrowhead { tip: tip + along * 5.0, along, length: 7.0 });
        }
        let at = foot + (along / away.max(1e-3)) * (LENGTH * away + 14.0) * grown;
        let text = name.to_owned();
        let (size, face, anchor) = (LETTERS * grown, Face::Medium, Anchor::Middle);
        figure.add(Role::Text, None, Ink::Text { at, text, size, face, anchor, boxed: false });
    }
    figure
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_point_where_the_camera_sees_them() {
        let size = Vec2::new(400.0, 300.0);
        let camera = Camera::Solid { eye: Vec3::NEG_Y * 5.0, target: Vec3::ZERO, up: Vec3::Z, fov_degrees: 40.0 };
        let figure = axes(&camera, size);
        let at = |name: &str| {
            let letter = figure.marks.iter().find_map(|mark| match &mark.ink {
                Ink::Text { at, text, .. } if text == name => Some(*at),
                _ => None,
            });
            letter.unwrap() - Vec2::new(CORNER, size.y - CORNER)
        };
        assert!(at("x").x > LENGTH && at("x").y.abs() < 1e-3, "x runs to the right");
        assert!(at("z").y < -LENGTH && at("z").x.abs() < 1e-3, "z runs up");
        assert!(axes(&Camera::Flat { center: Vec2::ZERO, half_height: 1.0 }, size).marks.is_empty());
    }
}
