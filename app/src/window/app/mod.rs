//! The window: one `ui` that shows the state and does what keys, bars, panes and dialogs ask for.

mod asked;
mod commands;
mod device;
mod look;
mod news;
mod notices;
mod page;
mod place;

use std::path::PathBuf;
use std::sync::Arc;

use egui::{Ui, ViewportInfo};
use raystep_accel::Ray;
use raystep_figure::Theme;
use raystep_lesson::{Library, StageKind};
use raystep_paint::Mesh;
use raystep_scene::Scene;

use crate::shown::Link;
use crate::shown::pictures::Pictures;
use crate::shown::playback::Playback;
use crate::shown::state::State;
use crate::shown::view::View;
use crate::window::device::Fate;
use crate::window::dialogs::Overlay;
use crate::window::last::{Keeper, Last};
use crate::window::look::fonts;
use crate::window::look::remembered::Remembered;
use crate::window::panes::Kept;
use crate::window::panes::present::Marks;
use crate::window::speaker::Speaker;
use crate::window::wishes::Wishes;
use crate::window::work::Underway;

/// The window.
pub struct App {
    /// What is shown.
    pub state: State,
    /// The theme of the study page, and that of the presenter's.
    themes: [&'static Theme; 2],
    /// Whether the last frame was the presenter's page, and whether the window filled the screen before that.
    presented: Option<bool>,
    /// What the lecturer's hand leaves on the page.
    marks: Marks,
    speaker: Speaker,
    /// The class's page, while it is held.
    held: Option<Held>,
    underway: Underway,
    kept: Kept,
    overlay: Overlay,
    remembered: Remembered,
    styled: Option<&'static str>,
    /// When the last frame was drawn, in seconds.
    played: Option<f64>,
    /// What has become of the device that the window is drawn with.
    fate: Fate,
    /// Set once that device is lost.
    lost: Option<Lost>,
    /// What is said of the lessons that are shown.
    problems: Option<String>,
    /// The folder of the lessons, if they are not those in the program.
    lessons: Option<PathBuf>,
    /// Whether the mesh is still awaited that the window was opened for.
    first_mesh: bool,
    /// The mesh that was opened last, and where it lies.
    mesh: Option<(Arc<Scene>, PathBuf)>,
    /// The ray of the pixel of a heat map that was clicked last, and what was counted of it.
    stepped: Option<(Ray, u32)>,
    /// The slide and the stage that were drawn when keys were taken last.
    seen: Option<(usize, StageKind)>,
    /// Keeps where the window stands.
    keeper: Option<Keeper>,
    /// Where it stood the last time, while the bar asks whether to go on there, and the view at which that was asked.
    offers: Option<(Last, Option<View>)>,
    /// Where it is to open once its mesh is there.
    reopens: Option<Link>,
}

/// A page that a class goes on seeing, with what is drawn on it.
struct Held {
    state: State,
    beside: Option<Arc<Playback>>,
    mesh: Option<Arc<Mesh>>,
}

/// A device was lost, and with it the window.
pub(super) struct Lost {
    /// Why, as far as that is known.
    pub(super) why: String,
    /// Where the window stood.
    pub(super) window: ViewportInfo,
}

impl App {
    /// A window on these lessons, standing on a slide.
    pub fn new(context: &egui::Context, library: Library, slide: usize, remembered: Remembered) -> App {
        context.set_fonts(fonts::definitions());
        let mut state = State::new(Arc::new(library), slide);
        state.predict = remembered.predict;
        state.motion = remembered.moves();
        let theme = |name: &str| Theme::named(name).unwrap_or(&Theme::LIGHT);
        let themes = [theme(&remembered.theme), theme(&remembered.presenting)];
        context.set_zoom_factor(remembered.zoom);
        let mut kept = Kept::default();
        remembered.wrong.iter().for_each(|sentence| kept.notices.keep(sentence));
        App {
            state,
            themes,
            presented: None,
            marks: Marks::default(),
            speaker: Speaker::new(context),
            held: None,
            underway: Underway::new(context),
            kept,
            overlay: Overlay::default(),
            remembered,
            styled: None,
            played: None,
            fate: Fate::default(),
            lost: None,
            problems: None,
            lessons: None,
            mesh: None,
            first_mesh: false,
            stepped: None,
            seen: None,
            keeper: None,
            offers: None,
            reopens: None,
        }
    }

    /// A window that shows what was wished for.
    pub fn wished(context: &egui::Context, library: Library, wishes: Wishes, remembered: Remembered) -> App {
        let slide = wishes.slide(&library);
        let mut app = App::new(context, library, slide, remembered);
        let library = app.state.library.clone();
        app.tell_problems(&library);
        wishes.go(&mut app.state);
        if let Some(folder) = &wishes.lessons {
            app.watch_lessons(folder, wishes.only);
        }
        if let Some(mesh) = wishes.mesh {
            app.first_mesh = true;
            app.open_mesh(mesh);
        }
        if let Some(link) = wishes.at {
            app.follow(link);
        }
        app
    }

    /// Which page of what is said is shown to a class, from 0 on, and how many there are.
    pub fn pages(&self) -> [usize; 2] {
        self.kept.pages.now()
    }

    /// How many strokes of the pen the class sees.
    pub fn strokes(&self) -> usize {
        self.marks.strokes()
    }

    /// How many places these strokes go through, all of them.
    pub fn stroke_points(&self) -> usize {
        self.marks.places()
    }

    /// The walk beside, once it is there.
    pub fn beside(&self) -> Option<&Arc<Playback>> {
        self.underway.beside()
    }

    /// The structures of the heat map that is shown, by their names.
    pub fn heat_names(&self) -> Vec<String> {
        let maps = self.underway.heat().0.and_then(|level| level.heated.maps());
        maps.map_or_else(Vec::new, |maps| maps.maps.iter().map(|map| map.name.clone()).collect())
    }

    /// Side of a pixel of the heat map that is shown, in points.
    pub fn heat_pixel(&self) -> Option<u32> {
        Some(self.underway.heat().0?.pixel)
    }

    /// The ray of the pixel of a heat map that was clicked last, and what was counted of it.
    pub fn stepped(&self) -> Option<(Ray, u32)> {
        self.stepped
    }

    /// Whether nothing is built beside the UI thread, not even what was given up.
    pub fn is_idle(&self) -> bool {
        self.underway.is_idle() && self.speaker.is_idle()
    }
}

/// So many seconds after it was moved a mouse lies still before a class: nothing shows it, and it lights nothing up.
const RESTS: f32 = 2.0;

impl eframe::App for App {
    fn raw_input_hook(&mut self, context: &egui::Context, input: &mut egui::RawInput) {
        if !self.state.present {
            return;
        }
        let now = input.time;
        let pointer = |seen: &egui::InputState| {
            let pointer = &seen.pointer;
            // What was seen last is as old as the frame before.
            let since = now.map_or(0.0, |now| (now - seen.time) as f32);
            (pointer.time_since_last_movement() + since, pointer.any_down(), pointer.has_pointer())
        };
        let (still, down, there) = context.input(pointer);
        let moves =
            |event: &egui::Event| matches!(event, egui::Event::PointerMoved(_) | egui::Event::PointerButton { .. });
        if down || input.events.iter().any(moves) {
            return;
        }
        if there && still >= RESTS {
            input.events.push(egui::Event::PointerGone);
        }
    }

    fn logic(&mut self, context: &egui::Context, _frame: &mut eframe::Frame) {
        self.watch_device(context);
    }

    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        self.dress(ui);
        self.take_keys(ui);
        if self.state.present {
            let pointer = ui.input(|input| input.pointer.clone());
            match pointer.has_pointer() {
                // Looked at again when it may have come to rest.
                true => ui.ctx().request_repaint_after_secs((RESTS - pointer.time_since_last_movement()).max(0.1)),
                false => ui.ctx().set_cursor_icon(egui::CursorIcon::None),
            }
        }
        self.catch_up(ui);
        if self.seen != Some((self.state.view.slide, self.state.view.stage)) {
            // Keys that come while a page is drawn for the first time are those of the next frame.
            ui.ctx().request_repaint();
        }
        // Playing follows the clock, however long a frame takes.
        let now = ui.input(|input| input.time);
        let seconds = self.played.replace(now).filter(|_| self.state.playing).map_or(0.0, |then| now - then);
        if let Some(wait) = self.state.tick(seconds as f32) {
            ui.ctx().request_repaint_after_secs(wait.min(0.1));
        }
        self.fill_screen(ui);
        self.marks.begin(&self.state);
        self.kept.moving.begin(ui, &self.state);
        self.hold();
        let shown = self.held.as_ref().map_or(&self.state, |held| &held.state);
        self.kept.pictures = Pictures::of(self.kept.pictures.take(), shown);
        let drawn = self.state.stamp();
        self.panes(ui);
        self.speak(ui);
        // A class sees no dialog, and not how far anything is.
        if !self.state.present {
            self.overlay(ui);
        }
        if ui.input(|input| !input.pointer.any_down()) {
            self.remembered.keep(ui.ctx().zoom_factor(), self.state.predict, self.state.motion);
            self.keep_place(ui.ctx());
        }
        if self.state.stamp() != drawn {
            // What was clicked shows without waiting for the pointer to move again.
            ui.ctx().request_repaint();
        }
    }
}
