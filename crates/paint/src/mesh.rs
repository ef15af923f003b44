//! The scene's primitives as one mesh on the GPU, uploaded once.

use std::borrow::Cow;
use std::collections::{HashMap, HashSet};

use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use raystep_accel::{PrimId, Primitives, Prims};
use wgpu::util::DeviceExt;

use crate::solid::triangles;

/// Most triangles of instances that are drawn one by one.
const MOST: u64 = 2_000_000;

/// So many triangles between two looks at whether to go on.
const BETWEEN_LOOKS: usize = 1 << 15;

/// A scene's primitives on the GPU: corners with their normals, and the triangles between them. For a large
/// scene the making takes a while; any thread can do it.
#[derive(Debug)]
pub struct Mesh {
    corners: wgpu::Buffer,
    indices: wgpu::Buffer,
    count: u32,
}

/// The layout of a corner in `mesh.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(crate) struct Corner {
    position: [f32; 3],
    /// The mean of its triangles' normals, not of length one.
    normal: [f32; 3],
}

impl Mesh {
    /// Uploads the primitives; nothing if `go_on` says to give up.
    pub fn new(device: &wgpu::Device, prims: &Prims, go_on: &dyn Fn() -> bool) -> Option<Mesh> {
        let (positions, mut indices): (Cow<'_, [Vec3]>, Cow<'_, [[u32; 3]]>) = match prims {
            Prims::Mesh(mesh) => (Cow::from(&mesh.corners), Cow::from(&mesh.triangles)),
            Prims::Instances(instances) if instances.triangles() <= MOST => {
                let flat = instances.flattened();
                (Cow::from(flat.corners), Cow::from(flat.triangles))
            }
            // A few; or too many to draw each: the boxes that stand for them.
            Prims::Few(_) | Prims::Instances(_) => {
                let (positions, indices) = weld(prims);
                (Cow::from(positions), Cow::from(indices))
            }
        };
        if let Some(once) = once(&positions, &indices) {
            indices = Cow::from(once);
        }
        let normals = normals(&positions, &indices, go_on)?;
        let mut corners: Vec<Corner> =
            normals.into_iter().zip(positions.iter()).map(|(normal, p)| corner(*p, normal)).collect();
        let limit = device.limits().max_buffer_size as usize;
        if size_of_val(&corners[..]) > limit || size_of_val(&indices[..]) > limit {
            // More than the device can hold: the marks alone are drawn.
            corners.clear();
            indices = Cow::default();
        }
        let buffer = |label, contents, usage| {
            device.create_buffer_init(&wgpu::util::BufferInitDescriptor { label: Some(label), contents, usage })
        };
        go_on().then(|| Mesh {
            count: indices.len() as u32 * 3,
            corners: buffer("raystep corners", bytemuck::cast_slice(&corners), wgpu::BufferUsages::VERTEX),
            indices: buffer("raystep triangles", bytemuck::cast_slice(&indices[..]), wgpu::BufferUsages::INDEX),
        })
    }

    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        if self.count > 0 {
            pass.set_vertex_buffer(0, self.corners.slice(..));
            pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
            pass.draw_indexed(0..self.count, 0, 0..1);
        }
    }
}

fn corner(position: Vec3, normal: Vec3) -> Corner {
    Corner { position: position.to_array(), normal: normal.normalize_or_zero().to_array() }
}

/// The triangles of a few shapes, equal corners shared.
fn weld(prims: &Prims) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let (mut positions, mut indices) = (Vec::new(), Vec::new());
    for prim in 0..prims.len() as u32 {
        let mut known = HashMap::new();
        for triangle in triangles(&prims.shape(PrimId(prim))) {
            indices.push(triangle.map(|p| {
                *known.entry(p.to_array().map(f32::to_bits)).or_insert_with(|| {
                    positions.push(p);
                    positions.len() as u32 - 1
                })
            }));
        }
    }
    (positions, indices)
}

/// Of triangles that lie on each other one, if there are such: to draw a hundred thousand over each other takes minutes
/// without a graphics card.
fn once(positions: &[Vec3], indices: &[[u32; 3]]) -> Option<Vec<[u32; 3]>> {
    let mut known = HashSet::with_capacity(indices.len());
    let corners = |triangle: &[u32; 3]| {
        let mut corners = triangle.map(|corner| positions[corner as usize].to_array().map(f32::to_bits));
        corners.sort_unstable();
        corners
    };
    let once: Vec<[u32; 3]> = indices.iter().filter(|triangle| known.insert(corners(triangle))).copied().collect();
    (once.len() < indices.len()).then_some(once)
}

/// For each corner the sum of its triangles' normals, each as long as its triangle is large.
fn normals(positions: &[Vec3], indices: &[[u32; 3]], go_on: &dyn Fn() -> bool) -> Option<Vec<Vec3>> {
    let mut sums = vec![Vec3::ZERO; positions.len()];
    for some in indices.chunks(BETWEEN_LOOKS) {
        if !go_on() {
            return None;
        }
        for triangle in some {
            let [a, b, c] = triangle.map(|i| positions[i as usize]);
            let normal = (b - a).cross(c - a);
            for &i in triangle {
                sums[i as usize] += normal;
            }
        }
    }
    Some(sums)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_lies_on_each_other_is_drawn_once() {
        let positions = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z, Vec3::X];
        let check =
            |indices: &[[u32; 3]], expected: Option<Vec<[u32; 3]>>| assert_eq!(once(&positions, indices), expected);
        check(&[[0, 1, 2], [0, 1, 3]], None);
        // The same corners in another order, and other corners at the same places.
        check(&[[0, 1, 2], [2, 1, 0], [0, 4, 2], [0, 1, 3]], Some(vec![[0, 1, 2], [0, 1, 3]]));
    }
}
