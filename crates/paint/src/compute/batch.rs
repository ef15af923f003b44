//! Buffers for some rays at a time, there and back.

use rayon::prelude::*;
use raystep_accel::{Ray, Want};

use super::layout::{Ask, Found, Record};
use super::{Fault, Gpu};

/// So many rays go there at once: enough to keep a large GPU at work, little enough that a slow one is not thought to hang.
pub(crate) const MOST: usize = 1 << 17;

/// Rays to a workgroup, as in the shader.
const GROUP: u32 = 64;

/// Buffers for at most so many rays.
pub(crate) struct Batch<'a> {
    gpu: &'a Gpu,
    ask: wgpu::Buffer,
    rays: wgpu::Buffer,
    found: wgpu::Buffer,
    /// Where the CPU reads.
    read: wgpu::Buffer,
    bindings: wgpu::BindGroup,
}

impl<'a> Batch<'a> {
    pub(crate) fn new(gpu: &'a Gpu, tree: &wgpu::Buffer, triangles: &wgpu::Buffer, rays: usize) -> Batch<'a> {
        use wgpu::BufferUsages as To;
        let buffer = |label, size: usize, usage| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: size as u64,
                usage,
                mapped_at_creation: false,
            })
        };
        let ask = buffer("raystep ask", size_of::<Ask>(), To::UNIFORM | To::COPY_DST);
        let records = buffer("raystep rays", rays * size_of::<Record>(), To::STORAGE | To::COPY_DST);
        let found = buffer("raystep found", rays * size_of::<Found>(), To::STORAGE | To::COPY_SRC);
        let read = buffer("raystep read", rays * size_of::<Found>(), To::COPY_DST | To::MAP_READ);
        let entries = [&ask, &records, tree, triangles, &found];
        let entries: Vec<_> = entries
            .into_iter()
            .zip(0..)
            .map(|(buffer, binding)| wgpu::BindGroupEntry { binding, resource: buffer.as_entire_binding() })
            .collect();
        let bindings = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("raystep walk"),
            layout: &gpu.pipeline.get_bind_group_layout(0),
            entries: &entries,
        });
        Batch { gpu, ask, rays: records, found, read, bindings }
    }

    /// Walks rays, no more than there is room for.
    pub(crate) fn walk(&self, rays: &[Ray], reach: f32, want: Want) -> Result<Vec<Found>, Fault> {
        let Gpu { device, queue, pipeline, .. } = self.gpu;
        let records: Vec<Record> = rays.par_iter().map(|ray| Record::new(ray, reach)).collect();
        let ask = Ask { rays: rays.len() as u32, any: u32::from(want == Want::Any) };
        queue.write_buffer(&self.ask, 0, bytemuck::bytes_of(&ask));
        queue.write_buffer(&self.rays, 0, bytemuck::cast_slice(&records));
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, &self.bindings, &[]);
            pass.dispatch_workgroups(ask.rays.div_ceil(GROUP), 1, 1);
        }
        let size = (rays.len() * size_of::<Found>()) as u64;
        encoder.copy_buffer_to_buffer(&self.found, 0, &self.read, 0, size);
        queue.submit([encoder.finish()]);
        self.fetch(size)
    }

    fn fetch(&self, size: u64) -> Result<Vec<Found>, Fault> {
        let refused = |why: &dyn std::fmt::Display| Fault::Refused(why.to_string());
        let (send, receive) = std::sync::mpsc::channel();
        self.read.map_async(wgpu::MapMode::Read, ..size, move |done| {
            // Whoever waits is still there, or has gone because of another fault.
            let _ = send.send(done);
        });
        self.gpu.device.poll(wgpu::PollType::wait_indefinitely()).map_err(|why| refused(&why))?;
        receive.recv().map_err(|why| refused(&why))?.map_err(|why| refused(&why))?;
        let bytes = self.read.get_mapped_range(..size).map_err(|why| refused(&why))?;
        let found = bytemuck::pod_collect_to_vec(&bytes);
        drop(bytes);
        self.read.unmap();
        Ok(found)
    }
}
