//! The walk.

use std::cell::RefCell;

use raystep_accel::{Hit, Place, Ray, Want, slab};

use super::node::{Child, Node};
use crate::fast::Question;
use crate::judge::{Count, Nearest, NotOrdinary, Shot, careful as judge};
use crate::lanes::stamped;
use crate::leaf::Four;

/// Room for more than the levels of any tree: no tree is deeper than it is high.
pub(super) type Stack = crate::stack::Stack<128>;

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
        pub(in crate::bvh2) fn walk_some<T>(
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

        /// Walks an ordinary ray.
        $(#[$features])*
        #[inline]
        pub(in crate::bvh2) fn walk<const ANY: bool>(
            nodes: &[Node],
            leaves: &[Four],
            ray: &Ray,
            reach: f32,
            stack: &mut Stack,
            count: &mut impl Count,
        ) -> Result<Option<Hit>, NotOrdinary> {
            let shot = &Shot::new(ray, reach)?;
            let mut best = Nearest::before(shot.ray.t_max);
            // Lanes 0 and 1 say where the ray enters the left and the right child; lanes 2 and 3, where it leaves them,
            // with the sign turned, so that one maximum narrows both ends.
            let turned = |r: f32| load4(&[r, r, -r, -r]);
            let (r_x, r_y, r_z) = (turned(shot.r[0]), turned(shot.r[1]), turned(shot.r[2]));
            let ends = |axis: usize| load4(&[shot.enter[axis], shot.enter[axis], -shot.leave[axis], -shot.leave[axis]]);
            let (n_x, n_y, n_z) = (ends(0), ends(1), ends(2));
            let (turn_x, turn_y, turn_z) = (turn4(shot.down[0]), turn4(shot.down[1]), turn4(shot.down[2]));
            let t_min = shot.ray.t_min;
            let mut range = load4(&[t_min, t_min, -best.t, -best.t]);
            let (mut here, mut high) = (Child::ROOT, 0usize);
            'walk: loop {
                // Down to a leaf, the nearer child first.
                while !here.is_leaf() {
                    let node = &nodes[here.index()];
                    count.node(2);
                    let x = add_product4(turned4(load4(&node.planes[0]), turn_x), r_x, n_x);
                    let y = add_product4(turned4(load4(&node.planes[1]), turn_y), r_y, n_y);
                    let z = add_product4(turned4(load4(&node.planes[2]), turn_z), r_z, n_z);
                    let within = max4(max4(x, y), max4(z, range));
                    let far = negated4(upper4(within));
                    let met = at_most4(within, far) & 3;
                    let near = array4(within);
                    let middle = array4(add4(within, far));
                    let [left, right] = node.children;
                    if met == 3 {
                        // By the middles of the ways through both: boxes often begin at the same plane.
                        let right_first = middle[1] < middle[0];
                        let (first, second) = if right_first { (right, left) } else { (left, right) };
                        stack.put(high, second.number(), if right_first { near[0] } else { near[1] });
                        high += 1;
                        here = first;
                    } else if met == 0 {
                        // Take the next node from the stack that may hold something nearer.
                        let Some(next) = stack.take(&mut high, best.t) else { break 'walk };
                        here = Child::numbered(next);
                    } else {
                        here = if met == 1 { left } else { right };
                    }
                }
                leaf::meet(&leaves[here.index()], shot, &mut best, count);
                if ANY && best.is_some() {
                    break;
                }
                range = load4(&[t_min, t_min, -best.t, -best.t]);
                let Some(next) = stack.take(&mut high, best.t) else { break };
                here = Child::numbered(next);
            }
            Ok(best.hit())
        }
    };
}

stamped!(walk);

/// Walks any ray, with the textbook's own tests.
pub(super) fn careful(nodes: &[Node], leaves: &[Four], ray: &Ray, want: Want, count: &mut impl Count) -> Option<Hit> {
    let mut best = Nearest::before(ray.t_max);
    let mut waiting = vec![Child::ROOT];
    while let Some(here) = waiting.pop() {
        if here.is_leaf() {
            let four = &leaves[here.index()];
            count.triangles(four.count());
            for lane in 0..four.count() as usize {
                judge(four.triangle(lane), four.prim(lane), ray, &mut best);
            }
            if want == Want::Any && best.is_some() {
                break;
            }
            continue;
        }
        let node = &nodes[here.index()];
        count.node(2);
        let mut met = [0, 1].map(|side| {
            let bounds = node.bounds(side);
            let within =
                if bounds.is_empty() { ray.range() } else { slab(&bounds, ray, ray.range(), Place::World, &mut ()) };
            let is_met = !bounds.is_empty() && !within.is_empty() && within.near <= best.t;
            (is_met, within.near, node.children[side])
        });
        // The nearer one last, as it is taken first.
        if met[0].1 < met[1].1 {
            met.swap(0, 1);
        }
        waiting.extend(met.iter().filter(|(is_met, ..)| *is_met).map(|(.., child)| *child));
    }
    best.hit()
}
