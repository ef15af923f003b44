//! A device without a window.

use std::fmt;

/// No driver answers, or none that can do what is needed.
#[derive(Clone, Debug)]
pub struct NoAdapter(pub(crate) String);

impl fmt::Display for NoAdapter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "no graphics adapter without a window: {}", self.0)
    }
}

impl std::error::Error for NoAdapter {}

/// A device and its queue.
pub(crate) struct Opened {
    pub(crate) device: wgpu::Device,
    pub(crate) queue: wgpu::Queue,
    pub(crate) info: wgpu::AdapterInfo,
}

/// Opens any adapter that works without a window, one in software too, with the limits that are needed of it.
pub(crate) fn open(
    power_preference: wgpu::PowerPreference,
    limits: impl FnOnce(&wgpu::Adapter) -> Result<wgpu::Limits, NoAdapter>,
) -> Result<Opened, NoAdapter> {
    pollster::block_on(async {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
        let options = wgpu::RequestAdapterOptions { power_preference, ..Default::default() };
        let adapter = instance.request_adapter(&options).await.map_err(|wrong| NoAdapter(wrong.to_string()))?;
        let descriptor =
            wgpu::DeviceDescriptor { label: Some("raystep"), required_limits: limits(&adapter)?, ..Default::default() };
        let (device, queue) =
            adapter.request_device(&descriptor).await.map_err(|wrong| NoAdapter(wrong.to_string()))?;
        Ok(Opened { device, queue, info: adapter.get_info() })
    })
}

/// An adapter in words.
pub(crate) fn words(info: &wgpu::AdapterInfo) -> String {
    format!("{} ({})", info.name, info.backend)
}
