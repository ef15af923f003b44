//! Which intervals of t are known at a moment, and which part of the t axis shows them.

use std::collections::BTreeSet;

use raystep_accel::{Axis, Interval, Place, Structure, Verdict, Visit};

use crate::moments::{Moment, Walk};
use crate::theme::Role;

/// An interval of t with a name.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Span {
    pub(crate) name: String,
    pub(crate) place: Option<Place>,
    pub(crate) interval: Interval,
    pub(crate) role: Role,
}

/// The intervals known at a moment: of a slab test, each slab's and what they leave; else where the walk
/// stands, what waits, and the boxes just tested.
pub(crate) fn spans(walk: &Walk<'_>, moment: &Moment) -> Vec<Span> {
    let span = |name: &str, place, interval, role| Span { name: name.to_owned(), place, interval, role };
    if let Some(slab) = &moment.slab {
        let cuts = slab.cuts.iter().filter(|cut| !walk.leaves_out(cut.axis));
        let cuts = cuts.map(|cut| {
            let interval = match cut.t {
                Some([t1, t2]) => Interval::new(t1.min(t2), t1.max(t2)),
                None if cut.inside => Interval::ALL,
                None => Interval::new(f32::INFINITY, f32::NEG_INFINITY),
            };
            let role = if cut.axis == slab.axis { Role::Plane } else { Role::Seen };
            span(&format!("slab {}", cut.axis), Some(slab.place), interval, role)
        });
        let name = if slab.place == Place::World { "so far".to_owned() } else { slab.place.to_string() };
        return cuts.chain([span(&name, Some(slab.place), slab.interval, Role::Live)]).collect();
    }
    if let Some(event @ (Visit::Roots { place, .. } | Visit::Clip { place, .. })) = moment.event {
        let (name, cut) = match event {
            Visit::Clip { face, t, entering: true, .. } => (format!("face {face}"), Interval::new(t, f32::INFINITY)),
            Visit::Clip { face, t, .. } => (format!("face {face}"), Interval::new(f32::NEG_INFINITY, t)),
            Visit::Roots { t1, t2, .. } => ("sphere".to_owned(), Interval::new(t1, t2)),
            _ => return Vec::new(),
        };
        let cut = span(&name, Some(place), cut, Role::Plane);
        return vec![cut, span(&place.to_string(), Some(place), moment.live, Role::Live)];
    }
    if moment.ending.is_some() {
        let role = if moment.best.is_some() { Role::Live } else { Role::Ray };
        let live = if moment.best.is_some() { moment.live } else { walk.ray.range() };
        return vec![span("ray", None, live, role)];
    }
    let Some(here) = moment.here else {
        let tested = moment.volumes.iter().map(|tested| box_span(tested.place, tested.interval, tested.verdict));
        // The part under consideration, as in space, or all of it.
        let part = if moment.live.is_empty() { (walk.ray.range(), Role::Ray) } else { (moment.live, Role::Live) };
        let ray = span("ray", None, part.0, part.1);
        // What is dropped says where it began: later than the best hit.
        let dropped = match moment.event {
            Some(Visit::Drop { node, t_near, t_far, .. }) => {
                let place = Place::Node(node);
                Some(span(&place.to_string(), Some(place), Interval::new(t_near, t_far), Role::Dropped))
            }
            _ => None,
        };
        return [ray].into_iter().chain(dropped).chain(tested).chain(waiting(moment)).collect();
    };
    let mut spans = vec![span(&here.to_string(), Some(here), moment.entered, Role::Here)];
    if let (Some(Visit::Step { .. }), Some(step)) = (moment.event, moment.stepping) {
        // How far it is to the next plane of each axis: the shortest decided.
        let axes = Axis::ALL.into_iter().filter(|axis| !(walk.flat && *axis == Axis::Z));
        spans.extend(axes.map(|axis| {
            let interval = Interval::new(moment.entered.near, step.next[axis.index()]);
            let role = if axis == step.axis { Role::Plane } else { Role::Seen };
            span(&format!("next {axis}"), Some(here), interval, role)
        }));
    }
    let on_stack = |place| matches!(place, Place::Node(node) if moment.waiting(node).is_some());
    let tested = moment.volumes.iter().filter(|tested| tested.place != here && !on_stack(tested.place));
    spans.extend(tested.map(|tested| box_span(tested.place, tested.interval, tested.verdict)));
    spans.extend(waiting(moment));
    spans
}

/// Of slabs and what they leave as many as there is room for: what they leave, the latest entry and the earliest exit,
/// then the last ones.
pub(crate) fn deciding(spans: Vec<Span>, room: usize) -> Vec<Span> {
    let slabs = spans.iter().enumerate().take(spans.len().saturating_sub(1));
    let entry = slabs.clone().max_by(|(_, a), (_, b)| a.interval.near.total_cmp(&b.interval.near));
    let exit = slabs.min_by(|(_, a), (_, b)| a.interval.far.total_cmp(&b.interval.far));
    let mut first: Vec<usize> = [entry, exit].into_iter().flatten().map(|(index, _)| index).collect();
    first.insert(0, spans.len() - 1);
    first.extend((0..spans.len()).rev());
    let mut kept = BTreeSet::new();
    for index in first {
        if kept.len() < room {
            kept.insert(index);
        }
    }
    spans.into_iter().enumerate().filter(|(index, _)| kept.contains(index)).map(|(_, span)| span).collect()
}

fn waiting(moment: &Moment) -> impl Iterator<Item = Span> {
    moment.stack.iter().rev().map(|waiting| {
        let place = Place::Node(waiting.node);
        let interval = Interval::new(waiting.near, waiting.far);
        Span { name: place.to_string(), place: Some(place), interval, role: Role::Waiting }
    })
}

fn box_span(place: Place, interval: Interval, verdict: Verdict) -> Span {
    let role = if verdict == Verdict::Hit { Role::Seen } else { Role::Dropped };
    Span { name: place.to_string(), place: Some(place), interval, role }
}

/// The t that the current event is about.
pub(crate) fn current_t(event: &Visit) -> Option<f32> {
    match *event {
        Visit::Plane { t, .. } | Visit::Split { t, .. } | Visit::Step { t, .. } => Some(t),
        Visit::Test { t, hit: true, .. } | Visit::Better { t, .. } | Visit::Beyond { t, .. } => Some(t),
        Visit::End { t, hit: true, .. } => Some(t),
        _ => None,
    }
    .filter(|t| t.is_finite())
}

/// The part of the t axis that is shown: the same at every step of a walk, unless a slab is cut far off.
pub(crate) fn extent(walk: &Walk<'_>, moment: &Moment) -> (f32, f32) {
    // What the walk stands in and finds must be seen; where slabs and planes cut it may lie anywhere.
    let (mut must, mut may) = (Vec::new(), Vec::new());
    for event in walk.events {
        match *event {
            Visit::Enter { t_near, t_far, .. } | Visit::Push { t_near, t_far, .. } => must.extend([t_near, t_far]),
            Visit::Volume { t_near, t_far, verdict: Verdict::Hit, .. } => must.extend([t_near, t_far]),
            Visit::Test { t, hit: true, .. } => must.push(t),
            Visit::Divide { axis, t1, t2, .. } if !walk.leaves_out(axis) => may.extend([t1, t2]),
            Visit::Roots { t1, t2, .. } => may.extend([t1, t2]),
            Visit::Clip { t, .. } => may.push(t),
            _ => {}
        }
    }
    let finite = |t: &f32| t.is_finite();
    // Once a walk goes on inside, the cuts of its first box no longer matter.
    if walk.events.iter().any(|event| matches!(event, Visit::Enter { .. })) {
        may.clear();
    }
    must.retain(finite);
    may.retain(finite);
    let reach = must.iter().map(|t| t.abs()).fold(0.0, f32::max);
    let far = if reach > 0.0 { 2.0 * reach } else { 2.4 * median(&may) };
    // Behind the ray's beginning there is less to see; what was cut there is shown once it is.
    let back = if reach > 0.0 { reach } else { far };
    let known = moment.slab.as_ref().filter(|_| matches!(walk.structure, Structure::Slab(_)));
    let cut: Vec<f32> = known.iter().flat_map(|slab| &slab.cuts).filter_map(|cut| cut.t).flatten().collect();
    let shown = must.iter().copied().chain(may.into_iter().filter(|t| {
        let near = -back <= *t && *t <= far;
        near || (t.abs() <= 20.0 * reach && cut.contains(t))
    }));
    let origin = if walk.ray.t_min.abs() <= far { walk.ray.t_min } else { 0.0 };
    let (low, high) = shown.fold((origin, origin), |(low, high), t| (low.min(t), high.max(t)));
    if high > low { (low, high + (high - low) * 0.03) } else { (low, low + 1.0) }
}

/// The middle one of the sizes.
fn median(values: &[f32]) -> f32 {
    let mut sizes: Vec<f32> = values.iter().map(|t| t.abs()).collect();
    sizes.sort_by(f32::total_cmp);
    sizes.get(sizes.len() / 2).copied().unwrap_or(0.0)
}
