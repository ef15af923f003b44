//! A slide's board as the figures draw it: its printed words, its formulas' values, its measured numbers.

use std::borrow::Cow;

use raystep_accel::{Appraisal, Measure, Place, Reveal, Value};
use raystep_figure::{
    Board, Camera, Chart, Curve, Drawn, Fact, Given, Image, Knob, Map, Maps, Meter, Panel, Picture, Pictures, Role,
    Row, Scale, Symbol, Table, VolumeName, forms_of, number, told, whole,
};
use raystep_lesson::{BoardTape, Cell, Column, Measured, Numbers, Stroke, Timed};
use raystep_scene::View;

/// How many points a law is drawn through.
const POINTS: usize = 96;

/// What stands on a filled board, made once for all its steps.
#[derive(Debug)]
pub(crate) struct Panels {
    panels: Vec<Panel>,
    /// What each of its entries is called.
    names: Vec<String>,
}

impl Panels {
    /// The panels of a filled board.
    pub(crate) fn of(filled: &BoardTape) -> Panels {
        let panels = panels(filled);
        let named =
            |(entry, at): (usize, &(usize, usize))| words(&name(filled, *at).unwrap_or_default(), entry, filled);
        Panels { panels, names: filled.places.iter().enumerate().map(named).collect() }
    }

    /// The board, ready to be drawn.
    pub(crate) fn board<'a>(&'a self, filled: &'a BoardTape) -> Board<'a> {
        Board { panels: &self.panels, events: &filled.events, names: &self.names }
    }
}

fn panels(filled: &BoardTape) -> Vec<Panel> {
    let panels = filled.board.panels.iter().enumerate().map(|(index, panel)| match panel {
        raystep_lesson::Panel::Table(table) => Panel::Table(of_table(table, index, filled)),
        raystep_lesson::Panel::Chart(chart) => Panel::Chart(of_chart(chart, index, filled)),
        raystep_lesson::Panel::Meter(meter) => Panel::Meter(of_meter(meter, filled)),
        raystep_lesson::Panel::Maps(maps) => Panel::Maps(of_maps(maps, index, filled)),
        raystep_lesson::Panel::Pictures(pictures) => Panel::Pictures(of_pictures(pictures, index, filled)),
    });
    panels.collect()
}

/// What that is called which stands at a place of a panel.
fn name(filled: &BoardTape, (panel, place): (usize, usize)) -> Option<String> {
    match filled.board.panels.get(panel) {
        Some(raystep_lesson::Panel::Table(table)) => table.rows.get(place).map(|row| row.name.clone()),
        Some(raystep_lesson::Panel::Chart(chart)) => chart.drawn.get(place).map(|drawn| drawn.name.clone()),
        Some(raystep_lesson::Panel::Maps(maps)) => maps.maps.get(place).map(|map| map.name.clone()),
        Some(raystep_lesson::Panel::Pictures(pictures)) => {
            pictures.pictures.get(place).map(|picture| picture.name.clone())
        }
        Some(raystep_lesson::Panel::Meter(_)) | None => None,
    }
}

/// The step at which what stands at a place of a panel comes to be seen, from 0.
fn entry(filled: &BoardTape, panel: usize, place: usize) -> usize {
    filled.places.iter().position(|at| *at == (panel, place)).unwrap_or(usize::MAX)
}

/// What stands beside an entry, with its numbers and those of the meter filled in.
fn words(text: &str, entry: usize, filled: &BoardTape) -> String {
    match filled.events.get(entry) {
        Some(event) if text.contains("{{") => told(text, &Shown { event, numbers: &filled.numbers }),
        _ => text.to_owned(),
    }
}

/// An entry, and where the numbers of the meter stand.
struct Shown<'a> {
    event: &'a Reveal,
    numbers: &'a Numbers,
}

impl Fact for Shown<'_> {
    fn name(&self) -> &'static str {
        self.event.name()
    }

    fn place(&self) -> Place {
        self.event.place()
    }

    fn field(&self, name: &str) -> Option<Value> {
        let moved = || self.numbers.get(name).map(|number| Value::Number(number as f32));
        self.event.field(name).or_else(moved)
    }

    fn symbol(&self) -> Option<Symbol> {
        None
    }

    fn short(&self, _: VolumeName) -> Cow<'static, str> {
        Cow::Borrowed("")
    }

    fn sentence(&self, _: VolumeName) -> String {
        String::new()
    }
}

fn of_meter(meter: &raystep_lesson::Meter, filled: &BoardTape) -> Meter {
    let knobs = meter.numbers.iter().map(|number| Knob {
        name: number.name.clone(),
        note: number.note.clone(),
        from: number.from,
        to: number.to,
        is: filled.numbers.get(&number.name).unwrap_or(number.is),
        log: number.log,
        whole: number.whole,
    });
    let gives = meter.gives.iter().map(|given| {
        let value = number(given.formula.at(0.0, &filled.numbers) as f32);
        let value = if given.unit.is_empty() { value } else { format!("{value} {}", given.unit) };
        Given { name: given.name.clone(), note: given.note.clone(), value }
    });
    Meter {
        title: meter.title.clone(),
        about: meter.about.clone(),
        knobs: knobs.collect(),
        gives: gives.collect(),
        entry: filled.board.first_moved(),
    }
}

fn of_table(table: &raystep_lesson::Table, panel: usize, filled: &BoardTape) -> Table {
    let columns = table.columns.iter().map(|(column, head)| raystep_figure::Column {
        head: head.clone(),
        role: match column {
            Column::Printed | Column::Nodes | Column::Bytes => Role::Text,
            Column::Total => Role::Quiet,
            Column::Computed | Column::Visits | Column::Boxes | Column::Cuts | Column::Alive => Role::Value,
            Column::Speed | Column::Time | Column::Share | Column::Picture => Role::Here,
            Column::Spread | Column::Build => Role::Quiet,
            Column::Content | Column::Area | Column::Planes | Column::After => Role::Text,
            Column::Before => Role::Quiet,
            Column::Tests | Column::Vain => Role::Missed,
        },
        given: matches!(column, Column::Printed | Column::Total | Column::Before),
    });
    let rows = table.rows.iter().enumerate().map(|(place, row)| {
        let entry = entry(filled, panel, place);
        let measured = filled.measured.get(entry).copied().flatten();
        let timing = filled.timed.get(entry).and_then(Option::as_ref);
        let is_built = row.plan.is_some() || row.fast.is_some();
        let first = table.columns.iter().map(|(column, _)| *column).find(|column| column.is_timed());
        let cell = |(column, _): &(Column, String)| match row.cells.iter().find(|(own, _)| own == column) {
            Some((_, Cell::Text(text))) => text.clone(),
            Some((_, Cell::Value(formula, unit))) => {
                let value = digits(formula.at(0.0, &filled.numbers));
                if unit.is_empty() { value } else { format!("{value} {unit}") }
            }
            None if column.is_timed() => match timing {
                Some(Ok(timed)) => timed_here(*column, timed),
                Some(Err(_)) => "\u{2013}".to_owned(),
                None if !is_built => String::new(),
                None if filled.is_clocked => "\u{2026}".to_owned(),
                None if first == Some(*column) => ELSEWHERE.to_owned(),
                None => "\u{2013}".to_owned(),
            },
            None => match filled.appraised.get(entry).and_then(Option::as_ref) {
                Some(appraised) => around(*column, appraised),
                None => measured.map_or_else(String::new, |measured| here(*column, &measured)),
            },
        };
        let cells = table.columns.iter().map(cell).collect();
        // Who could not be timed says why.
        let note = match timing {
            Some(Err(why)) => why.clone(),
            _ => words(&row.note, entry, filled),
        };
        Row { entry, name: words(&row.name, entry, filled), note, cells }
    });
    Table {
        title: table.title.clone(),
        about: table.about.clone(),
        of: table.of.clone(),
        columns: columns.collect(),
        rows: rows.collect(),
    }
}

/// What stands instead of times where none are told.
const ELSEWHERE: &str = "in the window";

/// What was timed, in three digits.
fn timed_here(column: Column, timed: &Timed) -> String {
    let known =
        |value: f64, says: &dyn Fn(f64) -> String| if value.is_nan() { "\u{2013}".to_owned() } else { says(value) };
    match column {
        Column::Speed => known(timed.speed, &digits),
        Column::Spread => {
            let [least, most] = timed.spread;
            known(least, &|least| format!("{}\u{2013}{}", digits(least), digits(most)))
        }
        Column::Time => known(timed.time(), &digits),
        Column::Build => known(timed.build, &digits),
        Column::Share => known(timed.share, &|share| format!("{:.1} %", share * 100.0)),
        Column::Picture => known(timed.seconds, &span),
        _ => String::new(),
    }
}

/// A time in the unit in which people say it.
pub(crate) fn span(seconds: f64) -> String {
    const YEAR: f64 = 365.25 * 86_400.0;
    let units = [(YEAR, "years"), (86_400.0, "days"), (3600.0, "hours"), (60.0, "minutes"), (1.0, "s"), (1e-3, "ms")];
    let (unit, name) = units.into_iter().find(|(unit, _)| seconds >= *unit * 1.5).unwrap_or((1e-6, "µs"));
    format!("{} {name}", digits(seconds / unit))
}

/// A measured number: counts a ray in three digits, counts of things in full.
fn here(column: Column, measured: &Measured) -> String {
    match column {
        Column::Tests => digits(measured.tests),
        // Where there is nothing to enter, none were.
        Column::Visits | Column::Boxes if measured.nodes == 0 && measured.visits == 0.0 => "\u{2013}".to_owned(),
        // Of fast structures only what a ray enters is counted.
        Column::Nodes if measured.nodes == 0 => "\u{2013}".to_owned(),
        Column::Visits => digits(measured.visits),
        Column::Boxes => digits(measured.boxes),
        Column::Alive if measured.alive.is_nan() => "\u{2013}".to_owned(),
        Column::Alive => digits(measured.alive),
        Column::Bytes if measured.bytes == 0 => "\u{2013}".to_owned(),
        Column::Nodes => whole(measured.nodes),
        Column::Bytes => whole(measured.bytes),
        Column::Printed | Column::Total | Column::Computed | Column::Before | Column::After => String::new(),
        // Of a structure nobody asks.
        Column::Content | Column::Area | Column::Planes | Column::Cuts | Column::Vain => String::new(),
        // Told by `timed_here`.
        Column::Speed | Column::Spread | Column::Time | Column::Build | Column::Share | Column::Picture => {
            String::new()
        }
    }
}

/// A number of a volume around everything.
fn around(column: Column, appraised: &Appraisal) -> String {
    match column {
        Column::Content => digits(appraised.content),
        Column::Area => digits(f64::from(appraised.area)),
        Column::Bytes => whole(appraised.bytes as u64),
        // A sphere has none.
        Column::Planes if appraised.planes == 0 => "\u{2013}".to_owned(),
        Column::Planes => whole(u64::from(appraised.planes)),
        Column::Cuts => digits(appraised.cuts),
        Column::Vain => format!("{:.1} %", appraised.vain_share() * 100.0),
        _ => String::new(),
    }
}

/// Three digits, idle zeros too: numbers below each other compare by their points.
pub(crate) fn digits(value: f64) -> String {
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
            Stroke::Point(x, y) => Curve::Point([x.at(0.0, &filled.numbers), y.at(0.0, &filled.numbers)]),
            Stroke::Growth { .. } => {
                let dots = filled.grown.get(entry(filled, panel, place)).cloned().unwrap_or_default();
                Curve::Line { dots, guess: false }
            }
            Stroke::Law { law, from, to, guess } => {
                let along = |index: usize| {
                    let part = index as f64 / (POINTS - 1) as f64;
                    // Evenly spaced on the page.
                    let x = if chart.x.log { from * libm::pow(to / from, part) } else { from + (to - from) * part };
                    [x, law.at(x, &filled.numbers)]
                };
                Curve::Line { dots: (0..POINTS).map(along).collect(), guess: *guess }
            }
        };
        let entry = entry(filled, panel, place);
        let moves = matches!(&drawn.stroke, Stroke::Point(x, y) if x.is_moved() || y.is_moved());
        let (name, note) = (words(&drawn.name, entry, filled), words(&drawn.note, entry, filled));
        Drawn { entry, name, note, moves, curve }
    });
    let untold = |(place, drawn): (usize, &raystep_lesson::Drawn)| {
        let seconds = matches!(drawn.stroke, Stroke::Growth { of: Column::Picture, .. });
        seconds && !filled.is_clocked && filled.timed.get(entry(filled, panel, place)).is_none_or(Option::is_none)
    };
    let about = match chart.drawn.iter().enumerate().any(untold) {
        true if chart.about.is_empty() => UNTOLD.to_owned(),
        true => format!("{}; {UNTOLD}", chart.about),
        false => chart.about.clone(),
    };
    Chart { title: chart.title.clone(), about, x: scale(&chart.x), y: scale(&chart.y), drawn: drawn.collect() }
}

/// What a chart says whose lines are not all drawn on paper.
const UNTOLD: &str = "times of this machine are measured in the window";

fn of_maps(maps: &raystep_lesson::Maps, panel: usize, filled: &BoardTape) -> Maps {
    let map = |(place, map): (usize, &raystep_lesson::Map)| {
        let entry = entry(filled, panel, place);
        let counted = filled.counted.get(entry).and_then(Option::as_ref);
        let (size, counts) = counted.map_or(([1, 1], vec![0]), |counted| (counted.size, counted.counts.clone()));
        Map { entry, name: words(&map.name, entry, filled), size, counts }
    };
    let (title, about) = (maps.title.clone(), maps.about.clone());
    Maps::new(title, about, counted(maps.of).to_owned(), maps.maps.iter().enumerate().map(map).collect())
}

/// What is counted of a ray, in words.
pub(crate) fn counted(of: Column) -> &'static str {
    match of {
        Column::Visits => "nodes or cells",
        Column::Boxes => "boxes",
        _ => "tests",
    }
}

fn of_pictures(pictures: &raystep_lesson::Pictures, panel: usize, filled: &BoardTape) -> Pictures {
    let picture = |(place, picture): (usize, &raystep_lesson::Picture)| {
        let entry = entry(filled, panel, place);
        let rendered = filled.rendered.get(entry).and_then(Option::as_ref);
        let blank = || ("".to_owned(), Image { width: 8, height: 5, rgba: vec![255; 160].into() }, None);
        let (says, image, over) = rendered.map_or_else(blank, |rendered| {
            let over = rendered.outline.as_ref().map(|outline| {
                let View { eye, target, up, fov_degrees } = rendered.view;
                (forms_of(outline), Camera::Solid { eye, target, up, fov_degrees })
            });
            let says = match &rendered.outline {
                Some(outline) => {
                    let area = f64::from(outline.measure(Measure::Area));
                    format!("volume {} · area {}", digits(outline.content()), digits(area))
                }
                None => {
                    let counts =
                        format!("{} triangles · {} tests per ray", whole(rendered.triangles), digits(rendered.tests));
                    match filled.timed.get(entry).and_then(Option::as_ref) {
                        Some(Ok(timed)) if !timed.seconds.is_nan() => {
                            format!("{counts} · {} here", span(timed.seconds))
                        }
                        _ if !pictures.times => counts,
                        _ if filled.is_clocked => format!("{counts} · \u{2026}"),
                        _ => format!("{counts} · its time: {ELSEWHERE}"),
                    }
                }
            };
            let [width, height] = rendered.size;
            (says, Image { width, height, rgba: rendered.rgba.clone() }, over)
        });
        Picture { entry, name: picture.name.clone(), says, image, over }
    };
    let (title, about) = (pictures.title.clone(), pictures.about.clone());
    Pictures { title, about, pictures: pictures.pictures.iter().enumerate().map(picture).collect() }
}
