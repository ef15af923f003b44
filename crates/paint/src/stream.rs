//! A vertex buffer that is written anew for every frame and grows when it must.

use bytemuck::Pod;

/// What a step's marks are drawn from.
pub(crate) struct Stream {
    label: &'static str,
    buffer: Option<wgpu::Buffer>,
    count: u32,
}

impl Stream {
    pub(crate) fn new(label: &'static str) -> Stream {
        Stream { label, buffer: None, count: 0 }
    }

    /// Replaces what it holds; items beyond what the device can hold are left out.
    pub(crate) fn write<T: Pod>(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, items: &[T]) {
        let most = device.limits().max_buffer_size as usize / size_of::<T>();
        let items = &items[..items.len().min(most)];
        self.count = items.len() as u32;
        let bytes: &[u8] = bytemuck::cast_slice(items);
        let needed = bytes.len() as u64;
        if needed == 0 {
            return;
        }
        let buffer = match self.buffer.take() {
            Some(buffer) if buffer.size() >= needed => buffer,
            _ => device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(self.label),
                size: needed.next_power_of_two().min(device.limits().max_buffer_size),
                usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            }),
        };
        queue.write_buffer(&buffer, 0, bytes);
        self.buffer = Some(buffer);
    }

    /// Draws its items as the corners of triangles.
    pub(crate) fn draw_vertices(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.draw(pass, 0..self.count, 0..1);
    }

    /// Draws a quad of two triangles for each item.
    pub(crate) fn draw_quads(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.draw(pass, 0..6, 0..self.count);
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>, vertices: std::ops::Range<u32>, instances: std::ops::Range<u32>) {
        if let Some(buffer) = self.buffer.as_ref().filter(|_| self.count > 0) {
            pass.set_vertex_buffer(0, buffer.slice(..));
            pass.draw(vertices, instances);
        }
    }
}
