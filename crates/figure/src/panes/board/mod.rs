//! Boards: tables, charts, heat maps and pictures beside each other, filled entry by entry, and a meter that is there
//! from the beginning.

mod chart;
mod heat_scale;
mod maps;
mod meter;
mod pictures;
mod probe;
mod table;

use glam::Vec2;
use raystep_accel::{CellId, Place};

pub use chart::{Chart, Curve, Dot, Drawn, Scale};
pub use maps::{Map, Maps, Pixel};
pub use meter::{Given, Knob, KnobLine, Meter};
pub use pictures::{Picture, Pictures};
pub use table::{Column, Row, Table};

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

/// Letters that are small enough for all panels: what stands in the presenter's hall is large, but a table may not be cut.
fn fitted(panels: &[&Panel], ask: &Ask<'_>, wide: bool) -> Look {
    // What follows a chart stands beside it; a chart that follows stands below.
    let beside = wide && panels.len() > 1 && matches!(panels, [Panel::Chart(_), ..]);
    let (mut across, mut up) = (0.0_f32, 0.0_f32);
    for panel in panels {
        let [width, height] = match panel {
            Panel::Table(table) => table.letters(),
            Panel::Chart(_) => [34.0, 18.0],
            Panel::Meter(meter) => meter.letters(),
            Panel::Maps(maps) => [26.0 * maps.maps.len() as f32, 22.0],
            Panel::Pictures(pictures) => [20.0 * pictures.pictures.len() as f32, 18.0],
        };
        let share = if beside { if matches!(panel, Panel::Chart(_)) { 0.58 } else { 0.42 } } else { 1.0 };
        across = across.max(width / share);
        up = if beside { up.max(height) } else { up + height };
    }
    let most = (ask.size.x / across.max(1.0)).min(ask.size.y / up.max(1.0));
    Look { text: ask.look.text.min(most), ..ask.look }
}

/// How large everything is set, and the corner and the room of each panel.
fn layout(panels: &[&Panel], ask: &Ask<'_>) -> (Look, Vec<[Vec2; 2]>) {
    let wide = ask.size.x > ask.size.y * 1.15;
    let look = fitted(panels, ask, wide);
    let mut corner = Vec2::ZERO;
    let mut rooms = Vec::new();
    for (index, panel) in panels.iter().enumerate() {
        let left = panels.len() - index;
        let mut room = ask.size - corner;
        if left > 1 {
            // The first of two has the larger part: a chart's, or what the rows of a table need.
            match panel {
                Panel::Chart(_) if wide => room.x *= 0.58,
                Panel::Chart(_) | Panel::Maps(_) | Panel::Pictures(_) => room.y *= 0.55,
                Panel::Table(table) => room.y = table.height(&look).min(room.y * 0.7),
                Panel::Meter(meter) => room.y = meter.height(&look).min(room.y * 0.7),
            }
        }
        rooms.push([corner, room]);
        match panel {
            Panel::Chart(_) if wide => corner.x += room.x,
            _ => corner.y += room.y,
        }
    }
    (look, rooms)
}

/// The panels, filled up to a step.
pub(crate) fn board(panels: &[&Panel], step: usize, ask: &Ask<'_>) -> Figure {
    let mut figure = Figure::new(ask.size);
    let filled = Filled { step, asks: ask.hide };
    let (look, rooms) = layout(panels, ask);
    for (panel, [corner, room]) in panels.iter().zip(rooms) {
        let part = match panel {
            Panel::Table(table) => table::draw(table, filled, room, &look),
            Panel::Chart(chart) => chart::draw(chart, filled, room, &look),
            Panel::Meter(meter) => meter::draw(meter, filled, room, &look),
            Panel::Maps(maps) => maps::draw(maps, filled, room, &look),
            Panel::Pictures(pictures) => pictures::draw(pictures, filled, room, &look),
        };
        figure.marks.extend(part.marks.into_iter().map(|mark| mark.moved(corner)));
    }
    figure
}

/// Where the numbers lie that can be moved by hand.
pub(crate) fn knobs(panels: &[&Panel], ask: &Ask<'_>) -> Vec<KnobLine> {
    let (look, rooms) = layout(panels, ask);
    let lines = panels.iter().zip(rooms).filter_map(|(panel, [corner, room])| match panel {
        Panel::Meter(meter) => Some(meter.lines_in(room, &look).into_iter().map(move |line| line.moved(corner))),
        _ => None,
    });
    lines.flatten().collect()
}

/// The pixel of a heat map at a point of the board.
pub(crate) fn pixel_at(panels: &[&Panel], step: usize, ask: &Ask<'_>, point: Vec2) -> Option<Pixel> {
    let filled = Filled { step, asks: ask.hide };
    let (look, rooms) = layout(panels, ask);
    panels.iter().zip(rooms).find_map(|(panel, [corner, room])| match panel {
        Panel::Maps(maps) => maps.pixel_at(room, &look, point - corner, &|entry| filled.shows(entry)),
        _ => None,
    })
}

/// What lies over the board where a pixel of a heat map is pointed at.
pub(crate) fn probe(panels: &[&Panel], step: usize, ask: &Ask<'_>, pixel: &Pixel) -> Figure {
    let mut figure = Figure::new(ask.size);
    let filled = Filled { step, asks: ask.hide };
    let (look, rooms) = layout(panels, ask);
    for (panel, [corner, room]) in panels.iter().zip(rooms) {
        if let Panel::Maps(maps) = panel
            && maps.maps.iter().any(|map| map.entry == pixel.entry)
        {
            let part = probe::draw(maps, pixel, room, &look, &|entry| filled.shows(entry));
            figure.marks.extend(part.marks.into_iter().map(|mark| mark.moved(corner)));
        }
    }
    figure
}
