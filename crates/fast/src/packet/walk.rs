//! The walk of a packet.

use std::array::from_fn;
use std::cell::RefCell;

use bytemuck::cast_ref;
use raystep_accel::Ray;

use super::beam::{Beam, Found};
use crate::bvh8::{LEAF, Node, octant};
use crate::judge::{BOX, Count, NONE, ORDINARY, POWER_30, STRAIGHT};
use crate::lanes::stamped;
use crate::leaf::Four;

/// Room for seven children of each level of the deepest tree.
pub(super) type Stack = crate::stack::Stack<1024>;

thread_local! {
    pub(super) static STACK: RefCell<Stack> = const { RefCell::new(Stack::EMPTY) };
}

macro_rules! walk {
    ($(#[$features:meta])* $isa:ident) => {
        use super::*;
        use crate::lanes::$isa::*;
        use crate::packet::meet::$isa as leaf;

        /// Makes a packet ready in `beam`, if its rays run alike.
        $(#[$features])*
        #[inline]
        fn beam<const G: usize>(rays: &[Ray], reach: f32, beam: &mut Beam<G>) -> bool {
            if rays.len() != 8 * G {
                return false;
            }
            let first = &rays[0];
            let o = first.o.to_array();
            let reach = o.iter().fold(reach, |reach, o| reach.max(o.abs()));
            if !ORDINARY.contains(&reach) {
                return false;
            }
            let all = (1u32 << 8) - 1;
            let down = first.d.to_array().map(f32::is_sign_negative);
            let size = first.d.abs();
            let axes = if size.x >= size.y && size.x >= size.z {
                [1, 2, 0]
            } else if size.y >= size.z {
                [2, 0, 1]
            } else {
                [0, 1, 2]
            };
            (beam.o, beam.down, beam.axes) = (o, down, axes);
            let mut alike = true;
            let mut low = [splat8(f32::INFINITY); 3];
            let mut high = [splat8(f32::NEG_INFINITY); 3];
            let mut longest = splat8(0.0);
            let mut shortest = splat8(f32::INFINITY);
            for group in 0..G {
                let Some(eight) = rays[8 * group..].first_chunk::<8>() else { return false };
                alike &= eight.iter().all(|ray| ray.o.to_array().map(f32::to_bits) == o.map(f32::to_bits));
                let d: [[f32; 8]; 3] = [
                    from_fn(|i| eight[i].d.x),
                    from_fn(|i| eight[i].d.y),
                    from_fn(|i| eight[i].d.z),
                ];
                beam.t_min[group] = from_fn(|i| eight[i].t_min);
                let [x, y, z] = [load8(&d[0]), load8(&d[1]), load8(&d[2])];
                let [sx, sy, sz] = [abs8(x), abs8(y), abs8(z)];
                let size = max8(max8(sx, sy), sz);
                alike &= minus8(x) == if down[0] { all } else { 0 };
                alike &= minus8(y) == if down[1] { all } else { 0 };
                alike &= minus8(z) == if down[2] { all } else { 0 };
                // The same largest axis; of equals the first.
                alike &= match axes[2] {
                    0 => at_most8(size, sx) == all,
                    1 => at_most8(size, sy) & below8(sx, sy) == all,
                    _ => below8(max8(sx, sy), sz) == all,
                };
                // No component counts as more than it is.
                let least = mul8(size, splat8(1.0 / POWER_30));
                alike &= (at_most8(least, sx) & at_most8(least, sy) & at_most8(least, sz)) == all;
                longest = max8(longest, size);
                shortest = min8(shortest, size);
                for (axis, d) in [x, y, z].into_iter().enumerate() {
                    low[axis] = min8(low[axis], d);
                    high[axis] = max8(high[axis], d);
                }
                beam.d[group] = d;
            }
            if !alike {
                return false;
            }
            beam.largest = most8(longest);
            if !(STRAIGHT.contains(&beam.largest) && STRAIGHT.contains(&least8(shortest))) {
                return false;
            }
            // One over the greatest component of one sign is the least.
            let (x, y, z) = (most8(high[0]), most8(high[1]), most8(high[2]));
            let (u, v, w) = (least8(low[0]), least8(low[1]), least8(low[2]));
            let [x, y, z, _, u, v, w, _] = array8(div8(splat8(1.0), load8(&[x, y, z, 1.0, u, v, w, 1.0])));
            beam.extreme = [[x, y, z], [u, v, w]];
            true
        }

        /// The least t that counts for any ray.
        $(#[$features])*
        #[inline]
        fn first_t<const G: usize>(beam: &Beam<G>) -> f32 {
            let mut least = load8(&beam.t_min[0]);
            for group in 1..G {
                least = min8(least, load8(&beam.t_min[group]));
            }
            least8(least)
        }

        /// The t beyond which no ray of the packet looks.
        $(#[$features])*
        #[inline]
        fn last_t<const G: usize>(found: &Found<G>) -> f32 {
            // By fours, as they were written.
            let four = |at: usize| load4(&cast_ref::<[f32; 8], [[f32; 4]; 2]>(&found.t[at / 2 % G])[at % 2]);
            let mut most = max4(four(0), four(1));
            for at in 2..2 * G {
                most = max4(most, four(at));
            }
            array4(max4(most, upper4(most))).into_iter().take(2).fold(f32::NEG_INFINITY, f32::max)
        }

        /// Walks a packet to the nearest hits of its rays, if they run alike. All is written where it stays: what is
        /// written by ones and then copied at once, the machine has to wait for.
        $(#[$features])*
        pub(in crate::packet) fn walk<const G: usize>(
            nodes: &[Node],
            leaves: &[Four],
            rays: &[Ray],
            reach: f32,
            stack: &mut Stack,
            found: &mut Found<G>,
            count: &mut impl Count,
        ) -> bool {
            let mut ready = Beam::EMPTY;
            if !beam::<G>(rays, reach, &mut ready) {
                return false;
            }
            let beam = &ready;
            *found = Found { t: from_fn(|group| from_fn(|i| rays[8 * group + i].t_max)), prims: [[NONE; 8]; G] };
            let reach = beam.o.iter().fold(reach, |reach, o| reach.max(o.abs()));
            // A plane is met by all rays between where the two extreme ones meet it.
            let [low, high] = beam.extreme;
            let [o_x, o_y, o_z] = beam.o;
            let out = BOX * reach;
            let start = |[x, y, z]: [f32; 3], side: f32| {
                [side * (out * x.abs()) - o_x * x, side * (out * y.abs()) - o_y * y, side * (out * z.abs()) - o_z * z]
            };
            let [low_x, low_y, low_z] = splats8(low);
            let [high_x, high_y, high_z] = splats8(high);
            let [enter_low_x, enter_low_y, enter_low_z] = splats8(start(low, -1.0));
            let [enter_high_x, enter_high_y, enter_high_z] = splats8(start(high, -1.0));
            let [leave_low_x, leave_low_y, leave_low_z] = splats8(start(low, 1.0));
            let [leave_high_x, leave_high_y, leave_high_z] = splats8(start(high, 1.0));
            let [down_x, down_y, down_z] = beam.down.map(usize::from);
            let (row_x, row_y, row_z) = (down_x, 2 + down_y, 4 + down_z);
            let (octant, turned) = octant(beam.down);
            let t_min = splat8(first_t(beam));
            let mut furthest = last_t(found);
            let (mut here, mut waiting) = (0u32, 0usize);
            'walk: loop {
                while here & LEAF == 0 {
                    let node = &nodes[here as usize];
                    count.node(8);
                    let plane = load8(&node.planes[row_x]);
                    let near_x = min8(add_product8(plane, low_x, enter_low_x), add_product8(plane, high_x, enter_high_x));
                    let plane = load8(&node.planes[row_y]);
                    let near_y = min8(add_product8(plane, low_y, enter_low_y), add_product8(plane, high_y, enter_high_y));
                    let plane = load8(&node.planes[row_z]);
                    let near_z = min8(add_product8(plane, low_z, enter_low_z), add_product8(plane, high_z, enter_high_z));
                    let plane = load8(&node.planes[row_x ^ 1]);
                    let far_x = max8(add_product8(plane, low_x, leave_low_x), add_product8(plane, high_x, leave_high_x));
                    let plane = load8(&node.planes[row_y ^ 1]);
                    let far_y = max8(add_product8(plane, low_y, leave_low_y), add_product8(plane, high_y, leave_high_y));
                    let plane = load8(&node.planes[row_z ^ 1]);
                    let far_z = max8(add_product8(plane, low_z, leave_low_z), add_product8(plane, high_z, leave_high_z));
                    let near = max8(max8(near_x, near_y), max8(near_z, t_min));
                    let far = min8(min8(far_x, far_y), min8(far_z, splat8(furthest)));
                    let met = at_most8(near, far);
                    if met == 0 {
                        let Some(next) = stack.take(&mut waiting, furthest) else { break 'walk };
                        here = next;
                    } else if met & (met - 1) == 0 {
                        here = node.child(met.trailing_zeros());
                    } else {
                        let nears = array8(near);
                        waiting += met.count_ones() as usize - 1;
                        let mut left = met;
                        while left != 0 {
                            let lane = left.trailing_zeros();
                            left &= left - 1;
                            let before = node.before(octant, turned, lane) & met & !(1 << lane);
                            stack.put(waiting - before.count_ones() as usize, node.child(lane), nears[lane as usize & 7]);
                        }
                        here = stack.child(waiting);
                    }
                }
                if leaf::meet(&leaves[(here & !LEAF) as usize], beam, rays, found, count) {
                    furthest = last_t(found);
                }
                let Some(next) = stack.take(&mut waiting, furthest) else { break };
                here = next;
            }
            true
        }
    };
}

stamped!(walk);
