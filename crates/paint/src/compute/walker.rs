//! Asks the GPU, and judges.

use rayon::prelude::*;
use raystep_accel::{Best, Hit, Mesh, PrimId, Ray, Want, test};
use raystep_fast::{Bvh2, Fast, Work};

use super::batch::{Batch, MOST};
use super::layout::{self, Found, Outcome};
use super::{Fault, Gpu};

/// A tree on the GPU, with the mesh that it was built over.
pub struct Walker<'a> {
    gpu: &'a Gpu,
    mesh: &'a Mesh,
    tree: &'a Bvh2,
    nodes: wgpu::Buffer,
    triangles: wgpu::Buffer,
}

/// What was left to the CPU.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Judged {
    /// Rays asked.
    pub rays: usize,
    /// Triangles that were left by the GPU and judged in double precision.
    pub triangles: usize,
    /// Rays that the CPU walked by itself.
    pub on_cpu: usize,
}

impl<'a> Walker<'a> {
    /// Uploads the tree, which was built over this mesh.
    ///
    /// # Errors
    /// When it does not fit, or the device is lost.
    pub fn new(gpu: &'a Gpu, mesh: &'a Mesh, tree: &'a Bvh2) -> Result<Walker<'a>, Fault> {
        let (nodes, triangles) = layout::tree(tree).ok_or(Fault::Many)?;
        let (nodes, triangles): (&[u8], &[u8]) = (bytemuck::cast_slice(&nodes), bytemuck::cast_slice(&triangles));
        let limits = gpu.device.limits();
        let most = limits.max_buffer_size.min(limits.max_storage_buffer_binding_size);
        let bytes = nodes.len().max(triangles.len()) as u64;
        if bytes > most {
            return Err(Fault::Large { bytes, most });
        }
        let buffer = |label, contents: &[u8]| {
            let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: contents.len() as u64,
                usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            });
            gpu.queue.write_buffer(&buffer, 0, contents);
            buffer
        };
        gpu.watched(|| {
            let [nodes, triangles] = [buffer("raystep nodes", nodes), buffer("raystep triangles", triangles)];
            Ok(Walker { gpu, mesh, tree, nodes, triangles })
        })
    }

    /// How much memory it takes on the GPU, in bytes.
    pub fn bytes(&self) -> u64 {
        self.nodes.size() + self.triangles.size()
    }

    /// The nearest hits of rays, in their order.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn nearest(&self, rays: &[Ray]) -> Result<(Vec<Option<Hit>>, Judged), Fault> {
        let found = self.walk(rays, Want::Nearest)?;
        let answer = |(ray, found): (&Ray, &Found)| match found.outcome() {
            Outcome::Left(prims) => self.judge(prims, ray, Want::Nearest),
            Outcome::Sure | Outcome::Many | Outcome::Again => self.tree.intersect(ray),
        };
        Ok((rays.par_iter().zip(&found).map(answer).collect(), Judged::of(&found)))
    }

    /// Whether each of many rays hits anything, in their order.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn any(&self, rays: &[Ray]) -> Result<(Vec<bool>, Judged), Fault> {
        let found = self.walk(rays, Want::Any)?;
        let answer = |(ray, found): (&Ray, &Found)| match found.outcome() {
            Outcome::Left(prims) => self.judge(prims, ray, Want::Any).is_some(),
            Outcome::Sure => true,
            Outcome::Many | Outcome::Again => self.tree.occluded(ray),
        };
        Ok((rays.par_iter().zip(&found).map(answer).collect(), Judged::of(&found)))
    }

    /// What the walk of each ray does: nodes and leaves opened, triangles tested, boxes tested two to a node. The GPU's
    /// own walk is counted, which goes a little further than one that knows each t to the last digit; the CPU's, where a
    /// ray was walked there alone.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn counts(&self, rays: &[Ray], want: Want) -> Result<(Vec<Work>, Judged), Fault> {
        let found = self.walk(rays, want)?;
        let counted = |(ray, found): (&Ray, &Found)| {
            let mut work = found.work();
            if let Outcome::Again = found.outcome() {
                work = Work::default();
                self.tree.walk(ray, want, &mut work);
            }
            work
        };
        Ok((rays.par_iter().zip(&found).map(counted).collect(), Judged::of(&found)))
    }

    fn walk(&self, rays: &[Ray], want: Want) -> Result<Vec<Found>, Fault> {
        let mut found = Vec::with_capacity(rays.len());
        if rays.is_empty() {
            return Ok(found);
        }
        self.gpu.watched(|| {
            let batch = Batch::new(self.gpu, &self.nodes, &self.triangles, rays.len().min(MOST));
            for rays in rays.chunks(MOST) {
                found.extend(batch.walk(rays, self.tree.reach(), want)?);
            }
            Ok(found)
        })
    }

    /// The best of a few triangles, by the textbook's own test.
    fn judge(&self, prims: &[u32], ray: &Ray, want: Want) -> Option<Hit> {
        let mut best = Best::new(want);
        for prim in prims {
            test(self.mesh, PrimId(*prim), ray, &mut best, &mut ());
        }
        best.hit
    }
}

impl Judged {
    fn of(found: &[Found]) -> Judged {
        let mut judged = Judged { rays: found.len(), ..Judged::default() };
        for found in found {
            match found.outcome() {
                Outcome::Left(prims) => judged.triangles += prims.len(),
                Outcome::Sure => {}
                Outcome::Many | Outcome::Again => judged.on_cpu += 1,
            }
        }
        judged
    }
}
