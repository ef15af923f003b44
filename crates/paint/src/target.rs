//! The textures that a frame is drawn into.

/// What egui shows as a native texture.
pub(crate) const COLOR: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
/// Reverse z in floats: even depth at all distances.
pub(crate) const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;
/// Samples a pixel; every device that runs wgpu has four.
pub(crate) const SAMPLES: u32 = 4;

/// A picture with its samples and depths.
pub(crate) struct Target {
    pub(crate) size: [u32; 2],
    pub(crate) texture: wgpu::Texture,
    pub(crate) view: wgpu::TextureView,
    samples: wgpu::TextureView,
    depth: wgpu::TextureView,
}

impl Target {
    pub(crate) fn new(device: &wgpu::Device, size: [u32; 2]) -> Target {
        let texture = |label, format, sample_count, usage| {
            device.create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT | usage,
                view_formats: &[],
            })
        };
        let view = |texture: &wgpu::Texture| texture.create_view(&wgpu::TextureViewDescriptor::default());
        let shown = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_SRC;
        let picture = texture("raystep picture", COLOR, 1, shown);
        Target {
            size,
            view: view(&picture),
            texture: picture,
            samples: view(&texture("raystep samples", COLOR, SAMPLES, wgpu::TextureUsages::empty())),
            depth: view(&texture("raystep depth", DEPTH, SAMPLES, wgpu::TextureUsages::empty())),
        }
    }

    /// Starts drawing on a cleared picture.
    pub(crate) fn begin<'a>(&self, encoder: &'a mut wgpu::CommandEncoder, ground: wgpu::Color) -> wgpu::RenderPass<'a> {
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("raystep space"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &self.samples,
                depth_slice: None,
                resolve_target: Some(&self.view),
                ops: wgpu::Operations { load: wgpu::LoadOp::Clear(ground), store: wgpu::StoreOp::Discard },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth,
                // 0 is infinitely far.
                depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(0.0), store: wgpu::StoreOp::Discard }),
                stencil_ops: None,
            }),
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        })
    }
}
