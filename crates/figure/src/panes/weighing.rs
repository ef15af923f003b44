//! How a flat node may be divided, all in one picture: space with the two sides, under it the costs along x, beside it
//! those along y, on the same axes; and what the chances of the two sides come from.

mod held;
mod listed;
mod order;
mod plots;
mod sides;

use glam::Vec2;
use raystep_accel::{Aabb, Axis, Grow, NodeId, Place};

pub use self::held::CutLine;
pub(crate) use self::held::{cut_line, cut_to};
use self::plots::Plot;
pub(crate) use self::sides::Sides;
use super::Ask;
use super::space::space_of_build;
use crate::moments::{Build, GrowMoment, Weighed};
use crate::page::{Anchor, Figure, Ink, Look, block, line, write};
use crate::stage::{Camera, Scenery, crop, stage};
use crate::theme::{Face, Role, text_width};
use crate::words::{Piece, come_out, number};
use crate::world::{Form, Space, SpaceMark};

/// A node that is smaller than this part of the whole box is shown alone.
const SMALL: f32 = 0.35;

/// The most primitives that have a row each in a bar of chances, and a box each in a sorted list.
const ROWS: usize = 15;

/// What is weighed at a step.
#[derive(Clone, Copy)]
struct Candidate {
    node: NodeId,
    axis: Axis,
    plane: f32,
    below: u32,
    above: u32,
    sizes: [f32; 3],
    chances: [f32; 2],
    test: f32,
}

impl Candidate {
    fn of(event: Grow) -> Option<Candidate> {
        let Grow::Weigh {
            node, axis, plane, below, above, size, size_below, size_above, p_below, p_above, test, ..
        } = event
        else {
            return None;
        };
        let (sizes, chances) = ([size, size_below, size_above], [p_below, p_above]);
        Some(Candidate { node, axis: axis.axis()?, plane, below, above, sizes, chances, test })
    }
}

/// The picture. While a question asks for the costs, `hide` shows the planes without them.
pub(crate) fn weighing(build: &Build<'_>, moment: &GrowMoment, ask: &Ask<'_>) -> Figure {
    let Ask { size, ref look, hide, .. } = *ask;
    let mut figure = Figure::new(size);
    let now = moment.event.and_then(Candidate::of);
    let Layout { space, costs, beside, chances } = Layout::of(build, moment, size, look);
    let sides = now.map(|now| Sides::of(build, now.node, now.axis, now.plane, now.below));
    let known = ask.space.cloned().unwrap_or_else(|| space_of_build(build, moment));
    picture(&mut figure, build, moment, known, &space, sides.as_ref().filter(|_| !hide), look);
    let mut plot = Plot { figure: &mut figure, build, moment, look, space: &space, costs, beside, hide };
    plot.draw(now);
    if let (Some(now), false) = (now, hide) {
        let listed = order::Order::of(build, now.node, Axis::X).is_some();
        tags(&mut figure, &space, now, sides.as_ref(), listed, look);
        if chances > 0.0 {
            bars(&mut figure, now, size.y - chances, &space, look);
        }
    }
    figure
}

/// What is still to be weighed for a node: where the marks of the axis stand, before anything is known of them.
fn ahead(build: &Build<'_>, moment: &GrowMoment, node: NodeId) -> Vec<Weighed> {
    let coming = build.events.get(moment.step..).unwrap_or_default().iter();
    let of_node = coming.take_while(|event| event.place() == Place::Node(node));
    let weighed = of_node.filter_map(|event| match *event {
        Grow::Weigh { axis, plane, below, above, cost, .. } => {
            Some(Weighed { axis, plane, below, above, cost, free: None })
        }
        _ => None,
    });
    weighed.collect()
}

/// Where everything stands: fixed, whatever is weighed. Where nothing is, space takes all of it.
struct Layout {
    space: Area,
    /// How high the plot of x is with its list.
    costs: f32,
    /// How wide the plot of y is with its list.
    beside: f32,
    /// How high the bars of the chances are.
    chances: f32,
}

impl Layout {
    fn of(build: &Build<'_>, moment: &GrowMoment, size: Vec2, look: &Look) -> Layout {
        let u = look.text;
        let node = moment.node.and_then(|id| moment.nodes.get_key_value(&id));
        let weighs = !moment.weighed.is_empty() || node.is_some_and(|(id, _)| !ahead(build, moment, *id).is_empty());
        let chances = if weighs && size.y > u * 38.0 { u * 8.2 } else { 0.0 };
        let costs = if weighs { (size.y * 0.27).clamp(u * 8.0, u * 16.0) + u * 3.0 } else { 0.0 };
        let beside = if weighs { (size.x * 0.2).clamp(u * 9.0, u * 15.0) + u * 3.4 } else { 0.0 };
        let (left, top) = (u * 4.6, u * 2.6);
        let room = Vec2::new(size.x - left - beside - u * 2.2, size.y - top - costs - chances - u * 2.6);
        let world = build.nodes.reach();
        let small = |bounds: &Aabb| bounds.extent().length() < SMALL * world.extent().length();
        let alone = node.map(|(_, node)| node.bounds).filter(small);
        let seen = alone.map_or(world, |bounds| bounds.padded(bounds.extent().length() * 0.06));
        let extent = seen.extent().truncate().max(Vec2::splat(1e-6));
        let scale = (room / extent).min_element().max(1e-6);
        let min = Vec2::new(left + (room.x - extent.x * scale) * 0.5, top);
        let max = min + extent * scale;
        Layout { space: Area { min, max, seen }, costs, beside, chances }
    }
}

/// The part of the page that shows space, and what it shows.
struct Area {
    min: Vec2,
    max: Vec2,
    seen: Aabb,
}

impl Area {
    /// Where a coordinate along an axis lies on the page.
    fn at(&self, axis: Axis, value: f32) -> f32 {
        let (low, high) = (self.seen.min[axis], self.seen.max[axis]);
        let share = ((value - low) / (high - low).max(1e-9)).clamp(-0.2, 1.2);
        match axis {
            Axis::Y => self.max.y + (self.min.y - self.max.y) * share,
            _ => self.min.x + (self.max.x - self.min.x) * share,
        }
    }
}

impl Area {
    /// The coordinate along an axis that lies there on the page.
    fn value(&self, axis: Axis, at: f32) -> f32 {
        let (low, high) = (self.seen.min[axis], self.seen.max[axis]);
        let share = match axis {
            Axis::Y => (at - self.max.y) / (self.min.y - self.max.y),
            _ => (at - self.min.x) / (self.max.x - self.min.x),
        };
        low + (high - low) * share
    }

    /// Where a share of the picture's side lies on the page, along an axis.
    fn along(&self, axis: Axis, share: f32) -> f32 {
        match axis {
            Axis::Y => self.max.y + (self.min.y - self.max.y) * share,
            _ => self.min.x + (self.max.x - self.min.x) * share,
        }
    }
}

/// Space: the tree so far and the primitives; where something is weighed, those of the two sides instead of labels.
fn picture(
    figure: &mut Figure,
    build: &Build<'_>,
    moment: &GrowMoment,
    mut space: Space,
    area: &Area,
    sides: Option<&Sides>,
    look: &Look,
) {
    // The plots stand at axes of their own.
    space.marks.retain(|mark| !matches!(mark.form, Form::Axes(_)));
    beside_plots(&mut space, moment);
    if let Some(sides) = sides {
        let place = moment.node.map(Place::Node);
        for (role, bounds) in [(Role::Above, sides.above_box), (Role::Below, sides.below_box)] {
            if !bounds.is_empty() {
                space.marks.push(SpaceMark { form: Form::Box(bounds), role, place });
            }
        }
        let groups = [(Role::Above, &sides.above), (Role::Below, &sides.below)];
        for (role, prim) in groups.into_iter().flat_map(|(role, prims)| prims.iter().map(move |prim| (role, *prim))) {
            space.marks.push(SpaceMark { form: Form::Prim(prim), role, place: Some(Place::Prim(prim)) });
        }
    }

    let margin = 2.0;
    let size = area.max - area.min + 2.0 * margin;
    let center = area.seen.center().truncate();
    let half_height = area.seen.extent().y * 0.5 * size.y / (size.y - 2.0 * margin);
    let camera = Camera::Flat { center, half_height };
    // As large as the words of the plots.
    let scale = look.text / Look::WINDOW.text;
    let mut drawn = stage(&space, build.prims, &camera, size / scale, Scenery::Drawn).scaled(scale);
    // What lies beside a node that is shown alone does not reach into the plots.
    crop(&mut drawn, look.text * 0.8);
    figure.marks.extend(drawn.marks.into_iter().map(|mark| mark.moved(area.min - margin)));
}

/// What the plots show of a weighing, space does not.
pub(crate) fn beside_plots(space: &mut Space, moment: &GrowMoment) {
    if !matches!(moment.event, Some(Grow::Weigh { .. })) {
        return;
    }
    space.marks.retain(|mark| mark.role == Role::Guess || mark.role != Role::Candidate && !is_label(mark));
    // The two sides have tints of their own.
    for mark in space.marks.iter_mut().filter(|mark| mark.role == Role::Here) {
        mark.role = Role::Edge;
    }
}

fn is_label(mark: &SpaceMark) -> bool {
    matches!(mark.form, Form::Label { .. })
}

/// How many lie on the two sides of what is weighed: over a picture that is cut from above, else over and under it.
fn tags(figure: &mut Figure, area: &Area, now: Candidate, sides: Option<&Sides>, listed: bool, look: &Look) {
    let u = look.text;
    let place = Some(Place::Node(now.node));
    let mut tag = |role, at: Vec2, text: String| {
        let (size, face, anchor) = (look.small() + 1.0, Face::Medium, Anchor::Middle);
        figure.add(role, place, Ink::Text { at, text, size, face, anchor, boxed: true });
    };
    let inside = |value: f32, text: &str| {
        let half = text_width(text, Face::Medium, look.small() + 1.0) * 0.5 + u;
        value.clamp(area.min.x + half, (area.max.x - half).max(area.min.x + half))
    };
    let boxes = sides.map_or([Aabb::EMPTY; 2], |sides| [sides.below_box, sides.above_box]);
    let (below, above) = (format!("{} below", now.below), format!("{} above", now.above));
    let middle = |bounds: &Aabb, fallback: f32| {
        if bounds.is_empty() { fallback } else { area.at(Axis::X, bounds.center().x) }
    };
    let y = area.min.y - u * 1.2;
    if now.axis == Axis::X {
        let at = area.at(Axis::X, now.plane);
        let apart = u * 4.0;
        let low = inside(middle(&boxes[0], (area.min.x + at) * 0.5), &below);
        let high = inside(middle(&boxes[1], (area.max.x + at) * 0.5), &above);
        let (low, high) = if high - low < 2.0 * apart {
            let center = (low + high) * 0.5;
            (inside(center - apart, &below), inside(center + apart, &above))
        } else {
            (low, high)
        };
        tag(Role::Below, Vec2::new(low, y), below);
        tag(Role::Above, Vec2::new(high, y), above);
    } else {
        let x = (area.min.x + area.max.x) * 0.5;
        // A list leaves no room under the picture.
        let under = area.max.y + if listed { -u * 1.2 } else { u * 2.0 };
        tag(Role::Below, Vec2::new(x, under), below);
        tag(Role::Above, Vec2::new(x, y), above);
    }
    if let Some(shared) = sides.map(Sides::shared).filter(|shared| *shared > 0) {
        let text = format!("{shared} on both");
        let at = Vec2::new((area.min.x + area.max.x) * 0.5, area.min.y + u * 1.4);
        tag(Role::Text, at, text);
    }
}

/// What the two chances are: a side's bar is as long as its perimeter, against the node's; it has a row for each
/// primitive, so its area says how many tests are to be expected.
fn bars(figure: &mut Figure, now: Candidate, top: f32, area: &Area, look: &Look) {
    let (u, small) = (look.text, look.small());
    let [whole, below, above] = now.sizes;
    // The names of both sides stand before their bars.
    let names = text_width("p above", Face::Medium, small);
    let (left, right) = (area.min.x.min(u * 6.0).max(look.margin() + names + u * 0.6), area.max.x);
    figure.add(Role::Panel, None, line(Vec2::new(0.0, top), Vec2::new(figure.size.x, top)));
    let y = top + u * 1.1;
    let title = "Chances";
    write(figure, Role::Text, None, Vec2::new(look.margin(), y), title, small, Face::Bold, Anchor::Start);
    let long = "length: perimeter · rows: primitives · area: tests to expect";
    let short = "length: perimeter · area: tests to expect";
    let room = right - look.margin() - text_width(title, Face::Bold, small) - u;
    let says = if text_width(long, Face::Regular, small) <= room { long } else { short };
    let at = Vec2::new(look.margin() + text_width(title, Face::Bold, small) + u, y);
    write(figure, Role::Quiet, None, at, says, small, Face::Regular, Anchor::Start);
    let at = Vec2::new(right + u * 1.2, y);
    let says = format!("node {}: {}", now.node.0, number(whole));
    write(figure, Role::Quiet, None, at, &says, small, Face::Regular, Anchor::Start);
    let end = Vec2::new(right, top + u * 2.0);
    figure.add(Role::Hidden, None, line(end, end + Vec2::new(0.0, u * 5.6)));
    let place = Some(Place::Node(now.node));
    let rows = |count: u32| (count as f32).min(ROWS as f32) / (now.below.max(now.above) as f32).clamp(1.0, ROWS as f32);
    let exact = |x: f32| Piece::Number { x, bracketed: false };
    let equals = || Piece::Text(" = ".to_owned());
    let sides = [
        (Role::Below, "p below", below, now.below, now.chances[0]),
        (Role::Above, "p above", above, now.above, now.chances[1]),
    ];
    for (index, (role, name, size, count, chance)) in sides.into_iter().enumerate() {
        let y = top + u * (3.3 + 2.9 * index as f32);
        let name_at = Vec2::new(left - u * 0.6, y);
        write(figure, role, None, name_at, name, small, Face::Medium, Anchor::End);
        let height = (u * 2.4 * rows(count)).max(2.0);
        let length = (right - left) * (size / whole.max(1e-9)).min(1.0);
        figure.add(role, place, block(Vec2::new(left, y - height * 0.5), Vec2::new(length, height), 0.0));
        for row in 1..count.min(ROWS as u32) {
            let at = Vec2::new(left, y - height * 0.5 + height * row as f32 / count.min(ROWS as u32) as f32);
            figure.add(Role::Hidden, None, line(at, at + Vec2::new(length, 0.0)));
        }
        let says =
            come_out(&[Piece::Text(format!("{count} · ")), exact(chance), equals(), exact(count as f32 * chance)]);
        let (at, size_of, face) = (Vec2::new(left + u * 0.8, y), small, Face::Mono);
        figure.add(role, place, Ink::Text { at, text: says, size: size_of, face, anchor: Anchor::Start, boxed: true });
        let says = come_out(&[exact(size), Piece::Text(" / ".to_owned()), exact(whole), equals(), exact(chance)]);
        write(figure, Role::Text, place, Vec2::new(right + u * 1.2, y), &says, small, Face::Mono, Anchor::Start);
    }
}
