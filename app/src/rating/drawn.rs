//! The table and the chart of all structures.

use raystep_accel::{Primitives, Reveal};
use raystep_figure::{Board, Chart, Column, Curve, Drawn, Known, Panel, Reel, Role, Row, Scale, Table, counted, whole};
use raystep_scene::Scene;

use super::Rated;
use crate::shown::board::digits;

/// All structures that were measured so far, ready to be drawn.
#[derive(Clone, Debug)]
pub(crate) struct Rating {
    panels: Vec<Panel>,
    events: Vec<Reveal>,
    names: Vec<String>,
}

impl Rating {
    /// What was measured over a scene; times are left out unless they are asked for.
    pub(crate) fn of(scene: &Scene, rated: &[Rated], times: bool) -> Rating {
        let rays = rated.iter().map(|rated| rated.rays).max().unwrap_or(0);
        // Before the first is measured nobody knows how many rays there will be.
        let rays = if rated.is_empty() { "the rays".to_owned() } else { counted(rays, "ray", "rays") };
        let prims = counted(scene.prims.len() as u64, "primitive", "primitives");
        let about = format!("{}, {prims}; {rays}, the same for all, a ray for each pixel of a picture", scene.title);
        let mut panels = vec![Panel::Table(table(rated, about, times))];
        panels.extend(chart(rated).map(Panel::Chart));
        let event = |(entry, rated): (usize, &Rated)| Reveal::Row {
            entry: entry as u32,
            printed: f32::NAN,
            total: f32::NAN,
            computed: f32::NAN,
            tests: rated.tests as f32,
            visits: rated.visits as f32,
            boxes: rated.boxes as f32,
            nodes: rated.nodes.map_or(f32::NAN, |nodes| nodes as f32),
            bytes: rated.bytes as f32,
            content: f32::NAN,
            area: f32::NAN,
            cuts: f32::NAN,
            planes: f32::NAN,
            vain: f32::NAN,
            alive: f32::NAN,
            speed: (1.0 / rated.ray_us) as f32,
            time: rated.ray_us as f32,
            build: rated.build_ms as f32,
            share: f32::NAN,
            seconds: f32::NAN,
            timed: true,
        };
        let events = rated.iter().enumerate().map(event).collect();
        Rating { panels, events, names: rated.iter().map(|rated| rated.what.name().to_owned()).collect() }
    }

    /// A board with a row and a point for each.
    pub(crate) fn reel(&self) -> Reel<'_> {
        Reel::new(Board { panels: &self.panels, events: &self.events, names: &self.names })
    }
}

/// A row for each.
fn table(rated: &[Rated], about: String, times: bool) -> Table {
    let column = |head: &str, role: Role| Column {
        head: head.to_owned(),
        role,
        given: false,
        words: false,
        rays: false,
        digits: 0,
    };
    let mut columns = vec![
        column("Measured here|tests per ray", Role::Missed),
        column("|nodes or cells per ray", Role::Value),
        column("|boxes per ray", Role::Value),
        column("|nodes or cells stored", Role::Text),
        column("|bytes", Role::Text),
    ];
    if times {
        columns.push(column("This machine, now|build, ms", Role::Quiet));
        columns.push(column("|one ray, µs", Role::Quiet));
    }
    let none = || "\u{2013}".to_owned();
    let row = |(entry, rated): (usize, &Rated)| {
        let list = rated.is_list();
        let unless = |cell: String| if list { none() } else { cell };
        let mut cells = vec![
            digits(rated.tests),
            unless(digits(rated.visits)),
            if rated.boxes > 0.0 { digits(rated.boxes) } else { none() },
            unless(rated.nodes.map_or_else(none, whole)),
            unless(whole(rated.bytes)),
        ];
        if times {
            cells.push(unless(digits(rated.build_ms)));
            cells.push(digits(rated.ray_us));
        }
        Row { entry, name: rated.what.name().to_owned(), note: String::new(), cells, known: Known::Fully }
    };
    let (title, of) = ("Which is best?".to_owned(), "structure".to_owned());
    Table { title, about, of, columns, rows: rated.iter().enumerate().map(row).collect() }
}

/// A point for each structure; brute force lies far above the page.
fn chart(rated: &[Rated]) -> Option<Chart> {
    let dots = || rated.iter().enumerate().filter(|(_, rated)| !rated.is_list());
    let scale = |name: &str, of: &dyn Fn(&Rated) -> f64| {
        let all = || dots().map(|(_, rated)| of(rated)).filter(|value| *value > 0.0 && value.is_finite());
        let (low, high) = all().fold((f64::INFINITY, 0.0_f64), |(low, high), value| (low.min(value), high.max(value)));
        let round = |value: f64, up: bool| {
            let steps = [1.0, 2.0, 5.0, 10.0];
            let power = libm::pow(10.0, libm::floor(libm::log10(value)));
            let of = steps.into_iter().map(|step| step * power);
            let found =
                if up { of.clone().find(|step| *step >= value) } else { of.clone().rfind(|step| *step <= value) };
            found.unwrap_or(value)
        };
        (high > 0.0).then(|| {
            let (from, to) = (round(low * 0.8, false), round(high * 1.25, true));
            let powers =
                (-3..9).flat_map(|power| [1.0, 2.0, 5.0].map(|digit| digit * libm::pow(10.0, f64::from(power))));
            let inside = powers.filter(|tick| *tick >= from * 0.999 && *tick <= to * 1.001);
            let ticks = inside.map(|tick| (tick, raystep_figure::number(tick as f32))).collect();
            Scale { name: name.to_owned(), log: true, from, to, ticks }
        })
    };
    let (x, y) =
        (scale("steps per ray: nodes, cells and boxes", &Rated::steps)?, scale("tests per ray", &|r| r.tests)?);
    let point = |(entry, rated): (usize, &Rated)| Drawn {
        entry,
        name: rated.what.name().to_owned(),
        note: String::new(),
        curve: Curve::Point([rated.steps(), rated.tests]),
        moves: false,
        known: Known::Fully,
    };
    let title = "Steps against tests".to_owned();
    let about = "down and to the left is better; brute force takes no step and lies far above".to_owned();
    Some(Chart { title, about, x, y, drawn: dots().map(point).collect() })
}
