//! A device that computes.

use crate::NoAdapter;
use crate::device::{Opened, open, words};

use super::margins::CONSTANTS;

/// A device with the walk compiled for it.
pub struct Gpu {
    pub(crate) device: wgpu::Device,
    pub(crate) queue: wgpu::Queue,
    pub(crate) pipeline: wgpu::ComputePipeline,
    /// The adapter, in words.
    pub adapter: String,
    /// Whether it is no GPU but software on the CPU.
    pub is_software: bool,
}

impl Gpu {
    /// The strongest adapter that computes, one in software too.
    ///
    /// # Errors
    /// When there is none, or it gives no device, or knows no compute shaders.
    pub fn new() -> Result<Gpu, NoAdapter> {
        let Opened { device, queue, info } = open(wgpu::PowerPreference::HighPerformance, |adapter| {
            let can = adapter.get_downlevel_capabilities().flags;
            if !can.contains(wgpu::DownlevelFlags::COMPUTE_SHADERS) {
                let name = words(&adapter.get_info());
                return Err(NoAdapter(format!("{name} only draws, and walks of rays need compute shaders")));
            }
            // What every such adapter has, with buffers as large as this one allows.
            let own = adapter.limits();
            Ok(wgpu::Limits {
                max_buffer_size: own.max_buffer_size,
                max_storage_buffer_binding_size: own.max_storage_buffer_binding_size,
                ..wgpu::Limits::downlevel_defaults()
            })
        })?;
        let pipeline = pipeline(&device);
        let (adapter, is_software) = (words(&info), info.device_type == wgpu::DeviceType::Cpu);
        Ok(Gpu { device, queue, pipeline, adapter, is_software })
    }

    /// Gives the device up, as a driver does that is updated: whatever is asked of it from now on is an error.
    pub fn lose(&self) {
        self.device.destroy();
    }
}

fn pipeline(device: &wgpu::Device) -> wgpu::ComputePipeline {
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("raystep walk"),
        source: wgpu::ShaderSource::Wgsl(include_str!("walk.wgsl").into()),
    });
    device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some("raystep walk"),
        layout: None,
        module: &module,
        entry_point: Some("walk"),
        compilation_options: wgpu::PipelineCompilationOptions { constants: &CONSTANTS, ..Default::default() },
        cache: None,
    })
}
