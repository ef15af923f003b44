//! What an event of a walk says, in plain words.

use raystep_accel::{Ending, Place, Probed, Side, Verdict, Visit};

use super::{cells, count};
use crate::words::{VolumeName, coordinate, number};

/// One sentence about what just happened, with its numbers.
pub(crate) fn of_visit(event: &Visit, volume: VolumeName) -> String {
    let range = |near: f32, far: f32| format!("[{}, {}]", number(near), number(far));
    match *event {
        Visit::Parallel { place, axis, o, low, high, inside } => {
            let verdict = if inside { "so it is inside for ever" } else { "so it never gets inside" };
            let side = if inside { "between" } else { "not between" };
            format!(
                "The ray runs parallel to the {axis} slab of {place}: {axis} = {} lies {side} {} and {}, {verdict}.",
                number(o),
                number(low),
                number(high)
            )
        }
        Visit::Divide { place, axis, low, high, t1, t2, .. } => format!(
            "The {axis} slab of {place}: the ray meets {axis} = {} at t = {} and {axis} = {} at t = {}.",
            number(low),
            number(t1),
            number(high),
            number(t2)
        ),
        Visit::Order { axis, t1, t2, swapped: true, .. } => {
            format!(
                "The ray runs down the {axis} axis: swapped, it enters at t = {} and leaves at t = {}.",
                number(t1),
                number(t2)
            )
        }
        Visit::Order { axis, t1, t2, .. } => {
            format!("In {axis} the ray enters at t = {} and leaves at t = {}: no swap needed.", number(t1), number(t2))
        }
        Visit::Narrow { axis, t_near, t_far, empty: true, .. } => format!(
            "The {axis} slab leaves nothing: the latest entry, {}, comes after the earliest exit, {}.",
            number(t_near),
            number(t_far)
        ),
        Visit::Narrow { axis, t_near, t_far, .. } => format!("The {axis} slab leaves {}.", range(t_near, t_far)),
        Visit::Roots { place, discriminant, .. } if discriminant < 0.0 => {
            format!(
                "The equation of {place} and the ray has no solution: under the root stands {}.",
                number(discriminant)
            )
        }
        Visit::Roots { place, t1, t2, t_near, t_far, empty, .. } => format!(
            "The ray enters the sphere of {place} at t = {} and leaves it at t = {}: {} is left.",
            number(t1),
            number(t2),
            if empty { "nothing".to_owned() } else { range(t_near, t_far) }
        ),
        Visit::Clip { face, d: 0.0, empty, .. } => {
            format!("The ray runs along face {face} of the hull, {} it.", if empty { "before" } else { "behind" })
        }
        Visit::Clip { face, t, entering, t_near, t_far, empty, .. } => format!(
            "The ray {} through the plane of face {face} at t = {}: {} is left.",
            if entering { "comes in" } else { "goes out" },
            number(t),
            if empty { "nothing".to_owned() } else { range(t_near, t_far) }
        ),
        Visit::Volume { place, t_near, t_far, verdict: Verdict::Hit, .. } => {
            format!("The ray lies in {place} for {}.", range(t_near, t_far))
        }
        Visit::Volume { place, verdict: Verdict::Miss, .. } => format!("The ray misses {place}."),
        Visit::Volume { place, t_near, best_t, verdict: Verdict::Cut, .. } => format!(
            "The ray enters {place} at t = {}, behind the best hit at t = {}: no need to look.",
            number(t_near),
            number(best_t)
        ),
        Visit::Enter { place, t_near, t_far, prims, leaf } => {
            let kind = match place {
                Place::Node(_) if leaf => ", a leaf",
                _ => "",
            };
            let holds = match prims {
                _ if !leaf && matches!(place, Place::Cell(_)) => " It holds a grid of its own.".to_owned(),
                0 if leaf => " It is empty.".to_owned(),
                0 => String::new(),
                n => format!(" It holds {}.", count(n, "primitive")),
            };
            format!("The walk enters {place}{kind}, with {}.{holds}", range(t_near, t_far))
        }
        Visit::Plane { axis, plane, d: 0.0, .. } => {
            let across = coordinate(axis);
            format!("The ray runs parallel to the plane {across} = {} and never crosses it.", number(plane))
        }
        Visit::Plane { axis, plane, t, t_near, t_far, .. } => {
            let side = if t < t_near {
                "before"
            } else if t > t_far {
                "behind"
            } else {
                "inside"
            };
            format!(
                "The plane {} = {} cuts the ray at t = {}, {side} {}.",
                coordinate(axis),
                number(plane),
                number(t),
                range(t_near, t_far)
            )
        }
        Visit::Split { near, far, side: Side::Both, .. } => {
            format!("Both children are met: node {near} first, node {far} after it.")
        }
        Visit::Split { near, far, side: Side::Near, .. } => {
            format!("Only the near child, node {near}, is met; node {far} is left out.")
        }
        Visit::Split { near, far, side: Side::Far, .. } => {
            format!("Only the far child, node {far}, is met; node {near} is left out.")
        }
        Visit::Push { node, t_near, t_far, depth } => {
            format!("Node {node} waits with {}; {} on the stack.", range(t_near, t_far), count(depth, "node"))
        }
        Visit::Pop { node, t_near, t_far, depth } => {
            let still = if depth == 1 { "waits" } else { "wait" };
            format!("Node {node} is taken from the stack with {}; {depth} still {still}.", range(t_near, t_far))
        }
        Visit::Drop { node, t_near, best_t, .. } => format!(
            "Node {node} begins at t = {}, behind the best hit at t = {}: it is dropped.",
            number(t_near),
            number(best_t)
        ),
        Visit::Step { cell, axis, t, inside: true, .. } => {
            format!("The next {axis} plane comes first, at t = {}: out of cell {cell} over its {axis} face.", number(t))
        }
        Visit::Step { axis, t, .. } => {
            format!("The next {axis} plane comes first, at t = {}: the walk leaves the grid.", number(t))
        }
        Visit::Descend { cell, nx, ny, nz, t_near, t_far } => {
            format!(
                "The walk goes down into the grid of {} cells inside cell {cell}, for {}.",
                cells(nx, ny, nz),
                range(t_near, t_far)
            )
        }
        Visit::Ascend { cell, t_far, .. } => format!(
            "The grid inside cell {cell} is crossed. Back in the cell, the next planes are where they were: it ends at t = {}.",
            number(t_far)
        ),
        Visit::Probe { cell, slot, holds } => {
            let result = match holds {
                Probed::Found => "it is there",
                Probed::Empty => "the slot is free, so the cell is empty",
                Probed::Taken => "another cell sits there, so the next slot is tried",
            };
            format!("Cell {cell} is looked up in slot {slot}: {result}.")
        }
        Visit::Skip { prim } => format!("The ray has tested primitive {prim} already: its mailbox saves the test."),
        Visit::Test { prim, t, hit: true } => format!("The ray hits primitive {prim} at t = {}.", number(t)),
        Visit::Test { prim, .. } => format!("The ray misses primitive {prim}."),
        Visit::Better { prim, t, before } if before.is_infinite() => {
            format!("Primitive {prim} at t = {} is the first hit, and so the best.", number(t))
        }
        Visit::Better { prim, t, before } => {
            format!("Primitive {prim} at t = {} is nearer than {}: the new best.", number(t), number(before))
        }
        Visit::Beyond { cell, t, t_far } => format!(
            "The hit at t = {} lies beyond cell {cell}, which ends at t = {}: the walk may not stop yet.",
            number(t),
            number(t_far)
        ),
        Visit::Local { instance, t_near, t_far, .. } => format!(
            "The ray is moved into the space of instance {instance}; it walks the model stored there from t = {} to {}.",
            number(t_near),
            number(t_far)
        ),
        Visit::World { instance, t, hit: true } => format!(
            "Back in the world: instance {instance} is hit, and t = {} means the same point in both spaces.",
            number(t)
        ),
        Visit::World { instance, .. } => format!("Back in the world: the ray misses what instance {instance} places."),
        Visit::Distant { reach } => {
            format!("The ray starts further away than {}: every primitive is tested instead.", number(reach))
        }
        Visit::Extreme { length, shortest, longest } => format!(
            "The largest component of the ray's direction, {}, is not between {} and {}: every primitive is tested instead.",
            number(length),
            number(shortest),
            number(longest)
        ),
        Visit::End { why: Ending::Outside, .. } => {
            format!("The ray does not meet the {}: nothing is hit.", volume.one)
        }
        Visit::End { why: Ending::Found, t, .. } => format!("Something is hit, at t = {}: that is enough.", number(t)),
        Visit::End { why: Ending::Settled, t, .. } => {
            format!("The hit at t = {} lies before everything that is left: the walk is over.", number(t))
        }
        Visit::End { hit: true, t, .. } => {
            format!("Nothing is left to visit: the nearest hit is at t = {}.", number(t))
        }
        Visit::End { .. } => "Nothing is left to visit: the ray hits nothing.".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use raystep_accel::{Axis, CellId, NodeId, PrimId};

    use super::*;

    const BOX: VolumeName = VolumeName { one: "box", many: "boxes", cut: "plane" };

    #[test]
    fn events_in_words() {
        let node = NodeId(1);
        let events = [
            Visit::Plane {
                node,
                axis: Axis::Y.into(),
                plane: 2.02,
                o: 0.53,
                d: 0.407,
                t: 3.66,
                t_near: 0.328,
                t_far: 5.14,
            },
            Visit::Split {
                node,
                near: NodeId(2),
                far: NodeId(5),
                t: 3.66,
                t_near: 0.328,
                t_far: 5.14,
                side: Side::Both,
            },
            Visit::Push { node: NodeId(5), t_near: 3.66, t_far: 5.14, depth: 2 },
            Visit::Enter { place: Place::Node(NodeId(2)), t_near: 0.328, t_far: 3.66, prims: 1, leaf: true },
            Visit::Pop { node: NodeId(5), t_near: 3.66, t_far: 5.14, depth: 1 },
            Visit::Test { prim: PrimId(4), t: f32::INFINITY, hit: false },
            Visit::Better { prim: PrimId(7), t: 4.2, before: f32::INFINITY },
            Visit::Beyond { cell: CellId(12), t: 4.2, t_far: 3.9 },
            Visit::Narrow {
                place: Place::World,
                axis: Axis::X.into(),
                t1: 1.0,
                t2: 2.0,
                t_near: 3.0,
                t_far: 2.0,
                empty: true,
            },
            Visit::End { why: Ending::Settled, hit: true, t: 4.2 },
        ];
        let lines: Vec<String> = events.iter().map(|event| of_visit(event, BOX)).collect();
        insta::assert_snapshot!(lines.join("\n"));
    }
}
