//! Lanes: several numbers to one instruction, and which instructions this machine has.
//!
//! Each file has the same functions for one set of instructions. The walks are written once, in terms of these
//! functions, and stamped out for each set (see [`stamped`]); [`Isa`] says which set a walk is to use.

#[cfg(target_arch = "x86_64")]
pub(crate) mod avx2;
#[cfg(target_arch = "x86_64")]
pub(crate) mod avx512;
mod isa;
pub(crate) mod portable;
#[cfg(target_arch = "x86_64")]
mod registers;

pub use isa::Isa;

/// Stamps out the items of a macro for each set of instructions: a module each, named like the lanes that it uses.
macro_rules! stamped {
    ($items:ident) => {
        #[cfg(target_arch = "x86_64")]
        pub(crate) mod avx512 {
            $items! { #[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw,avx2,fma,bmi1,bmi2,lzcnt,popcnt")] avx512 }
        }
        #[cfg(target_arch = "x86_64")]
        pub(crate) mod avx2 {
            $items! { #[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt,popcnt")] avx2 }
        }
        pub(crate) mod portable {
            $items! { portable }
        }
    };
}

/// Calls the stamped function that is meant for the set of instructions `$isa`.
macro_rules! dispatch {
    ($isa:expr, $room:ident :: $walk:ident $(::<$($kind:tt),*>)? ($($argument:expr),* $(,)?)) => {
        match $isa.which() {
            #[cfg(target_arch = "x86_64")]
            #[allow(unsafe_code, reason = "an `Isa` of this kind is only made where the machine was asked and has all of these instructions")]
            crate::lanes::Which::Avx512 => unsafe { $room::avx512::$walk $(::<$($kind),*>)? ($($argument),*) },
            #[cfg(target_arch = "x86_64")]
            #[allow(unsafe_code, reason = "an `Isa` of this kind is only made where the machine was asked and has all of these instructions")]
            crate::lanes::Which::Avx2 => unsafe { $room::avx2::$walk $(::<$($kind),*>)? ($($argument),*) },
            crate::lanes::Which::Portable => $room::portable::$walk $(::<$($kind),*>)? ($($argument),*),
        }
    };
}

pub(crate) use isa::Which;
pub(crate) use {dispatch, stamped};
