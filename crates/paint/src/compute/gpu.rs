//! A device that computes.

use std::sync::{Arc, OnceLock};

use crate::NoAdapter;
use crate::device::{Opened, open, words};

use super::Fault;
use super::margins::CONSTANTS;

/// The walk, which knows how triangles are met.
const SHADER: &str = concat!(include_str!("../shaders/meet.wgsl"), "\n", include_str!("../shaders/walk.wgsl"));

/// A device with the walk compiled for it.
pub struct Gpu {
    pub(crate) device: wgpu::Device,
    pub(crate) queue: wgpu::Queue,
    pub(crate) pipeline: wgpu::ComputePipeline,
    /// Why it is lost, once it is.
    lost: Arc<OnceLock<String>>,
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
        let lost = Arc::new(OnceLock::new());
        let told = lost.clone();
        // The first reason is the one.
        device.set_device_lost_callback(move |_, why| drop(told.set(why)));
        let pipeline = pipeline(&device);
        let (adapter, is_software) = (words(&info), info.device_type == wgpu::DeviceType::Cpu);
        Ok(Gpu { device, queue, pipeline, lost, adapter, is_software })
    }

    /// Gives the device up, as a driver does that is updated: whatever is asked of it from now on is an error.
    pub fn lose(&self) {
        self.device.destroy();
    }

    /// Does something with the device, and says what is wrong with it.
    pub(crate) fn watched<T>(&self, act: impl FnOnce() -> Result<T, Fault>) -> Result<T, Fault> {
        let scope = |filter| self.device.push_error_scope(filter);
        let invalid = scope(wgpu::ErrorFilter::Validation);
        let full = scope(wgpu::ErrorFilter::OutOfMemory);
        let done = act();
        // The last that was opened is closed first.
        let faults = [full, invalid].map(|scope| pollster::block_on(scope.pop()));
        // Whether it is lost is told while it is polled. An error of this has been told by then as well.
        let _ = self.device.poll(wgpu::PollType::Poll);
        match (self.lost.get(), faults.iter().flatten().next()) {
            (Some(why), _) => Err(Fault::Lost(why.clone())),
            // Drivers speak in many lines.
            (None, Some(fault)) => {
                Err(Fault::Refused(fault.to_string().split_whitespace().collect::<Vec<_>>().join(" ")))
            }
            (None, None) => done,
        }
    }
}

fn pipeline(device: &wgpu::Device) -> wgpu::ComputePipeline {
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("raystep walk"),
        source: wgpu::ShaderSource::Wgsl(SHADER.into()),
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
