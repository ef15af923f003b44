//! The part of a line inside a convex body, narrowed step by step: the slab test's idea, for round things.

use super::{Part, Probe};
use crate::Observer;

/// The t from `near` to `far`; none if `near > far`.
#[derive(Clone, Copy)]
pub(super) struct Inside {
    pub(super) near: f64,
    pub(super) far: f64,
}

impl Inside {
    /// The whole line.
    pub(super) const ALL: Inside = Inside { near: f64::NEG_INFINITY, far: f64::INFINITY };

    /// Narrowed to what lies in `[t1, t2]`.
    pub(super) fn narrow(self, of: Part, [t1, t2]: [f64; 2], watch: &mut impl Observer<Probe>) -> Inside {
        let near = if t1 > self.near { t1 } else { self.near };
        let far = if t2 < self.far { t2 } else { self.far };
        let (t_near, t_far) = (near as f32, far as f32);
        watch.on(Probe::Narrow { of, t1: t1 as f32, t2: t2 as f32, t_near, t_far, empty: near > far });
        Inside { near, far }
    }

    /// Narrowed to where a height that is `h` at the origin and climbs by `slope` lies in `[0, high]`.
    pub(super) fn between(self, h: f64, slope: f64, high: f64, watch: &mut impl Observer<Probe>) -> Inside {
        let of = Part::Ends;
        if slope == 0.0 {
            // Parallel to both ends: between them for ever or never.
            let inside = 0.0 <= h && h <= high;
            watch.on(Probe::Compare { of, value: h as f32, low: 0.0, high: high as f32, inside });
            return if inside { self } else { self.narrow(of, [f64::INFINITY, f64::NEG_INFINITY], watch) };
        }
        let mut cut = |height: f64| {
            let t = height / slope;
            watch.on(Probe::Cut { of, height: height as f32, slant: slope as f32, t: t as f32 });
            t
        };
        let (t1, t2) = (cut(-h), cut(high - h));
        self.narrow(of, if t1 <= t2 { [t1, t2] } else { [t2, t1] }, watch)
    }

    /// Where the line enters and leaves.
    pub(super) fn ends(self) -> Option<[f32; 2]> {
        (self.near <= self.far).then_some([self.near as f32, self.far as f32])
    }
}
