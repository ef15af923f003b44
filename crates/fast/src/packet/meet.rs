//! A packet and four triangles: ruled out in single precision, judged in double.

use glam::DVec3;
use raystep_accel::Ray;

use super::beam::{Beam, Found};
use crate::judge::{BEAM_AREA, BEAM_FAR_AREA, Count, EDGE_ON, INWARD, LEAST_AREA, LEAST_T, Nearest, accept};
use crate::lanes::stamped;
use crate::leaf::Four;

macro_rules! meet {
    ($(#[$features:meta])* $isa:ident) => {
        use super::*;
        use crate::lanes::$isa::*;

        /// The first or the last four of eight.
        $(#[$features])*
        #[inline]
        fn half4(of: &[f32; 8], half: usize) -> F4 {
            load4(&bytemuck::cast_ref::<[f32; 8], [[f32; 4]; 2]>(of)[half & 1])
        }

        /// Tests four triangles, one after the other, with all rays; whether anything was found.
        $(#[$features])*
        #[inline]
        pub(in crate::packet) fn meet<const G: usize>(
            four: &Four,
            beam: &Beam<G>,
            rays: &[Ray],
            found: &mut Found<G>,
            count: &mut impl Count,
        ) -> bool {
            count.triangles(four.count());
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
                    count.judged(left.iter().map(|left| left.count_ones()).sum());
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
            let [i, j, k] = beam.axes;
            let lane = lane & 3;
            let [x, y, z] = beam.axes.map(|axis| &four.rows[axis & 3]);
            let [o_x, o_y, o_z] = beam.axes.map(|axis| f64::from(beam.o[axis]));
            let [mut a, mut b, mut c] = [DVec3::ZERO; 3];
            for (corner, p) in [&mut a, &mut b, &mut c].into_iter().enumerate() {
                let [x, y, z] = [x[corner][lane], y[corner][lane], z[corner][lane]];
                *p = DVec3::new(f64::from(x) - o_x, f64::from(y) - o_y, f64::from(z) - o_z);
            }
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
                let [a_z, b_z, c_z] = [splat_d4(a.z), splat_d4(b.z), splat_d4(c.z)];
                let a_x = sub_d4(splat_d4(a.x), mul_d4(shear_x, a_z));
                let b_x = sub_d4(splat_d4(b.x), mul_d4(shear_x, b_z));
                let c_x = sub_d4(splat_d4(c.x), mul_d4(shear_x, c_z));
                let a_y = sub_d4(splat_d4(a.y), mul_d4(shear_y, a_z));
                let b_y = sub_d4(splat_d4(b.y), mul_d4(shear_y, b_z));
                let c_y = sub_d4(splat_d4(c.y), mul_d4(shear_y, c_z));
                let u = sub_d4(mul_d4(c_x, b_y), mul_d4(c_y, b_x));
                let v = sub_d4(mul_d4(a_x, c_y), mul_d4(a_y, c_x));
                let w = sub_d4(mul_d4(b_x, a_y), mul_d4(b_y, a_x));
                let outside = below_d4(min_d4(min_d4(u, v), w), zero) & below_d4(zero, max_d4(max_d4(u, v), w));
                let area = add_d4(add_d4(u, v), w);
                let most_x = max_d4(max_d4(abs_d4(a_x), abs_d4(b_x)), abs_d4(c_x));
                let most_y = max_d4(max_d4(abs_d4(a_y), abs_d4(b_y)), abs_d4(c_y));
                let limit = mul_d4(splat_d4(EDGE_ON * most_z), max_d4(most_x, most_y));
                let met_lanes = left & !outside & !at_most_d4(abs_d4(area), limit);
                if met_lanes == 0 {
                    continue;
                }
                let height = add_d4(add_d4(mul_d4(u, a_z), mul_d4(v, b_z)), mul_d4(w, c_z));
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
                let from = half4(&beam.t_min[group], half);
                let (t, prims) = found.half(group, half);
                any |= offer4(t, prims, met_4, prim, met_lanes & sure & at_most4(from, met_4)) != 0;
                let mut unsure = met_lanes & !sure;
                while unsure != 0 {
                    let i = unsure.trailing_zeros() as usize & 3;
                    unsure &= unsure - 1;
                    let mut best = Nearest::of(t[i], prims[i]);
                    accept(&triangle, prim, met[i], &rays[8 * group + 4 * half + i], &mut best);
                    (t[i], prims[i]) = best.parts();
                    any |= prims[i] == prim;
                }
            }
            any
        }
    };
}

stamped!(meet);
