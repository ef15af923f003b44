//! The walks of `raystep-accel` with every word to the observer taken out by hand, line by line.
//!
//! They stand here so that a benchmark can tell what observing costs when nobody watches. Whoever
//! changes a walk changes its copy; the benchmark fails if the two answer differently.

pub(crate) mod bvh;
pub(crate) mod grid;
pub(crate) mod kd;

use raystep_accel::{Aabb, Axis, Hit, Interval, PrimId, Primitives, Ray, Want};

const ROUNDING: f32 = 4.0 * f32::EPSILON;

/// The slab test.
#[inline(always)]
pub(crate) fn slab(bounds: &Aabb, ray: &Ray, within: Interval) -> Interval {
    let Interval { near: mut t_near, far: mut t_far } = within;
    for axis in Axis::ALL {
        let (o, d) = (ray.o[axis], ray.d[axis]);
        let (low, high) = (bounds.min[axis], bounds.max[axis]);

        let (t1, t2) = if d == 0.0 {
            let inside = low <= o && o <= high;
            if inside { (f32::NEG_INFINITY, f32::INFINITY) } else { (f32::INFINITY, f32::NEG_INFINITY) }
        } else {
            let (t1, t2) = ((low - o) / d, (high - o) / d);
            let swapped = t1 > t2;
            let (t1, t2) = if swapped { (t2, t1) } else { (t1, t2) };
            (earlier(t1), later(t2))
        };

        if t1 > t_near {
            t_near = t1;
        }
        if t2 < t_far {
            t_far = t2;
        }
    }
    Interval::new(t_near, t_far)
}

#[inline]
fn earlier(t: f32) -> f32 {
    if t > 0.0 { t * (1.0 - ROUNDING) } else { t * (1.0 + ROUNDING) }
}

#[inline]
fn later(t: f32) -> f32 {
    -earlier(-t)
}

/// The best hit so far.
#[derive(Clone, Copy)]
pub(crate) struct Best {
    want: Want,
    pub(crate) hit: Option<Hit>,
}

impl Best {
    #[inline]
    fn new(want: Want) -> Best {
        Best { want, hit: None }
    }

    #[inline]
    fn t(&self) -> f32 {
        self.hit.map_or(f32::INFINITY, |hit| hit.t)
    }

    #[inline]
    fn answered(&self) -> bool {
        self.want == Want::Any && self.hit.is_some()
    }

    #[inline]
    fn rules_out(&self, t_near: f32) -> bool {
        self.t() < t_near
    }

    #[inline]
    fn offer(&mut self, found: Hit) {
        let better = match self.hit {
            None => true,
            Some(hit) => found.t < hit.t || (found.t == hit.t && (found.prim, found.inner) < (hit.prim, hit.inner)),
        };
        if better {
            self.hit = Some(found);
        }
    }
}

/// Tests one primitive.
#[inline]
pub(crate) fn test(prims: &impl Primitives, prim: PrimId, ray: &Ray, best: &mut Best) {
    if let Some(t) = prims.intersect(prim, ray) {
        best.offer(Hit { t, prim, inner: None });
    }
}

/// Tests what a leaf refers to.
#[inline(always)]
pub(crate) fn test_each(
    refs: &[PrimId],
    mut mailbox: Option<&mut Mailbox>,
    prims: &impl Primitives,
    ray: &Ray,
    best: &mut Best,
) {
    for &prim in refs {
        if let Some(mailbox) = &mut mailbox {
            if mailbox.holds(prim) {
                continue;
            }
            mailbox.put(prim);
        }
        test(prims, prim, ray, best);
        if best.answered() {
            return;
        }
    }
}

/// What a ray has tested.
pub(crate) struct Mailbox {
    slots: [u32; Mailbox::SLOTS],
}

impl Mailbox {
    const SLOTS: usize = 64;

    #[inline]
    fn new() -> Mailbox {
        Mailbox { slots: [u32::MAX; Mailbox::SLOTS] }
    }

    #[inline]
    fn holds(&self, prim: PrimId) -> bool {
        self.slots[prim.index() % Mailbox::SLOTS] == prim.0
    }

    #[inline]
    fn put(&mut self, prim: PrimId) {
        self.slots[prim.index() % Mailbox::SLOTS] = prim.0;
    }
}
