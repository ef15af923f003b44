//! Two levels, slide 27: a mesh and its structure are stored once and placed many times.
//!
//! An instance is a primitive like any other, so every structure can stand on the upper level. Meeting one
//! moves the ray into the instance's own space and walks the structure stored there. The direction is moved
//! as it is, not normalised, so a `t` means the same point in both spaces.

mod below;
mod meet;
mod prims;
mod transform;

pub use prims::Prims;
pub use transform::{Transform, TransformError};

use std::sync::Arc;

use crate::{
    Aabb, Best, Cancelled, Grow, Margin, Mesh, Observer, PrimId, Primitives, Ray, Rule, Shape, Structure, Triangle,
    Visit, Want,
};

/// What is stored once: a mesh in its own space, and the structure over it.
#[derive(Clone, Debug)]
pub struct Model {
    /// Its triangles, local space.
    pub mesh: Mesh,
    /// The structure over them.
    pub structure: Structure,
}

impl Model {
    /// A mesh with the structure that `rule` says.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub fn build(mesh: Mesh, rule: &Rule, watch: &mut impl Observer<Grow>) -> Result<Model, Cancelled> {
        let structure = Structure::build(&mesh, rule, watch)?;
        Ok(Model { mesh, structure })
    }

    /// The box around its triangles, local space.
    pub fn bounds(&self) -> Aabb {
        (0..self.mesh.len() as u32).fold(Aabb::EMPTY, |all, prim| all.union(self.mesh.bounds(PrimId(prim))))
    }
}

/// What is stored for each instance: which model, and where.
#[derive(Clone, Debug)]
pub struct Instance {
    /// The model, by its place among the scene's models.
    pub model: u32,
    /// From the model's own space into the world.
    pub world_from_local: Transform,
    /// And back.
    pub local_from_world: Transform,
    /// A box around it, world space: roomy enough for the rounding of both ways.
    pub bounds: Aabb,
}

/// A scene of instances. Its primitives are the instances; a hit also says which primitive of the model was met.
#[derive(Clone, Debug)]
pub struct Instances {
    models: Vec<Arc<Model>>,
    placed: Vec<Instance>,
}

impl Instances {
    /// Places models: `placed` names for each instance the model and the way into the world. An instance of an
    /// empty model is met by no ray.
    ///
    /// # Errors
    /// The number of the first instance whose transform cannot be undone, or whose model is not there.
    pub fn new(models: Vec<Arc<Model>>, placed: &[(u32, Transform)]) -> Result<Instances, (usize, TransformError)> {
        let own: Vec<Aabb> = models.iter().map(|model| model.bounds()).collect();
        let place = |(index, &(model, world_from_local)): (usize, &(u32, Transform))| {
            let own = own.get(model as usize).ok_or((index, TransformError::Model { model }))?;
            let local_from_world = world_from_local.inverse().map_err(|error| (index, error))?;
            Ok(Instance { model, world_from_local, local_from_world, bounds: world_from_local.bounds(own) })
        };
        let mut placed = placed.iter().enumerate().map(place).collect::<Result<Vec<_>, _>>()?;
        // Rounding on the way there and back carries a point no further than its distance allows.
        let all = placed.iter().fold(Aabb::EMPTY, |all, instance| all.union(instance.bounds));
        let pad = Margin::of(&all, placed.len()).pad;
        for instance in placed.iter_mut().filter(|instance| !instance.bounds.is_empty()) {
            instance.bounds = instance.bounds.padded(pad * instance.world_from_local.condition());
        }
        Ok(Instances { models, placed })
    }

    /// The models, each stored once.
    pub fn models(&self) -> &[Arc<Model>] {
        &self.models
    }

    /// The instances, by their ids.
    pub fn placed(&self) -> &[Instance] {
        &self.placed
    }

    /// The model that an instance places.
    pub fn model(&self, instance: PrimId) -> &Model {
        &self.models[self.placed[instance.index()].model as usize]
    }

    /// How many triangles a ray can meet: each model counted as often as it is placed.
    pub fn triangles(&self) -> u64 {
        (0..self.placed.len() as u32).map(|id| self.model(PrimId(id)).mesh.len() as u64).sum()
    }

    /// A triangle of an instance's model, world space: for pictures.
    pub fn triangle(&self, instance: PrimId, inner: PrimId) -> Triangle {
        let world = &self.placed[instance.index()].world_from_local;
        let Triangle { a, b, c } = self.model(instance).mesh.triangle(inner);
        Triangle { a: world.point(a), b: world.point(b), c: world.point(c) }
    }

    /// How many bytes the instances take, without what their models hold.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.placed)
    }

    /// The same scene as one mesh, instance after instance: for small scenes, and to compare with.
    pub fn flattened(&self) -> Mesh {
        let mut flat = Mesh::default();
        for (index, instance) in self.placed.iter().enumerate() {
            let first = flat.corners.len() as u32;
            let mesh = &self.model(PrimId(index as u32)).mesh;
            flat.corners.extend(mesh.corners.iter().map(|corner| instance.world_from_local.point(*corner)));
            flat.triangles.extend(mesh.triangles.iter().map(|triangle| triangle.map(|corner| first + corner)));
        }
        flat
    }
}

impl Primitives for Instances {
    #[inline]
    fn len(&self) -> usize {
        self.placed.len()
    }

    /// The box that stands for an instance where structures are built and pictures drawn.
    #[inline]
    fn shape(&self, prim: PrimId) -> Shape<'_> {
        Shape::Box(self.placed[prim.index()].bounds)
    }

    fn intersect(&self, prim: PrimId, ray: &Ray) -> Option<f32> {
        let mut best = Best::new(Want::Nearest);
        self.meet(prim, ray, &mut best, &mut ());
        best.hit.map(|hit| hit.t)
    }

    fn test(&self, prim: PrimId, ray: &Ray, best: &mut Best, watch: &mut impl Observer<Visit>) {
        self.meet(prim, ray, best, watch);
    }
}
