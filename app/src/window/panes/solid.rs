//! The solid stage: drawn on the GPU into a texture that lies under the labels.

use std::sync::Arc;

use egui::{Color32, Rect, TextureId, Ui, pos2};
use egui_wgpu::RenderState;
use raystep_accel::{Place, Prims};
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

    /// Draws space in a rectangle of the window, the hovered place lit up.
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
        lit: Option<Place>,
    ) {
        let Some(gpu) = &mut self.gpu else { return };
        let pixels_per_point = ui.ctx().pixels_per_point();
        let size = [rect.width(), rect.height()].map(|side| (side * pixels_per_point).round().max(1.0) as u32);
        let space = with_lit(space, lit);
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

/// The marks of the hovered place once more, as what the pointer is on.
fn with_lit(space: &Space, lit: Option<Place>) -> Space {
    let mut space = space.clone();
    let Some(lit) = lit.filter(|lit| *lit != Place::World) else { return space };
    let again = |mark: &&SpaceMark| mark.place == Some(lit) && mark.role != Role::Candidate;
    let again: Vec<SpaceMark> = space.marks.iter().filter(again).cloned().collect();
    space.marks.extend(again.into_iter().map(|mark| SpaceMark { role: Role::Hover, ..mark }));
    space
}
