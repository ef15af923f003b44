//! Opening the window, and opening it again when the graphics device is lost.

use std::fs::File;
use std::path::PathBuf;
use std::time::Instant;

use egui::Event::{PointerButton, WindowFocused};
use egui::{Ui, ViewportBuilder, ViewportInfo};
use raystep_lesson::Library;

use super::app::App;
use super::device::{self, Patience};
use super::slot::Slot;
use super::wishes::Wishes;
use crate::window::look::remembered::Remembered;
use crate::{files, folders};

/// There is no window, or there is none any more.
#[derive(Debug, thiserror::Error)]
pub enum NoWindow {
    /// It cannot be opened.
    #[error("no window can be opened: {}", why(.0))]
    Refused(#[from] eframe::Error),
    /// One device after the other is lost.
    #[error("no window stays open: the graphics device is lost again and again ({0})")]
    Lost(String),
}

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

/// A window that is to be opened.
#[derive(Default)]
pub struct Opening {
    /// What is taught.
    pub library: Library,
    /// What it shall show first.
    pub wishes: Wishes,
    /// What it remembers.
    pub remembered: Remembered,
    /// The file in which it keeps where it stands.
    pub last: Option<PathBuf>,
    /// Held as long as the window is open: no other keeps its place in the same file.
    pub lock: Option<File>,
    /// How many devices may be lost.
    pub patience: Patience,
    /// Called before each frame.
    pub each_frame: Option<EachFrame>,
    /// Makes the event loop, where it must not be the usual one.
    pub event_loop: Option<eframe::EventLoopBuilderHook>,
}

/// What looks on, frame by frame.
pub type EachFrame = Box<dyn FnMut(&mut App, &Ui, &eframe::Frame)>;

impl Opening {
    /// The user's own window, with what it remembers.
    pub fn of_user(library: Library, wishes: Wishes) -> Opening {
        let slot = folders::state().map(|folder| Slot::free(&folder));
        let (last, lock) = slot.map_or((None, None), |slot| (Some(slot.file), slot.lock));
        Opening { library, wishes, remembered: Remembered::of_user(), last, lock, ..Opening::default() }
    }

    /// Opens the window and returns when it is closed. A window whose device is lost opens again on the same state: an
    /// app cannot give egui's painter another device.
    ///
    /// # Errors
    /// There is no display, or nothing that could draw; or it was lost too often.
    pub fn open(self) -> Result<(), NoWindow> {
        let Opening { library, wishes, remembered, last, lock: _held, mut patience, mut each_frame, mut event_loop } =
            self;
        let mut first = Some((library, wishes, remembered, last));
        let (mut app, mut context) = (None::<App>, None::<egui::Context>);
        let mut viewport = usual();
        loop {
            let known = context.clone();
            let returns = known.is_some();
            let options = eframe::NativeOptions {
                viewport,
                centered: !returns,
                event_loop_builder: event_loop.take(),
                ..eframe::NativeOptions::default()
            };
            let (shown, each_frame) = (&mut app, &mut each_frame);
            let (first, used) = (&mut first, &mut context);
            let create = move |creation: &eframe::CreationContext<'_>| {
                let (shown, each_frame, context) = (shown, each_frame, &creation.egui_ctx);
                if let Some((library, wishes, remembered, last)) = first.take() {
                    let reopens = wishes.leaves_open();
                    let app = shown.insert(App::wished(context, library, wishes, remembered));
                    if let Some(file) = last {
                        app.keep_in(file, reopens);
                    }
                } else {
                    device::upload_letters(context);
                }
                *used = Some(context.clone());
                let app = shown.as_mut().ok_or("the window was never opened")?;
                if let Some(state) = &creation.wgpu_render_state {
                    app.draw_with(context, state);
                }
                let shown: Box<dyn eframe::App> = Box::new(Shown { app, each_frame, returns, looks: LOOKS });
                Ok(shown)
            };
            eframe::run_native_ext("Raystep", options, known, Box::new(create))?;
            let (Some(app), Some(context)) = (&mut app, &context) else { return Ok(()) };
            app.close();
            let Some(lost) = app.take_lost() else { return Ok(()) };
            if patience.ends(Instant::now()) {
                return Err(NoWindow::Lost(lost.why));
            }
            files::say(&format!("the graphics device was lost ({}); the window opens again.", lost.why));
            app.is_back(context);
            viewport = again(&lost.window);
        }
    }
}

/// The window as it is opened first.
fn usual() -> ViewportBuilder {
    ViewportBuilder::default()
        .with_title("Raystep")
        .with_app_id("raystep")
        .with_inner_size([1440.0, 900.0])
        .with_min_inner_size([900.0, 600.0])
        .with_drag_and_drop(true)
}

/// The window where it stood.
fn again(stood: &ViewportInfo) -> ViewportBuilder {
    let is = |flag: Option<bool>| flag == Some(true);
    let mut window = usual().with_fullscreen(is(stood.fullscreen)).with_maximized(is(stood.maximized));
    if let Some(inner) = stood.inner_rect {
        window = window.with_inner_size(inner.size());
    }
    if let Some(outer) = stood.outer_rect {
        window = window.with_position(outer.min);
    }
    window
}

/// The app in a window of its own, which may be closed before it.
struct Shown<'a> {
    app: &'a mut App,
    each_frame: &'a mut Option<EachFrame>,
    /// Whether there was a window before, of which no frame has been drawn since.
    returns: bool,
    /// For so many frames it is looked whether the window, with what stands around it, is larger than the screen.
    looks: u32,
}

/// A window has its frame after so many frames at most.
const LOOKS: u32 = 60;

impl Shown<'_> {
    /// Makes a window smaller that reaches beyond the screen with its title bar: its foot would not be seen.
    fn stay_on_screen(&mut self, context: &egui::Context) {
        if self.looks == 0 {
            return;
        }
        self.looks -= 1;
        let window = context.input(|input| input.viewport().clone());
        let (Some(inner), Some(outer), Some(screen)) = (window.inner_rect, window.outer_rect, window.monitor_size)
        else {
            return;
        };
        let over = (outer.size() - screen).max(egui::Vec2::ZERO);
        let whole = window.fullscreen == Some(true) || window.maximized == Some(true);
        if over != egui::Vec2::ZERO && !whole {
            self.looks = 0;
            context.send_viewport_cmd(egui::ViewportCommand::InnerSize(inner.size() - over));
            context.send_viewport_cmd(egui::ViewportCommand::OuterPosition(egui::Pos2::ZERO));
        }
    }
}

impl eframe::App for Shown<'_> {
    fn logic(&mut self, context: &egui::Context, frame: &mut eframe::Frame) {
        self.app.logic(context, frame);
    }

    fn raw_input_hook(&mut self, context: &egui::Context, input: &mut egui::RawInput) {
        if std::mem::take(&mut self.returns) {
            // What was held when the window went is let go: no event says so.
            let held = context.input(|input| input.pointer.any_down());
            let pos = context.input(|input| input.pointer.latest_pos()).unwrap_or_default();
            let released = |button| PointerButton { pos, button, pressed: false, modifiers: egui::Modifiers::NONE };
            let buttons = [egui::PointerButton::Primary, egui::PointerButton::Secondary, egui::PointerButton::Middle];
            let releases = buttons.into_iter().filter(|_| held).map(released);
            input.events.splice(0..0, releases.chain([WindowFocused(false), WindowFocused(true)]));
        }
        self.app.raw_input_hook(context, input);
    }

    fn ui(&mut self, ui: &mut Ui, frame: &mut eframe::Frame) {
        self.stay_on_screen(ui.ctx());
        if let Some(each) = self.each_frame {
            each(self.app, ui, frame);
        }
        self.app.ui(ui, frame);
    }
}
