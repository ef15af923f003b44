//! Bounding volumes, slides 49-52: shapes around sets of primitives that a ray can be tested against first.

mod aligned_box;
mod appraisal;
mod around;
mod draft;
mod hull;
mod kdop;
mod oriented_box;
mod outline;
mod quickhull;
mod smallest_sphere;

use std::fmt::Debug;

use glam::{DVec3, Vec3};

pub use appraisal::Appraisal;
pub use around::fit_around;
pub use draft::{Draft, Spans};
pub use hull::Hull;
pub use kdop::KDop;
pub use outline::Outline;
pub use quickhull::outline;

use crate::events::{BETWEEN_LOOKS, patiently};
use crate::{
    Aabb, Axes, Cancelled, Corner, Direction, Fit, Interval, Measure, Observer, Place, PrimId, Primitives, Ray, Visit,
};

/// A shape that holds a set of primitives and is tested before any of them.
///
/// What brute force calls a hit is moved by rounding: its t is a single-precision number, clamped into the
/// primitive's own box. Volumes along the axes bracket such a t exactly (see [`slab`](crate::slab)); all
/// others test a body that is a little larger, the more so the further away the ray starts.
pub trait Volume: Clone + Debug + PartialEq {
    /// What stands for it while a tree is put together.
    type Draft: Draft;

    /// What keeps the ray from being measured against it, if anything does.
    #[inline]
    fn bars(_: &Ray) -> Option<Visit> {
        None
    }

    /// The volume around some primitives; `bounds` is the box around them. There must be at least one.
    ///
    /// # Errors
    /// `watch` asked to give up.
    fn fit<P: Primitives>(
        prims: &P,
        ids: impl Iterator<Item = PrimId>,
        bounds: &Aabb,
        axes: Axes,
        watch: &mut impl Observer<Fit>,
    ) -> Result<Self, Cancelled>;

    /// The part of `within` for which the ray lies in the volume; empty if it misses.
    fn meet(&self, ray: &Ray, within: Interval, place: Place, watch: &mut impl Observer<Visit>) -> Interval;

    /// The box around it.
    fn bounds(&self) -> Aabb;

    /// Its surface, as a picture or a sum needs it.
    fn outline(&self) -> Outline;

    /// Its surface, or in a flat scene the length of its outline.
    fn measure(&self, measure: Measure) -> f32 {
        self.outline().measure(measure)
    }

    /// How much room it encloses.
    fn content(&self) -> f64 {
        self.outline().content()
    }

    /// How many planes bound it: 0 of what is round.
    fn planes(&self) -> u32;

    /// How much memory it takes.
    fn bytes(&self) -> usize {
        size_of::<Self>()
    }
}

/// By which part of the distance between a ray's origin and the far side of a volume the volume is larger
/// when it is tested: 128 roundings. A hit moves by 8 when it is clamped into its primitive's box, a triangle
/// seen edge-on leaves its t uncertain by about 80, and the test itself errs by a few.
const SLACK: f32 = 128.0 * f32::EPSILON;

/// More than [`SLACK`] loses where the squares of lengths are too small for single precision, and by how much more
/// than rounding to the smallest steps of t, 10⁻⁴⁵, moves a point along a direction of length one. (A number as small
/// as those steps would do, but processors are slow to reckon with them.)
const LOST: f32 = 1e-27;

/// By how much a volume is larger for a ray whose origin lies at `f` from its middle, if it reaches `reach`
/// from there, in world units.
#[inline]
fn slack(ray: &Ray, f: Vec3, reach: f32) -> f32 {
    SLACK * (f.length() + reach) + LOST * (1.0 + ray.d.abs().element_sum())
}

/// The corners of all primitives of a set.
fn corners<P: Primitives>(
    prims: &P,
    ids: impl Iterator<Item = PrimId>,
    watch: &mut impl Observer<Fit>,
) -> Result<Vec<Corner>, Cancelled> {
    let mut corners = Vec::new();
    for prim in patiently(ids, watch) {
        prims.shape(prim?).corners(|corner| corners.push(corner));
    }
    watch.on(Fit::Gather { points: corners.len() as u32 });
    Ok(corners)
}

/// How far the corners reach along each of some normals, in one pass.
fn spans(
    corners: &[Corner],
    center: Vec3,
    normals: &[DVec3],
    watch: &mut impl Observer<Fit>,
) -> Result<Vec<[f64; 2]>, Cancelled> {
    spans_told(corners, center, normals, watch, |_, _, _, _| {})
}

/// The same; `moved` hears which of the normals has its two planes pushed out, where they lie now, and how many corners
/// lie between them.
fn spans_told<W: Observer<Fit>>(
    corners: &[Corner],
    center: Vec3,
    normals: &[DVec3],
    watch: &mut W,
    mut moved: impl FnMut(&mut W, usize, [f64; 2], u32),
) -> Result<Vec<[f64; 2]>, Cancelled> {
    let mut spans = vec![[f64::INFINITY, f64::NEG_INFINITY]; normals.len()];
    let mut seen = 0;
    for piece in corners.chunks(BETWEEN_LOOKS) {
        if watch.cancelled() {
            return Err(Cancelled);
        }
        seen += piece.len() as u32;
        for (index, (span_so_far, &n)) in spans.iter_mut().zip(normals).enumerate() {
            let ([least, most], [low, high]) = (span(piece, center, n), *span_so_far);
            *span_so_far = [low.min(least), high.max(most)];
            if least < low || most > high {
                moved(watch, index, *span_so_far, seen);
            }
        }
    }
    Ok(spans)
}

/// A place or a direction as it is told of something of this `size`: of coordinates so small that single precision does not
/// see them beside it, nothing is left but rounding, and they are told as 0.
#[inline]
fn told(at: DVec3, size: f64) -> Vec3 {
    at.as_vec3().map(|x| if f64::from(x).abs() <= f64::from(f32::EPSILON) * size { 0.0 } else { x })
}

/// Tells of two planes across a direction that were pushed out.
fn push(watch: &mut impl Observer<Fit>, axis: Direction, normal: DVec3, [low, high]: [f64; 2], points: u32) {
    let Vec3 { x, y, z } = told(normal, 1.0);
    watch.on(Fit::Push { axis, x, y, z, low: low as f32, high: high as f32, points });
}

/// How far the corners reach along `n`, seen from `center`: the lowest and the highest coordinate.
fn span(corners: &[Corner], center: Vec3, n: DVec3) -> [f64; 2] {
    let length = n.length();
    corners.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], corner| {
        let at = n.dot(corner.at.as_dvec3() - center.as_dvec3());
        let radius = f64::from(corner.radius) * length;
        [low.min(at - radius), high.max(at + radius)]
    })
}
