//! A ray enters an instance, slide 27.

use super::below::Below;
use super::{Instance, Instances};
use crate::{Accel, Best, Hit, Interval, Observer, Place, PrimId, Primitives, Ray, Verdict, Visit, Want, slab};

impl Instance {
    /// The part of the ray in the instance's box; empty if it misses. `own` is the instance's id.
    ///
    /// As with every primitive, only this part of the ray can meet the instance. The box is roomy enough for rays from
    /// nearby. From so far away that its t, or its origin in the other space, comes in longer steps than that, a ray may
    /// seem to meet what lies beside the box: such a meeting is none, and all structures agree on it.
    #[inline]
    pub fn met(&self, own: PrimId, ray: &Ray, watch: &mut impl Observer<Visit>) -> Interval {
        if self.bounds.is_empty() {
            return Interval::new(f32::INFINITY, f32::NEG_INFINITY);
        }
        slab(&self.bounds, ray, ray.range(), Place::Prim(own), watch)
    }

    /// That part of the ray in the instance's own space: the same `t` is the same point. Nothing if it is empty, or no
    /// ray there.
    #[inline]
    pub fn local(&self, ray: &Ray, part: Interval) -> Option<Ray> {
        if part.is_empty() {
            return None;
        }
        self.local_from_world.ray(ray)?.within(part.near, part.far).ok()
    }
}

impl Instances {
    /// Looks for a hit in one instance and keeps it if it is better.
    pub(super) fn meet(&self, prim: PrimId, ray: &Ray, best: &mut Best, watch: &mut impl Observer<Visit>) {
        let instance = &self.placed[prim.index()];
        // The part of the ray in the instance's box, no further than the best hit.
        let place = Place::Prim(prim);
        let met = instance.met(prim, ray, watch);
        let verdict = match met {
            _ if met.is_empty() => Verdict::Miss,
            _ if best.rules_out(met.near) => Verdict::Cut,
            _ => Verdict::Hit,
        };
        watch.on(Visit::Volume { place, t_near: met.near, t_far: met.far, best_t: best.t(), verdict });
        if verdict != Verdict::Hit {
            return;
        }

        // Move that part into the instance's own space.
        let far = if best.t() < met.far { best.t() } else { met.far };
        let Some(local) = instance.local(ray, Interval::new(met.near, far)) else { return };
        let ([o_x, o_y, o_z], [d_x, d_y, d_z]) = (local.o.to_array(), local.d.to_array());
        watch.on(Visit::Local { instance: prim, o_x, o_y, o_z, d_x, d_y, d_z, t_near: met.near, t_far: far });

        // Walk the structure that is stored there.
        let model = self.model(prim);
        let want = if best.wants_any() { Want::Any } else { Want::Nearest };
        let found = model.structure.walk(&model.mesh, &local, want, &mut Below { watch });

        // Come back: the same t is the same point.
        let t = found.map_or(f32::INFINITY, |hit| hit.t);
        watch.on(Visit::World { instance: prim, t, hit: found.is_some() });
        if let Some(hit) = found {
            best.offer(Hit { t: hit.t, prim, inner: Some(hit.prim) }, watch);
        }
    }

    /// Brute force over the same instances, without structure on either level: the judge.
    pub fn brute_force(&self, ray: &Ray) -> Option<Hit> {
        let mut best = Best::new(Want::Nearest);
        for (index, instance) in self.placed.iter().enumerate() {
            let prim = PrimId(index as u32);
            let Some(local) = instance.local(ray, instance.met(prim, ray, &mut ())) else { continue };
            let mesh = &self.model(prim).mesh;
            for inner in (0..mesh.len() as u32).map(PrimId) {
                if let Some(t) = mesh.intersect(inner, &local) {
                    best.offer(Hit { t, prim, inner: Some(inner) }, &mut ());
                }
            }
        }
        best.hit
    }
}
