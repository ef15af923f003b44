//! What bounds a set while its tree is put together: a volume that is cheap to join and to measure. Once the
//! tree stands, each node gets its true volume.

use crate::{Aabb, Corner, Direction, Measure, Sphere};

/// A stand-in for a volume while pairs of sets are compared.
pub trait Draft: Clone {
    /// Around one primitive.
    fn of(corners: &[Corner], bounds: &Aabb) -> Self;

    /// Around two sets.
    #[must_use]
    fn join(&self, other: &Self) -> Self;

    /// How large it is.
    fn measure(&self, measure: Measure) -> f32;
}

impl Draft for Aabb {
    fn of(_: &[Corner], bounds: &Aabb) -> Aabb {
        *bounds
    }

    #[inline]
    fn join(&self, other: &Aabb) -> Aabb {
        self.union(*other)
    }

    #[inline]
    fn measure(&self, measure: Measure) -> f32 {
        Aabb::measure(self, measure)
    }
}

impl Draft for Sphere {
    fn of(corners: &[Corner], bounds: &Aabb) -> Sphere {
        Sphere::around(corners, bounds, &mut ()).expect("nobody cancels")
    }

    fn join(&self, other: &Sphere) -> Sphere {
        self.union(*other)
    }

    fn measure(&self, measure: Measure) -> f32 {
        super::Volume::measure(self, measure)
    }
}

/// The slabs of a 26-DOP, for all volumes that follow the shape of a set more closely than a box.
#[derive(Clone, Copy, Debug)]
pub struct Spans {
    bounds: Aabb,
    slanted: [[f32; 2]; 10],
}

impl Draft for Spans {
    fn of(corners: &[Corner], bounds: &Aabb) -> Spans {
        let slanted = Direction::SLANTED_VECTORS.map(|n| {
            corners.iter().fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], corner| {
                let (at, radius) = (n.dot(corner.at), corner.radius * n.length());
                [low.min(at - radius), high.max(at + radius)]
            })
        });
        Spans { bounds: *bounds, slanted }
    }

    fn join(&self, other: &Spans) -> Spans {
        let slanted = std::array::from_fn(|i| {
            let ([low, high], [a, b]) = (self.slanted[i], other.slanted[i]);
            [low.min(a), high.max(b)]
        });
        Spans { bounds: self.bounds.union(other.bounds), slanted }
    }

    /// A convex body of the plane has the outline π·w around it if its mean width is w (Cauchy 1832); a body in
    /// space has at most the surface π·w².
    fn measure(&self, measure: Measure) -> f32 {
        let pi = std::f32::consts::PI;
        let width = |i: usize| {
            let [low, high] = self.slanted[i];
            (high - low) / Direction::SLANTED_VECTORS[i].length()
        };
        let e = self.bounds.extent();
        match measure {
            Measure::Perimeter => pi * (e.x + e.y + width(4) + width(5)) / 4.0,
            Measure::Area => {
                let mean = (e.element_sum() + (0..10).map(width).sum::<f32>()) / 13.0;
                pi * mean * mean
            }
        }
    }
}
