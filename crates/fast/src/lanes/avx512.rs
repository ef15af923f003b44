//! Lanes with AVX-512, on registers of up to 256 bits.

use super::registers::registers;

registers! { "avx512f,avx512vl,avx512dq,avx512bw,avx2,fma,bmi1,bmi2,lzcnt,popcnt",
    /// In which lanes a ≤ b.
    fn at_most8(a: F8, b: F8) -> u32 { u32::from(_mm256_cmp_ps_mask::<_CMP_LE_OQ>(a, b)) }
}
