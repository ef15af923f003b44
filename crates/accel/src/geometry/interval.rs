//! A closed interval of t along a ray.

/// `[near, far]`; empty when `near > far`. A single point is not empty.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Where it begins.
    pub near: f32,
    /// Where it ends.
    pub far: f32,
}

impl Interval {
    /// The whole line.
    pub const ALL: Interval = Interval { near: f32::NEG_INFINITY, far: f32::INFINITY };

    /// `[near, far]`.
    #[inline]
    pub fn new(near: f32, far: f32) -> Interval {
        Interval { near, far }
    }

    /// Whether no t lies in it.
    #[inline]
    pub fn is_empty(self) -> bool {
        self.near > self.far
    }

    /// Whether `t` lies in it, ends included.
    #[inline]
    pub fn contains(self, t: f32) -> bool {
        self.near <= t && t <= self.far
    }

    /// Both ends, unless it is empty.
    #[inline]
    pub fn ends(self) -> Option<[f32; 2]> {
        (!self.is_empty()).then_some([self.near, self.far])
    }

    /// The t of the interval closest to `t`. The interval must not be empty.
    #[inline]
    pub fn clamp(self, t: f32) -> f32 {
        if t < self.near {
            self.near
        } else if t > self.far {
            self.far
        } else {
            t
        }
    }
}
