//! The stack of a walk: our own, of a fixed size, kept from ray to ray, as clearing it would take longer than many a walk.

/// What waits: children, and where the ray enters their boxes. `HIGH` is a power of two, so that a place is found without
/// a branch, and more than can ever wait.
pub(crate) struct Stack<const HIGH: usize> {
    children: [u32; HIGH],
    nears: [f32; HIGH],
}

impl<const HIGH: usize> Stack<HIGH> {
    pub(crate) const EMPTY: Stack<HIGH> = {
        assert!(HIGH.is_power_of_two());
        Stack { children: [0; HIGH], nears: [0.0; HIGH] }
    };

    /// Lets a child wait at a place.
    #[inline(always)]
    pub(crate) fn put(&mut self, place: usize, child: u32, near: f32) {
        self.children[place % HIGH] = child;
        self.nears[place % HIGH] = near;
    }

    /// The child at a place.
    #[inline(always)]
    pub(crate) fn child(&self, place: usize) -> u32 {
        self.children[place % HIGH]
    }

    /// Takes the next child that the ray enters no further out than at `t`, if one is left among `high`.
    #[inline(always)]
    pub(crate) fn take(&self, high: &mut usize, t: f32) -> Option<u32> {
        loop {
            if *high == 0 {
                return None;
            }
            *high -= 1;
            if self.nears[*high % HIGH] <= t {
                return Some(self.children[*high % HIGH]);
            }
        }
    }
}
