//! Every kind of ink in every role, as files.

use glam::Vec2;
use raystep_accel::{NodeId, Place};
use raystep_figure::{Anchor, Face, Figure, Ink, Role, Theme};
use raystep_print::{Lettering, Manner, around, drawing, drawn, part, pdf, png, svg};

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

#[test]
fn letters_stand_as_text_where_that_is_asked_for() {
    let mut figure = chart();
    figure.add(
        Role::Text,
        None,
        Ink::Formula { at: Vec2::new(20.0, 20.0), tex: r"\frac{t_0}{2}".to_owned(), size: 20.0 },
    );
    for (lettering, texts, faces) in
        [(Lettering::Outlines, false, false), (Lettering::Named, true, false), (Lettering::Embedded, true, true)]
    {
        let manner = Manner { lettering, ..Manner::plain(&Theme::LIGHT) };
        let file = drawing(&figure, &manner);
        assert_eq!(file, drawing(&figure, &manner));
        assert_eq!(file.contains(">3 waits</text>"), texts, "{lettering:?}");
        assert_eq!(file.contains("&amp; &lt;text&gt;</text>"), texts, "{lettering:?}");
        assert_eq!(file.contains("@font-face{font-family:'Inter';font-weight:500"), faces, "{lettering:?}");
        assert_eq!(file.contains("@font-face{font-family:'KaTeX_Math'"), faces, "{lettering:?}");
        assert_eq!(file.contains("<path id="), !texts, "{lettering:?}");
        // Nothing but letters differs.
        assert_eq!(file.matches("<polyline").count(), svg(&figure, &Theme::LIGHT).matches("<polyline").count());
        // What is not asked for is not brought along: a file of some letters is small.
        assert!(file.len() < 200_000, "{} bytes", file.len());
    }
}

#[test]
fn a_page_in_pdf_is_as_large_as_asked_and_tells_no_time() {
    let figure = chart();
    let size = figure.size * 0.5 * 0.75;
    for theme in Theme::ALL {
        let manner = Manner { scale: 0.5, ..Manner::plain(theme) };
        let page = pdf(&figure, "Marks", &manner).unwrap();
        assert_eq!(page, pdf(&figure, "Marks", &manner).unwrap());
        let text = String::from_utf8_lossy(&page);
        let sides = format!("/MediaBox[0 0 {} {}]", size.x, size.y);
        let at = text.find("/MediaBox").map(|at| &text[at..(at + 60).min(text.len())]);
        assert!(text.starts_with("%PDF-1.") && text.contains(&sides), "{sides} {at:?}");
        assert!(text.contains("/FontFile3") && text.contains("/ToUnicode") && !text.contains("Date"));
    }
    let clear = Manner { clear: true, ..Manner::plain(&Theme::LIGHT) };
    assert!(pdf(&Figure::new(Vec2::new(40.0, 30.0)), "", &clear).is_ok());
    let error = pdf(&figure, "Marks", &Manner { scale: 1000.0, ..clear }).unwrap_err();
    assert!(error.to_string().contains("cannot be made"), "{error}");
}

#[test]
fn margins_are_cut_off_and_grounds_left_out() {
    let mut figure = Figure::new(Vec2::new(200.0, 100.0));
    figure.add(Role::Panel, None, Ink::Rect { min: Vec2::ZERO, max: figure.size, round: 0.0 });
    assert_eq!(drawn(&figure), None, "a ground is no drawing");
    figure.add(Role::Here, None, Ink::Circle { center: Vec2::new(60.0, 50.0), radius: 10.0 });
    figure.add(Role::Ray, None, Ink::Line { points: vec![Vec2::new(-40.0, 20.0), Vec2::new(90.0, 20.0)] });
    let found = drawn(&figure).unwrap();
    assert_eq!(found, [Vec2::new(0.0, 20.0), Vec2::new(90.0, 60.0)], "as far as the page goes");
    assert_eq!(around(found, [Vec2::splat(30.0); 2]), found);
    let opaque = svg(&figure, &Theme::LIGHT);
    let clear = drawing(&figure, &Manner { clear: true, scale: 2.0, ..Manner::plain(&Theme::LIGHT) });
    assert!(opaque.contains("class=\"panel\"") && !clear.contains("class=\"panel\""));
    assert!(clear.contains("width=\"400\" height=\"200\" viewBox=\"0 0 200 100\""), "{clear}");
    let part = part(figure, found);
    assert_eq!(part.size, Vec2::new(90.0, 40.0));
    assert!(matches!(part.marks[1].ink, Ink::Circle { center, .. } if center == Vec2::new(60.0, 30.0)));
}
