//! Structures that boards measure, kept for a while: rows and maps of one board, and its draft, ask for the same ones.

use std::collections::VecDeque;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::{Arc, LazyLock, Mutex, PoisonError};

use raystep_accel::{Cancelled, Grow, Hit, Mesh, Observer, Prims, Ray, Structure, Transform};
use raystep_fast::{Bvh8, Fast, Settings, TwoLevels};
use raystep_scene::Scene;

use crate::Plan;

/// Together they have at most so many bytes, but for the last one.
const MOST: usize = 96 << 20;

/// Structures by what they were built over and how, the last one first.
type Kept = VecDeque<(String, Arc<Structure>)>;

static KEPT: LazyLock<Mutex<Kept>> = LazyLock::new(Mutex::default);

/// What `plan` says over a scene, built or found; nothing where the plan cannot be followed.
///
/// # Errors
/// `watch` asked to give up.
pub(super) fn structure(
    plan: &Plan,
    scene: &Scene,
    watch: &mut impl Observer<Grow>,
) -> Result<Option<Arc<Structure>>, Cancelled> {
    let Ok(rule) = plan.rule(scene.flat) else { return Ok(None) };
    // A scene that was changed keeps its name.
    let key = format!("{} {:x} {rule:?}", scene.name, print(&scene.prims));
    let kept = || KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, found)) = kept().iter().find(|(known, _)| *known == key) {
        return Ok(Some(found.clone()));
    }
    let built = Arc::new(Structure::build(&scene.prims, &rule, watch)?);
    let mut kept = kept();
    kept.push_front((key, built.clone()));
    let mut bytes = 0;
    let many = kept.iter().position(|(_, structure)| {
        bytes += structure.bytes();
        bytes > MOST
    });
    let fit = many.unwrap_or(kept.len()).max(1);
    kept.truncate(fit);
    Ok(Some(built))
}

/// A fast structure over meshes, and over instances of them. It answers as those of the textbook do, to the bit.
pub(super) enum Quick {
    /// Over a mesh.
    Mesh(Bvh8),
    /// Over instances.
    Instances(TwoLevels),
}

impl Quick {
    /// The nearest hit.
    pub(super) fn nearest(&self, ray: &Ray) -> Option<Hit> {
        match self {
            Quick::Mesh(tree) => tree.intersect(ray),
            Quick::Instances(tree) => tree.intersect(ray),
        }
    }

    /// Whether there is any hit.
    pub(super) fn any(&self, ray: &Ray) -> bool {
        match self {
            Quick::Mesh(tree) => tree.occluded(ray),
            Quick::Instances(tree) => tree.occluded(ray),
        }
    }
}

/// A fast structure over a scene; nothing where there is none over such primitives.
pub(super) fn fast(scene: &Scene) -> Option<Quick> {
    match &scene.prims {
        Prims::Mesh(mesh) => Some(Quick::Mesh(Bvh8::build(mesh, &Settings::default()))),
        Prims::Instances(instances) => Some(Quick::Instances(TwoLevels::build(instances, &Settings::default()))),
        _ => None,
    }
}

/// A number by which primitives are known again.
fn print(prims: &Prims) -> u64 {
    let mut hasher = DefaultHasher::new();
    match prims {
        Prims::Mesh(mesh) => of_mesh(mesh, &mut hasher),
        // Written out, the models of a forest would fill books.
        Prims::Instances(instances) => {
            for model in instances.models() {
                of_mesh(&model.mesh, &mut hasher);
                (model.structure.node_count(), model.structure.bytes()).hash(&mut hasher);
            }
            for instance in instances.placed() {
                let Transform { matrix, shift } = instance.world_from_local;
                instance.model.hash(&mut hasher);
                matrix.to_cols_array().map(f32::to_bits).hash(&mut hasher);
                shift.to_array().map(f32::to_bits).hash(&mut hasher);
            }
        }
        prims => format!("{prims:?}").hash(&mut hasher),
    }
    hasher.finish()
}

fn of_mesh(mesh: &Mesh, hasher: &mut DefaultHasher) {
    mesh.triangles.hash(hasher);
    mesh.corners.iter().for_each(|corner| corner.to_array().map(f32::to_bits).hash(hasher));
}
