//! Boards: tables, charts, heat maps and pictures beside each other, filled entry by entry, and a meter that comes to be
//! seen with what follows it.

mod chart;
mod heat_scale;
mod known;
mod map;
mod maps;
mod meter;
mod pictures;
mod probe;
mod table;

use glam::Vec2;
use raystep_accel::{CellId, Place};

pub use chart::{Chart, Curve, Dot, Drawn, Scale};
pub use known::Known;
pub use map::Map;
pub use maps::{Maps, Pixel};
pub use meter::{Given, Knob, KnobLine, Meter};
pub use pictures::{Picture, Pictures};
use table::Lines;
pub use table::{Column, ELSEWHERE, Row, Table};

use super::{Ask, Pane};
use crate::page::{Figure, Look};

/// A part of a board. Its entries (rows, points, lines) have numbers, in the order in which they come to be seen.
#[derive(Clone, Debug, PartialEq)]
pub enum Panel {
    /// A table.
    Table(Table),
    /// A chart.
    Chart(Chart),
    /// Numbers that are moved by hand.
    Meter(Meter),
    /// Heat maps.
    Maps(Maps),
    /// Pictures.
    Pictures(Pictures),
}

impl Panel {
    /// The pane that shows it and those of its kind alone.
    pub(crate) fn pane(&self) -> Pane {
        match self {
            Panel::Table(_) => Pane::Table,
            Panel::Chart(_) => Pane::Chart,
            Panel::Meter(_) => Pane::Meter,
            Panel::Maps(_) => Pane::Heat,
            Panel::Pictures(_) => Pane::Traced,
        }
    }

    /// The entries that come to be seen in it; a meter has none, it comes with another's.
    fn entries(&self) -> Vec<usize> {
        match self {
            Panel::Table(table) => table.rows.iter().map(|row| row.entry).collect(),
            Panel::Chart(chart) => chart.entries(),
            Panel::Meter(_) => Vec::new(),
            Panel::Maps(maps) => maps.maps.iter().map(|map| map.entry).collect(),
            Panel::Pictures(pictures) => pictures.pictures.iter().map(|picture| picture.entry).collect(),
        }
    }
}

/// How far a board is filled.
#[derive(Clone, Copy, Debug)]
struct Filled {
    /// How many entries are to be seen.
    step: usize,
    /// Whether a question about the next one is open.
    asks: bool,
}

impl Filled {
    fn shows(self, entry: usize) -> bool {
        entry < self.step
    }

    fn is_new(self, entry: usize) -> bool {
        entry + 1 == self.step && !self.asks
    }

    fn is_asked(self, entry: usize) -> bool {
        entry == self.step && self.asks
    }
}

/// The place of an entry.
fn place(entry: usize) -> Option<Place> {
    Some(Place::Cell(CellId(entry as u32)))
}

/// A chart's usual part of the width, where something stands beside it.
const CHART: f32 = 0.58;

/// The part of the height that a picture has where there is another one.
const PICTURE: f32 = 0.55;

/// The part of the usual height of heat maps that they leave to no table.
const MAPS: f32 = 0.87;

/// Most room between a table or a meter and what stands below it, in letters.
const APART: f32 = 2.2;

/// How wide and how high a panel is at least, in letters.
fn letters(panel: &Panel) -> [f32; 2] {
    match panel {
        Panel::Table(table) => table.letters(),
        Panel::Chart(_) => [34.0, 18.0],
        Panel::Meter(meter) => meter.letters(),
        Panel::Maps(maps) => [26.0 * maps.maps.len() as f32, 22.0],
        Panel::Pictures(pictures) => [20.0 * pictures.pictures.len() as f32, 18.0],
    }
}

/// How some panels are set: letters that are small enough for all of them, and a chart's part of the width where the
/// others stand beside it. What stands in the presenter's hall is large, but a table may not be cut.
fn fitted(panels: &[&Panel], ask: &Ask<'_>, wide: bool) -> (Look, f32) {
    // What follows a chart stands beside it; a chart that follows stands below.
    let beside = wide && panels.len() > 1 && matches!(panels.first(), Some(Panel::Chart(_)));
    let set = |chart: f32| {
        let (mut across, mut up) = (0.0_f32, [0.0_f32; 2]);
        for panel in panels {
            let [width, height] = letters(panel);
            let is_chart = matches!(panel, Panel::Chart(_));
            let share = if beside { if is_chart { chart } else { 1.0 - chart } } else { 1.0 };
            // A narrow chart is still one.
            let width = if is_chart && chart < CHART { width * 0.7 } else { width };
            across = across.max(width / share);
            up[usize::from(beside && is_chart)] += height;
        }
        let up = up[0].max(up[1]);
        let most = (ask.size.x / across.max(1.0)).min(ask.size.y / up.max(1.0));
        ask.look.text.min(most)
    };
    let usual = set(CHART);
    // Letters that would be small beside the usual chart take of its width.
    let narrow = [0.5, 0.45, 0.4].into_iter().map(|chart| (set(chart), chart));
    let best = narrow.filter(|_| beside && usual < ask.look.text && ask.look.least > 0.0);
    let (text, chart) = best.fold((usual, CHART), |best, next| if next.0 > best.0 { next } else { best });
    (Look { text, ..ask.look }, chart)
}

/// Which panels stand there: all of them, where their letters can be read; else the one that is spoken of, with those
/// beside it that have room.
fn shown(panels: &[Panel], filled: Filled, ask: &Ask<'_>) -> Vec<bool> {
    let reads = |chosen: &[bool]| placed(panels, chosen, ask).reads(ask);
    let mut chosen = vec![true; panels.len()];
    if reads(&chosen) {
        return chosen;
    }
    let now = if filled.asks { filled.step } else { filled.step.saturating_sub(1) };
    let spoken_of = panels.iter().position(|panel| panel.entries().contains(&now)).unwrap_or(0);
    chosen = (0..panels.len()).map(|index| index == spoken_of).collect();
    // What is moved by hand stands beside what follows it; what is not seen yet takes no room.
    let meters = |seen: bool| {
        let is = move |panel: &Panel| matches!(panel, Panel::Meter(meter) if filled.shows(meter.entry) == seen);
        (0..panels.len()).filter(move |index| is(&panels[*index]))
    };
    for next in meters(true).chain(spoken_of + 1..panels.len()).chain((0..spoken_of).rev()) {
        if !chosen[next] && !meters(false).any(|hidden| hidden == next) {
            chosen[next] = true;
            chosen[next] = reads(&chosen);
        }
    }
    chosen
}

/// How a board is set.
struct Layout<'a> {
    look: Look,
    /// How its tables are set: all of them alike.
    tables: Lines,
    /// The corner and the room of each panel that stands there.
    rooms: Vec<(&'a Panel, [Vec2; 2])>,
}

impl Layout<'_> {
    /// Whether all letters are as large as they are to be at least.
    fn reads(&self, ask: &Ask<'_>) -> bool {
        let least = ask.look.least.min(ask.look.text);
        let has_table = self.rooms.iter().any(|(panel, _)| matches!(panel, Panel::Table(_)));
        self.look.text >= least && (!has_table || self.tables.text >= least)
    }

    /// How large what stands there is seen, in sizes that are good to read: as large as the smallest of it.
    fn worth(&self, ask: &Ask<'_>) -> f32 {
        let u = ask.look.text.max(1.0);
        let seen = |(panel, [_, room]): &(&Panel, [Vec2; 2])| match panel {
            Panel::Table(_) => (self.tables.text / u).min(GOOD_TABLE),
            Panel::Meter(_) => self.look.text / u,
            Panel::Chart(_) => (room.x / 34.0).min(room.y / 18.0).min(self.look.text * GOOD_CHART) / u,
            Panel::Maps(maps) => maps.high(*room, &self.look) / (u * GOOD_PICTURE),
            Panel::Pictures(pictures) => pictures.high(*room, &self.look) / (u * GOOD_PICTURE),
        };
        self.rooms.iter().map(seen).fold(f32::INFINITY, f32::min)
    }
}

/// A table's letters in those wished for, a chart's room in those that it needs, a picture's height in letters: above
/// these nothing is won, or everything is well.
const GOOD_TABLE: f32 = 1.15;
const GOOD_CHART: f32 = 1.3;
const GOOD_PICTURE: f32 = 13.0;

/// How well a board is seen in so much room, whichever of its panels is spoken of: 1 is well, twice that twice as large.
/// It is better seen as a whole than in parts.
pub(crate) fn worth(panels: &[Panel], ask: &Ask<'_>) -> f32 {
    let of = |panel: &Panel| {
        let step = panel.entries().into_iter().min()? + 1;
        let layout = layout(panels, Filled { step, asks: false }, ask);
        Some(layout.worth(ask) * (0.85 + 0.15 * layout.rooms.len() as f32 / panels.len() as f32))
    };
    let worth = panels.iter().filter_map(of).fold(f32::INFINITY, f32::min);
    if worth.is_finite() { worth } else { 1.0 }
}

fn layout<'a>(panels: &'a [Panel], filled: Filled, ask: &Ask<'_>) -> Layout<'a> {
    placed(panels, &shown(panels, filled, ask), ask)
}

/// The panels that are chosen, each in its room.
fn placed<'a>(panels: &'a [Panel], chosen: &[bool], ask: &Ask<'_>) -> Layout<'a> {
    let wide = ask.size.x > ask.size.y * 1.15;
    let panels: Vec<&Panel> =
        panels.iter().zip(chosen).filter(|(_, chosen)| **chosen).map(|(panel, _)| panel).collect();
    let (look, chart) = fitted(&panels, ask, wide);
    let (mut corner, mut rooms) = (Vec2::ZERO, Vec::new());
    let mut column = &panels[..];
    while let [Panel::Chart(_), below @ ..] = column
        && wide
        && !below.is_empty()
    {
        let room = Vec2::new((ask.size.x - corner.x) * chart, ask.size.y);
        rooms.push((column[0], [corner, room]));
        corner.x += room.x;
        column = below;
    }
    let room = ask.size - corner;
    let tables = lines_of_tables(column, room, &look);
    for (panel, height) in column.iter().zip(heights(column, tables, room.y, &look)) {
        rooms.push((*panel, [corner, Vec2::new(room.x, height)]));
        corner.y += height;
    }
    Layout { look, tables, rooms }
}

/// How high a table or a meter stands; a picture is as high as there is room.
fn own_height(panel: &Panel, tables: Lines, look: &Look) -> Option<f32> {
    match panel {
        Panel::Table(table) => Some(table.height(tables, look)),
        Panel::Meter(meter) => Some(meter.height(look)),
        Panel::Chart(_) | Panel::Maps(_) | Panel::Pictures(_) => None,
    }
}

/// How all tables of a column are set: in letters as large as the room for all that stands there allows, within reason.
fn lines_of_tables(column: &[&Panel], room: Vec2, look: &Look) -> Lines {
    let tables = || column.iter().filter_map(|panel| if let Panel::Table(table) = panel { Some(table) } else { None });
    let least = |panel: &Panel| match panel {
        Panel::Table(_) => 0.0,
        Panel::Maps(_) => letters(panel)[1] * MAPS,
        Panel::Meter(_) | Panel::Chart(_) | Panel::Pictures(_) => letters(panel)[1],
    };
    let others = look.text * column.iter().map(|panel| least(panel)).sum::<f32>();
    // A table alone that is wider than its letters allow has more lines instead.
    let narrow = column.len() == 1 && tables().any(|table| table.across(room.x, false, look) < look.text);
    let [close, open] = match column.iter().any(|panel| matches!(panel, Panel::Maps(_))) {
        _ if narrow => [table::TWO_CLOSE, table::TWO],
        true => [table::CLOSE, table::CLOSE],
        false => [table::CLOSE, table::ROW],
    };
    let high = |text: f32| tables().map(|table| table.height(Lines { text, row: close, narrow }, look)).sum::<f32>();
    let (heads, lines) = (high(0.0), high(1.0) - high(0.0));
    // Beside pictures it is they that grow.
    let pictures = column.iter().any(|panel| matches!(panel, Panel::Chart(_) | Panel::Maps(_) | Panel::Pictures(_)));
    let largest = match column {
        [_] => table::ALONE,
        _ if pictures => table::BESIDE,
        _ => table::LARGEST,
    };
    let largest = look.text * largest;
    let across = tables().map(|table| table.across(room.x, narrow, look)).fold(largest, f32::min);
    let text = across.min((room.y - others - heads) / lines.max(1.0)).max(look.text * table::SMALLEST);
    // Letters first: only then are the rows further apart.
    let rows = tables().map(|table| table.rows.len()).sum::<usize>().max(1) as f32;
    let spare = (room.y - others - high(text)) / (text * rows);
    Lines { text, row: close + spare.clamp(0.0, open - close), narrow }
}

/// The heights of what stands one over the other in so much room.
fn heights(column: &[&Panel], tables: Lines, room: f32, look: &Look) -> Vec<f32> {
    let own: Vec<Option<f32>> = column.iter().map(|panel| own_height(panel, tables, look)).collect();
    let pictures = own.iter().filter(|height| height.is_none()).count();
    let left = room - own.iter().flatten().sum::<f32>();
    let apart = (left / column.len().max(1) as f32).clamp(0.0, look.text * if pictures > 0 { 1.0 } else { APART });
    let gaps = apart * (own.len() - pictures) as f32;
    let mut left = (left - gaps).max(0.0);
    let mut still = pictures;
    let each = |own: Option<f32>| match own {
        Some(height) => height + apart,
        None => {
            let height = if still > 1 { left * PICTURE } else { left };
            (still, left) = (still - 1, left - height);
            height
        }
    };
    own.into_iter().map(each).collect()
}

/// Whether a meter is there: with what follows it, and where nothing else stands.
fn stands(meter: &Meter, filled: Filled, panels: &[Panel]) -> bool {
    filled.shows(meter.entry) || panels.len() == 1
}

/// The panels, filled up to a step.
pub(crate) fn board(panels: &[Panel], step: usize, ask: &Ask<'_>) -> Figure {
    let mut figure = Figure::new(ask.size);
    let filled = Filled { step, asks: ask.hide };
    let Layout { look, tables, rooms } = layout(panels, filled, ask);
    for (panel, [corner, room]) in rooms {
        let part = match panel {
            Panel::Table(table) => table::draw(table, filled, room, tables, &look),
            Panel::Chart(chart) => chart::draw(chart, filled, room, &look),
            Panel::Meter(meter) if stands(meter, filled, panels) => meter::draw(meter, filled, room, &look),
            // Its room waits.
            Panel::Meter(_) => continue,
            Panel::Maps(maps) => maps::draw(maps, filled, room, &look),
            Panel::Pictures(pictures) => pictures::draw(pictures, filled, room, &look),
        };
        figure.marks.extend(part.marks.into_iter().map(|mark| mark.moved(corner)));
    }
    figure
}

/// Where the numbers lie that can be moved by hand.
pub(crate) fn knobs(panels: &[Panel], step: usize, ask: &Ask<'_>) -> Vec<KnobLine> {
    let filled = Filled { step, asks: ask.hide };
    let Layout { look, rooms, .. } = layout(panels, filled, ask);
    let lines = rooms.into_iter().filter_map(|(panel, [corner, room])| match panel {
        Panel::Meter(meter) if stands(meter, filled, panels) => {
            Some(meter.lines_in(room, &look).into_iter().map(move |line| line.moved(corner)))
        }
        _ => None,
    });
    lines.flatten().collect()
}

/// The pixel of a heat map at a point of the board.
pub(crate) fn pixel_at(panels: &[Panel], step: usize, ask: &Ask<'_>, point: Vec2) -> Option<Pixel> {
    let filled = Filled { step, asks: ask.hide };
    let Layout { look, rooms, .. } = layout(panels, filled, ask);
    rooms.into_iter().find_map(|(panel, [corner, room])| match panel {
        Panel::Maps(maps) => maps.pixel_at(room, &look, point - corner, &|entry| filled.shows(entry)),
        _ => None,
    })
}

/// What lies over the board where a pixel of a heat map is pointed at.
pub(crate) fn probe(panels: &[Panel], step: usize, ask: &Ask<'_>, pixel: &Pixel) -> Figure {
    let mut figure = Figure::new(ask.size);
    let filled = Filled { step, asks: ask.hide };
    let Layout { look, rooms, .. } = layout(panels, filled, ask);
    for (panel, [corner, room]) in rooms {
        if let Panel::Maps(maps) = panel
            && maps.maps.iter().any(|map| map.entry == pixel.entry)
        {
            let part = probe::draw(maps, pixel, room, &look, &|entry| filled.shows(entry));
            figure.marks.extend(part.marks.into_iter().map(|mark| mark.moved(corner)));
        }
    }
    figure
}
