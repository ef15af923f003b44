//! Draws a frame: what a step looks like, into a texture.

use std::sync::Arc;

use bytemuck::{Pod, Zeroable};
use glam::{Vec2, Vec3};
use raystep_accel::Prims;
use raystep_figure::{Camera, Color, Role, Space, Theme};

use crate::batch::Batch;
use crate::mesh::Mesh;
use crate::pipelines::Pipelines;
use crate::stream::Stream;
use crate::target::Target;

/// What to draw, and how large.
#[derive(Clone, Copy)]
pub struct Frame<'a> {
    /// The scene's primitives.
    pub prims: &'a Prims,
    /// The same on the GPU; without it the marks alone are drawn.
    pub mesh: Option<&'a Arc<Mesh>>,
    /// What the step shows in it.
    pub space: &'a Space,
    /// Where it is seen from.
    pub camera: &'a Camera,
    /// How roles look.
    pub theme: &'a Theme,
    /// The role that the ground is filled with.
    pub ground: Role,
    /// Width and height in pixels; brought into the range that the device allows.
    pub size: [u32; 2],
    /// How many pixels a point of the theme's line widths is.
    pub pixels_per_point: f32,
}

/// Draws frames with one device.
pub struct Renderer {
    device: wgpu::Device,
    queue: wgpu::Queue,
    pipelines: Arc<Pipelines>,
    view_uniform: wgpu::Buffer,
    bind_group: wgpu::BindGroup,
    target: Target,
    /// What the picture shows now.
    drawn: Option<Content>,
    faces: Stream,
    buried: Stream,
    lines: Stream,
    points: Stream,
}

/// Everything that the pixels depend on.
struct Content {
    mesh: Option<Arc<Mesh>>,
    ground: [f32; 4],
    view: ViewUniform,
    batch: Batch,
}

/// What every shader knows of the view; the layout of `View` in `view.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Pod, Zeroable)]
struct ViewUniform {
    clip_from_world: [[f32; 4]; 4],
    /// The eye and 1, or the direction towards it and 0.
    eye: [f32; 4],
    /// The direction towards the light.
    light: [f32; 4],
    /// The colour of the primitives.
    scene: [f32; 4],
    size: [f32; 2],
    pixels_per_point: f32,
    /// Clip w at the near plane.
    near: f32,
}

impl Renderer {
    /// A renderer for a device. Its pipelines are compiled here, which takes a moment.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue) -> Renderer {
        Renderer::of(device, queue, Arc::new(Pipelines::new(device)))
    }

    /// Another renderer for the same device, with a picture of its own.
    pub fn another(&self) -> Renderer {
        Renderer::of(&self.device, &self.queue, self.pipelines.clone())
    }

    fn of(device: &wgpu::Device, queue: &wgpu::Queue, pipelines: Arc<Pipelines>) -> Renderer {
        let view_uniform = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("raystep view"),
            size: size_of::<ViewUniform>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let bind_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("raystep view"),
            layout: &pipelines.view_layout,
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: view_uniform.as_entire_binding() }],
        });
        Renderer {
            device: device.clone(),
            queue: queue.clone(),
            pipelines,
            view_uniform,
            bind_group,
            target: Target::new(device, [1, 1]),
            drawn: None,
            faces: Stream::new("raystep faces"),
            buried: Stream::new("raystep buried faces"),
            lines: Stream::new("raystep lines"),
            points: Stream::new("raystep points"),
        }
    }

    /// Draws a frame, unless the picture shows it already. Says whether [`view`](Renderer::view) is a new one
    /// since the last call, to be registered again: that is so when the size has changed, and the first time.
    pub fn draw(&mut self, frame: &Frame<'_>) -> bool {
        let most = self.device.limits().max_texture_dimension_2d;
        let size = frame.size.map(|side| side.clamp(1, most));
        let renewed = self.target.size != size;
        let content = Content::new(frame, size);
        if self.drawn.as_ref().is_some_and(|drawn| drawn.is_same(&content)) {
            return false;
        }
        if renewed {
            self.target = Target::new(&self.device, size);
        }
        self.queue.write_buffer(&self.view_uniform, 0, bytemuck::bytes_of(&content.view));
        self.faces.write(&self.device, &self.queue, &content.batch.faces);
        self.buried.write(&self.device, &self.queue, &content.batch.buried);
        self.lines.write(&self.device, &self.queue, &content.batch.lines);
        self.points.write(&self.device, &self.queue, &content.batch.points);

        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.encode(&mut encoder, &content);
        self.queue.submit([encoder.finish()]);
        self.drawn = Some(content);
        renewed
    }

    /// The picture: `Rgba8Unorm` in gamma space, opaque.
    pub fn view(&self) -> &wgpu::TextureView {
        &self.target.view
    }

    /// The picture's texture, for copying from.
    pub fn texture(&self) -> &wgpu::Texture {
        &self.target.texture
    }

    fn encode(&self, encoder: &mut wgpu::CommandEncoder, content: &Content) {
        let [r, g, b, a] = content.ground.map(f64::from);
        let mut pass = self.target.begin(encoder, wgpu::Color { r, g, b, a });
        pass.set_bind_group(0, &self.bind_group, &[]);
        if let Some(mesh) = &content.mesh {
            pass.set_pipeline(&self.pipelines.mesh);
            mesh.draw(&mut pass);
        }
        // Behind the scene, faint; then in front of it.
        let Pipelines { hidden, shown, .. } = &*self.pipelines;
        for (passes, faces) in [(hidden, &self.buried), (shown, &self.faces)] {
            pass.set_pipeline(&passes.face);
            faces.draw_vertices(&mut pass);
            pass.set_pipeline(&passes.line);
            self.lines.draw_quads(&mut pass);
            pass.set_pipeline(&passes.point);
            self.points.draw_quads(&mut pass);
        }
    }
}

impl Content {
    /// Whether both give the same pixels.
    fn is_same(&self, other: &Content) -> bool {
        let mesh = match (&self.mesh, &other.mesh) {
            (Some(a), Some(b)) => Arc::ptr_eq(a, b),
            (a, b) => a.is_none() && b.is_none(),
        };
        mesh && self.ground == other.ground && self.view == other.view && self.batch == other.batch
    }

    fn new(frame: &Frame<'_>, size: [u32; 2]) -> Content {
        Content {
            mesh: frame.mesh.cloned(),
            ground: frame.theme.style(frame.ground).fill.map_or([1.0; 4], unit),
            view: ViewUniform::new(frame, size),
            batch: Batch::new(frame),
        }
    }
}

impl ViewUniform {
    fn new(frame: &Frame<'_>, size: [u32; 2]) -> ViewUniform {
        let size = Vec2::new(size[0] as f32, size[1] as f32);
        let clip_from_world = frame.camera.clip_from_world(size.x / size.y);
        let (eye, light, near) = match *frame.camera {
            Camera::Flat { .. } => (Vec3::Z.extend(0.0), Vec3::new(-0.4, 0.5, 1.0), 0.5),
            Camera::Solid { eye, target, up, .. } => {
                let back = (eye - target).normalize_or(Vec3::Z);
                let right = up.cross(back).normalize_or(Vec3::X);
                // Over the left shoulder.
                let light = back + back.cross(right) * 0.8 - right * 0.6;
                (eye.extend(1.0), light, clip_from_world.w_axis.z)
            }
        };
        let style = frame.theme.style(Role::Scene);
        let ink = style.stroke.map_or([0.5; 4], |stroke| unit(stroke.color));
        let fill = style.fill.map_or(ink, unit);
        // A body is shaded; a little of its outline's colour keeps the lit side off the page.
        let scene = std::array::from_fn(|i| 0.7 * fill[i] + 0.3 * ink[i]);
        ViewUniform {
            clip_from_world: clip_from_world.to_cols_array_2d(),
            eye: eye.to_array(),
            light: light.normalize_or(Vec3::Z).extend(0.0).to_array(),
            scene,
            size: size.to_array(),
            pixels_per_point: frame.pixels_per_point,
            near,
        }
    }
}

/// A colour with channels from 0 to 1.
fn unit(color: Color) -> [f32; 4] {
    [color.r, color.g, color.b, color.a].map(|channel| f32::from(channel) / 255.0)
}
