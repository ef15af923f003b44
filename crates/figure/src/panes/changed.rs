//! What changed: the values that are not what they were at the step before, old and new.

use glam::Vec2;
use raystep_accel::{Axis, Grow, Place};

use crate::moments::{Build, GrowMoment, Moment, Walk, Weighed};
use crate::page::{Anchor, Figure, Look, write};
use crate::theme::fonts::elided;
use crate::theme::{Face, Role, text_width};
use crate::words::{coordinate, number, value, whole};

/// A value that is followed from step to step. What stands behind the `_` of its name is set lower.
#[derive(Clone, Debug, PartialEq)]
struct Watched {
    name: String,
    /// Nothing while it is not known.
    says: Option<String>,
    place: Option<Place>,
    /// Whether it is what the algorithm is after.
    loud: bool,
}

/// A row of the pane: what it was, and what it is now.
struct Row {
    now: Watched,
    before: Option<String>,
}

/// What a walk has changed since an earlier moment. Nothing in it comes from later events. While a question is open, `hide`
/// leaves out what is counted in all: it may be asked for.
pub fn changed(walk: &Walk<'_>, before: &Moment, now: &Moment, hide: bool, size: Vec2, look: &Look) -> Figure {
    let mut rows = compared(&of_walk(walk, before, now), of_walk(walk, now, now));
    rows.retain(|row| !hide || !TOTALS.contains(&&*row.now.name));
    draw(before.step, now.step, &rows, size, look)
}

/// What a builder has changed since an earlier moment; `hide` as above, and costs, too.
pub fn changed_of_build(
    build: &Build<'_>,
    before: &GrowMoment,
    now: &GrowMoment,
    hide: bool,
    size: Vec2,
    look: &Look,
) -> Figure {
    let mut rows = compared(&of_build(before, &before.weighed), of_build(now, &build.weighed(now).0));
    rows.retain(|row| !hide || !TOTALS.iter().chain(&COSTS).any(|name| *name == row.now.name));
    draw(before.step, now.step, &rows, size, look)
}

/// How high so many rows of what changed are, with their heading.
pub fn changed_height(rows: usize, look: &Look) -> f32 {
    look.heading(&mut Figure::default(), "", "") + look.line() * rows as f32
}

/// The values that are not what they were. One that is not known any more is no change to follow.
fn compared(before: &[Watched], now: Vec<Watched>) -> Vec<Row> {
    let old = |name: &str| before.iter().find(|old| old.name == name).and_then(|old| old.says.clone());
    let rows = now.into_iter().map(|now| Row { before: old(&now.name), now });
    rows.filter(|row| row.now.says.is_some() && row.now.says != row.before).collect()
}

/// What is counted in all, over a whole walk or build.
const TOTALS: [&str; 7] = ["tests", "tests skipped", "cells met", "not reached", "stored", "splits", "leaves"];

/// What the ways to divide a node cost.
const COSTS: [&str; 2] = ["cost", "least so far"];

/// The values of a list, in the order in which they are read.
#[derive(Default)]
struct Watching(Vec<Watched>);

impl Watching {
    fn says(&mut self, name: impl Into<String>, says: Option<String>) {
        self.0.push(Watched { name: name.into(), says, place: None, loud: false });
    }

    fn number(&mut self, name: impl Into<String>, x: Option<f32>) {
        self.says(name, x.map(number));
    }

    fn count(&mut self, name: &str, n: u64) {
        self.says(name, Some(whole(n)));
    }

    fn place(&mut self, name: &str, place: Option<Place>) {
        let says = place.map(|place| bare(&place));
        self.0.push(Watched { name: name.to_owned(), says, place, loud: false });
    }

    fn loud(&mut self) {
        if let Some(last) = self.0.last_mut() {
            last.loud = true;
        }
    }
}

/// A place without its kind.
fn bare(place: &Place) -> String {
    match place {
        Place::World => "the box".to_owned(),
        Place::Node(node) => node.to_string(),
        Place::Cell(cell) => cell.to_string(),
        Place::Prim(prim) => prim.to_string(),
    }
}

/// What is followed in a walk: where it is, its part of the ray, the step's own values, and what it has found.
fn of_walk(walk: &Walk<'_>, moment: &Moment, later: &Moment) -> Vec<Watched> {
    let mut all = Watching::default();
    let inner = moment.inside.as_ref();
    all.place("instance", inner.map(|inside| Place::Prim(inside.instance)));
    let at = inner.map_or(moment, |inside| &inside.moment);
    all.place("node", at.here.filter(|here| matches!(here, Place::Node(_))));
    all.place("cell", at.here.filter(|here| matches!(here, Place::Cell(_))));

    // A slab that is cut.
    if let Some(cut) = at.slab.as_ref().and_then(|slab| slab.cuts.last()).filter(|cut| !walk.leaves_out(cut.axis)) {
        let axis = cut.axis.name();
        all.number(format!("t1 in {axis}"), cut.t.map(|[t1, _]| t1));
        all.number(format!("t2 in {axis}"), cut.t.map(|[_, t2]| t2));
    }
    // A plane that is crossed.
    if let Some(cut) = at.cut {
        all.number(format!("{}_plane", cut.axis.name()), Some(cut.plane));
        all.number("t_plane", Some(cut.t));
    }
    let live = at.live;
    let known = moment.step > 0 && moment.ending.is_none() && (live.near.is_finite() || live.far.is_finite());
    all.number("t_near", known.then_some(live.near));
    all.number("t_far", known.then_some(live.far));

    // The next plane of each axis: of the axis that was stepped along, the one after.
    let next = match (at.stepping, later.stepping) {
        (Some(step), _) => {
            let mut next = step.next;
            next[step.axis.index()] += step.delta[step.axis.index()];
            Some(next)
        }
        // What the first step has compared was there before it.
        (None, later) if matches!(at.here, Some(Place::Cell(_))) => later.map(|step| step.next),
        _ => None,
    };
    for axis in Axis::ALL.into_iter().filter(|axis| !(walk.flat && *axis == Axis::Z)) {
        all.number(format!("next t in {axis}"), next.map(|next| next[axis.index()]));
    }

    all.count("on the stack", at.stack.len() as u64);
    all.count("tests", moment.cost.prim_tests);
    all.count("tests skipped", moment.cost.skips);
    all.place("nearest", moment.best.map(|hit| Place::Prim(hit.prim)));
    all.number("t_best", Some(moment.best.map_or(f32::INFINITY, |hit| hit.t)));
    all.loud();
    all.0
}

/// What is followed in a build: the node, the split that is weighed, what was decided. `own` is what the builder has
/// weighed itself.
fn of_build(moment: &GrowMoment, own: &[Weighed]) -> Vec<Watched> {
    let mut all = Watching::default();
    all.place("primitive", moment.prim.map(Place::Prim));
    all.place("node", moment.node.map(Place::Node));
    let extent = (!moment.bounds.is_empty()).then(|| value(&raystep_accel::Value::Box(moment.bounds)));
    all.says("box", extent);
    // Where the node is cut, and from then on, it is the split that is taken, not the one that was weighed last.
    let node = moment.node.and_then(|node| moment.nodes.get(&node));
    let is_cut = matches!(moment.event, Some(Grow::Split { .. })) || node.is_some_and(|node| node.split.is_some());
    let weighed = if is_cut { moment.cheapest() } else { moment.weighed.last().copied() };
    if let Some(weighed) = weighed {
        all.number(coordinate(weighed.axis), Some(weighed.plane));
        all.count("n_below", u64::from(weighed.below));
        all.count("n_above", u64::from(weighed.above));
        // Chances are followed where the builder tells them.
        if let Some(event @ Grow::Weigh { .. }) = moment.event.as_ref() {
            for name in ["p_below", "p_above"] {
                all.says(name, event.field(name).map(|found| value(&found)));
            }
        }
        all.number("cost", Some(weighed.cost));
        all.loud();
        all.number("least so far", Weighed::cheapest(own).map(|least| least.cost));
    }
    let tally = &moment.tally;
    all.count("cells met", tally.rasterised);
    all.count("not reached", tally.pruned);
    all.count("stored", tally.stored);
    all.count("splits", tally.taken);
    all.count("leaves", tally.leaves);
    all.count("nodes that wait", moment.waiting.len() as u64);
    all.0
}

fn draw(before: usize, now: usize, rows: &[Row], size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    let top = look.heading(&mut figure, "What changed", "");
    let (u, line) = (look.text, look.line());
    let (left, right) = (look.margin(), size.x - look.margin());
    if look.titles && now > before {
        let at = Vec2::new(right, look.margin() + u * 0.6);
        let since = format!("since step {before}");
        write(&mut figure, Role::Quiet, None, at, &since, look.small(), Face::Regular, Anchor::End);
    }
    if rows.is_empty() {
        let says = if now == 0 { "Nothing has happened yet." } else { "Nothing that is followed here." };
        let at = Vec2::new(left, top + line * 0.5);
        write(&mut figure, Role::Quiet, None, at, says, u, Face::Regular, Anchor::Start);
        return figure;
    }
    // Of more rows than there is room for, those at the end say what it comes to.
    let fit = (((size.y - top) / line) as usize).max(1);
    let shown = &rows[rows.len().saturating_sub(fit)..];
    let columns = Columns::of(shown, right - left, look);
    let u = columns.u;
    let (old, arrow, new) = (left + columns.old, left + columns.arrow, left + columns.new);
    for (index, row) in shown.iter().enumerate() {
        let y = top + line * (index as f32 + 0.5);
        let role = if row.now.loud { Role::Live } else { Role::Text };
        let place = row.now.place;
        named(&mut figure, role, place, Vec2::new(left, y), &row.now.name, u);
        let before = row.before.as_deref().unwrap_or("–");
        let before = elided(before, Face::Mono, u, old - left - columns.names);
        write(&mut figure, Role::Quiet, None, Vec2::new(old, y), &before, u, Face::Mono, Anchor::End);
        write(&mut figure, role, None, Vec2::new(arrow, y), "→", u, Face::Mono, Anchor::Middle);
        let now = elided(row.now.says.as_deref().unwrap_or("–"), Face::MonoMedium, u, right - new);
        write(&mut figure, role, place, Vec2::new(new, y), &now, u, Face::MonoMedium, Anchor::Start);
    }
    figure
}

/// The letters of the rows, and where after the names the old value ends, the arrow stands and the new one begins.
struct Columns {
    u: f32,
    names: f32,
    old: f32,
    arrow: f32,
    new: f32,
}

/// How far the letters of the rows shrink before a value is cut short.
const SHRUNK: [f32; 5] = [1.0, 0.92, 0.85, 0.78, 0.72];

impl Columns {
    /// At fixed shares of the room where the values fit there; else as close as they come, in smaller letters.
    fn of(rows: &[Row], room: f32, look: &Look) -> Columns {
        let longest = |wide: &dyn Fn(&Row) -> f32| rows.iter().map(wide).fold(0.0, f32::max);
        let old = longest(&|row| text_width(row.before.as_deref().unwrap_or("–"), Face::Mono, 1.0));
        let new = longest(&|row| text_width(row.now.says.as_deref().unwrap_or("–"), Face::MonoMedium, 1.0));
        let name = longest(&|row| named(&mut Figure::default(), Role::Text, None, Vec2::ZERO, &row.now.name, 1.0));
        let (u, names) = (look.text, (name.max(7.0) + 1.0) * look.text);
        let rest = (room - names).max(u * 8.0);
        if old * u <= rest * 0.36 && new * u <= room - names - rest * 0.56 {
            return Columns {
                u,
                names,
                old: names + rest * 0.36,
                arrow: names + rest * 0.46,
                new: names + rest * 0.56,
            };
        }
        let sizes = SHRUNK.map(|part| (part * look.text).max(look.least.min(look.text)));
        let fits = |u: &f32| (name + 0.6 + old + ARROW + new) * u <= room;
        let u = sizes.into_iter().find(fits).unwrap_or(sizes[SHRUNK.len() - 1]);
        // What is too long even so leaves the old value less room.
        let names = (name + 0.6) * u;
        let old = (names + old * u).min((room - new * u - ARROW * u).max(names + u * 2.0));
        Columns { u, names, old, arrow: old + ARROW * 0.5 * u, new: old + ARROW * u }
    }
}

/// The room of an arrow between two values, in parts of the letters.
const ARROW: f32 = 2.0;

/// Writes a name, what stands behind its `_` smaller and lower; says how wide it is.
fn named(figure: &mut Figure, role: Role, place: Option<Place>, at: Vec2, name: &str, size: f32) -> f32 {
    let Some((letter, below)) = name.split_once('_') else {
        write(figure, role, place, at, name, size, Face::Regular, Anchor::Start);
        return text_width(name, Face::Regular, size);
    };
    write(figure, role, place, at, letter, size, Face::Italic, Anchor::Start);
    let wide = text_width(letter, Face::Italic, size) + size * 0.08;
    let (small, lower) = (size * 0.76, at + Vec2::new(wide, size * 0.26));
    write(figure, role, place, lower, below, small, Face::Italic, Anchor::Start);
    wide + text_width(below, Face::Italic, small)
}
