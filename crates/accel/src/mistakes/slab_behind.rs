//! The slab test without t ≥ 0: a ray becomes a line.

use crate::{Hit, Interval, Observer, OneBox, Place, Ray, Verdict, Visit, slab};

pub(super) fn walk(one: &OneBox, ray: &Ray, watch: &mut impl Observer<Visit>) -> Option<Hit> {
    // MISTAKE: the search begins with all t, not with those of the ray.
    let within = Interval::ALL;
    let part = slab(&one.bounds, ray, within, Place::World, watch);
    let verdict = if part.is_empty() { Verdict::Miss } else { Verdict::Hit };
    let (t_near, t_far) = (part.near, part.far);
    watch.on(Visit::Volume { place: Place::World, t_near, t_far, best_t: f32::INFINITY, verdict });
    None
}
