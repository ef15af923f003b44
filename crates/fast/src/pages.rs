//! Arrays in large pages, where the system lends them: a walk through a large tree then seldom waits until a page's place
//! is looked up.

use std::ops::{Deref, DerefMut};

use bytemuck::{AnyBitPattern, NoUninit};

/// An array of plain values.
#[derive(Debug)]
pub(crate) struct Pages<T> {
    values: Kept<T>,
}

/// Smaller arrays are left to the allocator.
#[cfg(target_os = "linux")]
const LARGE: usize = 4 << 20;

#[derive(Debug)]
enum Kept<T> {
    Small(Vec<T>),
    #[cfg(target_os = "linux")]
    Large(memmap2::MmapMut, std::marker::PhantomData<T>),
}

impl<T: AnyBitPattern + NoUninit> Pages<T> {
    /// So many values of zero bits.
    pub(crate) fn zeroed(many: usize) -> Pages<T> {
        #[cfg(target_os = "linux")]
        if many.saturating_mul(size_of::<T>()) >= LARGE
            && let Ok(map) = memmap2::MmapMut::map_anon(many * size_of::<T>())
        {
            // Whether the system heeds it or not, all is well.
            let _ = map.advise(memmap2::Advice::HugePage);
            return Pages { values: Kept::Large(map, std::marker::PhantomData) };
        }
        Pages { values: Kept::Small(vec![T::zeroed(); many]) }
    }

    /// The same values in large pages.
    pub(crate) fn of(values: &[T]) -> Pages<T> {
        let mut own = Pages::zeroed(values.len());
        own.copy_from_slice(values);
        own
    }
}

impl<T: AnyBitPattern + NoUninit> Deref for Pages<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        match &self.values {
            Kept::Small(values) => values,
            #[cfg(target_os = "linux")]
            Kept::Large(map, _) => bytemuck::cast_slice(map),
        }
    }
}

impl<T: AnyBitPattern + NoUninit> DerefMut for Pages<T> {
    fn deref_mut(&mut self) -> &mut [T] {
        match &mut self.values {
            Kept::Small(values) => values,
            #[cfg(target_os = "linux")]
            Kept::Large(map, _) => bytemuck::cast_slice_mut(map),
        }
    }
}

impl<T: AnyBitPattern + NoUninit> Clone for Pages<T> {
    fn clone(&self) -> Pages<T> {
        Pages::of(self)
    }
}
