//! Lanes as plain arrays: the compiler makes of them what every machine of a kind has.

use std::array::from_fn;

/// Four numbers of single precision.
pub(crate) type F4 = [f32; 4];
/// Eight numbers of single precision.
pub(crate) type F8 = [f32; 8];
/// Four numbers of double precision.
pub(crate) type D4 = [f64; 4];

macro_rules! ops {
    ($($(#[$doc:meta])* fn $name:ident($($argument:ident: $kind:ty),*) -> $result:ty $body:block)*) => {
        $($(#[$doc])*
        #[inline(always)]
        pub(crate) fn $name($($argument: $kind),*) -> $result $body)*
    };
}

/// A bit for each lane.
#[inline(always)]
fn bits<const N: usize>(holds: impl Fn(usize) -> bool) -> u32 {
    (0..N).fold(0, |bits, i| bits | u32::from(holds(i)) << i)
}

/// Plain comparisons, as an instruction makes them: there is no NaN to think of.
#[inline(always)]
fn lesser<T: PartialOrd>(a: T, b: T) -> T {
    if a < b { a } else { b }
}

#[inline(always)]
fn greater<T: PartialOrd>(a: T, b: T) -> T {
    if a > b { a } else { b }
}

ops! {
    fn splat4(x: f32) -> F4 { [x; 4] }
    fn load4(x: &[f32; 4]) -> F4 { *x }
    fn array4(x: F4) -> [f32; 4] { x }
    fn add4(a: F4, b: F4) -> F4 { from_fn(|i| a[i] + b[i]) }
    fn sub4(a: F4, b: F4) -> F4 { from_fn(|i| a[i] - b[i]) }
    fn mul4(a: F4, b: F4) -> F4 { from_fn(|i| a[i] * b[i]) }
    fn div4(a: F4, b: F4) -> F4 { from_fn(|i| a[i] / b[i]) }
    fn min4(a: F4, b: F4) -> F4 { from_fn(|i| lesser(a[i], b[i])) }
    fn max4(a: F4, b: F4) -> F4 { from_fn(|i| greater(a[i], b[i])) }
    /// a·b + c, fused or not.
    fn add_product4(a: F4, b: F4, c: F4) -> F4 { from_fn(|i| a[i] * b[i] + c[i]) }
    /// c − a·b, fused or not.
    fn sub_product4(a: F4, b: F4, c: F4) -> F4 { from_fn(|i| c[i] - a[i] * b[i]) }
    fn abs4(a: F4) -> F4 { from_fn(|i| a[i].abs()) }
    /// With the other sign in lanes where `by` has a minus.
    fn flipped4(a: F4, by: F4) -> F4 { from_fn(|i| f32::from_bits(a[i].to_bits() ^ by[i].to_bits() & (1 << 31))) }
    fn negated4(a: F4) -> F4 { from_fn(|i| -a[i]) }
    /// In which lanes a ≤ b.
    fn at_most4(a: F4, b: F4) -> u32 { bits::<4>(|i| a[i] <= b[i]) }
    /// Lanes 2, 3, 0, 1, or as they are: as `turn` says, which [`turn4`] made.
    fn turned4(a: F4, turn: bool) -> F4 { if turn { [a[2], a[3], a[0], a[1]] } else { a } }
    fn turn4(turned: bool) -> bool { turned }
    /// Lanes 2, 3, 2, 3.
    fn upper4(a: F4) -> F4 { [a[2], a[3], a[2], a[3]] }

    /// Lets a hit of triangle `prim` at `met` stand in some lanes, where it is nearer, or as near and the number is
    /// smaller; in which lanes that is.
    fn offer4(t: &mut [f32; 4], prims: &mut [u32; 4], met: F4, prim: u32, lanes: u32) -> u32 {
        let is_better = |i: usize| met[i] < t[i] || met[i] == t[i] && prim < prims[i];
        let better = lanes & bits::<4>(is_better);
        for i in (0..4).filter(|i| better >> i & 1 == 1) {
            (t[i], prims[i]) = (met[i], prim);
        }
        better
    }

    fn splat8(x: f32) -> F8 { [x; 8] }
    fn load8(x: &[f32; 8]) -> F8 { *x }
    fn array8(x: F8) -> [f32; 8] { x }
    fn min8(a: F8, b: F8) -> F8 { from_fn(|i| lesser(a[i], b[i])) }
    fn max8(a: F8, b: F8) -> F8 { from_fn(|i| greater(a[i], b[i])) }
    /// a·b + c, fused or not.
    fn add_product8(a: F8, b: F8, c: F8) -> F8 { from_fn(|i| a[i] * b[i] + c[i]) }

    fn double4(x: F4) -> D4 { x.map(f64::from) }
    /// Rounded to single precision.
    fn single4(x: D4) -> [f32; 4] { x.map(|x| x as f32) }
    fn splat_d4(x: f64) -> D4 { [x; 4] }
    fn add_d4(a: D4, b: D4) -> D4 { from_fn(|i| a[i] + b[i]) }
    fn sub_d4(a: D4, b: D4) -> D4 { from_fn(|i| a[i] - b[i]) }
    fn mul_d4(a: D4, b: D4) -> D4 { from_fn(|i| a[i] * b[i]) }
    fn div_d4(a: D4, b: D4) -> D4 { from_fn(|i| a[i] / b[i]) }
    fn abs_d4(a: D4) -> D4 { from_fn(|i| a[i].abs()) }
    fn max_d4(a: D4, b: D4) -> D4 { from_fn(|i| greater(a[i], b[i])) }
    fn min_d4(a: D4, b: D4) -> D4 { from_fn(|i| lesser(a[i], b[i])) }
    /// In which lanes a < b.
    fn below_d4(a: D4, b: D4) -> u32 { bits::<4>(|i| a[i] < b[i]) }
    /// In which lanes a ≤ b.
    fn at_most_d4(a: D4, b: D4) -> u32 { bits::<4>(|i| a[i] <= b[i]) }

    /// In which lanes a ≤ b.
    fn at_most8(a: F8, b: F8) -> u32 { bits::<8>(|i| a[i] <= b[i]) }
    fn mul8(a: F8, b: F8) -> F8 { from_fn(|i| a[i] * b[i]) }
    fn div8(a: F8, b: F8) -> F8 { from_fn(|i| a[i] / b[i]) }
    fn abs8(a: F8) -> F8 { from_fn(|i| a[i].abs()) }
    /// The least and the greatest of all lanes.
    fn least8(a: F8) -> f32 { a.into_iter().fold(f32::INFINITY, lesser) }
    fn most8(a: F8) -> f32 { a.into_iter().fold(f32::NEG_INFINITY, greater) }
    fn splats4(x: [f32; 3]) -> [F4; 3] { [splat4(x[0]), splat4(x[1]), splat4(x[2])] }
    fn splats8(x: [f32; 3]) -> [F8; 3] { [splat8(x[0]), splat8(x[1]), splat8(x[2])] }
    /// In which lanes the sign is a minus.
    fn minus8(a: F8) -> u32 { bits::<8>(|i| a[i].is_sign_negative()) }
    /// In which lanes a < b.
    fn below8(a: F8, b: F8) -> u32 { bits::<8>(|i| a[i] < b[i]) }
}
