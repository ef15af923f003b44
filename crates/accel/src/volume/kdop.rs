//! The k-DOP, slide 52: a discrete orientation polytope, the common part of slabs in fixed directions.

use glam::{DVec3, Vec3};

use super::{Outline, Spans, Volume, corners, push, slack, spans_told};
use crate::common::bars_projection;
use crate::slab::Slab;
use crate::{
    Aabb, Axes, Axis, Cancelled, Direction, Fit, Interval, Observer, Place, PrimId, Primitives, Ray, Visit, slab,
};

/// A box with `N` more slabs: those of [`Direction::SLANTED`] from `FIRST` on. The number of planes, k, is
/// 6 + 2·`N`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KDop<const FIRST: usize, const N: usize> {
    /// Its first three slabs.
    pub bounds: Aabb,
    /// Its slanted slabs, seen from the middle of the box.
    pub slabs: [[f32; 2]; N],
}

impl Direction {
    /// The directions of [`Direction::SLANTED`] as vectors.
    pub const SLANTED_VECTORS: [Vec3; 10] = [
        Vec3::new(1.0, 1.0, 1.0),
        Vec3::new(1.0, 1.0, -1.0),
        Vec3::new(1.0, -1.0, 1.0),
        Vec3::new(1.0, -1.0, -1.0),
        Vec3::new(1.0, 1.0, 0.0),
        Vec3::new(1.0, -1.0, 0.0),
        Vec3::new(1.0, 0.0, 1.0),
        Vec3::new(1.0, 0.0, -1.0),
        Vec3::new(0.0, 1.0, 1.0),
        Vec3::new(0.0, 1.0, -1.0),
    ];
}

impl<const FIRST: usize, const N: usize> Volume for KDop<FIRST, N> {
    type Draft = Spans;

    #[inline]
    fn bars(ray: &Ray) -> Option<Visit> {
        if N == 0 { None } else { bars_projection(ray) }
    }

    fn fit<P: Primitives>(
        prims: &P,
        ids: impl Iterator<Item = PrimId>,
        bounds: &Aabb,
        _: Axes,
        watch: &mut impl Observer<Fit>,
    ) -> Result<Self, Cancelled> {
        let corners = if N == 0 { Vec::new() } else { corners(prims, ids, watch)? };
        let normals: [DVec3; N] = std::array::from_fn(|i| normal(FIRST + i));
        // The first three slabs are those of the box.
        let half = (bounds.extent() * 0.5).as_dvec3();
        for axis in [Axis::X, Axis::Y, Axis::Z] {
            let (at, way) = (half[axis.index()], DVec3::AXES[axis.index()]);
            push(watch, axis.into(), way, [-at, at], corners.len() as u32);
        }
        let spans = spans_told(&corners, bounds.center(), &normals, watch, |watch, i, span, points| {
            push(watch, Direction::Slanted((FIRST + i) as u8), normals[i], span, points);
        })?;
        Ok(KDop { bounds: *bounds, slabs: std::array::from_fn(|i| spans[i].map(|at| at as f32)) })
    }

    fn meet(&self, ray: &Ray, within: Interval, place: Place, watch: &mut impl Observer<Visit>) -> Interval {
        // The slabs of the box first.
        let mut live = slab(&self.bounds, ray, within, place, watch);
        if N == 0 || live.is_empty() {
            return live;
        }
        // Then the slanted ones, whose normals are up to √3 long.
        let f = ray.o - self.bounds.center();
        let slack = 2.0 * slack(ray, f, self.bounds.extent().length() * 0.5);
        for (i, &[low, high]) in self.slabs.iter().enumerate() {
            let n = Direction::SLANTED_VECTORS[FIRST + i];
            let across = Direction::Slanted((FIRST + i) as u8);
            let cut = Slab { across, o: n.dot(f), d: n.dot(ray.d), low: low - slack, high: high + slack };
            live = cut.narrow(live, place, watch);
            if live.is_empty() {
                break;
            }
        }
        live
    }

    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn planes(&self) -> u32 {
        6 + 2 * N as u32
    }

    fn outline(&self) -> Outline {
        let half = self.bounds.extent() * 0.5;
        let straight = DVec3::AXES.into_iter().zip(half.to_array()).flat_map(|(n, half)| {
            let half = f64::from(half);
            [(n, half), (-n, half)]
        });
        let slanted = self.slabs.iter().enumerate().flat_map(|(i, &[low, high])| {
            let n = normal(FIRST + i);
            [(n, f64::from(high)), (-n, -f64::from(low))]
        });
        Outline::of_planes(self.bounds.center(), straight.chain(slanted))
    }
}

fn normal(slanted: usize) -> DVec3 {
    Direction::SLANTED_VECTORS[slanted].as_dvec3()
}
