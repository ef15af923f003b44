//! The walk.

use std::cell::RefCell;

use raystep_accel::{Hit, Place, Ray, Want, slab};

use super::node::{LEAF, Node, octant};
use crate::fast::Question;
use crate::judge::{Count, Nearest, NotOrdinary, Shot, careful as judge};
use crate::lanes::stamped;
use crate::leaf::Four;

/// Room for seven children of each level of the deepest tree, and for a node's eight.
pub(super) type Stack = crate::stack::Stack<1024>;

thread_local! {
    pub(super) static STACK: RefCell<Stack> = const { RefCell::new(Stack::EMPTY) };
}

macro_rules! walk {
    ($(#[$features:meta])* $isa:ident) => {
        use super::*;
        use crate::lanes::$isa::*;
        use crate::leaf::$isa as leaf;

        /// Walks rays one after the other, up to the first that is not an ordinary one; how many that are.
        $(#[$features])*
        pub(in crate::bvh8) fn walk_some<T>(
            nodes: &[Node],
            leaves: &[Four],
            rays: &[Ray],
            answers: &mut [T],
            reach: f32,
            question: impl Question<T>,
            stack: &mut Stack,
        ) -> usize {
            for (at, (ray, answer)) in rays.iter().zip(answers).enumerate() {
                let walked = match question.want() {
                    Want::Nearest => walk::<false>(nodes, leaves, ray, reach, stack, &mut ()),
                    Want::Any => walk::<true>(nodes, leaves, ray, reach, stack, &mut ()),
                };
                match walked {
                    Ok(found) => *answer = question.answer(found),
                    Err(NotOrdinary) => return at,
                }
            }
            rays.len()
        }

        /// Walks an ordinary ray to its nearest hit, or to any.
        $(#[$features])*
        #[inline]
        pub(in crate::bvh8) fn walk<const ANY: bool>(
            nodes: &[Node],
            leaves: &[Four],
            ray: &Ray,
            reach: f32,
            stack: &mut Stack,
            count: &mut impl Count,
        ) -> Result<Option<Hit>, NotOrdinary> {
            let shot = &Shot::new(ray, reach)?;
            let mut best = Nearest::before(shot.ray.t_max);
            let [r_x, r_y, r_z] = splats8(shot.r);
            let [enter_x, enter_y, enter_z] = splats8(shot.enter);
            let [leave_x, leave_y, leave_z] = splats8(shot.leave);
            // In which rows the planes stand through which the ray enters slabs; the next but for the last bit, those
            // through which it leaves them.
            let [down_x, down_y, down_z] = shot.down.map(usize::from);
            let (row_x, row_y, row_z) = (down_x, 2 + down_y, 4 + down_z);
            let (octant, turned) = octant(shot.down);
            let t_min = splat8(shot.ray.t_min);
            let mut t_max = splat8(best.t);
            let (mut here, mut high) = (0u32, 0usize);
            'walk: loop {
                // Down to a leaf, the nearest child first.
                while here & LEAF == 0 {
                    let node = &nodes[here as usize];
                    count.node(8);
                    let near_x = add_product8(load8(&node.planes[row_x]), r_x, enter_x);
                    let near_y = add_product8(load8(&node.planes[row_y]), r_y, enter_y);
                    let near_z = add_product8(load8(&node.planes[row_z]), r_z, enter_z);
                    let far_x = add_product8(load8(&node.planes[row_x ^ 1]), r_x, leave_x);
                    let far_y = add_product8(load8(&node.planes[row_y ^ 1]), r_y, leave_y);
                    let far_z = add_product8(load8(&node.planes[row_z ^ 1]), r_z, leave_z);
                    let near = max8(max8(near_x, near_y), max8(near_z, t_min));
                    let far = min8(min8(far_x, far_y), min8(far_z, t_max));
                    let met = at_most8(near, far);
                    let others = met & met.wrapping_sub(1);
                    if others == 0 && met != 0 {
                        here = node.child(met.trailing_zeros());
                    } else if others != 0 {
                        let nears = array8(near);
                        let (first, last) = (met.trailing_zeros(), 31 ^ met.leading_zeros());
                        if others & (others - 1) == 0 {
                            // Two: the nearer one is next, the other one waits.
                            let is_behind = node.before(octant, turned, first) >> last & 1 == 1;
                            let (next, waits) = if is_behind { (last, first) } else { (first, last) };
                            here = node.child(next);
                            stack.put(high, node.child(waits), nears[waits as usize & 7]);
                            high += 1;
                        } else {
                            // Several: each waits where its rank puts it, the nearest at the top; and that is next.
                            high += met.count_ones() as usize - 1;
                            let mut left = met;
                            while left != 0 {
                                let lane = left.trailing_zeros();
                                left &= left - 1;
                                let before = node.before(octant, turned, lane) & met & !(1 << lane);
                                let place = high - before.count_ones() as usize;
                                stack.put(place, node.child(lane), nears[lane as usize & 7]);
                            }
                            here = stack.child(high);
                        }
                    } else {
                        // Take the next child from the stack that may hold something nearer.
                        let Some(next) = stack.take(&mut high, best.t) else { break 'walk };
                        here = next;
                    }
                }
                leaf::meet(&leaves[(here & !LEAF) as usize], shot, &mut best, count);
                if ANY && best.is_some() {
                    break;
                }
                t_max = splat8(best.t);
                let Some(next) = stack.take(&mut high, best.t) else { break };
                here = next;
            }
            Ok(best.hit())
        }
    };
}

stamped!(walk);

/// Walks any ray, with the textbook's own tests.
pub(super) fn careful(nodes: &[Node], leaves: &[Four], ray: &Ray, want: Want, count: &mut impl Count) -> Option<Hit> {
    let mut best = Nearest::before(ray.t_max);
    let mut waiting = vec![0];
    while let Some(child) = waiting.pop() {
        if child & LEAF != 0 {
            let four = &leaves[(child & !LEAF) as usize];
            count.triangles(four.count());
            for lane in 0..four.count() as usize {
                judge(four.triangle(lane), four.prim(lane), ray, &mut best);
            }
            if want == Want::Any && best.is_some() {
                break;
            }
            continue;
        }
        let node = &nodes[child as usize];
        count.node(8);
        let mut met = Vec::new();
        for lane in 0..node.count() {
            let bounds = node.bounds(lane);
            let within = slab(&bounds, ray, ray.range(), Place::World, &mut ());
            if !within.is_empty() && within.near <= best.t {
                met.push((within.near, node.child(lane as u32)));
            }
        }
        // The nearest last, as it is taken first.
        met.sort_by(|a, b| b.0.total_cmp(&a.0));
        waiting.extend(met.into_iter().map(|(_, child)| child));
    }
    best.hit()
}
