//! The ray as a ruler: every known interval of t, the current t and the hits.

mod scale;
mod spans;

use glam::Vec2;
use raystep_accel::{Interval, Structure, Visit};

pub use scale::RulerScale;
use spans::{Span, current_t, deciding};
pub(crate) use spans::{extent, spans};

use crate::moments::{Moment, Walk};
use crate::page::{Anchor, Figure, Ink, Look, Ticks, line, write};
use crate::theme::{Face, Role, text_width};
use crate::words::{digits, number};

/// A row for each known interval over one axis.
pub fn ruler(walk: &Walk<'_>, moment: &Moment, hide: bool, size: Vec2, look: &Look) -> Figure {
    ruler_of(walk, moment, None, hide, size, look)
}

/// The same, of a part of the axis.
pub(crate) fn ruler_of(
    walk: &Walk<'_>,
    moment: &Moment,
    part: Option<Interval>,
    hide: bool,
    size: Vec2,
    look: &Look,
) -> Figure {
    let mut figure = Figure::new(size);
    // Without a heading, room for the number of the current t, if there is one.
    let labelled = moment.event.as_ref().and_then(current_t).is_some();
    let label = if look.titles || !labelled { 0.0 } else { look.text };
    let top = look.heading(&mut figure, TITLE, "") + label;
    let u = look.text;
    let mut spans = spans(walk, moment);
    // The ends of slabs have their numbers beside them.
    let aside = if matches!(walk.structure, Structure::Slab(_)) { u * 3.0 } else { 0.0 };
    let axis = axis(walk, moment, part, beside_names(&spans, look) + aside, size.x - look.margin() - u - aside);
    if part.is_some() && look.titles {
        draw_part(&mut figure, &axis, extent(walk, moment), moment, look);
    }

    // Rows stand closer before any is left out: what lies furthest down the stack, slabs that decide nothing.
    let bottom = size.y - look.margin() - u * 1.1;
    let height = (bottom - top - u * 0.4).max(u);
    let fit = ((height / (u * 0.85)) as usize).max(1);
    let more = if spans.len() > fit { spans.len() + 1 - fit } else { 0 };
    let room = spans.len() - more;
    if moment.slab.is_some() {
        spans = deciding(spans, room);
    } else {
        spans.truncate(room);
    }
    let rows = spans.len() + usize::from(more > 0);
    let row = (height / rows.max(1) as f32).min(look.line());
    let letters = u.min(row * 0.9);

    for (index, span) in spans.iter().enumerate() {
        let y = top + row * (index as f32 + 0.5);
        let name = Vec2::new(look.margin(), y);
        write(&mut figure, span.role, span.place, name, &span.name, letters, Face::Medium, Anchor::Start);
        draw_span(&mut figure, &axis, span, hide, y, letters);
        if moment.slab.is_some() {
            let room = [beside_names(&spans, look) - u * 0.7, size.x - u * 0.3];
            draw_ends(&mut figure, &axis, span, room, y, letters);
        }
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
    ruler_line_of(walk, moment, None, hide, size, look)
}

/// The same, of a part of the axis.
pub(crate) fn ruler_line_of(
    walk: &Walk<'_>,
    moment: &Moment,
    part: Option<Interval>,
    hide: bool,
    size: Vec2,
    look: &Look,
) -> Figure {
    let Some(spans) = on_one_line(walk, moment) else {
        return ruler_of(walk, moment, part, hide, size, &Look { titles: false, ..*look });
    };
    let mut figure = Figure::new(size);
    let u = look.text;
    let axis = line_axis(walk, moment, part, size, look);
    let bottom = size.y - u * 1.5;
    let y = bottom - u * 0.9;

    let now = moment.event.as_ref().and_then(current_t).filter(|t| axis.shows(*t)).map(|t| axis.x(t));
    let mut taken = f32::NEG_INFINITY;
    for span in &spans {
        draw_span(&mut figure, &axis, span, hide, y, u);
        if span.interval.far < axis.low || span.interval.near > axis.high {
            continue;
        }
        let middle = (axis.x(span.interval.near) + axis.x(span.interval.far)) / 2.0;
        let half = |name: &str| text_width(name, Face::Bold, u) / 2.0;
        // Beside the line of the current t, not on it.
        let beside = |half: f32| {
            now.filter(|now| (now - middle).abs() < half + u * 0.3).map_or(middle, |now| now + half + u * 0.4)
        };
        // A name that would run into the one before is but a number, and stands a little to the right at most.
        let number = span.name.split(' ').next_back().unwrap_or_default();
        let pushed = beside(half(number)).max(taken + half(number));
        let fits = pushed - half(number) <= axis.x(span.interval.far) && pushed + half(number) <= size.x;
        let (name, middle) = match beside(half(&span.name)) {
            middle if middle - half(&span.name) > taken => (span.name.as_str(), middle),
            _ if fits => (number, pushed),
            _ => continue,
        };
        if !span.interval.is_empty() {
            let at = Vec2::new(middle, y - u * 1.1);
            write(&mut figure, span.role, span.place, at, name, u, Face::Bold, Anchor::Middle);
            taken = middle + half(name) + u * 0.5;
        }
    }
    draw_axis(&mut figure, &axis, walk.ray.t_min, bottom, look);
    draw_points(&mut figure, &axis, moment, y - u * 2.0, bottom, &Look { titles: false, ..*look });
    figure
}

/// The intervals that find room on one line; nothing where they lie over each other, as slabs and boxes do.
fn on_one_line(walk: &Walk<'_>, moment: &Moment) -> Option<Vec<Span>> {
    let spans = side_by_side(walk, moment);
    let apart = spans.windows(2).all(|pair| pair[0].interval.far <= pair[1].interval.near);
    (apart && moment.slab.is_none()).then_some(spans)
}

/// The intervals; of a node about to be left, the part before what waits next.
pub(crate) fn side_by_side(walk: &Walk<'_>, moment: &Moment) -> Vec<Span> {
    let mut spans = spans(walk, moment);
    if let (Some(first), Some(next)) = (spans.first().map(|span| span.interval), moment.stack.last())
        && first.near < next.near
        && next.near < first.far
    {
        spans[0].interval.far = next.near;
    }
    spans
}

/// The scale of a ruler of this size, or of one on one line.
pub(crate) fn ruler_scale(
    walk: &Walk<'_>,
    moment: &Moment,
    part: Option<Interval>,
    on_line: bool,
    size: Vec2,
    look: &Look,
) -> RulerScale {
    let Ticks { low, high, left, right } = match on_line && on_one_line(walk, moment).is_some() {
        true => line_axis(walk, moment, part, size, look),
        false => {
            let aside = if matches!(walk.structure, Structure::Slab(_)) { look.text * 3.0 } else { 0.0 };
            let left = beside_names(&spans(walk, moment), look) + aside;
            axis(walk, moment, part, left, size.x - look.margin() - look.text - aside)
        }
    };
    let (first, last) = extent(walk, moment);
    RulerScale { whole: Interval::new(first, last), shown: Interval::new(low, high), left, right }
}

/// Where the axis begins: right of the names.
fn beside_names(spans: &[Span], look: &Look) -> f32 {
    let name = |span: &Span| text_width(&span.name, Face::Medium, look.text);
    look.margin() + spans.iter().map(name).fold(look.text * 4.5, f32::max) + look.text
}

/// The axis of a ruler on one line.
fn line_axis(walk: &Walk<'_>, moment: &Moment, part: Option<Interval>, size: Vec2, look: &Look) -> Ticks {
    let aside = look.margin() + look.text * 0.6;
    axis(walk, moment, part, aside, size.x - aside)
}

/// What stands over a ruler.
const TITLE: &str = "t along the ray";

/// The axis of the whole walk, or of a part of it.
fn axis(walk: &Walk<'_>, moment: &Moment, part: Option<Interval>, left: f32, right: f32) -> Ticks {
    let (low, high) = part.map_or_else(|| extent(walk, moment), |part| (part.near, part.far));
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
    // What lies beside the axis is an arrow at its end.
    if far < axis.low || near > axis.high {
        let (at, along) = if far < axis.low { (from, Vec2::NEG_X) } else { (to, Vec2::X) };
        figure.add(span.role, span.place, Ink::Arrowhead { tip: at + along * u * 0.5, along, length: u * 0.8 });
        return;
    }
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

/// The numbers of a span beside its ends, where there is room between these two edges.
fn draw_ends(figure: &mut Figure, axis: &Ticks, span: &Span, room: [f32; 2], y: f32, u: f32) {
    if span.interval.is_empty() {
        return;
    }
    let size = u * 0.85;
    let ends = [(span.interval.near, -1.0, Anchor::End), (span.interval.far, 1.0, Anchor::Start)];
    for (t, side, anchor) in ends.into_iter().filter(|(t, ..)| t.is_finite()) {
        let says = number(t);
        let x = axis.x(t) + side * u * if axis.shows(t) { 0.4 } else { 1.0 };
        let end = x + side * text_width(&says, Face::Regular, size);
        if room[0] <= end && end <= room[1] {
            write(figure, span.role, span.place, Vec2::new(x, y), &says, size, Face::Regular, anchor);
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

/// Says which part of all is shown, on the side of the heading where the current t is not.
fn draw_part(figure: &mut Figure, axis: &Ticks, (low, high): (f32, f32), moment: &Moment, look: &Look) {
    let [near, far] = [axis.low, axis.high].map(|end| digits(end, telling(&[axis.low, axis.high])));
    let says = format!("{near} – {far} of {} – {}, double click: all of it", number(low), number(high));
    let aside = moment.event.as_ref().and_then(current_t).is_some_and(|t| axis.x(t) > (axis.left + axis.right) * 0.5);
    let y = look.margin() + look.text * 0.6;
    let (at, anchor) = match aside {
        true => (Vec2::new(look.margin() + look.text * 8.0, y), Anchor::Start),
        false => (Vec2::new(figure.size.x - look.margin(), y), Anchor::End),
    };
    write(figure, Role::Quiet, None, at, &says, look.small(), Face::Regular, anchor);
}

/// As few digits as tell all of these numbers apart, three at least.
fn telling(values: &[f32]) -> usize {
    let apart = |count: &usize| {
        let told: Vec<String> = values.iter().map(|value| digits(*value, *count)).collect();
        told.windows(2).all(|pair| pair[0] != pair[1])
    };
    (3..8).find(apart).unwrap_or(8)
}

/// The axis with its ticks.
fn draw_axis(figure: &mut Figure, axis: &Ticks, begin: f32, y: f32, look: &Look) {
    let u = look.text;
    figure.add(Role::Edge, None, line(Vec2::new(axis.left, y), Vec2::new(axis.right, y)));
    let marks = axis.marks(u * 4.2);
    let count = telling(&marks);
    for t in marks {
        let x = axis.x(t);
        figure.add(Role::Edge, None, line(Vec2::new(x, y - u * 0.3), Vec2::new(x, y + u * 0.3)));
        let at = Vec2::new(x, y + u * 1.05);
        write(figure, Role::Quiet, None, at, &digits(t, count), look.small(), Face::Regular, Anchor::Middle);
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
