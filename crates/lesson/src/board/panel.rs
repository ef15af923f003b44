//! What stands on a board, and in which order it comes to be seen.

use raystep_scene::Scenes;

use crate::keys::Keys;
use crate::reading::Reading;
use crate::{Plan, Spot, limits};

use super::{
    Cell, Chart, Column, Drawn, Map, Maps, Meter, Number, Numbers, Picture, Pictures, Row, Stroke, Table, chart, maps,
    meter, picture, table,
};

/// Tables, charts, heat maps, pictures, and a meter.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Board {
    /// What it holds, the largest first.
    pub panels: Vec<Panel>,
    /// The scenes of somebody's own among which names are looked up first.
    pub scenes: Scenes,
}

/// A part of a board.
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

/// One thing on a board that comes to be seen.
#[derive(Clone, Copy, Debug)]
pub enum Entry<'a> {
    /// A row of a table.
    Row(&'a Row),
    /// A point or a line of a chart.
    Drawn(&'a Drawn),
    /// A heat map, and what it counts.
    Map(&'a Map, Column),
    /// A picture.
    Picture(&'a Picture),
}

impl Entry<'_> {
    /// Whether it follows numbers that are moved by hand.
    fn is_moved(self) -> bool {
        match self {
            Entry::Row(row) => {
                let value = |cell: &Cell| matches!(cell, Cell::Value(formula, _) if formula.is_moved());
                row.plan.as_ref().is_some_and(Plan::is_moved) || row.cells.iter().any(|(_, cell)| value(cell))
            }
            Entry::Drawn(drawn) => match &drawn.stroke {
                Stroke::Point(x, y) => x.is_moved() || y.is_moved(),
                Stroke::Law { law, .. } => law.is_moved(),
                Stroke::Growth { .. } => false,
            },
            Entry::Map(map, _) => map.plan.as_ref().is_some_and(Plan::is_moved),
            Entry::Picture(_) => false,
        }
    }
}

impl Board {
    /// Everything that comes to be seen: its panel and its place there, in the order in which it does.
    pub fn order(&self) -> Vec<(usize, usize)> {
        let mut order: Vec<(f32, usize, usize)> = Vec::new();
        for (index, panel) in self.panels.iter().enumerate() {
            // What names no step of its own comes after what stands before it.
            let mut step = 0.0;
            for (place, own) in panel.steps().into_iter().enumerate() {
                step = own.unwrap_or(step);
                order.push((step, index, place));
            }
        }
        order.sort_by(|a, b| a.0.total_cmp(&b.0));
        order.into_iter().map(|(_, panel, place)| (panel, place)).collect()
    }

    /// Its meter, if it has one.
    pub fn meter(&self) -> Option<&Meter> {
        self.panels.iter().find_map(|panel| match panel {
            Panel::Meter(meter) => Some(meter),
            _ => None,
        })
    }

    /// The place, among all that comes to be seen, of the first that follows the meter: the meter comes with it. It is
    /// there from the beginning where nothing does.
    pub fn first_moved(&self) -> usize {
        let follows = |at: &(usize, usize)| self.entry(*at).is_some_and(Entry::is_moved);
        self.order().iter().position(follows).unwrap_or(0)
    }

    /// The number of that name which is moved by hand.
    pub fn number(&self, name: &str) -> Option<&Number> {
        self.meter()?.numbers.iter().find(|number| number.name == name)
    }

    /// Its numbers where the settings put them, as keys and values; the others where the slide has them.
    pub fn moved(&self, settings: &[(String, String)]) -> Numbers {
        self.meter().map_or_else(Numbers::default, |meter| meter.moved(settings))
    }

    /// Everything that is built to be measured.
    pub(crate) fn plans(&self) -> Vec<&Plan> {
        let entries = self.order().into_iter().filter_map(|at| self.entry(at));
        let plans = entries.filter_map(|entry| match entry {
            Entry::Row(row) => row.plan.as_ref(),
            Entry::Map(map, _) => map.plan.as_ref(),
            Entry::Picture(picture) => Some(&picture.plan),
            Entry::Drawn(Drawn { stroke: Stroke::Growth { plan, .. }, .. }) => plan.as_ref(),
            Entry::Drawn(_) => None,
        });
        plans.collect()
    }

    /// The plans that are built to be measured, those that move with the meter at the ends of its numbers.
    pub(crate) fn plans_at_ends(&self) -> Vec<Plan> {
        let ends = self.meter().map_or_else(Vec::new, Meter::ends);
        let mut plans = Vec::new();
        for plan in self.plans() {
            match plan.is_moved() {
                true => plans.extend(ends.iter().map(|numbers| plan.at(numbers))),
                false => plans.push(plan.clone()),
            }
        }
        // What names no number of the meter was told already.
        for plan in &mut plans {
            plan.settings.retain(|setting| setting.value != "NaN");
        }
        plans
    }

    /// Whether something is counted at a place of a panel: a table that has only times counts nothing.
    pub(crate) fn measures(&self, at: (usize, usize)) -> bool {
        match self.entry(at) {
            Some(Entry::Row(row)) => {
                let counts = |(column, _): &(Column, String)| column.is_measured() && !column.is_timed();
                let told =
                    matches!(self.panels.get(at.0), Some(Panel::Table(table)) if table.columns.iter().any(counts));
                told && (row.plan.is_some() || row.fast.is_some() || row.volume.is_some())
            }
            Some(Entry::Drawn(drawn)) => {
                matches!(&drawn.stroke, Stroke::Growth { plan: Some(_), of, .. } if !of.is_timed())
            }
            Some(Entry::Map(..) | Entry::Picture(_)) => true,
            None => false,
        }
    }

    /// The scenes that are named on it beside its own, and where.
    pub(crate) fn scenes(&self) -> Vec<(Spot, &str)> {
        let mut scenes: Vec<(Spot, &str)> = Vec::new();
        for entry in self.order().into_iter().filter_map(|at| self.entry(at)) {
            match entry {
                Entry::Row(row) => scenes.extend(row.scene.as_deref().map(|scene| (row.spot, scene))),
                Entry::Picture(picture) => scenes.extend(picture.scene.as_deref().map(|scene| (picture.spot, scene))),
                Entry::Drawn(Drawn { stroke: Stroke::Growth { scenes: named, .. }, spot, .. }) => {
                    scenes.extend(named.iter().map(|scene| (*spot, scene.as_str())));
                }
                Entry::Drawn(_) | Entry::Map(..) => {}
            }
        }
        scenes
    }

    /// What stands at a place of a panel.
    pub fn entry(&self, (panel, place): (usize, usize)) -> Option<Entry<'_>> {
        match self.panels.get(panel)? {
            Panel::Table(table) => table.rows.get(place).map(Entry::Row),
            Panel::Chart(chart) => chart.drawn.get(place).map(Entry::Drawn),
            Panel::Meter(_) => None,
            Panel::Pictures(pictures) => pictures.pictures.get(place).map(Entry::Picture),
            Panel::Maps(maps) => maps.maps.get(place).map(|map| Entry::Map(map, maps.of)),
        }
    }
}

impl Panel {
    fn steps(&self) -> Vec<Option<f32>> {
        match self {
            Panel::Table(table) => table.rows.iter().map(|row| row.step).collect(),
            Panel::Chart(chart) => chart.drawn.iter().map(|drawn| drawn.step).collect(),
            // It comes with what follows it.
            Panel::Meter(_) => Vec::new(),
            Panel::Pictures(pictures) => pictures.pictures.iter().map(|picture| picture.step).collect(),
            Panel::Maps(maps) => maps.maps.iter().map(|map| map.step).collect(),
        }
    }
}

/// Reads the tables, charts, heat maps and pictures of a head.
pub(crate) fn read(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Board {
    let mut board = Board::default();
    // What follows may name its numbers.
    reading.numbers.clear();
    let mut meter = None;
    if let Some(mut keys) = keys.table("meter", reading) {
        meter = meter::read(&mut keys, reading).map(Panel::Meter);
        keys.finish(reading);
    }
    for mut keys in keys.tables("chart", reading) {
        board.panels.extend(chart::read(&mut keys, reading).map(Panel::Chart));
        keys.finish(reading);
    }
    for mut keys in keys.tables("table", reading) {
        board.panels.extend(table::read(&mut keys, reading).map(Panel::Table));
        keys.finish(reading);
    }
    for mut keys in keys.tables("heat", reading) {
        board.panels.extend(maps::read(&mut keys, reading).map(Panel::Maps));
        keys.finish(reading);
    }
    for mut keys in keys.tables("picture", reading) {
        board.panels.extend(picture::read(&mut keys, reading).map(Panel::Pictures));
        keys.finish(reading);
    }
    // Below everything else its room is missed least, as long as it waits.
    board.panels.extend(meter);
    if !["chart", "table", "heat", "picture"].into_iter().any(|key| keys.has(key)) {
        reading.problem(0, "a board has tables, charts, heat maps or pictures: write `[[table]]`, `[[chart]]`, `[[heat]]` or `[[picture]]`");
    }
    let entries = board.order().len();
    if entries > limits::BOARD {
        reading.problem(0, format!("the board shows {entries} things: at most {} are allowed", limits::BOARD));
        return Board::default();
    }
    board
}
