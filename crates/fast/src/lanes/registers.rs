//! Lanes in registers of up to 256 bits: what AVX2 and AVX-512 have in common.

/// Makes the functions of lanes for a set of features; behind its name, those in which the sets differ.
macro_rules! registers {
    ($features:literal, $($own:tt)*) => {
        use std::arch::x86_64::*;

        use bytemuck::cast;

        use crate::lanes::registers::functions;

        /// Four numbers of single precision.
        pub(crate) type F4 = __m128;
        /// Eight numbers of single precision.
        pub(crate) type F8 = __m256;
        /// Four numbers of double precision.
        pub(crate) type D4 = __m256d;

        functions! { $features, $($own)*
            fn splat4(x: f32) -> F4 { _mm_set1_ps(x) }
            fn load4(x: &[f32; 4]) -> F4 { cast(*x) }
            fn array4(x: F4) -> [f32; 4] { cast(x) }
            fn add4(a: F4, b: F4) -> F4 { _mm_add_ps(a, b) }
            fn sub4(a: F4, b: F4) -> F4 { _mm_sub_ps(a, b) }
            fn mul4(a: F4, b: F4) -> F4 { _mm_mul_ps(a, b) }
            fn div4(a: F4, b: F4) -> F4 { _mm_div_ps(a, b) }
            fn min4(a: F4, b: F4) -> F4 { _mm_min_ps(a, b) }
            fn max4(a: F4, b: F4) -> F4 { _mm_max_ps(a, b) }
            /// a·b + c, fused or not.
            fn add_product4(a: F4, b: F4, c: F4) -> F4 { _mm_fmadd_ps(a, b, c) }
            /// c − a·b, fused or not.
            fn sub_product4(a: F4, b: F4, c: F4) -> F4 { _mm_fnmadd_ps(a, b, c) }
            fn abs4(a: F4) -> F4 { _mm_andnot_ps(_mm_set1_ps(-0.0), a) }
            /// With the other sign in lanes where `by` has a minus.
            fn flipped4(a: F4, by: F4) -> F4 { _mm_xor_ps(a, _mm_and_ps(_mm_set1_ps(-0.0), by)) }
            fn negated4(a: F4) -> F4 { _mm_xor_ps(_mm_set1_ps(-0.0), a) }
            /// In which lanes a ≤ b.
            fn at_most4(a: F4, b: F4) -> u32 { _mm_movemask_ps(_mm_cmple_ps(a, b)) as u32 }
            /// Lanes 2, 3, 0, 1, or as they are: as `turn` says, which [`turn4`] made.
            fn turned4(a: F4, turn: __m128i) -> F4 { _mm_permutevar_ps(a, turn) }
            fn turn4(turned: bool) -> __m128i { if turned { _mm_setr_epi32(2, 3, 0, 1) } else { _mm_setr_epi32(0, 1, 2, 3) } }
            /// Lanes 2, 3, 2, 3.
            fn upper4(a: F4) -> F4 { _mm_movehl_ps(a, a) }

            /// Lets a hit of triangle `prim` at `met` stand in some lanes, where it is nearer, or as near and the number is
            /// smaller; in which lanes that is.
            fn offer4(t: &mut [f32; 4], prims: &mut [u32; 4], met: F4, prim: u32, lanes: u32) -> u32 {
                let (old_t, old) = (load4(t), cast::<[u32; 4], __m128i>(*prims));
                let own = _mm_set1_epi32(prim as i32);
                let bit = _mm_setr_epi32(1, 2, 4, 8);
                let lanes = _mm_cmpeq_epi32(_mm_and_si128(_mm_set1_epi32(lanes as i32), bit), bit);
                let no_less = _mm_castsi128_ps(_mm_cmpeq_epi32(_mm_max_epu32(own, old), own));
                let nearer = _mm_or_ps(_mm_cmplt_ps(met, old_t), _mm_andnot_ps(no_less, _mm_cmpeq_ps(met, old_t)));
                let better = _mm_and_ps(_mm_castsi128_ps(lanes), nearer);
                *t = cast(_mm_blendv_ps(old_t, met, better));
                *prims = cast(_mm_blendv_epi8(old, own, _mm_castps_si128(better)));
                _mm_movemask_ps(better) as u32
            }

            fn splat8(x: f32) -> F8 { _mm256_set1_ps(x) }
            fn load8(x: &[f32; 8]) -> F8 { cast(*x) }
            fn array8(x: F8) -> [f32; 8] { cast(x) }
            fn min8(a: F8, b: F8) -> F8 { _mm256_min_ps(a, b) }
            fn max8(a: F8, b: F8) -> F8 { _mm256_max_ps(a, b) }
            /// a·b + c, fused or not.
            fn add_product8(a: F8, b: F8, c: F8) -> F8 { _mm256_fmadd_ps(a, b, c) }

            fn double4(x: F4) -> D4 { _mm256_cvtps_pd(x) }
            /// Rounded to single precision.
            fn single4(x: D4) -> [f32; 4] { cast(_mm256_cvtpd_ps(x)) }
            fn splat_d4(x: f64) -> D4 { _mm256_set1_pd(x) }
            fn add_d4(a: D4, b: D4) -> D4 { _mm256_add_pd(a, b) }
            fn sub_d4(a: D4, b: D4) -> D4 { _mm256_sub_pd(a, b) }
            fn mul_d4(a: D4, b: D4) -> D4 { _mm256_mul_pd(a, b) }
            fn div_d4(a: D4, b: D4) -> D4 { _mm256_div_pd(a, b) }
            fn abs_d4(a: D4) -> D4 { _mm256_andnot_pd(_mm256_set1_pd(-0.0), a) }
            fn max_d4(a: D4, b: D4) -> D4 { _mm256_max_pd(a, b) }
            fn min_d4(a: D4, b: D4) -> D4 { _mm256_min_pd(a, b) }
            /// In which lanes a < b.
            fn below_d4(a: D4, b: D4) -> u32 { _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LT_OQ>(a, b)) as u32 }
            /// In which lanes a ≤ b.
            fn at_most_d4(a: D4, b: D4) -> u32 { _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LE_OQ>(a, b)) as u32 }

            fn mul8(a: F8, b: F8) -> F8 { _mm256_mul_ps(a, b) }
            fn div8(a: F8, b: F8) -> F8 { _mm256_div_ps(a, b) }
            fn abs8(a: F8) -> F8 { _mm256_andnot_ps(_mm256_set1_ps(-0.0), a) }
            /// The least and the greatest of all lanes.
            fn least8(a: F8) -> f32 {
                let a = _mm_min_ps(_mm256_castps256_ps128(a), _mm256_extractf128_ps::<1>(a));
                let a = _mm_min_ps(a, _mm_movehl_ps(a, a));
                _mm_cvtss_f32(_mm_min_ss(a, _mm_shuffle_ps::<1>(a, a)))
            }
            fn most8(a: F8) -> f32 {
                let a = _mm_max_ps(_mm256_castps256_ps128(a), _mm256_extractf128_ps::<1>(a));
                let a = _mm_max_ps(a, _mm_movehl_ps(a, a));
                _mm_cvtss_f32(_mm_max_ss(a, _mm_shuffle_ps::<1>(a, a)))
            }
            fn splats4(x: [f32; 3]) -> [F4; 3] { [splat4(x[0]), splat4(x[1]), splat4(x[2])] }
            fn splats8(x: [f32; 3]) -> [F8; 3] { [splat8(x[0]), splat8(x[1]), splat8(x[2])] }
            /// In which lanes the sign is a minus.
            fn minus8(a: F8) -> u32 { _mm256_movemask_ps(a) as u32 }
            /// In which lanes a < b.
            fn below8(a: F8, b: F8) -> u32 { _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LT_OQ>(a, b)) as u32 }
        }
    };
}

/// Functions for machines with some features.
macro_rules! functions {
    ($features:literal, $($(#[$doc:meta])* fn $name:ident($($argument:ident: $kind:ty),*) -> $result:ty $body:block)*) => {
        $($(#[$doc])*
        #[target_feature(enable = $features)]
        #[inline]
        pub(crate) fn $name($($argument: $kind),*) -> $result $body)*
    };
}

pub(crate) use {functions, registers};
