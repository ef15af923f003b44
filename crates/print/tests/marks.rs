//! Every kind of ink in every role, as files.

use glam::Vec2;
use raystep_accel::{NodeId, Place};
use raystep_figure::{Anchor, Face, Figure, Ink, Role, Theme};
use raystep_print::{png, svg};

/// One row for each role: line, box, circle, arrow, label, text.
fn chart() -> Figure {
    let mut figure = Figure::new(Vec2::new(760.0, 40.0 + 34.0 * Role::ALL.len() as f32));
    for (row, role) in Role::ALL.into_iter().enumerate() {
        let y = 30.0 + 34.0 * row as f32;
        let place = Some(Place::Node(NodeId(row as u32)));
        let at = |x: f32| Vec2::new(x, y);
        let mut add = |ink| figure.add(role, place, ink);
        add(Ink::Line { points: vec![at(20.0), at(120.0)] });
        add(Ink::Arrowhead { tip: at(134.0), along: Vec2::X, length: 14.0 });
        add(Ink::Rect { min: at(150.0) - Vec2::Y * 12.0, max: at(230.0) + Vec2::Y * 12.0, round: 4.0 });
        add(Ink::Circle { center: at(260.0), radius: 12.0 });
        add(Ink::Area { points: vec![at(290.0), at(320.0) - Vec2::Y * 12.0, at(320.0) + Vec2::Y * 12.0] });
        let text =
            |x: f32, text: String, face, anchor, boxed| Ink::Text { at: at(x), text, size: 14.0, face, anchor, boxed };
        add(text(400.0, format!("{row} waits"), Face::Medium, Anchor::Middle, true));
        add(text(460.0, format!("{role:?} & <text>"), Face::Regular, Anchor::Start, false));
        add(text(740.0, "[0.328, 3.66]".to_owned(), Face::Mono, Anchor::End, false));
    }
    figure
}

#[test]
fn the_same_figure_gives_the_same_bytes() {
    for theme in Theme::ALL {
        let (first, again) = (svg(&chart(), theme), svg(&chart(), theme));
        assert_eq!(first, again);
        assert_eq!(png(&first, 1.0).unwrap(), png(&again, 1.0).unwrap());
    }
}

#[test]
fn formulas_are_set_and_what_is_none_stands_as_typed() {
    for (tex, taller) in [(r"t = \frac{p - o_x}{d_x}", true), (r"\frac{", false)] {
        let room = raystep_print::extent(tex, 20.0);
        assert!(room.width > 20.0);
        assert_eq!(room.height + room.depth > 30.0, taller, "{tex}");
        let file = raystep_print::formula(tex, 20.0, Theme::LIGHT.style(Role::Text).text);
        assert!(png(&file, 1.0).is_ok());
    }
}

#[test]
fn too_large_a_picture_is_refused() {
    let error = png(&svg(&chart(), &Theme::LIGHT), 1000.0).unwrap_err();
    assert!(error.to_string().contains("16384"), "{error}");
}
