//! What a structure looks like in memory: the corners of a box, slide 12, a node of a kd-tree, slides 60-62, or the table
//! of a hashed grid, slide 63.

mod corners;
mod hash;
mod kd;
mod lines;

use glam::Vec2;
use raystep_accel::Structure;

use crate::moments::{Moment, Walk};
use crate::page::{Figure, Look};

/// The node where the walk stands in each of four layouts, and the cache lines that the ray has touched so far; of a
/// hashed grid its table, with the slots that were looked at; of a single box its two corners. While a question asks
/// what stands there, `hide` leaves it out.
pub fn bytes(walk: &Walk<'_>, moment: &Moment, hide: bool, size: Vec2, look: &Look) -> Figure {
    match walk.structure {
        Structure::Kd(tree) => kd::node(tree, walk, moment, hide, size, look),
        Structure::HashedGrid(grid) => hash::table(grid, walk, moment, hide, size, look),
        Structure::Slab(one) => {
            let done = walk.events.get(..moment.step).unwrap_or(walk.events);
            corners::box_bytes(&one.bounds, done, hide, size, look)
        }
        _ => {
            let mut figure = Figure::new(size);
            let says = "Only a box, nodes of a kd-tree and slots of a hashed grid are shown as bytes.";
            look.nothing(&mut figure, "Bytes", says);
            figure
        }
    }
}

/// How high the pane should be; nothing for what is not shown as bytes.
pub(crate) fn bytes_height(walk: &Walk<'_>, look: &Look) -> Option<f32> {
    let heading = if look.titles { look.text * 2.2 } else { 0.0 };
    match walk.structure {
        Structure::Kd(_) => Some(heading + kd::height(walk.layout, look)),
        Structure::HashedGrid(grid) => Some(heading + hash::height(grid, look)),
        _ => None,
    }
}
