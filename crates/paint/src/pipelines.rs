//! How each kind of thing is drawn: shaders, layouts, blending and depth.

use wgpu::{VertexAttribute, VertexStepMode, vertex_attr_array};

use crate::mesh::Corner;
use crate::target::{COLOR, DEPTH, SAMPLES};
use crate::vertex::{FaceCorner, Line, Point};

/// The view's uniform, on top of every shader.
const VIEW: &str = include_str!("shaders/view.wgsl");

/// Everything that draws.
pub(crate) struct Pipelines {
    pub(crate) view_layout: wgpu::BindGroupLayout,
    pub(crate) mesh: wgpu::RenderPipeline,
    /// What the scene hides, faint.
    pub(crate) hidden: Marks,
    /// What it does not.
    pub(crate) shown: Marks,
}

/// The pipelines of marks.
pub(crate) struct Marks {
    pub(crate) face: wgpu::RenderPipeline,
    pub(crate) line: wgpu::RenderPipeline,
    pub(crate) point: wgpu::RenderPipeline,
}

/// What makes one pipeline differ from another.
struct Recipe<'a> {
    label: &'a str,
    shader: &'a str,
    stride: usize,
    step_mode: VertexStepMode,
    attributes: &'a [VertexAttribute],
    depth_write: bool,
    /// In reverse z the greater depth is the nearer one.
    depth_compare: wgpu::CompareFunction,
    /// Factor on the opacity of marks.
    fade: Option<f64>,
}

const FACE: [VertexAttribute; 3] = vertex_attr_array![0 => Float32x3, 1 => Unorm8x4, 2 => Unorm8x4];
const LINE: [VertexAttribute; 6] = vertex_attr_array![
    0 => Float32x3, 1 => Float32x3, 2 => Float32x2, 3 => Float32x2, 4 => Float32x2, 5 => Unorm8x4
];
const POINT: [VertexAttribute; 4] = vertex_attr_array![0 => Float32x3, 1 => Float32x2, 2 => Unorm8x4, 3 => Unorm8x4];
const CORNER: [VertexAttribute; 2] = vertex_attr_array![0 => Float32x3, 1 => Float32x3];

impl Pipelines {
    pub(crate) fn new(device: &wgpu::Device) -> Pipelines {
        let view_layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("raystep view"),
            entries: &[wgpu::BindGroupLayoutEntry {
                binding: 0,
                visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
                ty: wgpu::BindingType::Buffer {
                    ty: wgpu::BufferBindingType::Uniform,
                    has_dynamic_offset: false,
                    min_binding_size: None,
                },
                count: None,
            }],
        });
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("raystep"),
            bind_group_layouts: &[Some(&view_layout)],
            immediate_size: 0,
        });
        let make = |recipe: &Recipe<'_>| pipeline(device, &layout, recipe);
        let mesh = make(&Recipe {
            label: "raystep mesh",
            shader: include_str!("shaders/mesh.wgsl"),
            stride: size_of::<Corner>(),
            step_mode: VertexStepMode::Vertex,
            attributes: &CORNER,
            depth_write: true,
            depth_compare: wgpu::CompareFunction::Greater,
            fade: None,
        });
        let marks = |depth_compare, fade: [f64; 3]| Marks {
            face: make(&Recipe {
                label: "raystep faces",
                shader: include_str!("shaders/face.wgsl"),
                stride: size_of::<FaceCorner>(),
                step_mode: VertexStepMode::Vertex,
                attributes: &FACE,
                depth_write: false,
                depth_compare,
                fade: Some(fade[0]),
            }),
            line: make(&Recipe {
                label: "raystep lines",
                shader: include_str!("shaders/line.wgsl"),
                stride: size_of::<Line>(),
                step_mode: VertexStepMode::Instance,
                attributes: &LINE,
                depth_write: false,
                depth_compare,
                fade: Some(fade[1]),
            }),
            point: make(&Recipe {
                label: "raystep points",
                shader: include_str!("shaders/point.wgsl"),
                stride: size_of::<Point>(),
                step_mode: VertexStepMode::Instance,
                attributes: &POINT,
                depth_write: false,
                depth_compare,
                fade: Some(fade[2]),
            }),
        };
        Pipelines {
            mesh,
            hidden: marks(wgpu::CompareFunction::Less, [0.35, 0.3, 0.6]),
            shown: marks(wgpu::CompareFunction::GreaterEqual, [1.0; 3]),
            view_layout,
        }
    }
}

fn pipeline(device: &wgpu::Device, layout: &wgpu::PipelineLayout, recipe: &Recipe<'_>) -> wgpu::RenderPipeline {
    let source = format!("{VIEW}\n{}", recipe.shader);
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(recipe.label),
        source: wgpu::ShaderSource::Wgsl(source.into()),
    });
    let fade = recipe.fade.map(|fade| [("FADE", fade)]);
    let constants = fade.as_ref().map_or(&[][..], |fade| &fade[..]);
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(recipe.label),
        layout: Some(layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("vertex"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[Some(wgpu::VertexBufferLayout {
                array_stride: recipe.stride as u64,
                step_mode: recipe.step_mode,
                attributes: recipe.attributes,
            })],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: Some(wgpu::DepthStencilState {
            format: DEPTH,
            depth_write_enabled: Some(recipe.depth_write),
            depth_compare: Some(recipe.depth_compare),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }),
        multisample: wgpu::MultisampleState { count: SAMPLES, ..Default::default() },
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some("fragment"),
            compilation_options: wgpu::PipelineCompilationOptions { constants, ..Default::default() },
            targets: &[Some(wgpu::ColorTargetState {
                format: COLOR,
                blend: Some(wgpu::BlendState::ALPHA_BLENDING),
                write_mask: wgpu::ColorWrites::ALL,
            })],
        }),
        multiview_mask: None,
        cache: None,
    })
}
