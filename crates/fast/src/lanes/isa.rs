//! Which instructions a walk uses.

use std::fmt;

/// A set of instructions that this machine has. Only asking the machine makes one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Isa(Which);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Which {
    #[cfg(target_arch = "x86_64")]
    Avx512,
    #[cfg(target_arch = "x86_64")]
    Avx2,
    Portable,
}

impl Isa {
    /// The best that this machine has.
    pub fn best() -> Isa {
        Isa::all()[0]
    }

    /// All that this machine has, the best first. The last is what the compiler makes of plain arrays: SSE2 on every
    /// x86-64, NEON on every AArch64.
    pub fn all() -> Vec<Isa> {
        let mut all = Vec::new();
        #[cfg(target_arch = "x86_64")]
        {
            let bits = std::is_x86_feature_detected!("bmi1")
                && std::is_x86_feature_detected!("bmi2")
                && std::is_x86_feature_detected!("lzcnt")
                && std::is_x86_feature_detected!("popcnt");
            let avx2 = bits && std::is_x86_feature_detected!("avx2") && std::is_x86_feature_detected!("fma");
            if avx2 {
                all.push(Isa(Which::Avx2));
            }
            // The walks have lanes of 256 bits either way; the longer instructions were up to 6 % slower on a Zen 5, and
            // nowhere quicker by more than the spread (peers/README.md).
            if avx2
                && std::is_x86_feature_detected!("avx512f")
                && std::is_x86_feature_detected!("avx512vl")
                && std::is_x86_feature_detected!("avx512dq")
                && std::is_x86_feature_detected!("avx512bw")
            {
                all.push(Isa(Which::Avx512));
            }
        }
        all.push(Isa(Which::Portable));
        all
    }

    pub(crate) fn which(self) -> Which {
        self.0
    }

    /// Its name: `avx512`, `avx2`, `sse2`, `neon`, or `portable` elsewhere.
    pub fn name(self) -> &'static str {
        match self.0 {
            #[cfg(target_arch = "x86_64")]
            Which::Avx512 => "avx512",
            #[cfg(target_arch = "x86_64")]
            Which::Avx2 => "avx2",
            Which::Portable if cfg!(target_arch = "x86_64") => "sse2",
            Which::Portable if cfg!(target_arch = "aarch64") => "neon",
            Which::Portable => "portable",
        }
    }
}

impl fmt::Display for Isa {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
