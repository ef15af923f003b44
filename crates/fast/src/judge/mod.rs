//! What may be ruled out in single precision, and what decides about the rest.
//!
//! `accel` meets a triangle in double precision and moves the t into the slab interval of the triangle's own box.
//! Lanes of single precision cannot say the same; they can say *no* where it is certain. Two bounds make it certain.
//! Below, u = 2⁻²⁴ is the largest relative rounding of single precision, and S the largest coordinate of the scene and
//! of the ray's origin, without its sign. Both hold for ordinary rays only, see [`Shot::new`]: 2⁻⁴⁰ ≤ S ≤ 2⁴⁰, and
//! 2⁻³⁰ ≤ D ≤ 2³⁰ for the largest component D of the direction, so nothing overflows, and what underflows is far
//! smaller than the margins.
//!
//! # Boxes: moved out by 32·u·S·|r|
//!
//! `accel` finds τ = earlier(fl(fl(b − o) / d)) where a ray meets a plane b, which is (b − o) / d up to two roundings,
//! a factor 1 ± 8u on purpose, and its rounding: 11.1·u·|b − o| / |d| at most, or 22.2·u·S / |d|. A hit's t lies in the
//! interval of its own box, so in that of every box around that (`slab` is monotone): τ_near ≤ t ≤ τ_far.
//!
//! The lanes compute b·r + n with r = fl(1 / d) and n = fl(−fl(o·r) − e) or, for the far plane, fl(−fl(o·r) + e).
//! Beside (b − o) / d ∓ e that errs by: r itself, 2u·S·|r|; the product o·r, u·S·|r|; the sum n, u·S·|r|; the product
//! b·r, u·S·|r| (none if it is fused); the last sum, 2u·S·|r|; these with a little from second order are at most
//! 8·u·S·|r|. So with e = 32·u·S·|r| ≥ (22.2 + 8)·u·S·|r| + rounding of e the near plane never comes out beyond t, and
//! the far plane never before t.
//!
//! A component d of less than D·2⁻³⁰, zero included, counts as that much: r = ±R = ±2³⁰/D. The t of a hit is at most
//! T = 2.1·S/D, since it lies in a slab of the axis of D. On the small component's axis the hit's slab interval says that
//! t·d lies between l − 22.2·u·S and h + 22.2·u·S, where l and h are the box's planes less o; and |t·d| ≤ 2.1·S·2⁻³⁰ ≤
//! 0.04·u·S. So l ≤ 22.3·u·S, and the lanes find for the near plane at most (22.3 + 8 − 32)·u·S·R < −1.6·u·S·2³⁰/D <
//! −T ≤ t. The far plane likewise.
//!
//! # Triangles: areas within g·(2⁻¹⁸·x + 2⁻³⁸·g) + 2⁻¹⁰⁰ of zero have no sign
//!
//! x is the longest side of the triangle's box, z_a the distance of its first corner along the ray's largest axis, and
//! g = |z_a| + 2x. `accel` accepts a triangle only if the slab interval of its own box is not empty: a point P = t·d,
//! relative to the origin, lies within ρ = 11.1·u·L + 2⁻¹¹⁸ of the box on every axis, where L is the largest coordinate of
//! its corners relative to the origin. As P runs along z at least as fast as along any axis, no coordinate of P is larger
//! than |z_a| + x + ρ, so L ≤ |z_a| + 2x + 2ρ, which is g·(1 + 23u) and a crumb.
//!
//! A sheared corner is (A_x − P_x) − s·(A_z − P_z) with |s| ≤ 1, since P itself is sheared to zero: at most 2·(x + ρ).
//! Lanes compute A_x − s·A_z from A rounded once (u·L), s rounded twice and their product (4·u·L), and round the result
//! (u·2·(x + ρ) ≤ 1.1·u·g): δ ≤ 6.1·u·g. So no computed coordinate is larger than m = 2x + 29·u·g.
//! An area is a difference of two products of such coordinates. It errs by 4·δ·m from them, and by 4·u·m² ≤ 4.1·u·g·m from
//! its own roundings: 28.6·u·g·m ≤ 57.2·u·g·x + 830·u²·g² in all. In double precision `accel` errs by a 2⁻²⁸th of it.
//! Taken together that is less than 64·u·g·x + 1024·u²·g², which is what stands above; its own few roundings, and that of
//! g, are covered by the difference. 2⁻¹⁰⁰ covers products that underflow.
//!
//! A triangle is ruled out where one area is surely negative and another surely positive. `accel` rejects it then.
//!
//! # How far: heights within (g + |τ|)·(8·M + 32·u·|area|) + 2⁻¹²⁰ of τ·|area| do not tell
//!
//! M is the margin of areas above, and area the sum of the three that lanes computed. The height u·A_z + v·B_z + w·C_z is
//! t·D times the area, each with its sign. A triangle that `accel` accepts in front of `t_max` has a t of at most `t_max`;
//! τ is `t_max`·D, rounded. Say a for `accel`'s area, and h for its height, turned so that h = t·D·|a|.
//!
//! `accel`'s three areas have one sign, so their sum without signs is |a|; the lanes' differ by M each. Lanes find the
//! height with an error of M on each area, u·g on each z, and three roundings: at most g·(3.1·M + 4.5·u·|a|); and the area
//! with 3·M + 3.2·u·(|a| + 3·M). `accel` rounds t once and moves it by 16·u at most: t·D·|a| differs from h by 17.2·u·|h| ≤
//! 17.3·u·g·|a|. So the lanes' height is at most τ·|area| + |τ|·(3.2·M + 5·u·|area|) + g·(3.2·M + 22·u·|area|), if both areas
//! have the same sign. If not, they are 3.2·M at most, and so the lanes' height is no more than 6.4·g·M from zero. What
//! stands above covers both, with some roundings of its own; 2⁻¹²⁰ covers products that underflow, and none of an accepted
//! triangle overflows: its height is at most 2¹²⁵, and where a limit is infinite, it rules out nothing. What lies before
//! `t_min` is ruled out likewise.
//!
//! # Packets
//!
//! Rays with one origin whose directions have the same signs enter a slab between where the rays of the least and of the
//! greatest r on that axis do: (b − o)·r − 32·u·S·|r| is linear in r, and if both ends are found with errors of 8·u·S·|r| at
//! most, then the lesser of them is no further out than any mean of both, and so than the t of any ray's hit, by the same
//! sums as above.
//!
//! The area that such a ray makes with an edge from p to q is, times the largest component D of d, the product n·d with
//! n = p × q. That is computed in double precision (to 2⁻⁵¹·L² on each axis) and rounded: no component is larger than
//! 2·L·x, since n = p × (q − p). The product with d errs by 4.1·u·Σ|n_k·d_k| ≤ 4.1·u·6·L·x·D: less than
//! D·(32·u·g·x + u²·g²) with all the rest.
//!
//! # Meetings: within a box's interval but for 1.5·u of its ends
//!
//! What the judge met counts as it is if it lies in the slab interval of the triangle's own box. To know that, the six
//! divisions of the interval are not needed. Where no component of the direction was taken for more than it is, fl(x·r)
//! with x = fl(b − o), which `accel` computes alike, is within 2.1·u of x/d. The end of `accel`'s interval is fl(x/d) moved
//! outward by 8u and rounded: at least 5.9·u of x/d further out. Moved outward by 1.5·u and rounded once or twice, fl(x·r)
//! is at most 2.1 + 1.5 + 1.1·u, and so less, further out than x/d. A meeting between such ends lies in the interval. (The least and the greatest of
//! the three corners' are those of the box, as subtraction and multiplication are monotone.) Where it does not lie there,
//! the six divisions decide; and so they do where the meeting's t is less than 2⁻¹⁰⁰, since the ends of such intervals may
//! underflow.

mod best;
mod count;
mod shot;
mod verdict;

pub(crate) use best::{NONE, Nearest};
pub use count::{Count, Work};
pub use shot::{NotOrdinary, Shot};
pub(crate) use shot::{ORDINARY, POWER_30, STRAIGHT};
pub(crate) use verdict::{accept, careful};

/// The margin of a box, as a part of S·|r|.
pub(crate) const BOX: f32 = 32.0 * UNIT;
/// The margin of an area: so much of g·x ...
pub(crate) const AREA: f32 = 64.0 * UNIT;
/// ... of g² ...
pub(crate) const FAR_AREA: f32 = 1024.0 * UNIT * UNIT;
/// ... and this.
pub(crate) const LEAST_AREA: f32 = f32::from_bits((127 - 100) << 23);
/// What the height errs by, times the distance: so many margins of the area ...
pub(crate) const AREAS: f32 = 8.0;
/// ... this part of the area ...
pub(crate) const PART: f32 = 32.0 * UNIT;
/// ... and this.
pub(crate) const LEAST_HEIGHT: f32 = f32::from_bits((127 - 120) << 23);
/// The same of an area that was found as a product of a direction and a normal: so much of g·x times the direction ...
pub(crate) const BEAM_AREA: f32 = 32.0 * UNIT;
/// ... and of g².
pub(crate) const BEAM_FAR_AREA: f32 = UNIT * UNIT;
/// Thinner than this part of its distance, and a triangle counts as seen edge-on: as `accel` has it.
pub(crate) const EDGE_ON: f64 = 1e-10;
/// The part of an end by which a meeting may lie further out and surely be within.
pub(crate) const INWARD: f32 = 1.5 * UNIT;
/// The least t of which that can be said.
pub(crate) const LEAST_T: f32 = LEAST_AREA;
/// The largest relative rounding.
const UNIT: f32 = f32::EPSILON / 2.0;
