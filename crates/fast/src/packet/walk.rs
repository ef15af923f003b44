//! The walk of a packet.

use std::array::from_fn;
use std::cell::RefCell;

use glam::{DVec3, Vec3};
use raystep_accel::Ray;

use super::beam::{Beam, Found};
use crate::bvh8::{LEAF, Node, octant};
use crate::judge::{
    BEAM_AREA, BEAM_FAR_AREA, BOX, EDGE_ON, INWARD, LEAST_AREA, LEAST_T, NONE, Nearest, ORDINARY, POWER_30, STRAIGHT,
    accept,
};
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

        /// Makes a packet ready, if its rays run alike.
        $(#[$features])*
        #[inline]
        fn beam<const G: usize>(rays: &[Ray], reach: f32) -> Option<Beam<G>> {
            if rays.len() != 8 * G {
                return None;
            }
            let first = &rays[0];
            let o = first.o.to_array();
            let reach = o.iter().fold(reach, |reach, o| reach.max(o.abs()));
            if !ORDINARY.contains(&reach) {
                return None;
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
            let mut beam = Beam {
                o,
                d: [[[0.0; 8]; 3]; G],
                extreme: [[0.0; 3]; 2],
                down,
                axes,
                largest: 0.0,
                t_min: [[0.0; 8]; G],
            };
            let mut alike = true;
            let mut low = [splat8(f32::INFINITY); 3];
            let mut high = [splat8(f32::NEG_INFINITY); 3];
            let mut longest = splat8(0.0);
            let mut shortest = splat8(f32::INFINITY);
            for group in 0..G {
                let eight = rays[8 * group..].first_chunk::<8>()?;
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
                return None;
            }
            beam.largest = most8(longest);
            if !(STRAIGHT.contains(&beam.largest) && STRAIGHT.contains(&least8(shortest))) {
                return None;
            }
            // One over the greatest component of one sign is the least.
            let (x, y, z) = (most8(high[0]), most8(high[1]), most8(high[2]));
            let (u, v, w) = (least8(low[0]), least8(low[1]), least8(low[2]));
            let [x, y, z, _, u, v, w, _] = array8(div8(splat8(1.0), load8(&[x, y, z, 1.0, u, v, w, 1.0])));
            beam.extreme = [[x, y, z], [u, v, w]];
            Some(beam)
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
            let mut most = load8(&found.t[0]);
            for group in 1..G {
                most = max8(most, load8(&found.t[group]));
            }
            most8(most)
        }

        /// The first or the last four of eight.
        $(#[$features])*
        #[inline]
        fn half4(of: &[f32; 8], half: usize) -> F4 {
            load4(&bytemuck::cast_ref::<[f32; 8], [[f32; 4]; 2]>(of)[half & 1])
        }

        /// Walks a packet to the nearest hits of its rays, if they run alike.
        $(#[$features])*
        pub(in crate::packet) fn walk<const G: usize>(
            nodes: &[Node],
            leaves: &[Four],
            rays: &[Ray],
            reach: f32,
            stack: &mut Stack,
        ) -> Option<Found<G>> {
            let beam = beam::<G>(rays, reach)?;
            let mut found =
                Found { t: from_fn(|group| from_fn(|i| rays[8 * group + i].t_max)), prims: [[NONE; 8]; G] };
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
            let t_min = splat8(first_t(&beam));
            let mut furthest = last_t(&found);
            let (mut here, mut waiting) = (0u32, 0usize);
            'walk: loop {
                while here & LEAF == 0 {
                    let node = &nodes[here as usize];
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
                if meet(&leaves[(here & !LEAF) as usize], &beam, rays, &mut found) {
                    furthest = last_t(&found);
                }
                let Some(next) = stack.take(&mut waiting, furthest) else { break };
                here = next;
            }
            Some(found)
        }

        /// Tests four triangles, one after the other, with all rays; whether anything was found.
        $(#[$features])*
        #[inline]
        fn meet<const G: usize>(four: &Four, beam: &Beam<G>, rays: &[Ray], found: &mut Found<G>) -> bool {
            // As all rays begin at one point, the area that a ray makes with an edge is the product of its direction and
            // of the normal of the plane through that point and the edge: computed once, for four triangles.
            let corner = |axis: usize, corner: usize| {
                sub_d4(double4(load4(&four.rows[axis][corner])), splat_d4(f64::from(beam.o[axis])))
            };
            let a = [corner(0, 0), corner(1, 0), corner(2, 0)];
            let b = [corner(0, 1), corner(1, 1), corner(2, 1)];
            let c = [corner(0, 2), corner(1, 2), corner(2, 2)];
            let cross = |p: [_; 3], q: [_; 3]| {
                let [p_x, p_y, p_z] = p;
                let [q_x, q_y, q_z] = q;
                [
                    single4(sub_d4(mul_d4(p_y, q_z), mul_d4(p_z, q_y))),
                    single4(sub_d4(mul_d4(p_z, q_x), mul_d4(p_x, q_z))),
                    single4(sub_d4(mul_d4(p_x, q_y), mul_d4(p_y, q_x))),
                ]
            };
            let normals = [cross(c, b), cross(a, c), cross(b, a)];
            let last = beam.axes[2];
            let far = sub4(load4(&four.rows[last & 3][0]), splat4(beam.o[last]));
            let size = load4(four.sizes());
            let far = add_product4(splat4(2.0), size, abs4(far));
            let part = add_product4(splat4(BEAM_FAR_AREA), far, mul4(splat4(BEAM_AREA), size));
            let margins = array4(add_product4(mul4(far, part), splat4(beam.largest), splat4(LEAST_AREA)));
            let mut any = false;
            for lane in 0..four.count() as usize {
                let lane = lane & 3;
                let [u, v, w] = &normals;
                let [u, v, w] = [
                    splats8([u[0][lane], u[1][lane], u[2][lane]]),
                    splats8([v[0][lane], v[1][lane], v[2][lane]]),
                    splats8([w[0][lane], w[1][lane], w[2][lane]]),
                ];
                let margin = splat8(margins[lane]);
                let minus = splat8(-margins[lane]);
                let mut left = [0; G];
                for group in 0..G {
                    let [x, y, z] = [load8(&beam.d[group][0]), load8(&beam.d[group][1]), load8(&beam.d[group][2])];
                    let u = add_product8(u[0], x, add_product8(u[1], y, mul8(u[2], z)));
                    let v = add_product8(v[0], x, add_product8(v[1], y, mul8(v[2], z)));
                    let w = add_product8(w[0], x, add_product8(w[1], y, mul8(w[2], z)));
                    left[group] = at_most8(minus, min8(min8(u, v), w)) | at_most8(max8(max8(u, v), w), margin);
                }
                if left != [0; G] {
                    any |= judge(four, lane, beam, rays, left, found);
                }
            }
            any
        }

        /// Judges a triangle for some rays of each group as `Triangle::meet` of `accel` does: its operations, in its order.
        $(#[$features])*
        #[inline]
        fn judge<const G: usize>(
            four: &Four,
            lane: usize,
            beam: &Beam<G>,
            rays: &[Ray],
            left: [u32; G],
            found: &mut Found<G>,
        ) -> bool {
            let triangle = four.triangle(lane);
            let o = Vec3::from(beam.o).as_dvec3();
            let [i, j, k] = beam.axes;
            let sorted = |p: Vec3| -> DVec3 {
                let p = p.as_dvec3() - o;
                DVec3::new(p[i], p[j], p[k])
            };
            let (a, b, c) = (sorted(triangle.a), sorted(triangle.b), sorted(triangle.c));
            let most_z = a.z.abs().max(b.z.abs()).max(c.z.abs());
            let bounds = triangle.bounds();
            let prim = four.prim(lane);
            let zero = splat_d4(0.0);
            let mut any = false;
            for half in 0..2 * G {
                let (group, half) = (half / 2, half % 2);
                let left = left[group] >> (4 * half) & 15;
                if left == 0 {
                    continue;
                }
                let d_z = double4(half4(&beam.d[group][k], half));
                let shear_x = div_d4(double4(half4(&beam.d[group][i], half)), d_z);
                let shear_y = div_d4(double4(half4(&beam.d[group][j], half)), d_z);
                let sheared = |p: DVec3| {
                    let z = splat_d4(p.z);
                    (sub_d4(splat_d4(p.x), mul_d4(shear_x, z)), sub_d4(splat_d4(p.y), mul_d4(shear_y, z)))
                };
                let ((a_x, a_y), (b_x, b_y), (c_x, c_y)) = (sheared(a), sheared(b), sheared(c));
                let u = sub_d4(mul_d4(c_x, b_y), mul_d4(c_y, b_x));
                let v = sub_d4(mul_d4(a_x, c_y), mul_d4(a_y, c_x));
                let w = sub_d4(mul_d4(b_x, a_y), mul_d4(b_y, a_x));
                let outside = below_d4(min_d4(min_d4(u, v), w), zero) & below_d4(zero, max_d4(max_d4(u, v), w));
                let area = add_d4(add_d4(u, v), w);
                let most_x = max_d4(max_d4(abs_d4(a_x), abs_d4(b_x)), abs_d4(c_x));
                let most_y = max_d4(max_d4(abs_d4(a_y), abs_d4(b_y)), abs_d4(c_y));
                let limit = mul_d4(splat_d4(EDGE_ON * most_z), max_d4(most_x, most_y));
                let mut met_lanes = left & !outside & !at_most_d4(abs_d4(area), limit);
                if met_lanes == 0 {
                    continue;
                }
                let height = add_d4(
                    add_d4(mul_d4(u, splat_d4(a.z)), mul_d4(v, splat_d4(b.z))),
                    mul_d4(w, splat_d4(c.z)),
                );
                let met = single4(div_d4(div_d4(height, area), d_z));
                // Where the meeting surely lies in the interval of the triangle's own box, it is the hit.
                let (mut low, mut high) = (splat4(f32::NEG_INFINITY), splat4(f32::INFINITY));
                for axis in 0..3 {
                    let (near, far) = (bounds.min[axis] - beam.o[axis], bounds.max[axis] - beam.o[axis]);
                    let (near, far) = if beam.down[axis] { (far, near) } else { (near, far) };
                    let r = div4(splat4(1.0), half4(&beam.d[group][axis], half));
                    low = max4(low, mul4(splat4(near), r));
                    high = min4(high, mul4(splat4(far), r));
                }
                let slack = splat4(INWARD);
                let met_4 = load4(&met);
                let sure = at_most4(sub_product4(abs4(low), slack, low), met_4)
                    & at_most4(met_4, add_product4(abs4(high), slack, high))
                    & at_most4(splat4(LEAST_T), abs4(met_4));
                while met_lanes != 0 {
                    let i = met_lanes.trailing_zeros() as usize & 3;
                    met_lanes &= met_lanes - 1;
                    let at = (4 * half + i) & 7;
                    let mut best = Nearest::of(found.t[group][at], found.prims[group][at]);
                    if sure >> i & 1 == 0 {
                        accept(&triangle, prim, met[i], &rays[8 * group + at], &mut best);
                    } else if beam.t_min[group][at] <= met[i] {
                        best.offer(met[i], prim);
                    }
                    (found.t[group][at], found.prims[group][at]) = best.parts();
                    any |= best.parts().1 == prim;
                }
            }
            any
        }
    };
}

stamped!(walk);
