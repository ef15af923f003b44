//! Boards as they are laid out.

use glam::Vec2;
use raystep_accel::Reveal;
use raystep_figure::{
    Ask, Board, Column, Face, Figure, Given, Image, Ink, Knob, Known, Look, Meter, Pane, Panel, Picture, Pictures,
    Reel, Role, Row, Table,
};

/// A table with so many rows, the first of which comes to be seen with this entry.
fn table(title: &str, rows: usize, from: usize) -> Panel {
    let row = |index: usize| Row {
        entry: from + index,
        name: format!("{title} {index}"),
        note: "a few words".to_owned(),
        cells: vec!["12.5".to_owned()],
        known: Known::Fully,
    };
    Panel::Table(Table {
        title: title.to_owned(),
        about: String::new(),
        of: "row".to_owned(),
        columns: vec![Column {
            head: "number".to_owned(),
            role: Role::Value,
            given: false,
            words: false,
            rays: true,
            digits: 7,
        }],
        rows: (0..rows).map(row).collect(),
    })
}

/// A meter that comes to be seen with this entry.
fn meter(entry: usize) -> Panel {
    let knob = |name: &str| Knob {
        name: name.to_owned(),
        note: String::new(),
        from: 1.0,
        to: 100.0,
        is: 10.0,
        log: true,
        whole: true,
    };
    Panel::Meter(Meter {
        title: "By hand".to_owned(),
        about: String::new(),
        knobs: vec![knob("N"), knob("k")],
        gives: vec![Given { name: "both".to_owned(), note: String::new(), value: "100".to_owned() }],
        entry,
    })
}

/// A board filled up to a step, and how many numbers can be moved on it.
fn board(panels: &[Panel], step: usize, ask: &Ask<'_>) -> (Figure, usize) {
    let events: Vec<Reveal> = (0..10).map(|entry| Reveal::Point { entry, x: 1.0, y: 1.0 }).collect();
    let names = vec![String::new(); events.len()];
    let reel = Reel::new(Board { panels, events: &events, names: &names });
    let at = reel.at(step);
    let still = reel.still(&at);
    (still.draw(Pane::Picture, ask), still.knobs(ask).len())
}

/// The sizes of letters that begin so, and the lowest of them.
fn letters(figure: &Figure, begins: &str) -> Vec<(f32, f32)> {
    let texts = figure.marks.iter().filter_map(|mark| match &mark.ink {
        Ink::Text { at, text, size, face: Face::Bold, .. } if text.starts_with(begins) => Some((*size, at.y)),
        _ => None,
    });
    texts.collect()
}

#[test]
fn all_tables_of_a_board_are_set_alike_and_stand_in_their_room() {
    let panels = [table("first", 6, 0), table("second", 4, 6), meter(5)];
    for size in [[1000.0, 670.0], [1300.0, 870.0], [1600.0, 950.0], [780.0, 560.0]] {
        let size = Vec2::from(size);
        let (figure, _) = board(&panels, 10, &Ask::new(size, Look::WINDOW));
        let rows: Vec<(f32, f32)> = ["first ", "second "].iter().flat_map(|title| letters(&figure, title)).collect();
        assert_eq!(rows.len(), 10, "at {size}");
        for (letters, y) in &rows {
            assert_eq!(*letters, rows[0].0, "at {size}");
            assert!(*y < size.y, "at {size}");
        }
        // One stands below the other, and the meter below both.
        let by_hand = letters(&figure, "N")[0].1;
        assert!(rows.windows(2).all(|rows| rows[0].1 < rows[1].1) && rows[9].1 < by_hand && by_hand < size.y);
    }
}

#[test]
fn a_meter_waits_for_what_follows_it_and_nothing_moves_when_it_comes() {
    let panels = [table("first", 6, 0), meter(5)];
    let ask = Ask::new(Vec2::new(1000.0, 670.0), Look::WINDOW);
    let rows = letters(&board(&panels, 6, &ask).0, "first ");
    for step in 0..=6 {
        let (figure, knobs) = board(&panels, step, &ask);
        let there = step == 6;
        assert_eq!(!letters(&figure, "N").is_empty(), there, "step {step}");
        assert_eq!(knobs, if there { 2 } else { 0 }, "step {step}");
        assert_eq!(letters(&figure, "first "), rows, "step {step}");
    }
    // Where it stands alone, somebody has asked for it.
    assert_eq!(board(&panels[1..], 0, &ask).1, 2);
}

/// A text of a figure, with where it stands and what it is.
fn said(figure: &Figure, words: &str) -> Option<(Vec2, Role)> {
    figure.marks.iter().find_map(|mark| match &mark.ink {
        Ink::Text { at, text, .. } if text == words => Some((*at, mark.role)),
        _ => None,
    })
}

#[test]
fn what_is_not_final_looks_so_and_nothing_moves_when_it_is() {
    let ask = Ask::new(Vec2::new(1000.0, 670.0), Look::WINDOW);
    let drawn = |known: Known, cell: &str| {
        let Panel::Table(mut table) = table("first", 3, 0) else { unreachable!() };
        table.about = "a remark".to_owned();
        for row in &mut table.rows {
            (row.known, row.cells) = (known, vec![cell.to_owned()]);
        }
        board(&[Panel::Table(table)], 2, &ask).0
    };
    let fully = drawn(Known::Fully, "12.5");
    let names = letters(&fully, "first ");
    for (known, cell, sign, legend) in [
        (Known::NotYet, "\u{2026}", "\u{2026}", "\u{2026} not measured yet · a remark"),
        (Known::Roughly, "12.5", "\u{2248}", "\u{2248} from few rays so far · a remark"),
    ] {
        let figure = drawn(known, cell);
        assert_eq!(letters(&figure, "first "), names, "{known:?}");
        assert!(said(&figure, legend).is_some(), "{known:?}");
        let (at, role) = said(&figure, sign).expect("a sign");
        assert_eq!(role, Role::Quiet, "{known:?}");
        assert_eq!(at.y, said(&fully, "12").expect("a number").0.y, "{known:?}");
        assert_eq!(said(&figure, "number"), said(&fully, "number"), "{known:?}");
    }
    assert!(said(&fully, "a remark").is_some() && said(&fully, "\u{2248}").is_none());
    assert_eq!(said(&fully, "12").expect("a number").1, Role::Value);
    // Where nothing is counted of rays, a few of them tell all.
    let figure = drawn(Known::Roughly, "\u{2013}");
    assert!(said(&figure, "\u{2248}").is_none() && said(&figure, "a remark").is_some());
}

#[test]
fn a_picture_that_waits_has_its_frame() {
    let ask = Ask::new(Vec2::new(1000.0, 670.0), Look::WINDOW);
    let drawn = |image: Option<Image>, known: Known| {
        let picture = |entry: usize| Picture {
            entry,
            name: format!("picture {entry}"),
            says: if image.is_some() { "few".to_owned() } else { String::new() },
            room: "some more words".to_owned(),
            size: [720, 450],
            image: image.clone(),
            over: None,
            known,
        };
        let (title, about) = ("Pictures".to_owned(), String::new());
        board(&[Panel::Pictures(Pictures { title, about, pictures: (0..3).map(picture).collect() })], 2, &ask).0
    };
    // A draft's pixels are not quite of the shape of the frame.
    let image = Image { width: 100, height: 62, rgba: vec![200; 100 * 62 * 4].into() };
    let (waits, there) = (drawn(None, Known::NotYet), drawn(Some(image), Known::Fully));
    assert_eq!(letters(&waits, "picture "), letters(&there, "picture "));
    let frames = |figure: &Figure| {
        let lines = figure.marks.iter().filter(|mark| matches!(mark.ink, Ink::Line { .. }) && mark.role == Role::Edge);
        lines.map(|mark| mark.ink.clone()).collect::<Vec<_>>()
    };
    assert_eq!(frames(&waits), frames(&there));
    let seen = |figure: &Figure| figure.marks.iter().filter(|mark| matches!(mark.ink, Ink::Image { .. })).count();
    assert_eq!((seen(&waits), seen(&there)), (0, 2));
    assert!(said(&waits, "not traced yet").is_some() && said(&there, "not traced yet").is_none());
}

#[test]
fn rows_come_close_before_letters_become_small() {
    let panels = [table("first", 9, 0)];
    let set = |high: f32| letters(&board(&panels, 9, &Ask::new(Vec2::new(900.0, high), Look::WINDOW)).0, "first ");
    let (low, high) = (set(280.0), set(420.0));
    let apart = |rows: &[(f32, f32)]| (rows[1].1 - rows[0].1) / rows[0].0;
    assert!(low[0].0 >= Look::WINDOW.text * 0.99, "{low:?}");
    assert!(low[8].1 < 280.0 && high[8].1 < 420.0 && high[0].0 > low[0].0, "{low:?}, {high:?}");
    assert!(apart(&low) < 2.0 && apart(&high) <= 2.51, "{low:?}, {high:?}");
}
