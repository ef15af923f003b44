//! The splits that a builder weighs: what each would cost, along the axis it cuts.

use std::collections::BTreeSet;

use glam::Vec2;
use raystep_accel::{Direction, FreePlane, Grow, Place};

use crate::moments::{GrowMoment, Weighed};
use crate::page::{Anchor, Figure, Ink, Look, Ticks, line, write};
use crate::theme::{Face, Role, text_width};
use crate::words::{VolumeName, coordinate, number};

/// Most dots of one curve; of more, evenly spaced ones.
const MOST: usize = 80;

/// In a pane that is lower than this, in letters, or with plots narrower than that, the axes alone say what is across them.
const LOW: f32 = 14.0;
const NARROW: f32 = 11.0;

/// A curve for each axis that was tried: cost over the plane's coordinate. Planes of all directions share no
/// coordinate: they stand side by side in the order in which they were weighed. The cheapest so far is ringed,
/// the one taken filled. While a question asks for it, `hide` shows the planes without their costs.
pub fn costs(moment: &GrowMoment, volume: VolumeName, hide: bool, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    let cut = volume.cut;
    let divide = if cut == "way" { "sharing out" } else { "cutting" };
    let title = moment.node.map_or("Costs".to_owned(), |node| format!("Costs of {divide} node {node}"));
    let weighed: Vec<Weighed> = moment.weighed.iter().copied().filter(|w| w.cost.is_finite()).collect();
    let axes: BTreeSet<Direction> = weighed.iter().map(|weighed| weighed.axis).collect();
    if axes.is_empty() {
        let node = moment.node.and_then(|node| moment.nodes.get(&node));
        let says = match node {
            Some(node) if node.leaf.is_some() => format!("This node is a leaf: no {cut} is taken."),
            Some(_) => format!("No {cut} has been weighed here yet."),
            None => "There is nothing to weigh now.".to_owned(),
        };
        look.nothing(&mut figure, &title, &says);
        return figure;
    }
    let remark = remark(moment, cut, hide);
    let top = look.heading(&mut figure, &title, &remark);

    // Beside each other, over one scale of costs: the first one has its numbers.
    let (least, most) = weighed.iter().fold((f32::INFINITY, 0.0_f32), |(a, b), w| (a.min(w.cost), b.max(w.cost)));
    let u = look.text;
    let (scale, gap) = (u * 3.5, u * 1.2);
    let many = axes.len() as f32;
    let width = (size.x - 2.0 * look.margin() - scale - gap * (many - 1.0)) / many;
    let tight = size.y < u * LOW || width < u * NARROW;
    let (bottom, plot_top) = (size.y - look.margin() - u * 1.2, top + u * if tight { 1.2 } else { 2.2 });
    for (index, axis) in axes.iter().enumerate() {
        let left = look.margin() + scale + (width + gap) * index as f32;
        let here: Vec<Dot> = moment.weighed.iter().enumerate().filter_map(|(i, w)| Dot::of(i, w, *axis)).collect();
        let (low, high) =
            here.iter().fold((f32::INFINITY, f32::NEG_INFINITY), |(a, b), dot| (a.min(dot.across), b.max(dot.across)));
        // As wide as the node, so that the curve stands as the planes do.
        let node = moment.node.and_then(|node| moment.nodes.get(&node));
        let (low, high) = match (node, axis.axis()) {
            (Some(node), Some(axis)) => (low.min(node.bounds.min[axis]), high.max(node.bounds.max[axis])),
            _ => (low, high),
        };
        let pad = ((high - low) * 0.05).max(1e-3 * high.abs()).max(1e-6);
        let across = Ticks { low: low - pad, high: high + pad, left, right: left + width };
        let up = Ticks {
            low: least * 0.9,
            high: most + (most - least) * 0.05 + f32::MIN_POSITIVE,
            left: bottom,
            // No dot reaches up to the words.
            right: plot_top + u * 0.7,
        };
        let mut plot = Plot { figure: &mut figure, moment, cut, look, across, up, bottom, plot_top, tight };
        plot.frame(*axis, index == 0, hide);
        if hide || taken(moment) {
            plot.shares(*axis, &here);
        }
        if hide {
            plot.planes(&here);
        } else {
            plot.costs(*axis, &here);
        }
    }
    figure
}

/// A plane and where it stands in its plot.
struct Dot {
    across: f32,
    weighed: Weighed,
}

impl Dot {
    /// The plane that was weighed after `before` others, if it stands across this axis and its cost is a number.
    fn of(before: usize, weighed: &Weighed, axis: Direction) -> Option<Dot> {
        let across = if axis == Direction::Normal { before as f32 + 1.0 } else { weighed.plane };
        (weighed.axis == axis && weighed.cost.is_finite()).then_some(Dot { across, weighed: *weighed })
    }
}

/// Whether the node has been divided: all that could be weighed has been.
fn taken(moment: &GrowMoment) -> bool {
    moment.node.and_then(|node| moment.nodes.get(&node)).is_some_and(|node| node.split.is_some())
}

/// What was found, in words.
fn remark(moment: &GrowMoment, cut: &str, hide: bool) -> String {
    let name = |axis: Direction, plane: f32, free: Option<FreePlane>| {
        let before = moment.weighed.iter().position(|weighed| weighed.free == free);
        match before.filter(|_| axis == Direction::Normal) {
            Some(before) => format!("candidate {}", before + 1),
            None => format!("{} = {}", coordinate(axis), number(plane)),
        }
    };
    let taken = moment.node.and_then(|node| moment.nodes.get(&node)?.split);
    match (taken, moment.cheapest()) {
        _ if hide => format!("{} {cut}s were weighed", moment.weighed.len()),
        (Some(taken), _) => {
            format!("taken: {}, cost {}", name(taken.axis, taken.plane, taken.free), number(taken.cost))
        }
        (None, Some(least)) => {
            format!("cheapest so far: {}, cost {}", name(least.axis, least.plane, least.free), number(least.cost))
        }
        (None, None) => String::new(),
    }
}

struct Plot<'a> {
    figure: &'a mut Figure,
    moment: &'a GrowMoment,
    /// What is weighed: a plane, or a way to share out.
    cut: &'static str,
    look: &'a Look,
    across: Ticks,
    /// From the bottom (its left) to the top (its right).
    up: Ticks,
    bottom: f32,
    plot_top: f32,
    /// Whether there is no room for a line of words over each plot.
    tight: bool,
}

impl Plot<'_> {
    /// The axes, with the scale of costs if it is the first plot's.
    fn frame(&mut self, axis: Direction, first: bool, hide: bool) {
        let (u, small) = (self.look.text, self.look.small());
        let (left, right) = (self.across.left, self.across.right);
        let corner = Vec2::new(left, self.bottom);
        self.figure.add(Role::Edge, None, line(corner, Vec2::new(right, self.bottom)));
        self.figure.add(Role::Edge, None, line(corner, Vec2::new(left, self.plot_top)));
        let counted = axis == Direction::Normal;
        // The name of the axis stands at its end where it has no line of words.
        let name = if counted { "candidate".to_owned() } else { axis.to_string() };
        let long = text_width(&name, Face::Medium, small) + u * 0.8;
        let end = if self.tight { right - long } else { f32::INFINITY };
        for plane in self.across.marks(u * 4.0).into_iter().filter(|at| !counted || at.fract() == 0.0) {
            let at = Vec2::new(self.across.x(plane), self.bottom);
            if at.x > end {
                continue;
            }
            self.figure.add(Role::Edge, None, line(at, at + Vec2::new(0.0, u * 0.3)));
            let below = at + Vec2::new(0.0, u * 1.0);
            write(self.figure, Role::Quiet, None, below, &number(plane), small, Face::Regular, Anchor::Middle);
        }
        let sideways = Ticks { left: 0.0, right: (self.bottom - self.plot_top).max(1.0), ..self.up };
        for cost in sideways.marks(u * 2.2).into_iter().filter(|_| !hide) {
            let at = Vec2::new(left, self.up.x(cost));
            self.figure.add(Role::Edge, None, line(at, at - Vec2::new(u * 0.3, 0.0)));
            if !first {
                continue;
            }
            let beside = at - Vec2::new(u * 0.5, 0.0);
            write(self.figure, Role::Quiet, None, beside, &number(cost), small, Face::Regular, Anchor::End);
        }
        if self.tight {
            let at = Vec2::new(right, self.bottom + u * 1.0);
            write(self.figure, Role::Text, None, at, &name, small, Face::Medium, Anchor::End);
            return;
        }
        let cut = self.cut;
        let across = format!("{} {axis}", self.along());
        let names = match (counted, hide) {
            (true, true) => ["candidates, in order".to_owned(), "candidates".to_owned(), "in order".to_owned()],
            (true, false) => {
                ["cost of each candidate, in order".to_owned(), "cost, in order".to_owned(), "cost".to_owned()]
            }
            (false, true) => [format!("{cut}s {across}"), across.clone(), across],
            (false, false) => [format!("cost of each {cut} {across}"), format!("cost {across}"), across],
        };
        // No longer than its plot.
        let room = right - left + u * 0.6;
        let fits = |name: &&String| text_width(name, Face::Regular, small) <= room;
        let name = names.iter().find(fits).unwrap_or(&names[2]);
        let at = Vec2::new(left, self.plot_top - u * 1.7);
        write(self.figure, Role::Quiet, None, at, name, small, Face::Regular, Anchor::Start);
    }

    /// Planes stand across an axis; a list is shared out along it.
    fn along(&self) -> &'static str {
        if self.cut == "way" { "along" } else { "across" }
    }

    /// Where the node's middle lies, and the plane with the most even shares: what one might guess.
    fn shares(&mut self, axis: Direction, dots: &[Dot]) {
        let u = self.look.text;
        let middle = self.moment.node.and_then(|node| self.moment.nodes.get(&node));
        let middle = middle.and_then(|node| Some(node.bounds.center()[axis.axis()?]));
        let even = dots.iter().min_by_key(|dot| dot.weighed.below.abs_diff(dot.weighed.above)).map(|dot| dot.across);
        let small = self.look.small();
        let shown =
            |plane: Option<f32>| plane.filter(|plane| self.across.shows(*plane)).map(|plane| self.across.x(plane));
        let mut notes: Vec<(f32, &str)> = [(middle, "middle"), (even, "most even")]
            .into_iter()
            .filter_map(|(at, word)| Some((shown(at)?, word)))
            .collect();
        notes.sort_by(|a, b| a.0.total_cmp(&b.0));
        // Words that would touch stand to both sides of their lines, those of one line in one.
        let wide = |word: &str| text_width(word, Face::Regular, small);
        let near = notes.len() == 2 && notes[1].0 - notes[0].0 < (wide(notes[0].1) + wide(notes[1].1)) * 0.5 + u * 1.5;
        if near && notes[1].0 - notes[0].0 < 1.0 {
            notes = vec![(notes[0].0, "middle, most even")];
        }
        // None reaches into the next plot, nor over the other word.
        let mut before = self.across.left - u * 0.4;
        let mut begins = Vec::new();
        for (index, (x, word)) in notes.iter().enumerate() {
            let begin = match index {
                _ if !near || notes.len() == 1 => x - wide(word) * 0.5,
                0 => x - u * 0.3 - wide(word),
                _ => x + u * 0.3,
            };
            begins.push(begin.max(before));
            before = begin.max(before) + wide(word) + u * 0.6;
        }
        let mut after = self.across.right + u * 0.6;
        for (begin, (_, word)) in begins.iter_mut().zip(&notes).rev() {
            *begin = begin.min(after - wide(word));
            after = *begin - u * 0.6;
        }
        for (begin, (x, word)) in begins.into_iter().zip(notes) {
            self.figure.add(Role::Hidden, None, line(Vec2::new(x, self.bottom), Vec2::new(x, self.plot_top)));
            let at = Vec2::new(begin, self.plot_top - u * 0.5);
            write(self.figure, Role::Quiet, None, at, word, small, Face::Regular, Anchor::Start);
        }
    }

    /// The planes alone.
    fn planes(&mut self, dots: &[Dot]) {
        let place = self.moment.node.map(Place::Node);
        for dot in dots.iter().step_by(dots.len().div_ceil(MOST).max(1)) {
            let at = Vec2::new(self.across.x(dot.across), self.bottom);
            self.figure.add(Role::Candidate, place, line(at, at - Vec2::new(0.0, self.look.text * 0.6)));
        }
    }

    /// The planes and their costs: a curve along an axis, else a bar for each.
    fn costs(&mut self, axis: Direction, dots: &[Dot]) {
        let u = self.look.text;
        let place = self.moment.node.map(Place::Node);
        let at = |dot: &Dot| Vec2::new(self.across.x(dot.across), self.up.x(dot.weighed.cost));
        let mut points: Vec<Vec2> = dots.iter().step_by(dots.len().div_ceil(MOST).max(1)).map(at).collect();
        points.sort_by(|a, b| a.x.total_cmp(&b.x));
        if axis == Direction::Normal {
            for top in &points {
                self.figure.add(Role::Edge, None, line(top.with_y(self.bottom), *top));
            }
        } else {
            self.figure.add(Role::Edge, None, Ink::Line { points: points.clone() });
        }
        for center in &points {
            self.figure.add(Role::Scene, place, Ink::Circle { center: *center, radius: u * 0.2 });
        }
        let ring = |dot: &Dot| Ink::Circle { center: at(dot), radius: u * 0.4 };
        let among = |weighed: Weighed| dots.iter().find(|dot| dot.weighed == weighed);

        // The one weighed now, the cheapest so far, the one taken.
        let taken = self.moment.node.and_then(|node| self.moment.nodes.get(&node)?.split);
        let cheapest = self.moment.cheapest().and_then(among);
        let weighs = matches!(self.moment.event, Some(Grow::Weigh { .. }));
        if let Some(now) = dots.last().filter(|now| weighs && self.moment.weighed.last() == Some(&now.weighed)) {
            self.figure.add(Role::Candidate, place, ring(now));
        }
        if let Some(cheapest) = cheapest {
            let role = if taken.is_some() { Role::Best } else { Role::Here };
            self.figure.add(role, place, ring(cheapest));
        }
    }
}
