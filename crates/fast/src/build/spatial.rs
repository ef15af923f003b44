//! Nodes split in space: Stich, Friedrich and Dietrich, "Spatial Splits in Bounding Volume Hierarchies" (2009). A triangle
//! that lies on both sides of the plane is referred to from both, each time with the box around its part there.
//!
//! # Why no hit is lost
//!
//! A box around a part of a triangle does not enclose the triangle's own box, so what stands in `judge` about boxes is not
//! enough: the t of a hit has to lie in the box of some part. Notation as there; v = 2⁻⁵³ is the rounding of double
//! precision.
//!
//! `accel` finds areas u, v, w of one sign and meets the triangle at t = (u·A_z + v·B_z + w·C_z) / area / d_z. So there is a
//! point Q = (u·A + v·B + w·C) / area of the triangle, in some part of it, with the same z but for roundings of t. How far
//! is the ray from Q, where it has Q's z? Sheared, along x, by E = |u·A_x + v·B_x + w·C_x| / area, which were zero if the
//! areas were not rounded; and by 7·v·g, since sheared corners are rounded.
//!
//! Let ℓ be the longest edge of the triangle and h its least height, which is its width in the narrowest direction;
//! h > ℓ/4096. Let r_a ≥ r_b ≥ r_c be how far sheared corners are from the ray, and X the longest sheared edge. u is rounded
//! by v·(|p_x·q_y| + |p_y·q_x|), at most the product of two of these distances, so E ≤ 3·v·r_a·r_b·r_c / area (and v·r_a, as
//! the sum is rounded). As the ray passes through the triangle, r_b ≤ X, and r_c ≤ X/√3 (Jung's theorem), but for E.
//!
//! Seen nearly edge-on, where the sine of the angle between ray and plane is less than 1/64, the plane holds a direction
//! that differs from the ray's by 1/64 and so has a z of at least 0.56: z ranges over Z ≥ 0.56·h, and one corner's z is Z/2 at
//! least. `accel` takes no area below 10⁻¹⁰·Z/2·m, where m ≥ r_a/√2 is the largest sheared coordinate. So E ≤
//! 3·√2·v·X·(X/√3) / (10⁻¹⁰·Z/2) ≤ 5.5·10⁻⁶·X²/Z. And X ≤ ℓ + √2·Z, since neither x nor y is sheared by more than z. From
//! Z = 0.56·h to Z = ℓ that is largest at its first end: E ≤ 10⁻⁵·(ℓ + 0.8·h)²/h, at most 0.04·ℓ. (That r_b and r_c may be
//! larger by E makes it a fifth larger at most. The same sums would let E be several times X, but then the hit, which lies
//! within 11.1·u·L of the triangle's own box, would be as far from all of a triangle that is smaller than that: the lanes'
//! margin alone does.) Seen from the side, the area is h·ℓ/64 at least, and E much smaller.
//!
//! So a box of a part that is wider by 2⁻¹⁶·(ℓ + 0.8·h)²/h (1.5·10⁻⁵) on all sides holds the point of the ray that has Q's z. If
//! it is wider by less, where the triangle's own box ends, then `accel` moves t into that box, or it is no hit.
//!
//! That moves t by 16·u·t at most, and it was rounded by u·t: 17·u·(S + s)·|r| for any axis, where s is the largest
//! coordinate of the scene alone. The lanes' margin of 32·u·S·|r| covers (8 + 17)·u·S·|r| and what v·g adds; another 64·u·s
//! of the width covers the rest, and the rounding of a part's own corners.
//!
//! Slimmer triangles are not split, nor is a part that is not much wider than its margin. A scene of no common size is not
//! split either, and rays that are not ordinary are answered by brute force where there are parts.

use raystep_accel::{Aabb, Axis, Mesh, PrimId};

use super::reference::{Box4, Reference};
use crate::judge::ORDINARY;

/// The planes that are tried along an axis, and one.
const BINS: usize = 16;
/// A node's parts overlap by more than this part of the root's surface, or are not worth being split in space.
const OVERLAP: f32 = 1e-5;
/// So many times longer than high, and a triangle is not split: it would be no loss of hits up to 4096, but of time, as
/// measured in the stadium, whose rows are long.
const SLIMMEST: f64 = 64.0;
/// By what part of (ℓ + 0.8·h)²/h a box of a part is wider.
const WIDER: f64 = 1.0 / 65536.0;
/// By what part of the largest coordinate: 64·u.
const ROUNDINGS: f32 = 32.0 * f32::EPSILON;
/// Narrower than so many times the margin, a part is not split.
const WORTH: f32 = 8.0;

/// What splits in space have to know.
pub(super) struct Spatial<'a> {
    mesh: &'a Mesh,
    /// Half the surface of the root.
    surface: f32,
    /// The margin that every part needs.
    least: f32,
}

/// Two parts of a node, where they are worth it.
pub(super) struct Parts {
    pub(super) left: Vec<Reference>,
    pub(super) right: Vec<Reference>,
    pub(super) bounds: [Box4; 2],
}

/// A plane across an axis, and what it costs.
struct Plane {
    axis: usize,
    at: f32,
    cost: f32,
    bounds: [Box4; 2],
    counts: [usize; 2],
}

impl<'a> Spatial<'a> {
    /// For a scene with such bounds, if it can be split at all.
    pub(super) fn of(mesh: &'a Mesh, bounds: &Box4) -> Option<Spatial<'a>> {
        let Aabb { min, max } = bounds.aabb();
        let reach = min.abs().max(max.abs()).max_element();
        ORDINARY.contains(&reach).then(|| Spatial { mesh, surface: bounds.area(), least: reach * ROUNDINGS })
    }

    /// The margin of the parts of a triangle, if it can be split.
    fn margin(&self, prim: u32) -> Option<f32> {
        let triangle = self.mesh.triangle(PrimId(prim));
        let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(glam::Vec3::as_dvec3);
        let (ab, ac) = (b - a, c - a);
        let longest = ab.length().max(ac.length()).max((c - b).length());
        let height = ab.cross(ac).length() / longest;
        let reach = longest + 0.8 * height;
        (height * SLIMMEST > longest).then(|| (WIDER * reach * (reach / height)) as f32 + self.least)
    }

    /// The box of a reference as rays have to meet it.
    pub(super) fn widened(&self, reference: &Reference) -> Box4 {
        let own = self.mesh.triangle(PrimId(reference.prim())).bounds();
        let part = reference.bounds();
        if part == own {
            return Box4::from(&own);
        }
        let margin = self.margin(reference.prim()).unwrap_or(f32::INFINITY);
        Box4::from(&Aabb { min: part.min - margin, max: part.max + margin }.intersection(own))
    }

    /// Splits a node in space, if that costs less than `cost` and the parts have no more than `most` references together.
    /// `overlap` is what the parts of the best split by triangles have in common.
    pub(super) fn parts(&self, references: &[Reference], overlap: &Box4, cost: f32, most: usize) -> Option<Parts> {
        if overlap.area() <= OVERLAP * self.surface {
            return None;
        }
        let count = references.len();
        let plane = self.best_plane(references).filter(|plane| plane.cost < cost)?;
        let parts = self.split(references, &plane, most - count);
        let own_cost = |part: &[Reference], bounds: &Box4| bounds.area() * part.len() as f32;
        let [left, right] = &parts.bounds;
        let is_better = own_cost(&parts.left, left) + own_cost(&parts.right, right) < cost;
        let is_progress = [&parts.left, &parts.right].iter().all(|part| (1..count).contains(&part.len()));
        (is_better && is_progress).then_some(parts)
    }

    /// Whether a reference can be split along an axis: it is wide enough.
    fn splits(&self, reference: &Reference, axis: usize) -> bool {
        let width = reference.bounds().extent()[axis];
        width > WORTH * self.least && self.margin(reference.prim()).is_some_and(|margin| width > WORTH * margin)
    }

    fn best_plane(&self, references: &[Reference]) -> Option<Plane> {
        let all = Box4::around(references);
        let (from, extent) = (all.low, all.high - all.low);
        let mut best: Option<Plane> = None;
        for axis in 0..3 {
            let width = extent[axis] / BINS as f32;
            // Planes that cannot be told apart are no use.
            if width.is_nan() || width <= 2.0 * self.least {
                continue;
            }
            let plane = |bin: usize| from[axis] + width * bin as f32;
            let bin_of = |at: f32| (((at - from[axis]) / width) as usize).min(BINS - 1);
            let mut boxes = [Box4::EMPTY; BINS];
            let (mut begin, mut end) = ([0; BINS], [0; BINS]);
            for reference in references {
                let own = reference.bounds();
                let (mut first, mut last) = (bin_of(own.min[axis]), bin_of(own.max[axis]));
                if first != last && !self.splits(reference, axis) {
                    // As a whole where its middle lies.
                    first = bin_of(own.center()[axis]);
                    last = first;
                }
                begin[first] += 1;
                end[last] += 1;
                if first == last {
                    boxes[first].add(reference);
                } else {
                    self.spread(reference, axis, first..=last, plane, &mut boxes);
                }
            }
            let mut rights = [(Box4::EMPTY, 0); BINS];
            let (mut right, mut count) = (Box4::EMPTY, 0);
            for bin in (1..BINS).rev() {
                right = right.union(&boxes[bin]);
                count += end[bin];
                rights[bin] = (right, count);
            }
            let (mut left, mut count) = (Box4::EMPTY, 0);
            for bin in 1..BINS {
                left = left.union(&boxes[bin - 1]);
                count += begin[bin - 1];
                let (right, on_right) = rights[bin];
                if count == 0 || on_right == 0 {
                    continue;
                }
                let cost = left.area() * count as f32 + right.area() * on_right as f32;
                if best.as_ref().is_none_or(|best| cost < best.cost) {
                    best = Some(Plane { axis, at: plane(bin), cost, bounds: [left, right], counts: [count, on_right] });
                }
            }
        }
        best
    }

    /// Adds the parts of a triangle to the bins they lie in: each edge adds the points where it meets planes to the bins on
    /// both sides.
    fn spread(
        &self,
        reference: &Reference,
        axis: usize,
        bins: std::ops::RangeInclusive<usize>,
        plane: impl Fn(usize) -> f32,
        boxes: &mut [Box4; BINS],
    ) {
        let triangle = self.mesh.triangle(PrimId(reference.prim()));
        let corners = [triangle.a, triangle.b, triangle.c].map(|corner| corner.extend(1.0));
        let (first, last) = (*bins.start(), *bins.end());
        let mut parts = [Box4::EMPTY; BINS];
        for i in 0..3 {
            let (mut p, mut q) = (corners[i], corners[(i + 1) % 3]);
            if p[axis] > q[axis] {
                (p, q) = (q, p);
            }
            let per_length = (q - p) / (q[axis] - p[axis]);
            for (bin, part) in parts.iter_mut().enumerate().take(last + 1).skip(first) {
                let (low, high) = (plane(bin), plane(bin + 1));
                if q[axis] < low && bin > first || p[axis] > high && bin < last {
                    continue;
                }
                // The edge's piece in this bin; beyond the first and the last bin the reference's box cuts it.
                let at = |plane: f32| p + per_length * (plane - p[axis]);
                let begin = if bin > first && p[axis] < low { at(low) } else { p };
                let end = if bin < last && q[axis] > high { at(high) } else { q };
                part.add_point(begin);
                part.add_point(end);
            }
        }
        let own = reference.box4();
        for bin in bins {
            let part = Box4 { low: parts[bin].low.max(own.low), high: parts[bin].high.min(own.high) };
            if part.low.truncate().cmple(part.high.truncate()).all() {
                boxes[bin] = boxes[bin].union(&part);
            }
        }
    }

    /// Sorts references to both sides of a plane, and splits those on both where that costs less than to leave them whole,
    /// up to `spare` of them.
    fn split(&self, references: &[Reference], plane: &Plane, mut spare: usize) -> Parts {
        let Plane { axis, at, bounds: [mut left_box, mut right_box], counts: [on_left, on_right], .. } = *plane;
        let (mut on_left, mut on_right) = (on_left as f32, on_right as f32);
        let (mut left, mut right) = (Vec::with_capacity(references.len()), Vec::with_capacity(references.len()));
        for reference in references {
            let own = reference.bounds();
            if own.max[axis] <= at || own.min[axis] >= at || !self.splits(reference, axis) {
                let side = if own.center()[axis] < at { &mut left } else { &mut right };
                side.push(*reference);
                continue;
            }
            let triangle = self.mesh.triangle(PrimId(reference.prim()));
            let [below, above] = triangle.clip_twice(&own, Axis::ALL[axis], [at, at]);
            let whole = reference.box4();
            let (left_area, right_area) = (left_box.area(), right_box.area());
            let both = left_area * on_left + right_area * on_right;
            let all_left = left_box.union(&whole).area() * on_left + right_area * (on_right - 1.0);
            let all_right = left_area * (on_left - 1.0) + right_box.union(&whole).area() * on_right;
            // What cannot be split is as well off on the better side.
            let both = if spare == 0 || below.is_empty() || above.is_empty() { f32::INFINITY } else { both };
            if all_left < both && all_left <= all_right {
                (left_box, on_right) = (left_box.union(&whole), on_right - 1.0);
                left.push(*reference);
            } else if all_right < both {
                (right_box, on_left) = (right_box.union(&whole), on_left - 1.0);
                right.push(*reference);
            } else {
                spare -= 1;
                left.push(Reference::new(&below, reference.prim()));
                right.push(Reference::new(&above, reference.prim()));
            }
        }
        let bounds = [Box4::around(&left), Box4::around(&right)];
        Parts { left, right, bounds }
    }
}
