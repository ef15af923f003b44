//! The solid stage: drawn on the GPU into a texture that lies under the labels.

use std::borrow::Cow;
use std::sync::Arc;

use egui::{Color32, Rect, TextureId, Ui, pos2};
use egui_wgpu::RenderState;
use raystep_accel::Prims;
use raystep_figure::{Camera, Role, Space, SpaceMark, Theme};
use raystep_paint::{Frame, Mesh, Renderer};

/// The renderer and its texture, where there is a GPU or a software one.
#[derive(Default)]
pub(crate) struct Solid {
    gpu: Option<Gpu>,
}

struct Gpu {
    state: RenderState,
    renderer: Renderer,
    texture: Option<TextureId>,
}

impl Solid {
    /// A stage on egui's own device.
    pub(crate) fn new(state: &RenderState) -> Solid {
        let renderer = Renderer::new(&state.device, &state.queue);
        Solid { gpu: Some(Gpu { state: state.clone(), renderer, texture: None }) }
    }

    /// Another stage on the same device, for the picture beside.
    pub(crate) fn another(&self) -> Solid {
        let another = |gpu: &Gpu| Gpu { state: gpu.state.clone(), renderer: gpu.renderer.another(), texture: None };
        Solid { gpu: self.gpu.as_ref().map(another) }
    }

    /// Whether there is a device to draw with.
    pub(crate) fn is_there(&self) -> bool {
        self.gpu.is_some()
    }

    /// Draws space in a rectangle of the window, with what lights up.
    pub(crate) fn show(
        &mut self,
        ui: &Ui,
        rect: Rect,
        space: &Space,
        prims: &Prims,
        mesh: Option<&Arc<Mesh>>,
        camera: &Camera,
        theme: &Theme,
        ground: Role,
        lit: &[SpaceMark],
    ) {
        let Some(gpu) = &mut self.gpu else { return };
        let pixels_per_point = ui.ctx().pixels_per_point();
        let size = [rect.width(), rect.height()].map(|side| (side * pixels_per_point).round().max(1.0) as u32);
        let mut space = Cow::Borrowed(space);
        if !lit.is_empty() {
            space.to_mut().marks.extend_from_slice(lit);
        }
        let frame = Frame { prims, mesh, space: &space, camera, theme, ground, size, pixels_per_point };
        let renewed = gpu.renderer.draw(&frame);
        let mut registry = gpu.state.renderer.write();
        let (device, view, filter) = (&gpu.state.device, gpu.renderer.view(), wgpu::FilterMode::Linear);
        match gpu.texture {
            Some(texture) if renewed => registry.update_egui_texture_from_wgpu_texture(device, view, filter, texture),
            Some(_) => {}
            None => gpu.texture = Some(registry.register_native_texture(device, view, filter)),
        }
        drop(registry);
        if let Some(texture) = gpu.texture {
            let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
            ui.painter().image(texture, rect, whole, Color32::WHITE);
        }
    }
}
