//! The walk.

use std::cell::RefCell;

use raystep_accel::{Aabb, Hit, Interval, Place, Ray, Want, slab};

use super::node::Node;
use crate::judge::{Count, Nearest, NotOrdinary, Shot};
use crate::lanes::stamped;
use crate::leaf::Four;

/// What waits: nodes, and the parts of the ray in them.
pub(super) struct Stack([(u32, Interval); HIGH]);

/// No kd-tree of the textbook is deeper.
const HIGH: usize = 64;

thread_local! {
    pub(super) static STACK: RefCell<Stack> =
        const { RefCell::new(Stack([(0, Interval { near: 0.0, far: 0.0 }); HIGH])) };
}

macro_rules! walk {
    ($(#[$features:meta])* $isa:ident) => {
        use super::*;
        use crate::leaf::$isa as leaf;

        /// Walks an ordinary ray.
        $(#[$features])*
        pub(in crate::kd) fn walk(
            nodes: &[Node],
            leaves: &[Four],
            bounds: &Aabb,
            ray: &Ray,
            reach: f32,
            want: Want,
            stack: &mut Stack,
            count: &mut impl Count,
        ) -> Result<Option<Hit>, NotOrdinary> {
            let shot = &Shot::new(ray, reach)?;
            let mut best = Nearest::before(ray.t_max);
            let mut live = slab(bounds, ray, ray.range(), Place::World, &mut ());
            if live.is_empty() || bounds.is_empty() {
                return Ok(None);
            }
            let (mut here, mut high) = (0u32, 0usize);
            'walk: loop {
                let node = nodes[here as usize];
                if let Some(axis) = node.axis() {
                    // Where the ray meets the plane: not before the one, not after the other.
                    let (first, last) = (
                        node.plane() * shot.r[axis] + shot.enter[axis],
                        node.plane() * shot.r[axis] + shot.leave[axis],
                    );
                    count.node(1);
                    let below = node.below();
                    let (near, far) = if shot.down[axis] { (below + 1, below) } else { (below, below + 1) };
                    if last < live.near {
                        here = far;
                    } else if first > live.far {
                        here = near;
                    } else {
                        // Both: the far child waits.
                        let begin = if first > live.near { first } else { live.near };
                        stack.0[high % HIGH] = (far, Interval { near: begin, far: live.far });
                        high += 1;
                        here = near;
                        live.far = if last < live.far { last } else { live.far };
                    }
                    continue;
                }
                for four in &leaves[node.fours()] {
                    leaf::meet(four, shot, &mut best, count);
                }
                if want == Want::Any && best.is_some() {
                    break;
                }
                // Take the next node from the stack that may hold something nearer.
                loop {
                    if high == 0 {
                        break 'walk;
                    }
                    high -= 1;
                    (here, live) = stack.0[high % HIGH];
                    if live.near <= best.t {
                        break;
                    }
                }
            }
            Ok(best.hit())
        }
    };
}

stamped!(walk);
