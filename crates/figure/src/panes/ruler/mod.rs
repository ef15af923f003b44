//! The ray as a ruler: every known interval of t, the current t and the hits.

mod spans;

use glam::Vec2;
use raystep_accel::{Structure, Visit};

use spans::{Span, current_t};
pub(crate) use spans::{extent, spans};

use crate::moments::{Moment, Walk};
use crate::page::{Anchor, Figure, Ink, Look, Ticks, line, write};
use crate::theme::{Face, Role, text_width};
use crate::words::number;

/// A row for each known interval over one axis.
pub fn ruler(walk: &Walk<'_>, moment: &Moment, hide: bool, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    // Without a heading, room for the number of the current t, if there is one.
    let labelled = moment.event.as_ref().and_then(current_t).is_some();
    let label = if look.titles || !labelled { 0.0 } else { look.text };
    let top = look.heading(&mut figure, "t along the ray", "") + label;
    let u = look.text;
    let mut spans = spans(walk, moment);

    // Rows stand closer before any is left out; what is left out lies furthest down the stack.
    let bottom = size.y - look.margin() - u * 1.1;
    let height = (bottom - top - u * 0.4).max(u);
    let fit = ((height / (u * 0.85)) as usize).max(1);
    let more = if spans.len() > fit { spans.len() + 1 - fit } else { 0 };
    if moment.slab.is_some() {
        // What all slabs leave stands last, and is what counts.
        spans.drain(..more);
    } else {
        spans.truncate(spans.len() - more);
    }
    let rows = spans.len() + usize::from(more > 0);
    let row = (height / rows.max(1) as f32).min(look.line());
    let letters = u.min(row * 0.9);
    let names = spans.iter().map(|span| text_width(&span.name, Face::Medium, u)).fold(u * 4.5, f32::max);
    let axis = axis(walk, look.margin() + names + u, size.x - look.margin() - u);

    for (index, span) in spans.iter().enumerate() {
        let y = top + row * (index as f32 + 0.5);
        let name = Vec2::new(look.margin(), y);
        write(&mut figure, span.role, span.place, name, &span.name, letters, Face::Medium, Anchor::Start);
        draw_span(&mut figure, &axis, span, hide, y, letters);
    }
    if more > 0 {
        let at = Vec2::new(look.margin(), top + row * (spans.len() as f32 + 0.5));
        let says = format!("+ {more} more");
        write(&mut figure, Role::Quiet, None, at, &says, letters, Face::Regular, Anchor::Start);
    }
    draw_axis(&mut figure, &axis, walk.ray.t_min, bottom, look);
    draw_points(&mut figure, &axis, moment, top - u * 0.1, bottom, look);
    figure
}

/// How high a ruler is that shows every interval of this walk at any of its steps; at most six rows.
pub fn ruler_height(walk: &Walk<'_>, look: &Look) -> f32 {
    let axes = if walk.flat { 2 } else { 3 };
    let deepest = walk.events.iter().map(|event| match *event {
        Visit::Push { depth, .. } => depth as usize + 1,
        Visit::Divide { .. } | Visit::Parallel { .. } | Visit::Step { .. } => axes + 1,
        _ => 1,
    });
    let rows = deepest.max().unwrap_or(1).min(6) as f32;
    let mut scratch = Figure::default();
    look.heading(&mut scratch, "", "") + look.line() * rows + look.margin() + look.text * 1.6
}

/// How high a [`ruler_line`] is: names over one line, or four rows where the intervals lie over each other.
pub fn ruler_line_height(walk: &Walk<'_>, look: &Look) -> f32 {
    // Slabs and boxes overlap, cells and the halves of a node do not.
    let overlap = matches!(walk.structure, Structure::Slab(_) | Structure::Bvh(_));
    look.text * if overlap { 6.2 } else { 4.6 }
}

/// Everything on one line, names above: for the far end of a lecture hall.
pub fn ruler_line(walk: &Walk<'_>, moment: &Moment, hide: bool, size: Vec2, look: &Look) -> Figure {
    // Of a node about to be left, the part before what waits next.
    let mut spans = spans(walk, moment);
    if let (Some(first), Some(next)) = (spans.first().map(|span| span.interval), moment.stack.last())
        && first.near < next.near
        && next.near < first.far
    {
        spans[0].interval.far = next.near;
    }
    // What lies over each other, as slabs and boxes do, needs a row each.
    let apart = spans.windows(2).all(|pair| pair[0].interval.far <= pair[1].interval.near);
    if moment.slab.is_some() || !apart {
        return ruler(walk, moment, hide, size, &Look { titles: false, ..*look });
    }
    let mut figure = Figure::new(size);
    let u = look.text;
    let axis = axis(walk, look.margin() + u * 0.6, size.x - look.margin() - u * 0.6);
    let bottom = size.y - u * 1.5;
    let y = bottom - u * 0.9;

    let now = moment.event.as_ref().and_then(current_t).filter(|t| axis.shows(*t)).map(|t| axis.x(t));
    let mut taken = f32::NEG_INFINITY;
    for span in &spans {
        draw_span(&mut figure, &axis, span, hide, y, u);
        let mut middle = (axis.x(span.interval.near) + axis.x(span.interval.far)) / 2.0;
        let half = text_width(&span.name, Face::Bold, u) / 2.0;
        // Beside the line of the current t, not on it.
        if let Some(now) = now.filter(|now| (now - middle).abs() < half + u * 0.3) {
            middle = now + half + u * 0.4;
        }
        // A name that would run into the one before is left out.
        if !span.interval.is_empty() && middle - half > taken {
            let at = Vec2::new(middle, y - u * 1.1);
            write(&mut figure, span.role, span.place, at, &span.name, u, Face::Bold, Anchor::Middle);
            taken = middle + half + u * 0.5;
        }
    }
    draw_axis(&mut figure, &axis, walk.ray.t_min, bottom, look);
    draw_points(&mut figure, &axis, moment, y - u * 2.0, bottom, &Look { titles: false, ..*look });
    figure
}

fn axis(walk: &Walk<'_>, left: f32, right: f32) -> Ticks {
    let (low, high) = extent(walk);
    Ticks { low, high, left, right: right.max(left + 1.0) }
}

/// A bar with a cap at each end, or an arrow where it runs on beyond the axis.
fn draw_span(figure: &mut Figure, axis: &Ticks, span: &Span, hide: bool, y: f32, u: f32) {
    let (near, far) = (span.interval.near, span.interval.far);
    if span.interval.is_empty() {
        // While a question asks what it comes to, the numbers alone.
        let finite = near.is_finite() && far.is_finite();
        let says = if hide {
            format!("[{}, {}]", number(near), number(far))
        } else if finite {
            format!("empty: {} > {}", number(near), number(far))
        } else {
            "empty".to_owned()
        };
        let at = Vec2::new(axis.left, y);
        let role = if hide { span.role } else { Role::Wrong };
        write(figure, role, span.place, at, &says, u * 0.9, Face::Regular, Anchor::Start);
        return;
    }
    let (from, to) = (Vec2::new(axis.x(near), y), Vec2::new(axis.x(far), y));
    let (before, beyond) = (near < axis.low, far > axis.high);
    figure.add(span.role, span.place, line(from, to));
    let tall = Vec2::new(0.0, u * 0.5);
    let ends = [(from, before, Vec2::NEG_X), (to, beyond, Vec2::X)];
    for (at, clipped, along) in ends {
        if clipped {
            figure.add(span.role, span.place, Ink::Arrowhead { tip: at + along * u * 0.5, along, length: u * 0.8 });
        } else {
            figure.add(cap(span.role), span.place, line(at - tall, at + tall));
        }
    }
}

/// Caps are drawn solid and thin whatever the bar.
fn cap(role: Role) -> Role {
    match role {
        Role::Here | Role::Plane => Role::Seen,
        Role::Waiting | Role::Dropped => Role::Quiet,
        other => other,
    }
}

fn draw_axis(figure: &mut Figure, axis: &Ticks, begin: f32, y: f32, look: &Look) {
    let u = look.text;
    figure.add(Role::Edge, None, line(Vec2::new(axis.left, y), Vec2::new(axis.right, y)));
    for t in axis.marks(u * 4.2) {
        let x = axis.x(t);
        figure.add(Role::Edge, None, line(Vec2::new(x, y - u * 0.3), Vec2::new(x, y + u * 0.3)));
        let at = Vec2::new(x, y + u * 1.05);
        write(figure, Role::Quiet, None, at, &number(t), look.small(), Face::Regular, Anchor::Middle);
    }
    // Where the ray begins: what lies before it does not count.
    if axis.shows(begin) {
        figure.add(Role::Live, None, Ink::Circle { center: Vec2::new(axis.x(begin), y), radius: u * 0.12 });
    }
}

/// The hits so far as dots on the axis, and the t of the current event as a line across the rows.
fn draw_points(figure: &mut Figure, axis: &Ticks, moment: &Moment, top: f32, bottom: f32, look: &Look) {
    let u = look.text;
    for test in &moment.tested {
        let Some(t) = test.t.filter(|t| axis.shows(*t)) else { continue };
        let place = Some(raystep_accel::Place::Prim(test.prim));
        let best = moment.best.is_some_and(|best| best.prim == test.prim);
        let (role, radius) = if best { (Role::Best, 0.35) } else { (Role::Hit, 0.25) };
        figure.add(role, place, Ink::Circle { center: Vec2::new(axis.x(t), bottom), radius: u * radius });
    }
    let Some(event) = moment.event.as_ref() else { return };
    let Some(t) = current_t(event) else { return };
    let label = format!("t = {}", number(t));
    let half = text_width(&label, Face::Bold, u) / 2.0;
    if axis.shows(t) {
        let x = axis.x(t);
        figure.add(Role::Ray, Some(event.place()), line(Vec2::new(x, top), Vec2::new(x, bottom + u * 0.4)));
    }
    // Out of range it stands at the edge, with an arrow.
    let (label, x) = match () {
        () if t > axis.high => (format!("{label} →"), axis.right - half),
        () if t < axis.low => (format!("← {label}"), axis.left + half),
        () => (label, axis.x(t)),
    };
    // Beside the heading and inside the pane.
    let heading = if look.titles { look.margin() + u * 7.5 } else { 0.0 };
    let x = x.max(heading + half).min((axis.right + look.margin() - half).max(0.0));
    let at = Vec2::new(x, top - u * 0.7);
    write(figure, Role::Value, Some(event.place()), at, &label, u, Face::Bold, Anchor::Middle);
}
