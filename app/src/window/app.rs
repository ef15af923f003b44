//! The window: one `ui` that shows the state and does what keys, bars, panes and dialogs ask for.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use egui::{Frame, Margin, Panel, Ui, ViewportCommand, ViewportInfo};
use raystep_accel::{Place, Ray};
use raystep_figure::{Role, Theme};
use raystep_lesson::Library;
use raystep_scene::Scene;

use super::bars::{bottom, top};
use super::device::{self, Fate};
use super::dialogs::{self, Overlay};
use super::keys;
use super::last::{Keeper, Last, named};
use super::look::fonts;
use super::look::remembered::Remembered;
use super::look::visuals::{self, fill};
use super::panes::{self, Kept, Moved, Page, present, study};
use super::wishes::Wishes;
use super::work::Underway;
use super::work::errands::News;
use super::work::exporting::{self, Window, Wish};
use crate::fault::Fault;
use crate::files;
use crate::rating::rays;
use crate::shown::Link;
use crate::shown::beside::Beside;
use crate::shown::command::Command;
use crate::shown::heat::sentence;
use crate::shown::pictures::Pictures;
use crate::shown::playback::Playback;
use crate::shown::state::State;
use crate::shown::view::RayChoice;

/// The window.
pub struct App {
    /// What is shown.
    pub state: State,
    theme: &'static Theme,
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
    /// The mesh that was opened last, and where it lies.
    mesh: Option<(Arc<Scene>, PathBuf)>,
    /// The ray of the pixel of a heat map that was clicked last, and what was counted of it.
    stepped: Option<(Ray, u32)>,
    /// Keeps where the window stands.
    keeper: Option<Keeper>,
    /// Where it is to open once its mesh is there.
    reopens: Option<Link>,
}

/// Rays across and down by which all structures are measured.
const JUDGED: [u32; 2] = [160, 120];

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
        let theme = Theme::named(&remembered.theme).unwrap_or(&Theme::LIGHT);
        context.set_zoom_factor(remembered.zoom);
        let mut kept = Kept::default();
        remembered.wrong.iter().for_each(|sentence| kept.notices.keep(sentence));
        App {
            state,
            theme,
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
            stepped: None,
            keeper: None,
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
            app.open_mesh(mesh);
        }
        if let Some(link) = wishes.at {
            app.follow(link);
        }
        app
    }

    /// Draws solid stages with egui's own device. If there was another one before, what is shown goes on on this one.
    pub fn draw_with(&mut self, context: &egui::Context, state: &egui_wgpu::RenderState) {
        self.fate = Fate::of(&state.device, &state.queue, context);
        device::guard(context, &self.fate);
        self.kept.draw_with(Some(state));
        self.underway.upload_to(Some(state.device.clone()), self.state.playback());
    }

    /// If the window was closed since its device is lost: lets go of all that lies on that, and says what was there.
    pub(super) fn take_lost(&mut self) -> Option<Lost> {
        let lost = self.lost.take()?;
        self.kept.draw_with(None);
        self.underway.upload_to(None, None);
        Some(lost)
    }

    /// Says for a while why the window was gone.
    pub(super) fn is_back(&mut self, context: &egui::Context) {
        self.kept.notices.say(context, "The graphics device was lost. The window is back with everything in it.");
    }

    /// Watches the device: once it is lost, the window closes.
    fn watch_device(&mut self, context: &egui::Context) {
        for sentence in self.fate.wrong() {
            self.kept.notices.keep(sentence);
        }
        if self.lost.is_none()
            && let Some(why) = self.fate.lost()
        {
            let window = context.input(|input| input.viewport().clone());
            self.lost = Some(Lost { why, window });
            context.send_viewport_cmd(ViewportCommand::Close);
            context.request_repaint();
        }
    }

    /// Lets lessons in a folder be read again when they are saved, `only` those or beside the lecture.
    pub fn watch_lessons(&mut self, folder: &Path, only: bool) {
        self.lessons = Some(folder.to_path_buf());
        self.underway.errands.watch(folder, only);
    }

    /// Opens a mesh beside the UI thread.
    pub fn open_mesh(&mut self, path: PathBuf) {
        self.underway.errands.load(path);
    }

    /// Keeps where the window stands in a file from now on. With `reopens` it opens where the file says.
    pub fn keep_in(&mut self, file: PathBuf, reopens: bool) {
        if !reopens {
            self.keeper = Some(Keeper::new(file));
            return;
        }
        let (keeper, found) = Keeper::reopening(file);
        self.keeper = Some(keeper);
        found.wrong.into_iter().for_each(|sentence| self.complain(sentence));
        let Some(last) = found.last.filter(|last| last.is_of(self.lessons.as_deref())) else { return };
        // What is not there any more is not missed.
        let _ = self.follow(last.link);
    }

    /// Goes where a link leads, once its mesh is there; says what of it is not.
    fn follow(&mut self, link: Link) -> Vec<String> {
        let wrong = link.open(&mut self.state, None);
        self.kept.sight.aspect = link.aspect;
        if let Some(mesh) = link.mesh.as_ref().map(PathBuf::from) {
            self.open_mesh(mesh);
            self.reopens = Some(link);
        }
        wrong
    }

    /// The place where the window stands.
    fn link(&self) -> Link {
        let shown = |(scene, _): &&(Arc<Scene>, PathBuf)| {
            self.state.view.mesh.as_ref().is_some_and(|mesh| Arc::ptr_eq(mesh, scene))
        };
        let mesh = self.mesh.as_ref().filter(shown).and_then(|(_, path)| named(path));
        Link::of(&self.state, mesh, self.kept.sight.aspect)
    }

    /// Where the window stands; nothing while it goes somewhere else.
    fn stands(&self) -> Option<Last> {
        let stands = self.state.is_current() && self.reopens.is_none();
        stands.then(|| Last::of(self.link(), self.lessons.as_deref()))
    }

    /// The window closes: where it stands is kept at once.
    pub fn close(&mut self) {
        if let (Some(now), Some(keeper)) = (self.stands(), &mut self.keeper) {
            keeper.close(now);
        }
    }

    /// Keeps where the window stands now and then.
    fn keep_place(&mut self, context: &egui::Context) {
        if self.keeper.is_none() {
            return;
        }
        if let (Some(now), Some(keeper)) = (self.stands(), &mut self.keeper)
            && let Some(waits) = keeper.keep(now)
        {
            context.request_repaint_after(waits);
        }
    }

    /// The walk beside, once it is there.
    pub fn beside(&self) -> Option<&Arc<Playback>> {
        self.underway.beside()
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
        self.underway.is_idle()
    }

    /// Does what a command says.
    pub fn run(&mut self, ui: &Ui, command: Command) {
        let context = ui.ctx();
        match command {
            Command::FullScreen => {
                let full = context.input(|input| input.viewport().fullscreen.unwrap_or(false));
                context.send_viewport_cmd(ViewportCommand::Fullscreen(!full));
            }
            Command::Palette => self.overlay.find(),
            Command::Help => self.overlay.help(),
            Command::Export => self.overlay.export(&self.state, self.theme),
            Command::Open => self.overlay.open(),
            Command::Copy => self.copy(),
            Command::Link => {
                let link = self.link().to_string();
                self.say(ui, format!("The link is on the clipboard: {link}"));
                context.copy_text(link);
            }
            Command::Cancel => self.underway.stop_all(&mut self.state),
            Command::Theme => {
                let themes = [&Theme::LIGHT, &Theme::DARK, &Theme::PROJECTOR];
                let now = themes.iter().position(|theme| theme.name == self.theme.name).unwrap_or(0);
                self.set_theme(themes[(now + 1) % themes.len()]);
            }
            Command::ZoomIn => egui::gui_zoom::zoom_in(context),
            Command::ZoomOut => egui::gui_zoom::zoom_out(context),
            Command::ZoomReset => context.set_zoom_factor(1.0),
            Command::Frame => self.frame_here(),
            Command::Best => self.judge(ui),
            Command::Offer(offer) if self.state.offers_best(offer) => self.judge(ui),
            Command::Heat => {
                self.state.apply(command);
                if self.state.is_current() && !self.state.can_heat() {
                    self.say(ui, "A heat map needs a solid scene and a structure; this slide has none.");
                }
            }
            Command::Break => {
                let on = matches!(self.state.beside, Beside::Mistake(_));
                self.break_it(ui, (!on).then_some(0));
            }
            other => self.state.apply(other),
        }
    }

    /// Measures all structures over the mesh that was opened last, or the solid scene that is shown, or the teapot.
    fn judge(&mut self, ui: &Ui) {
        let shown = self.state.playback().map(|playback| playback.play.scene.clone());
        let mesh = self.mesh.as_ref().map(|(mesh, _)| mesh.clone());
        let scene = mesh.or(shown.filter(|scene| !scene.flat));
        let scene = scene.or_else(|| Scene::named("teapot-6321").ok().map(Arc::new));
        let Some(scene) = scene else { return };
        let camera = self.kept.sight.camera_of(&self.state, &scene);
        match rays(&camera, JUDGED) {
            Ok(rays) => {
                self.underway.judging.begin(scene, rays);
                self.overlay.best();
            }
            Err(error) => self.say(ui, format!("The camera shoots no rays: {error}.")),
        }
    }

    fn set_theme(&mut self, theme: &'static Theme) {
        self.theme = theme;
        theme.name.clone_into(&mut self.remembered.theme);
    }

    /// Moves the camera to where the walk stands.
    fn frame_here(&mut self) {
        let Kept { pictures, sight, .. } = &mut self.kept;
        let seen = pictures.as_ref().and_then(|pictures| sight.framed(&self.state, pictures));
        if let Some(seen) = seen {
            sight.aspect = seen.aspect;
            self.state.look(Some(seen.camera));
        }
    }

    /// Shows a mistake beside the walk, on a ray where it shows; or none.
    fn break_it(&mut self, ui: &Ui, mistake: Option<usize>) {
        if let Some(consequence) = self.underway.break_it(&mut self.state, mistake) {
            self.say(ui, consequence);
        }
        self.catch_up_beside(ui);
    }

    /// Writes files beside the UI thread.
    fn write(&mut self, wish: Wish) -> Result<(), Fault> {
        let window = Window::of(&self.state, self.kept.sight.aspect)?;
        exporting::write(&mut self.underway.errands, window, wish);
        Ok(())
    }

    /// Puts the picture of space on the clipboard, as it would be exported.
    fn copy(&mut self) {
        let sight = &self.kept.sight;
        let window = Window::of(&self.state, sight.aspect);
        exporting::copy(&mut self.underway.errands, window, self.state.view.step, sight.size * 2.0, self.theme);
    }

    /// Says something for a while.
    fn say(&mut self, ui: &Ui, sentence: impl Into<String>) {
        self.kept.notices.say(ui.ctx(), sentence);
    }

    /// Says what went wrong, until somebody closes it, and on the standard error.
    fn complain(&mut self, sentence: impl Into<String>) {
        let sentence = sentence.into();
        files::say(&sentence);
        self.kept.notices.keep(sentence);
    }

    /// Says what is wrong in the lessons, until they are read again.
    fn tell_problems(&mut self, library: &Library) {
        if let Some(old) = self.problems.take() {
            self.kept.notices.take_back(&old);
        }
        let Some(first) = library.problems.first() else { return };
        let more = match library.problems.len() - 1 {
            0 => String::new(),
            more => format!(" And {more} more: raystep check names them."),
        };
        let sentence = format!("{first}.{more}");
        self.kept.notices.keep(sentence.clone());
        self.problems = Some(sentence);
    }

    /// Makes what the state asks for, as far as it is not there, and takes in what has come back.
    fn catch_up(&mut self, ui: &Ui) {
        if let Some(wrong) = self.underway.catch_up(&mut self.state) {
            self.complain(wrong);
        }
        for file in ui.input(|input| input.raw.dropped_files.clone()) {
            let path = file.path().to_path_buf();
            match path.extension() {
                Some(ending) if ending.eq_ignore_ascii_case("obj") => self.open_mesh(path),
                _ => self.complain(format!("{} is not opened: a mesh is a file in OBJ.", path.display())),
            }
        }
        while let Some(news) = self.underway.errands.next() {
            self.learn(ui, news);
        }
        self.catch_up_beside(ui);
        self.underway.catch_up_heat(self.kept.heat.take_wish());
        self.underway.judging.catch_up();
    }

    fn catch_up_beside(&mut self, ui: &Ui) {
        if let Some(wrong) = self.underway.catch_up_beside(&mut self.state) {
            self.say(ui, wrong);
        }
    }

    /// Takes in what has come back from outside.
    fn learn(&mut self, ui: &Ui, news: News) {
        match news {
            News::Chosen(path) => {
                if !self.overlay.chose_mesh(&path) {
                    self.open_mesh(path);
                }
            }
            News::Mesh(scene, ray, path) => {
                if !scene.note.is_empty() {
                    self.say(ui, scene.note.clone());
                }
                let wanted = self.reopens.take().filter(|link| link.mesh.as_ref().map(Path::new) == Some(&path));
                self.mesh = Some((scene.clone(), path));
                match wanted {
                    Some(link) => _ = link.open(&mut self.state, Some(scene)),
                    None => self.state.show_mesh(scene, ray),
                }
            }
            News::Folder(folder) => self.overlay.chose_folder(&folder),
            News::Copied(image) => {
                ui.ctx().copy_image(image);
                self.say(ui, "The picture is on the clipboard.");
            }
            News::Lessons(library) => {
                library.problems.iter().for_each(|problem| files::say(&problem.to_string()));
                self.tell_problems(&library);
                self.underway.renew();
                self.state.renew(*library);
            }
            News::Written(sentence) => self.say(ui, sentence),
            News::Failed(sentence) => {
                self.reopens = None;
                self.complain(sentence);
            }
        }
    }

    /// The theme's colours and sizes for egui, when they are not set yet.
    fn dress(&mut self, ui: &mut Ui) {
        if self.styled != Some(self.theme.name) {
            self.styled = Some(self.theme.name);
            let style = visuals::style(self.theme);
            for theme in [egui::Theme::Light, egui::Theme::Dark] {
                ui.ctx().set_style_of(theme, style.clone());
            }
            ui.set_style(style);
        }
    }

    /// What lights up: where the pointer is, else what was picked.
    fn lit(&self) -> Option<Place> {
        self.kept.hovered().or(self.state.picked)
    }

    /// Shows the bars and does what they ask for; says which place the pointer is on.
    fn bars(&mut self, ui: &mut Ui) -> Option<Place> {
        let bar = Frame::new().fill(fill(self.theme, Role::Page)).inner_margin(Margin::symmetric(16, 0));
        let top = Panel::top("top").exact_size(48.0).frame(bar).resizable(false);
        match top.show(ui, |ui| top::bar(ui, &self.state, self.theme)).inner {
            Some(top::Asked::Command(command)) => self.run(ui, command),
            Some(top::Asked::Slide(slide)) => self.state.show_slide(slide),
            Some(top::Asked::Ray(ray)) => self.state.show_ray(RayChoice::Named(ray), false),
            Some(top::Asked::Mistake(mistake)) => self.break_it(ui, mistake),
            Some(top::Asked::Theme(theme)) => self.set_theme(theme),
            None => {}
        }
        let bottom = Panel::bottom("bottom").exact_size(80.0).frame(bar).resizable(false);
        let lit = self.lit();
        let pictures = self.kept.pictures.as_mut();
        let (asked, under) = bottom.show(ui, |ui| bottom::bar(ui, &self.state, pictures, self.theme, lit)).inner;
        match asked {
            Some(bottom::Asked::Command(command)) => self.run(ui, command),
            Some(bottom::Asked::Step(step)) => {
                self.state.playing = false;
                self.state.go(step);
            }
            Some(bottom::Asked::Symbol(symbol)) => self.state.run_to_symbol(&symbol, shift(ui)),
            None => {}
        }
        under
    }

    /// While another slide or stage is made, what is still shown of the one before fades.
    fn veil(&self, ui: &Ui, room: egui::Rect) {
        let leaves = self.state.leaves();
        let gone = ui.ctx().animate_bool_with_time(egui::Id::unique("veil"), leaves, 0.4);
        if leaves && gone > 0.0 {
            let page = fill(self.theme, Role::Page);
            ui.painter().rect_filled(room, 0.0, page.gamma_multiply(0.75 * gone));
        }
    }

    /// Shows the panes and does what they ask for.
    fn panes(&mut self, ui: &mut Ui) {
        let present = self.state.present;
        let in_bars = if present { None } else { self.bars(ui) };
        let mut asked = Vec::new();
        let room = ui.available_rect_before_wrap();
        let (heat, counting) = self.underway.heat();
        let page = Page {
            state: &self.state,
            beside: self.underway.beside(),
            mesh: self.underway.mesh(),
            making: self.underway.is_making(),
            heat,
            counting,
            lit: self.lit(),
            theme: self.theme,
        };
        let under = match present {
            true => present::page(ui, page, &mut self.kept, &mut asked),
            false => study::page(ui, page, &mut self.kept, &mut self.remembered, &mut asked),
        };
        self.kept.hover(ui, under.or(in_bars));
        self.veil(ui, room);
        for asked in asked {
            match asked {
                panes::Asked::Command(command) => self.run(ui, command),
                panes::Asked::Slide(slide) => self.state.show_slide(slide),
                panes::Asked::Pick(place) => self.state.pick(place, shift(ui)),
                panes::Asked::Line(line) => self.state.run_to_line(line, shift(ui)),
                panes::Asked::Keep => self.state.keep(),
                panes::Asked::Turn(seen) => {
                    self.kept.sight.aspect = seen.aspect;
                    self.state.turn(seen.camera);
                }
                panes::Asked::Depth(depth) => self.state.show_depth(depth),
                panes::Asked::Part(part) => self.state.show_part(part),
                panes::Asked::Ray(ray) => self.state.show_ray(RayChoice::Own(ray), true),
                panes::Asked::Set(key, value) => self.state.set(key, &value),
                panes::Asked::Body(grip, to) => self.state.move_body(&grip, to),
                panes::Asked::Number(name, value) => self.state.set(&name, &value.to_string()),
                panes::Asked::Move(Moved { grasp, to }) => {
                    self.state.move_part(&grasp.scene, grasp.prim, grasp.part, [grasp.from, to]);
                }
                panes::Asked::Cut(cut) => self.state.cut(cut),
                panes::Asked::Try(cut) => self.state.try_cut(cut),
                panes::Asked::Say(sentence) => self.say(ui, sentence),
                panes::Asked::Count(of) => self.state.count(of),
                panes::Asked::PixelRay { ray, count, of, seen } => {
                    self.kept.sight.aspect = seen.aspect;
                    self.stepped = Some((ray, count));
                    if !self.state.step_ray(ray, seen.camera) {
                        self.say(ui, sentence(count, of, &ray));
                    }
                }
                panes::Asked::MapPixel(pixel) => {
                    self.kept.sight.aspect = pixel.size[0] as f32 / pixel.size[1] as f32;
                    if let Some(says) = self.state.open_pixel(&pixel) {
                        self.say(ui, says);
                    }
                }
                panes::Asked::Compare(kind) => self.state.compare(kind),
                panes::Asked::Abreast(rivals) => self.state.compare_all(rivals),
                panes::Asked::Pace(pace) => self.state.pace = pace,
            }
        }
    }

    /// Shows what lies over the page and does what it asks for.
    fn overlay(&mut self, ui: &Ui) {
        let tasks = self.underway.tasks();
        let asked = self.overlay.show(ui, &self.state, &tasks, &self.underway.judging, self.theme);
        if !asked.is_empty() {
            ui.ctx().request_repaint();
        }
        for asked in asked {
            match asked {
                dialogs::Asked::Command(command) => self.run(ui, command),
                dialogs::Asked::Slide(slide) => self.state.show_slide(slide),
                dialogs::Asked::Link(link) => {
                    self.state.keep();
                    let wrong = self.follow(*link);
                    if !wrong.is_empty() {
                        self.say(ui, format!("Not all of the link is here: {}.", wrong.join("; ")));
                    }
                }
                dialogs::Asked::ChooseFolder => self.underway.errands.ask_for_folder(),
                dialogs::Asked::Write(wish) => {
                    let written = self.write(wish);
                    self.overlay.wrote(written);
                }
                dialogs::Asked::ChooseMesh => self.underway.errands.ask_for_mesh(),
                dialogs::Asked::Mesh(path) => self.open_mesh(path),
                dialogs::Asked::Judged => self.underway.judging.end(),
                dialogs::Asked::Stop(task) => self.underway.stop(&task, &mut self.state),
            }
        }
    }
}

/// Whether Shift is held: what runs forth runs back.
fn shift(ui: &Ui) -> bool {
    ui.input(|input| input.modifiers.shift)
}

impl eframe::App for App {
    fn logic(&mut self, context: &egui::Context, _frame: &mut eframe::Frame) {
        self.watch_device(context);
    }

    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        self.dress(ui);
        let busy = self.overlay.is_open();
        let escape = ui.input(|input| input.key_pressed(egui::Key::Escape)) && !busy;
        // What is held goes back to where it was, and nothing else happens.
        let takes_back = escape && self.kept.sight.let_go();
        if takes_back {
            self.state.take_back();
        } else if !busy {
            for command in keys::pressed(ui) {
                self.run(ui, command);
            }
        }
        if escape && !takes_back {
            self.state.picked = None;
            if self.state.present {
                self.state.apply(Command::Present);
            }
        }
        self.catch_up(ui);
        // Playing follows the clock, however long a frame takes.
        let now = ui.input(|input| input.time);
        let seconds = self.played.replace(now).filter(|_| self.state.playing).map_or(0.0, |then| now - then);
        if let Some(wait) = self.state.tick(seconds as f32) {
            ui.ctx().request_repaint_after_secs(wait.min(0.1));
        }
        self.kept.moving.begin(ui, &self.state);
        self.kept.pictures = Pictures::of(self.kept.pictures.take(), &self.state);
        let drawn = self.state.stamp();
        self.panes(ui);
        self.overlay(ui);
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
