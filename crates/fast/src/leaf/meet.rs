//! A ray and four triangles: ruled out in single precision, judged in double.

use crate::judge::{
    AREA, AREAS, Count, EDGE_ON, FAR_AREA, INWARD, LEAST_AREA, LEAST_HEIGHT, LEAST_T, Nearest, PART, Shot, accept,
};
use crate::lanes::stamped;
use crate::leaf::Four;

macro_rules! meet {
    ($(#[$features:meta])* $isa:ident) => {
        use super::*;
        use crate::lanes::$isa::*;

        /// Tests four triangles and keeps the best hit.
        $(#[$features])*
        #[inline]
        pub(crate) fn meet(four: &Four, shot: &Shot<'_>, best: &mut Nearest, count: &mut impl Count) {
            count.triangles(four.count());
            let left = left(four, shot, best.t);
            if left != 0 {
                // Each triangle once, though the last one may stand in several lanes.
                let left = left & ((1 << four.count()) - 1);
                count.judged(left.count_ones());
                judge(four, shot, left, best);
            }
        }

        /// In which lanes the triangle cannot be ruled out: it may be met, up to `t_max`. The proof stands in `judge`.
        $(#[$features])*
        #[inline]
        pub(crate) fn left(four: &Four, shot: &Shot<'_>, t_max: f32) -> u32 {
            let [x, y, z] = shot.axes.map(|axis| &four.rows[axis & 3]);
            let [o_x, o_y, o_z] = splats4(shot.o);
            let (shear_x, shear_y) = (splat4(shot.shear[0]), splat4(shot.shear[1]));
            // The corners relative to the origin, sheared so that the ray runs along z.
            let [a_z, b_z, c_z] = [sub4(load4(&z[0]), o_z), sub4(load4(&z[1]), o_z), sub4(load4(&z[2]), o_z)];
            let a_x = sub_product4(shear_x, a_z, sub4(load4(&x[0]), o_x));
            let b_x = sub_product4(shear_x, b_z, sub4(load4(&x[1]), o_x));
            let c_x = sub_product4(shear_x, c_z, sub4(load4(&x[2]), o_x));
            let a_y = sub_product4(shear_y, a_z, sub4(load4(&y[0]), o_y));
            let b_y = sub_product4(shear_y, b_z, sub4(load4(&y[1]), o_y));
            let c_y = sub_product4(shear_y, c_z, sub4(load4(&y[2]), o_y));
            // Twice the areas that the ray makes with each edge.
            let u = sub_product4(c_y, b_x, mul4(c_x, b_y));
            let v = sub_product4(a_y, c_x, mul4(a_x, c_y));
            let w = sub_product4(b_y, a_x, mul4(b_x, a_y));
            // How large an area has to be to have a sign.
            let size = load4(four.sizes());
            let far = add_product4(splat4(2.0), size, abs4(a_z));
            let part = add_product4(splat4(FAR_AREA), far, mul4(splat4(AREA), size));
            let margin = add_product4(far, part, splat4(LEAST_AREA));
            // Inside, unless one of them is surely negative and another surely positive.
            let least = min4(min4(u, v), w);
            let most = max4(max4(u, v), w);
            let inside = at_most4(negated4(margin), least) | at_most4(most, margin);
            if inside == 0 {
                return 0;
            }
            // How far along the ray, times the area: surely not before it begins, nor beyond what counts.
            let area = add4(add4(u, v), w);
            let height = add_product4(u, a_z, add_product4(v, b_z, mul4(w, c_z)));
            let height = mul4(flipped4(height, area), splat4(shot.way));
            let area = abs4(area);
            let doubt = add_product4(splat4(PART), area, mul4(splat4(AREAS), margin));
            let (from, to) = (shot.ray.t_min * shot.pace, t_max * shot.pace);
            let before = add_product4(doubt, add4(far, splat4(from.abs())), splat4(LEAST_HEIGHT));
            let beyond = add_product4(doubt, add4(far, splat4(to.abs())), splat4(LEAST_HEIGHT));
            let before = sub4(mul4(splat4(from), area), before);
            let beyond = add_product4(splat4(to), area, beyond);
            inside & !at_most4(height, before) & !at_most4(beyond, height)
        }

        /// Judges the triangles in some lanes as `Triangle::meet` of `accel` does: its operations, in its order.
        $(#[$features])*
        #[inline]
        pub(crate) fn judge(four: &Four, shot: &Shot<'_>, lanes: u32, best: &mut Nearest) {
            let d = shot.ray.d.to_array();
            let [x, y, z] = shot.axes.map(|axis| &four.rows[axis & 3]);
            let [d_x, d_y, d_z] = shot.axes.map(|axis| f64::from(d[axis]));
            let [o_x, o_y, o_z] = shot.o.map(f64::from);
            let (o_x, o_y, o_z) = (splat_d4(o_x), splat_d4(o_y), splat_d4(o_z));
            let (shear_x, shear_y) = (splat_d4(d_x / d_z), splat_d4(d_y / d_z));
            let [a_z, b_z, c_z] = [
                sub_d4(double4(load4(&z[0])), o_z),
                sub_d4(double4(load4(&z[1])), o_z),
                sub_d4(double4(load4(&z[2])), o_z),
            ];
            let a_x = sub_d4(sub_d4(double4(load4(&x[0])), o_x), mul_d4(shear_x, a_z));
            let b_x = sub_d4(sub_d4(double4(load4(&x[1])), o_x), mul_d4(shear_x, b_z));
            let c_x = sub_d4(sub_d4(double4(load4(&x[2])), o_x), mul_d4(shear_x, c_z));
            let a_y = sub_d4(sub_d4(double4(load4(&y[0])), o_y), mul_d4(shear_y, a_z));
            let b_y = sub_d4(sub_d4(double4(load4(&y[1])), o_y), mul_d4(shear_y, b_z));
            let c_y = sub_d4(sub_d4(double4(load4(&y[2])), o_y), mul_d4(shear_y, c_z));

            let u = sub_d4(mul_d4(c_x, b_y), mul_d4(c_y, b_x));
            let v = sub_d4(mul_d4(a_x, c_y), mul_d4(a_y, c_x));
            let w = sub_d4(mul_d4(b_x, a_y), mul_d4(b_y, a_x));
            let zero = splat_d4(0.0);
            let outside = below_d4(min_d4(min_d4(u, v), w), zero) & below_d4(zero, max_d4(max_d4(u, v), w));
            let inside = lanes & !outside;
            if inside == 0 {
                return;
            }
            let area = add_d4(add_d4(u, v), w);
            let most_x = max_d4(max_d4(abs_d4(a_x), abs_d4(b_x)), abs_d4(c_x));
            let most_y = max_d4(max_d4(abs_d4(a_y), abs_d4(b_y)), abs_d4(c_y));
            let most_z = max_d4(max_d4(abs_d4(a_z), abs_d4(b_z)), abs_d4(c_z));
            let limit = mul_d4(mul_d4(splat_d4(EDGE_ON), most_z), max_d4(most_x, most_y));
            let edge_on = at_most_d4(abs_d4(area), limit);

            let height = add_d4(add_d4(mul_d4(u, a_z), mul_d4(v, b_z)), mul_d4(w, c_z));
            let met = single4(div_d4(div_d4(height, area), splat_d4(d_z)));
            // Where the meeting surely lies in the interval of the triangle's own box, it is the hit.
            let sure = if shot.steep { within(four, shot, &met) } else { 0 };
            let mut met_lanes = inside & !edge_on;
            while met_lanes != 0 {
                let lane = met_lanes.trailing_zeros() as usize;
                let (t, prim) = (met[lane & 3], four.prim(lane));
                if sure >> lane & 1 == 0 {
                    accept(&four.triangle(lane), prim, t, shot.ray, best);
                } else if shot.ray.t_min <= t && t <= shot.ray.t_max {
                    best.offer(t, prim);
                }
                met_lanes &= met_lanes - 1;
            }
        }

        /// In which lanes `met` surely lies in the slab interval of the triangle's own box. The proof stands in `judge`.
        $(#[$features])*
        #[inline]
        fn within(four: &Four, shot: &Shot<'_>, met: &[f32; 4]) -> u32 {
            let met = load4(met);
            let [mut low, mut high] = [splat4(f32::NEG_INFINITY), splat4(f32::INFINITY)];
            for i in 0..3 {
                let [a, b, c] = &four.rows[shot.axes[i] & 3];
                let (o, r) = (splat4(shot.o[i]), splat4(shot.sorted_r[i]));
                let a = mul4(sub4(load4(a), o), r);
                let b = mul4(sub4(load4(b), o), r);
                let c = mul4(sub4(load4(c), o), r);
                low = max4(low, min4(min4(a, b), c));
                high = min4(high, max4(max4(a, b), c));
            }
            let slack = splat4(INWARD);
            let from = sub_product4(abs4(low), slack, low);
            let to = add_product4(abs4(high), slack, high);
            at_most4(from, met) & at_most4(met, to) & at_most4(splat4(LEAST_T), abs4(met))
        }
    };
}

stamped!(meet);
