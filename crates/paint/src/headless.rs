//! Drawing without a window.

use std::sync::Arc;

use raystep_accel::Prims;

use crate::device::{NoAdapter, Opened, open, words};
use crate::{Frame, Mesh, Renderer};

/// A device of its own, and a renderer on it.
pub struct Headless {
    device: wgpu::Device,
    queue: wgpu::Queue,
    renderer: Renderer,
    /// The adapter, in words.
    pub adapter: String,
}

impl Headless {
    /// Any adapter that draws without a window, one in software too.
    ///
    /// # Errors
    /// When there is none, or it gives no device.
    pub fn new() -> Result<Headless, NoAdapter> {
        let limits =
            |adapter: &wgpu::Adapter| Ok(wgpu::Limits::downlevel_defaults().using_resolution(adapter.limits()));
        let Opened { device, queue, info } = open(wgpu::PowerPreference::default(), limits)?;
        let renderer = Renderer::new(&device, &queue);
        Ok(Headless { device, queue, renderer, adapter: words(&info) })
    }

    /// Uploads primitives, to be drawn in many frames.
    ///
    /// # Panics
    /// Never: nobody gives up.
    pub fn mesh(&self, prims: &Prims) -> Arc<Mesh> {
        Arc::new(Mesh::new(&self.device, prims, &|| true).expect("nobody gives up"))
    }

    /// Draws a frame and reads its pixels: four bytes each, row by row from the upper left.
    ///
    /// # Panics
    /// When the device is lost.
    pub fn rgba(&mut self, frame: &Frame<'_>) -> Vec<u8> {
        self.renderer.draw(frame);
        let texture = self.renderer.texture();
        let (width, height) = (texture.width(), texture.height());
        // Rows in a buffer begin at multiples of 256 bytes.
        let stride = (width * 4).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let buffer = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("raystep pixels"),
            size: u64::from(stride) * u64::from(height),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encoder.copy_texture_to_buffer(
            texture.as_image_copy(),
            wgpu::TexelCopyBufferInfo {
                buffer: &buffer,
                layout: wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(stride), rows_per_image: None },
            },
            texture.size(),
        );
        self.queue.submit([encoder.finish()]);
        buffer.map_async(wgpu::MapMode::Read, .., |done| done.expect("the device is not lost"));
        self.device.poll(wgpu::PollType::wait_indefinitely()).expect("the device is not lost");
        let bytes = buffer.get_mapped_range(..).expect("the buffer is mapped");
        bytes.chunks_exact(stride as usize).flat_map(|row| &row[..width as usize * 4]).copied().collect()
    }
}
