//! Opening the window.

use std::path::PathBuf;

use raystep_lesson::Library;

use super::app::App;
use super::remember::Remembered;
use super::solid::Solid;
use super::view::RayChoice;

/// What the window shall show first.
#[derive(Debug, Default)]
pub struct Wishes {
    /// The slide: `"5/33"`, or the name of its file.
    pub slide: Option<String>,
    /// The name of a ray.
    pub ray: Option<String>,
    /// The step.
    pub step: Option<usize>,
    /// The folder of lessons, to be read again when they are saved.
    pub lessons: Option<PathBuf>,
    /// A mesh.
    pub mesh: Option<PathBuf>,
}

/// The window cannot be opened.
#[derive(Debug, thiserror::Error)]
#[error("no window can be opened: {}", why(.0))]
pub struct NoWindow(#[from] eframe::Error);

/// Why there is none, where the libraries below say nothing that anybody could act on.
fn why(error: &eframe::Error) -> String {
    use egui_wgpu::WgpuError;
    match error {
        eframe::Error::Wgpu(
            WgpuError::CreateSurfaceError(_) | WgpuError::RequestAdapterError(_) | WgpuError::NoSurfaceFormatsAvailable,
        ) => "no graphics driver answers that could draw on this display".to_owned(),
        // The first line of some is followed by a list of everything that was tried.
        other => other.to_string().lines().next().unwrap_or("the display does not answer").to_owned(),
    }
}

/// Opens the window on these lessons and returns when it is closed.
///
/// # Errors
/// There is no display, or nothing that could draw.
pub fn open(library: Library, wishes: Wishes) -> Result<(), NoWindow> {
    let viewport = egui::ViewportBuilder::default()
        .with_title("Raystep")
        .with_app_id("raystep")
        .with_inner_size([1440.0, 900.0])
        .with_min_inner_size([900.0, 600.0])
        .with_drag_and_drop(true);
    let options = eframe::NativeOptions { viewport, centered: true, ..eframe::NativeOptions::default() };
    let create = move |context: &eframe::CreationContext<'_>| {
        let mut app = App::wished(&context.egui_ctx, library, wishes, Remembered::of_user());
        if let Some(state) = &context.wgpu_render_state {
            app.draw_with(state);
        }
        let app: Box<dyn eframe::App> = Box::new(app);
        Ok(app)
    };
    Ok(eframe::run_native("Raystep", options, Box::new(create))?)
}

impl App {
    /// Draws solid stages with egui's own device.
    pub fn draw_with(&mut self, state: &egui_wgpu::RenderState) {
        self.solid = Solid::new(state);
        self.solid_beside = self.solid.another();
        self.workshop.upload_to(&state.device);
    }

    /// A window that shows what was wished for.
    pub fn wished(context: &egui::Context, library: Library, wishes: Wishes, remembered: Remembered) -> App {
        let index = |id: &String| {
            let slide = library.slide(id)?;
            library.slides.iter().position(|other| std::ptr::eq(other, slide))
        };
        // A mesh is met first where a tree walks through it.
        let tree = || library.slides.iter().position(|slide| slide.listing == "kd-walk");
        let first = if wishes.mesh.is_some() { tree().unwrap_or(0) } else { 0 };
        let slide = wishes.slide.as_ref().and_then(index).unwrap_or(first);
        let mut app = App::new(context, library, slide, remembered);
        let named = |name: &String| app.state.stage()?.rays.iter().position(|ray| ray.name == *name);
        if let Some(ray) = wishes.ray.as_ref().and_then(named) {
            app.state.show_ray(RayChoice::Named(ray), true);
        }
        if let Some(step) = wishes.step {
            app.state.open_at(step);
        }
        if let Some(folder) = &wishes.lessons {
            app.watch_lessons(folder);
        }
        if let Some(mesh) = wishes.mesh {
            app.open_mesh(mesh);
        }
        app
    }
}
