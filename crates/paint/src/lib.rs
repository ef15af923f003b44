//! Solid scenes as pixels on the GPU, and walks of many rays there.
//!
//! A [`Renderer`] draws a figure's [`Space`](raystep_figure::Space) over the scene's primitives, as a
//! [`Camera`](raystep_figure::Camera) sees them, into a texture of its own. Where the texture is shown is the caller's business:
//! with egui, register [`Renderer::view`] as a native texture and show it as an image. Labels are not
//! drawn here; the caller sets them as text at the points where the camera shows them.
//!
//! Colours stay in gamma space from the theme to the texture, as in egui and in SVG, so that the same
//! translucent fill looks the same on paper and on screen.
//!
//! A [`compute::Walker`] answers rays over a mesh as brute force does.

mod batch;
#[cfg(not(target_arch = "wasm32"))]
pub mod compute;
#[cfg(not(target_arch = "wasm32"))]
mod device;
#[cfg(not(target_arch = "wasm32"))]
mod headless;
mod mesh;
mod pen;
mod pipelines;
mod renderer;
mod solid;
mod stream;
mod target;
mod vertex;

#[cfg(not(target_arch = "wasm32"))]
pub use device::NoAdapter;
#[cfg(not(target_arch = "wasm32"))]
pub use headless::Headless;
pub use mesh::Mesh;
pub use renderer::{Frame, Renderer};
