//! The slab test with the strict comparison of slides 13 to 15.

use crate::{Axis, Hit, Interval, Observer, OneBox, Place, Ray, Verdict, Visit};

pub(super) fn walk(one: &OneBox, ray: &Ray, watch: &mut impl Observer<Visit>) -> Option<Hit> {
    let place = Place::World;
    let Interval { near: mut t_near, far: mut t_far } = ray.range();
    for axis in Axis::ALL {
        let (o, d) = (ray.o[axis], ray.d[axis]);
        let (low, high) = (one.bounds.min[axis], one.bounds.max[axis]);
        let (t1, t2) = if d == 0.0 {
            let inside = low <= o && o <= high;
            watch.on(Visit::Parallel { place, axis: axis.into(), o, low, high, inside });
            if inside { (f32::NEG_INFINITY, f32::INFINITY) } else { (f32::INFINITY, f32::NEG_INFINITY) }
        } else {
            let (t1, t2) = ((low - o) / d, (high - o) / d);
            watch.on(Visit::Divide { place, axis: axis.into(), o, d, low, high, t1, t2 });
            let swapped = t1 > t2;
            let (t1, t2) = if swapped { (t2, t1) } else { (t1, t2) };
            watch.on(Visit::Order { place, axis: axis.into(), t1, t2, swapped });
            (t1, t2)
        };
        t_near = t_near.max(t1);
        t_far = t_far.min(t2);
        // MISTAKE: an interval of one point counts as empty.
        watch.on(Visit::Narrow { place, axis: axis.into(), t1, t2, t_near, t_far, empty: t_near >= t_far });
    }
    // MISTAKE: the ray may enter and leave at the same t.
    let verdict = if t_near < t_far { Verdict::Hit } else { Verdict::Miss };
    watch.on(Visit::Volume { place, t_near, t_far, best_t: f32::INFINITY, verdict });
    None
}
