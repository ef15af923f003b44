//! Opening the window.

use raystep_lesson::Library;

use super::app::App;
use super::wishes::Wishes;
use crate::window::look::remembered::Remembered;

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
