//! Boards as they are laid out.

use glam::Vec2;
use raystep_accel::Reveal;
use raystep_figure::{
    Ask, Board, Column, Face, Figure, Given, Ink, Knob, Look, Meter, Pane, Panel, Reel, Role, Row, Table,
};

/// A table with so many rows, the first of which comes to be seen with this entry.
fn table(title: &str, rows: usize, from: usize) -> Panel {
    let row = |index: usize| Row {
        entry: from + index,
        name: format!("{title} {index}"),
        note: "a few words".to_owned(),
        cells: vec!["12.5".to_owned()],
    };
    Panel::Table(Table {
        title: title.to_owned(),
        about: String::new(),
        of: "row".to_owned(),
        columns: vec![Column { head: "number".to_owned(), role: Role::Value, given: false }],
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
