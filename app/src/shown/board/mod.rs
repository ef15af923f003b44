//! A slide's board as the figures draw it: its printed words, its formulas' values, its measured numbers.

mod numbers;

use std::borrow::Cow;

use raystep_accel::{Measure, Place, Reveal, Value};
use raystep_figure::{
    Board, Camera, Chart, Curve, Drawn, ELSEWHERE, Fact, Given, Image, Knob, Known, Map, Maps, Meter, Panel, Picture,
    Pictures, ROUGH, Role, Row, Scale, Symbol, Table, VolumeName, forms_of, number, told, whole,
};
use raystep_lesson::{BoardTape, Care, Cell, Column, Rendered, Stroke, Timing};
use raystep_scene::View;

use numbers::{around, here, timed_here};
pub(crate) use numbers::{digits, span};

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
        Some(event) if text.contains("{{") => told(text, &Shown { event, entry, filled }),
        _ => text.to_owned(),
    }
}

/// How well an entry is known.
fn known(filled: &BoardTape, entry: usize) -> Known {
    match filled.care_of(entry) {
        Care::Bare => Known::NotYet,
        Care::Draft => Known::Roughly,
        Care::Full => Known::Fully,
    }
}

/// What stands for a number that is still to be measured.
const WAITS: &str = "\u{2026}";

/// An entry of a board, with the numbers of the meter.
struct Shown<'a> {
    event: &'a Reveal,
    entry: usize,
    filled: &'a BoardTape,
}

impl Fact for Shown<'_> {
    fn name(&self) -> &'static str {
        self.event.name()
    }

    fn place(&self) -> Place {
        self.event.place()
    }

    fn field(&self, name: &str) -> Option<Value> {
        let moved = || self.filled.numbers.get(name).map(|number| Value::Number(number as f32));
        let waits = || {
            let bare = self.filled.care_of_number(self.entry, name) == Care::Bare;
            bare.then_some(Value::Word(WAITS, &[]))
        };
        self.event.told(name).or_else(moved).or_else(waits)
    }

    fn is_rough(&self, name: &str) -> bool {
        self.filled.care_of_number(self.entry, name) == Care::Draft
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
        words: matches!(column, Column::Before | Column::After),
        rays: matches!(column, Column::Tests | Column::Visits | Column::Boxes | Column::Alive),
        digits: room(*column),
    });
    let rows = table.rows.iter().enumerate().map(|(place, row)| {
        let entry = entry(filled, panel, place);
        let measured = filled.measured.get(entry).copied().flatten();
        let timing = filled.timed.get(entry).and_then(Option::as_ref);
        let known = known(filled, entry);
        let is_built = row.plan.is_some() || row.fast.is_some();
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
                None if filled.is_clocked => WAITS.to_owned(),
                None => ELSEWHERE.to_owned(),
            },
            None => match filled.appraised.get(entry).and_then(Option::as_ref) {
                Some(appraised) => around(*column, appraised),
                None if column.is_measured() && known == Known::NotYet => WAITS.to_owned(),
                None => measured.map_or_else(String::new, |measured| here(*column, &measured)),
            },
        };
        let cells = table.columns.iter().map(cell).collect();
        // Who could not be timed says why.
        let note = match timing {
            Some(Err(why)) => why.clone(),
            _ => words(&row.note, entry, filled),
        };
        Row { entry, name: words(&row.name, entry, filled), note, cells, known }
    });
    Table {
        title: table.title.clone(),
        about: table.about.clone(),
        of: table.of.clone(),
        columns: columns.collect(),
        rows: rows.collect(),
    }
}

/// For so many digits there is room in a column before any number is known, commas and points among them.
fn room(column: Column) -> usize {
    match column {
        Column::Bytes => "9,999,999".len(),
        Column::Nodes => "999,999".len(),
        _ if column.is_measured() => "99,999".len(),
        _ => 0,
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
        Drawn { entry, name, note, moves, curve, known: known(filled, entry) }
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
        let (size, counts) = counted.map_or((FRAME, Vec::new()), |counted| (counted.size, counted.counts.clone()));
        Map { entry, name: words(&map.name, entry, filled), size, counts, known: known(filled, entry) }
    };
    let (title, about) = (maps.title.clone(), maps.about.clone());
    Maps::new(title, about, counted(maps.of).to_owned(), maps.maps.iter().enumerate().map(map).collect()).framed(FRAME)
}

/// The shape of a map's frame: so many across for so many down.
const FRAME: [u32; 2] = [4, 3];

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
        let known = match known(filled, entry) {
            // What a volume encloses is known without a ray.
            Known::Roughly if picture.volume.is_some() => Known::Fully,
            known => known,
        };
        let (image, over) = rendered.map_or((None, None), |rendered| {
            let over = rendered.outline.as_ref().map(|outline| {
                let View { eye, target, up, fov_degrees } = rendered.view;
                (forms_of(outline), Camera::Solid { eye, target, up, fov_degrees })
            });
            let [width, height] = rendered.size;
            (Some(Image { width, height, rgba: rendered.rgba.clone() }), over)
        });
        let (name, size) = (picture.name.clone(), picture.size);
        let says = rendered.map_or_else(String::new, |rendered| {
            let timing = filled.timed.get(entry).and_then(Option::as_ref);
            picture_says(rendered, known == Known::Roughly, timing, pictures.times, filled.is_clocked)
        });
        let room = match picture.volume {
            Some(_) => "room inside 00.00 · surface 00.00".to_owned(),
            None if pictures.times => format!("{ROOM} · its time: {ELSEWHERE}"),
            None => ROOM.to_owned(),
        };
        Picture { entry, name, says, room, size, image, over, known }
    };
    let (title, about) = (pictures.title.clone(), pictures.about.clone());
    Pictures { title, about, pictures: pictures.pictures.iter().enumerate().map(picture).collect() }
}

/// Words as wide as those that stand below a picture.
const ROOM: &str = "000,000,000 triangles · ≈00.0 tests per ray";

/// A picture in numbers.
fn picture_says(rendered: &Rendered, rough: bool, timing: Option<&Timing>, times: bool, clocked: bool) -> String {
    if let Some(outline) = &rendered.outline {
        let area = f64::from(outline.measure(Measure::Area));
        return format!("room inside {} · surface {}", digits(outline.content()), digits(area));
    }
    let sign = if rough { ROUGH } else { "" };
    let counts = format!("{} triangles · {sign}{} tests per ray", whole(rendered.triangles), digits(rendered.tests));
    match timing {
        Some(Ok(timed)) if !timed.seconds.is_nan() => format!("{counts} · {} here", span(timed.seconds)),
        _ if !times => counts,
        _ if clocked => format!("{counts} · {WAITS}"),
        _ => format!("{counts} · its time: {ELSEWHERE}"),
    }
}
