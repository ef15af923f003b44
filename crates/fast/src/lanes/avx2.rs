//! Lanes with AVX2 and fused multiply-add.

use super::registers::registers;

registers! { "avx2,fma,bmi1,bmi2,lzcnt,popcnt",
    /// In which lanes a ≤ b.
    fn at_most8(a: F8, b: F8) -> u32 { _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(a, b)) as u32 }
}
