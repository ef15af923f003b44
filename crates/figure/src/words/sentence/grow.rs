//! What an event of a build says, in plain words.

use raystep_accel::{Grow, LeafReason, Place};

use super::{cells, count};
use crate::words::{VolumeName, coordinate, number};

/// One sentence about what just happened, with its numbers.
pub(crate) fn of_grow(event: &Grow, volume: VolumeName) -> String {
    let shares = volume.cut == "way";
    match *event {
        Grow::Widen { prim, grown: true, .. } => format!("The box grows until it holds primitive {prim}."),
        Grow::Widen { prim, .. } => format!("Primitive {prim} lies in the box already."),
        Grow::Refine { cell, nx, ny, nz, prims, .. } => {
            format!(
                "Cell {cell} is crowded, with {}: they go into a grid of its own, of {} cells.",
                count(prims, "primitive"),
                cells(nx, ny, nz)
            )
        }
        Grow::Resolve { nx, ny, nz, prims, .. } => {
            format!("{} get a grid of {} cells.", count(prims, "primitive"), cells(nx, ny, nz))
        }
        Grow::Rasterise { prim, cell } => format!("The box of primitive {prim} meets cell {cell}."),
        Grow::Prune { prim, cell } => {
            format!("Primitive {prim} itself does not reach into cell {cell}: no reference is stored.")
        }
        Grow::Open { node, prims, depth, .. } => {
            format!("Node {node} comes to be at depth {depth}, with {}.", count(prims, "primitive"))
        }
        Grow::Normal { normal_x, normal_y, normal_z, plane, from, .. } => {
            let who = match from {
                Place::Prim(prim) => format!("Primitive {prim} proposes"),
                _ => "The set of directions offers".to_owned(),
            };
            let normal = [normal_x, normal_y, normal_z].map(number).join(", ");
            format!("{who} the plane n · p = {} with n = ({normal}).", number(plane))
        }
        Grow::Weigh { axis, below, above, cost, .. } if shares => format!(
            "Along {axis} the first {below} would go to one child, the other {above} to the other: cost {}.",
            number(cost)
        ),
        Grow::Weigh { axis, plane, below, above, cost, .. } => format!(
            "The plane {} = {} leaves {below} below and {above} above: cost {}.",
            coordinate(axis),
            number(plane),
            number(cost)
        ),
        Grow::Split { node, axis, plane, below, above, .. } if shares => format!(
            "The primitives of node {node} are shared out along {axis}: those with their centre before {} go to node {below}, the others to node {above}.",
            number(plane)
        ),
        Grow::Split { node, axis, plane, below, above, .. } => {
            let across = coordinate(axis);
            format!("Node {node} is cut at {across} = {}: node {below} lies below, node {above} above.", number(plane))
        }
        Grow::Share { prim, .. } => format!("Primitive {prim} lies on both sides: both children refer to it."),
        Grow::Divide { node, first, ways, .. } => {
            format!("Node {node} is cut into {ways} equal cells, nodes {first} to {}.", first.0 + ways - 1)
        }
        Grow::Touch { node } => format!("Node {node} is looked at."),
        Grow::Leaf { node, prims, why } => {
            let why = match why {
                LeafReason::Few => "that is few enough",
                LeafReason::Deep => "the tree may not become deeper",
                LeafReason::Cheap => "nothing that was weighed costs less than testing them all",
                LeafReason::Inseparable => "nothing separates them",
                LeafReason::Crowded => "the tree refers to its primitives often enough",
            };
            format!("Node {node} stays a leaf with {}: {why}.", count(prims, "primitive"))
        }
        Grow::Settle { prim, place: Place::Cell(cell) } => {
            format!("Primitive {prim} reaches into cell {cell}: the cell stores a reference.")
        }
        Grow::Settle { prim, place } => format!("A reference to primitive {prim} is stored in {place}."),
        Grow::Remove { prim, place } => format!("The reference to primitive {prim} is removed from {place}."),
        Grow::Rank { node, rank, first, second, third, .. } => {
            format!("The code of node {node} begins {first}{second}{third}: it is number {} on the curve.", rank + 1)
        }
        Grow::Prefer { node, nearest } => {
            format!("Of its neighbours on the curve node {node} has the smallest common volume with node {nearest}.")
        }
        Grow::Merge { node, left, right, .. } => {
            format!("Nodes {left} and {right} become the children of node {node}.")
        }
        Grow::Move { node, parent, .. } => format!("Node {node} moves under node {parent}."),
        Grow::Refit { node, .. } => format!("The volume of node {node} is fitted to what lies below it now."),
        Grow::Renumber { to, .. } => format!("Node {to} is laid where it stays."),
        Grow::End { nodes: 0, cells, references } => {
            format!("The grid is built: {} with {}.", count(cells, "cell"), count(references, "reference"))
        }
        Grow::End { nodes, references, .. } => {
            format!("The tree is built: {} and {}.", count(nodes, "node"), count(references, "reference"))
        }
    }
}
