//! A slide's board as the figures draw it: its printed words, its formulas' values, its measured numbers.

use raystep_figure::{
    Board, Chart, Curve, Drawn, Image, Map, Maps, Panel, Picture, Pictures, Role, Row, Scale, Table, number,
};
use raystep_lesson::{BoardTape, Cell, Column, Measured, Stroke};

/// How many points a law is drawn through.
const POINTS: usize = 96;

/// A filled board, ready to be drawn.
pub(crate) fn board(filled: &BoardTape) -> Board<'_> {
    let panels = filled.board.panels.iter().enumerate().map(|(index, panel)| match panel {
        raystep_lesson::Panel::Table(table) => Panel::Table(of_table(table, index, filled)),
        raystep_lesson::Panel::Chart(chart) => Panel::Chart(of_chart(chart, index, filled)),
        raystep_lesson::Panel::Maps(maps) => Panel::Maps(of_maps(maps, index, filled)),
        raystep_lesson::Panel::Pictures(pictures) => Panel::Pictures(of_pictures(pictures, index, filled)),
    });
    let name = |&(panel, place): &(usize, usize)| match filled.board.panels.get(panel) {
        Some(raystep_lesson::Panel::Table(table)) => table.rows.get(place).map(|row| row.name.clone()),
        Some(raystep_lesson::Panel::Chart(chart)) => chart.drawn.get(place).map(|drawn| drawn.name.clone()),
        Some(raystep_lesson::Panel::Maps(maps)) => maps.maps.get(place).map(|map| map.name.clone()),
        Some(raystep_lesson::Panel::Pictures(pictures)) => {
            pictures.pictures.get(place).map(|picture| picture.name.clone())
        }
        None => None,
    };
    let names = filled.places.iter().map(|at| name(at).unwrap_or_default()).collect();
    Board { panels: panels.collect(), events: &filled.events, names }
}

/// The step at which what stands at a place of a panel comes to be seen, from 0.
fn entry(filled: &BoardTape, panel: usize, place: usize) -> usize {
    filled.places.iter().position(|at| *at == (panel, place)).unwrap_or(usize::MAX)
}

fn of_table(table: &raystep_lesson::Table, panel: usize, filled: &BoardTape) -> Table {
    let columns = table.columns.iter().map(|(column, head)| raystep_figure::Column {
        head: head.clone(),
        role: match column {
            Column::Printed | Column::Nodes | Column::Bytes => Role::Text,
            Column::Total => Role::Quiet,
            Column::Computed | Column::Visits | Column::Boxes | Column::Alive => Role::Value,
            Column::Tests => Role::Missed,
        },
        given: matches!(column, Column::Printed | Column::Total),
    });
    let rows = table.rows.iter().enumerate().map(|(place, row)| {
        let entry = entry(filled, panel, place);
        let measured = filled.measured.get(entry).copied().flatten();
        let cell = |(column, _): &(Column, String)| match row.cells.iter().find(|(own, _)| own == column) {
            Some((_, Cell::Text(text))) => text.clone(),
            Some((_, Cell::Value(formula, unit))) => {
                let value = digits(formula.at(0.0));
                if unit.is_empty() { value } else { format!("{value} {unit}") }
            }
            None => measured.map_or_else(String::new, |measured| here(*column, &measured)),
        };
        let cells = table.columns.iter().map(cell).collect();
        Row { entry, name: row.name.clone(), note: row.note.clone(), cells }
    });
    Table {
        title: table.title.clone(),
        about: table.about.clone(),
        of: table.of.clone(),
        columns: columns.collect(),
        rows: rows.collect(),
    }
}

/// A measured number: counts a ray in three digits, counts of things in full.
fn here(column: Column, measured: &Measured) -> String {
    match column {
        Column::Tests => digits(measured.tests),
        // Where there is nothing to enter, none were.
        Column::Visits | Column::Boxes | Column::Nodes if measured.nodes == 0 => "\u{2013}".to_owned(),
        Column::Visits => digits(measured.visits),
        Column::Boxes => digits(measured.boxes),
        Column::Alive if measured.alive.is_nan() => "\u{2013}".to_owned(),
        Column::Alive => digits(measured.alive),
        Column::Bytes if measured.bytes == 0 => "\u{2013}".to_owned(),
        Column::Nodes => grouped(measured.nodes),
        Column::Bytes => grouped(measured.bytes),
        Column::Printed | Column::Total | Column::Computed => String::new(),
    }
}

/// Three digits, idle zeros too: numbers below each other compare by their points.
fn digits(value: f64) -> String {
    let short = number(value as f32);
    let places = short.split_once('.').map_or(0, |(_, behind)| behind.len());
    let whole = short.chars().take_while(char::is_ascii_digit).count();
    let wanted = 3_usize.saturating_sub(whole);
    if short.chars().all(|c| c.is_ascii_digit() || c == '.') && value.abs() >= 1.0 && places < wanted {
        format!("{value:.wanted$}")
    } else {
        short
    }
}

/// `124,288`
fn grouped(count: u64) -> String {
    let digits = count.to_string();
    let groups: Vec<String> =
        digits.as_bytes().rchunks(3).rev().map(|group| String::from_utf8_lossy(group).into_owned()).collect();
    groups.join(",")
}

fn of_chart(chart: &raystep_lesson::Chart, panel: usize, filled: &BoardTape) -> Chart {
    let scale = |scale: &raystep_lesson::Scale| Scale {
        name: scale.name.clone(),
        log: scale.log,
        from: scale.from,
        to: scale.to,
        ticks: scale.ticks.clone(),
    };
    let drawn = chart.drawn.iter().enumerate().map(|(place, drawn)| {
        let curve = match &drawn.stroke {
            Stroke::Point(x, y) => Curve::Point([x.at(0.0), y.at(0.0)]),
            Stroke::Growth { .. } => {
                let dots = filled.grown.get(entry(filled, panel, place)).cloned().unwrap_or_default();
                Curve::Line { dots, guess: false }
            }
            Stroke::Law { law, from, to, guess } => {
                let along = |index: usize| {
                    let part = index as f64 / (POINTS - 1) as f64;
                    // Evenly spaced on the page.
                    let x = if chart.x.log { from * libm::pow(to / from, part) } else { from + (to - from) * part };
                    [x, law.at(x)]
                };
                Curve::Line { dots: (0..POINTS).map(along).collect(), guess: *guess }
            }
        };
        Drawn { entry: entry(filled, panel, place), name: drawn.name.clone(), note: drawn.note.clone(), curve }
    });
    Chart {
        title: chart.title.clone(),
        about: chart.about.clone(),
        x: scale(&chart.x),
        y: scale(&chart.y),
        drawn: drawn.collect(),
    }
}

fn of_maps(maps: &raystep_lesson::Maps, panel: usize, filled: &BoardTape) -> Maps {
    let map = |(place, map): (usize, &raystep_lesson::Map)| {
        let entry = entry(filled, panel, place);
        let counted = filled.counted.get(entry).and_then(Option::as_ref);
        let (size, counts) = counted.map_or(([1, 1], vec![0]), |counted| (counted.size, counted.counts.clone()));
        Map { entry, name: map.name.clone(), size, counts }
    };
    let of = match maps.of {
        Column::Visits => "nodes or cells",
        Column::Boxes => "boxes",
        _ => "tests",
    };
    let (title, about) = (maps.title.clone(), maps.about.clone());
    Maps { title, about, of: of.to_owned(), maps: maps.maps.iter().enumerate().map(map).collect() }
}

fn of_pictures(pictures: &raystep_lesson::Pictures, panel: usize, filled: &BoardTape) -> Pictures {
    let picture = |(place, picture): (usize, &raystep_lesson::Picture)| {
        let entry = entry(filled, panel, place);
        let rendered = filled.rendered.get(entry).and_then(Option::as_ref);
        let blank = || ("".to_owned(), Image { width: 8, height: 5, rgba: vec![255; 160].into() });
        let (says, image) = rendered.map_or_else(blank, |rendered| {
            let says = format!("{} triangles · {} tests per ray", grouped(rendered.triangles), digits(rendered.tests));
            let [width, height] = rendered.size;
            (says, Image { width, height, rgba: rendered.rgba.clone() })
        });
        Picture { entry, name: picture.name.clone(), says, image }
    };
    let (title, about) = (pictures.title.clone(), pictures.about.clone());
    Pictures { title, about, pictures: pictures.pictures.iter().enumerate().map(picture).collect() }
}
