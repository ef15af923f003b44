//! Two levels, slide 27: each model has a tree of its own, however often it is placed, and one more stands over the boxes
//! of all instances.

mod upper;

use raystep_accel::{Aabb, Hit, Instance, Instances, Interval, Primitives, Ray, Want};

use crate::build::Settings;
use crate::bvh8::Bvh8;
use crate::fast::Fast;
use crate::judge::Count;
use upper::Upper;

/// Instances of meshes, answered as [`Instances::brute_force`] answers: the same t, the same instance, the same triangle
/// of its model.
#[derive(Clone, Debug)]
pub struct TwoLevels {
    models: Vec<Bvh8>,
    placed: Vec<Instance>,
    upper: Upper,
}

impl TwoLevels {
    /// Builds a tree for each model and the one over all instances, on the threads of the current pool. The structures
    /// that the models have already are not used.
    pub fn build(instances: &Instances, settings: &Settings) -> TwoLevels {
        let models = instances.models().iter().map(|model| Bvh8::build(&model.mesh, settings)).collect();
        let boxes: Vec<Aabb> = instances.placed().iter().map(|placed| placed.bounds).collect();
        debug_assert_eq!(boxes.len(), instances.len());
        TwoLevels { models, placed: instances.placed().to_vec(), upper: Upper::over(&boxes) }
    }
}

impl Fast for TwoLevels {
    fn walk(&self, ray: &Ray, want: Want, count: &mut impl Count) -> Option<Hit> {
        let mut best: Option<Hit> = None;
        self.upper.walk(ray, count, |instance, t_max, count| {
            let placed = &self.placed[instance.index()];
            // Only what lies in the instance's own box counts. What lies as far as the best hit may still have a smaller id.
            let met = placed.met(instance, ray, &mut ());
            let local = placed.local(ray, Interval::new(met.near, met.far.min(t_max)))?;
            let inner = self.models[placed.model as usize].walk(&local, want, count)?;
            let is_better = best.is_none_or(|best| inner.t < best.t || (inner.t == best.t && instance < best.prim));
            if is_better {
                best = Some(Hit { t: inner.t, prim: instance, inner: Some(inner.prim) });
            }
            Some(if want == Want::Any { f32::NEG_INFINITY } else { best.map_or(t_max, |best| best.t) })
        });
        best
    }

    fn bytes(&self) -> usize {
        let models: usize = self.models.iter().map(Bvh8::bytes).sum();
        models + size_of_val(&*self.placed) + self.upper.bytes()
    }
}
