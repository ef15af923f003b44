//! A chart: points and laws over two axes.

use glam::Vec3;

use crate::keys::Keys;
use crate::problem::misspelt;
use crate::reading::Reading;

use raystep_fast::FastKind;

use crate::{Plan, Spot, limits, template};

use super::{Column, Formula, table};

/// A chart of a board.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// What it is about, in a few words.
    pub title: String,
    /// What stands behind the title.
    pub about: String,
    /// Across.
    pub x: Scale,
    /// Up.
    pub y: Scale,
    /// What is drawn in it.
    pub drawn: Vec<Drawn>,
}

/// An axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Scale {
    /// What it counts.
    pub name: String,
    /// Whether equal steps on it are equal factors.
    pub log: bool,
    /// Its lower end.
    pub from: f64,
    /// Its upper end.
    pub to: f64,
    /// Numbers that stand on it with words of their own; round numbers where there are none.
    pub ticks: Vec<(f64, String)>,
}

/// Something drawn in a chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawn {
    /// What it is called; it may name its own numbers and those of the meter, as in `{{y}} s`.
    pub name: String,
    /// A few words below its name; it may name them, too.
    pub note: String,
    /// Its line or point.
    pub stroke: Stroke,
    /// When it comes to be seen, among everything on the board.
    pub(crate) step: Option<f32>,
    /// Where it stands.
    pub(crate) spot: Spot,
}

/// A line or a point.
#[derive(Clone, Debug, PartialEq)]
pub enum Stroke {
    /// A point, at these two numbers.
    Point(Formula, Formula),
    /// What is measured over scenes of more and more primitives: their number, and what a ray costs there.
    Growth {
        /// What is built.
        plan: Option<Plan>,
        /// Whether a fast hierarchy is built instead.
        fast: bool,
        /// What is counted, tests, visits, boxes; or the seconds of a picture.
        of: Column,
        /// The names of the scenes.
        scenes: Vec<String>,
        /// The point that all rays go through, from all around; nothing where they are those of a picture.
        through: Option<Vec3>,
    },
    /// A law in `x`, from here to there; a guess is dashed.
    Law {
        /// The law.
        law: Formula,
        /// Where it begins.
        from: f64,
        /// Where it ends.
        to: f64,
        /// Whether it is but a guess.
        guess: bool,
    },
}

/// Reads `[[chart]]`.
pub(super) fn read(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Option<Chart> {
    let (title, about) = (keys.need::<String>("title", reading), keys.get::<String>("about", reading));
    let x = axis("x", keys, reading);
    let y = axis("y", keys, reading);
    let drawn: Vec<Drawn> = keys.tables("drawn", reading).into_iter().filter_map(|keys| draw(keys, reading)).collect();
    if drawn.is_empty() {
        reading.problem(
            keys.at(),
            "nothing is drawn in the chart: write `drawn = [{ name = \"...\", point = [\"8\", \"3\"] }]`",
        );
    }
    Some(Chart { title: title?.1, about: about.unwrap_or_default().1, x: x?, y: y?, drawn })
}

/// `x = { name = "polygons", scale = "log", from = 1, to = 1e11, ticks = [[1, "1"], [1e6, "1 million"]] }`
fn axis(key: &'static str, keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Option<Scale> {
    const SCALES: [&str; 2] = ["linear", "log"];
    let Some(mut keys) = keys.table(key, reading) else {
        reading
            .problem(keys.at(), format!("`{key}` is missing: write `{key} = {{ name = \"...\", from = 0, to = 10 }}`"));
        return None;
    };
    let name = keys.need::<String>("name", reading);
    let scale = keys.get::<String>("scale", reading);
    let (from, to) = (keys.need::<f64>("from", reading), keys.need::<f64>("to", reading));
    let ticks = keys.get::<Vec<(f64, String)>>("ticks", reading);
    let at = keys.at();
    keys.finish(reading);
    if let Some((at, scale)) = scale.as_ref().filter(|(_, scale)| !SCALES.contains(&scale.as_str())) {
        reading.problem(*at, misspelt("scale", scale, &SCALES));
    }
    let log = scale.is_some_and(|(_, scale)| scale == "log");
    let ((_, from), (_, to)) = (from?, to?);
    if !(from < to && (to - from).is_finite() && (!log || from > 0.0)) {
        let zero = if log { ", both above 0 on a scale of factors" } else { "" };
        reading.problem(at, format!("the axis runs from {from} to {to}: `from` lies below `to`{zero}"));
        return None;
    }
    Some(Scale { name: name?.1, log, from, to, ticks: ticks.unwrap_or_default().1 })
}

/// `{ name = "8 primitives", point = ["8", "3"] }`, `{ name = "linear", law = "3 / 8 * x", from = 8, to = 5e10 }`
fn draw(mut keys: Keys<'_>, reading: &mut Reading<'_>) -> Option<Drawn> {
    let (name, note) = (keys.need::<String>("name", reading), keys.get::<String>("note", reading));
    let step = keys.get::<f32>("step", reading).map(|(_, step)| step);
    let point = keys.get::<Vec<String>>("point", reading);
    let law = keys.get::<String>("law", reading);
    let (from, to) = (keys.get::<f64>("from", reading), keys.get::<f64>("to", reading));
    let guess = keys.get::<bool>("guess", reading).unwrap_or_default().1;
    let scenes = keys.get::<Vec<String>>("scenes", reading);
    let plan = keys.table("structure", reading).and_then(|mut table| Plan::read(&mut table, reading));
    let at = keys.at();
    table::moves(plan.as_ref(), false, at, reading);
    let fast = table::fast(&mut keys, plan.as_ref(), reading);
    let of = keys.get::<String>("of", reading);
    let through = keys.get::<Vec3>("through", reading);
    let at = keys.at();
    let spot = reading.spot(at);
    keys.finish(reading);
    if let Some((through_at, _)) = through.as_ref().filter(|_| scenes.is_none()) {
        reading
            .problem(*through_at, "`through` belongs to what is measured over `scenes`: there the rays go through it");
    }
    let stroke = match (point, law, scenes) {
        (None, None, Some((_, scenes))) => {
            let (of_at, of) = of.unwrap_or((at, Column::Tests.name().to_owned()));
            let counts = [Column::Tests, Column::Visits, Column::Boxes, Column::Picture];
            let known = counts.into_iter().find(|column| column.name() == of);
            if known.is_none() {
                reading.problem(of_at, misspelt("count", &of, &counts.map(Column::name)));
            }
            match fast {
                Some(FastKind::Bvh8) if known == Some(Column::Picture) => {}
                Some(_) => reading.problem(
                    at,
                    "of fast structures only `fast = \"fast-bvh8\"` makes a line, and that of `of = \"seconds\"`",
                ),
                None if plan.is_none() => {
                    reading.problem(at, "nothing is built: write `structure = { kind = \"kd\" }`");
                }
                None => {}
            }
            if !(2..=limits::ENTRIES).contains(&scenes.len()) {
                reading.problem(at, "two scenes or more, one larger than the other, make a line");
            }
            if plan.is_none() && fast.is_none() {
                return None;
            }
            Stroke::Growth { plan, fast: fast.is_some(), of: known?, scenes, through: through.map(|(_, point)| point) }
        }
        (Some((at, point)), None, None) => {
            let [x, y] = point.as_slice() else {
                reading.problem(at, "a point has two numbers: point = [\"8\", \"3\"]");
                return None;
            };
            let (x, y) = (Formula::read(x, at, &[], reading), Formula::read(y, at, &[], reading));
            Stroke::Point(x?, y?)
        }
        (None, Some((law_at, law)), None) => {
            let law = Formula::read(&law, law_at, &["x"], reading)?;
            let (Some((_, from)), Some((_, to))) = (from, to) else {
                reading.problem(at, "a law says where it begins and ends: `from = 8, to = 5e10`");
                return None;
            };
            Stroke::Law { law, from, to, guess }
        }
        _ => {
            reading.problem(at, "what is drawn is a `point`, a `law`, or what is measured over `scenes`");
            return None;
        }
    };
    let event = if matches!(stroke, Stroke::Point(..)) { "point" } else { "line" };
    for (at, words) in [&name, &note].into_iter().flatten() {
        template::check_said(words, *at, event, reading);
    }
    Some(Drawn { name: name?.1, note: note.unwrap_or_default().1, stroke, step, spot })
}
