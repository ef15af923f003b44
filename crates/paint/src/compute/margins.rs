//! What the GPU may rule out, what it may be sure of, and between which t a triangle is met.
//!
//! The proofs are those of `raystep-fast`'s room `judge` with a coarser rounding. The language of the shader (WGSL) allows
//! a sum or product to be rounded up or down as the GPU likes, also where the other number is nearer, or to be fused with
//! the next sum; a quotient 2.5 units in the last place; numbers of less than 2⁻¹²⁶ to be taken for zero. With u = 2⁻²⁴ as
//! there, a sum or product errs by 2u of itself and a quotient by 5u. Nothing else is computed there that rounds: what is
//! divided by the direction is so on the CPU, correctly rounded. Rays and scenes are the ordinary ones of `judge`:
//! nothing overflows, and 2⁻⁴⁰ ≤ S ≤ 2⁴⁰, so that a coordinate taken for zero, an error of 2⁻¹²⁶, is far below u²·S.
//!
//! # Boxes: moved out by 48·u·S·|r|
//!
//! Of b·r + n the reciprocal r errs by 2·u·S·|r| (b is up to S, r by u of itself, and |b − o| up to 2S), o·r and n by
//! u·S·|r| each: these are the CPU's. The GPU's product errs by 2·u·S·|r| and its sum by 4·u·S·|r|: with a little from
//! second order at most 11·u·S·|r|. `accel` is within 22.2·u·S·|r|. 33.2 and the rounding of the margin are less than 48.
//! A small component of the direction counts as D·2⁻³⁰; for it (22.3 + 11 − 48)·u·S·2³⁰/D < −14·u·S·2³⁰/D < −2.1·S/D.
//!
//! # Triangles: areas within M = g·(2⁻¹⁷·x + 2⁻³⁷·g) + 2⁻¹⁰⁰ of zero have no sign
//!
//! x is the longest side of the triangle's box and g = |z_a| + 2x, as there. A sheared corner errs by A rounded once
//! (2·u·L), s·A_z (2·u of s on the CPU, 2·u of A_z, 2·u of the product: 6·u·L) and its own rounding (2·u·2·(x + ρ) ≤
//! 2.2·u·g): δ ≤ 10.2·u·g, so no computed one is larger than m = 2x + 33·u·g. An area errs by 4·δ·m and by 8·u·m² ≤
//! 8.2·u·g·m: 49·u·g·m ≤ 98·u·g·x + 1620·u²·g². M is 128·u·g·x + 2048·u²·g²: enough for its own roundings, for the 2⁻²⁸th
//! by which `accel` errs in double precision, and 2⁻¹⁰⁰ for products taken for zero. So a triangle that `accel` accepts
//! never has an area surely negative and another surely positive.
//!
//! # Certain hits: all areas beyond 2·M with one sign, and some more
//!
//! There the ray need not pass near the triangle, so the computed corners are looked at: none may be larger than
//! m' = 2x + 64·u·g (those of a real hit never are). Then |A_x| ≤ m' + g·(1 + 10u) ≤ 2.1·g, a corner errs by 4.2·u·g for A_x, 6·u·g for
//! s·A_z and 2.1·u·g for its rounding, δ ≤ 12.3·u·g, and an area by (49.2 + 8.2)·u·g·m' ≤ 115·u·g·x + 3700·u²·g² +
//! 2⁻¹⁰⁰ < 2·M. So the true areas have that sign, `accel`'s in double precision too: the line meets the triangle inside.
//! With |area| ≥ 8·M computed, the true one is at least (8 − 3·1.85)·M > 2⁻¹⁶·g·x, far above `accel`'s limit for a triangle seen
//! edge-on, 10⁻¹⁰·g·2.1·x. The point that is met lies in the triangle's box, whose slab interval `accel` moves outward by
//! more than it rounds: it holds the true t. `accel`'s own t is off by u·|t| and, from double precision, by less than 2⁻²⁵
//! of the slack below: with |t| ≥ 2·slack less than 2·u·|t|, and the move into the interval is accepted up to 16·u·|t|.
//! (t is then at least 2·slack > 2⁻¹¹⁰, far from what underflows.) The rest is the ray's range, which must hold all
//! of [t − slack, t + slack].
//!
//! # Where: t within (12·x·M/|area| + 2⁻¹⁸·g)·|r_z| of what is computed, if |area| ≥ 8·M
//!
//! With areas u, v, w of one sign, N = v·(B_z − A_z) + w·(C_z − A_z) and the area a, the depth is A_z + N/a, and |N/a| ≤ x
//! as the weights v/a and w/a add up to one at most. Let E be the error of an area: M, or 2·M of a certain hit. From E the computed N/a errs by
//! at most (2·E·x + 3·E·|N/a|)/|area| ≤ 5·x·E/|area| ≤ 10·x·M/|area|. From roundings, as parts of u·g (x ≤ g/2), where the computed weights' sizes may add up to 1.25
//! as each may have the wrong sign by M: B_z − A_z and C_z − A_z, 6.4; the sum of the areas, 2.8; the reciprocal, 3.3;
//! both products and their sum, 4; A_z and the last sum, 4.1: 20.6 at most.
//! Times r_z: u of its own and 2·u of the product, 3.1. `accel` rounds once and moves t into its box's interval, 16·u·|t|:
//! 17.1. t ± slack are rounded, 2.1. That is 42.9·u·g·|r_z|, of 64. M/|area| is rounded too: 10.1 of 12. So every t that
//! `accel` gives lies between t − slack and t + slack, and what is nearer than a certain hit's t + slack can be told from
//! what lies behind it. As x ≥ 2⁻⁵⁰ there (the area is at least 2⁻⁹⁷), the difference also covers what is taken for zero.

/// The largest relative rounding of the CPU.
const UNIT: f32 = f32::EPSILON / 2.0;

/// The margin of a box, as a part of S·|r|.
pub(crate) const BOX: f32 = 48.0 * UNIT;

/// The margins that the shader needs, by their names there.
pub(crate) const CONSTANTS: [(&str, f64); 4] = [
    ("AREA", (128.0 * UNIT) as f64),
    ("FAR_AREA", (2048.0 * UNIT * UNIT) as f64),
    ("LEAST_AREA", f32::from_bits((127 - 100) << 23) as f64),
    ("DEPTH", (64.0 * UNIT) as f64),
];
