//! The window: one `ui` that shows the state and does what keys, bars, panes and dialogs ask for.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use egui::{Frame, Margin, Panel, Ui, ViewportCommand, ViewportInfo};
use raystep_accel::{Place, Ray};
use raystep_figure::{Role, Theme};
use raystep_lesson::Library;
use raystep_paint::Mesh;
use raystep_scene::Scene;

use super::bars::{bottom, go_on, top};
use super::device::{self, Fate};
use super::dialogs::{self, Overlay};
use super::keys;
use super::last::{Keeper, Last, named};
use super::look::fonts;
use super::look::remembered::Remembered;
use super::look::visuals::{self, fill};
use super::panes::present::{self, Marks};
use super::panes::speaker::AskedHere;
use super::panes::{self, Kept, Moved, Notices, Page, study};
use super::speaker::{self, Speaker};
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
use crate::shown::view::{RayChoice, View};

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
    /// The mesh that was opened last, and where it lies.
    mesh: Option<(Arc<Scene>, PathBuf)>,
    /// The ray of the pixel of a heat map that was clicked last, and what was counted of it.
    stepped: Option<(Ray, u32)>,
    /// Keeps where the window stands.
    keeper: Option<Keeper>,
    /// Where it stood the last time, while the bar asks whether to go on there, and the view at which that was asked.
    offers: Option<(Last, Option<View>)>,
    /// Where it is to open once its mesh is there.
    reopens: Option<Link>,
}

/// Rays across and down by which all structures are measured.
const JUDGED: [u32; 2] = [160, 120];

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
            stepped: None,
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
        self.speaker.draw_with(Some(state));
        self.underway.upload_to(Some(state.device.clone()), self.state.playback());
    }

    /// If the window was closed since its device is lost: lets go of all that lies on that, and says what was there.
    pub(super) fn take_lost(&mut self) -> Option<Lost> {
        let lost = self.lost.take()?;
        self.kept.draw_with(None);
        self.speaker.draw_with(None);
        self.held = None;
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

    /// Keeps where the window stands in a file from now on. With `reopens` it asks whether to go on where the file says.
    pub fn keep_in(&mut self, file: PathBuf, reopens: bool) {
        if !reopens {
            self.keeper = Some(Keeper::new(file));
            return;
        }
        let (keeper, found) = Keeper::reopening(file);
        self.keeper = Some(keeper);
        found.wrong.into_iter().for_each(|sentence| self.complain(sentence));
        let of_these = |last: &Last| last.is_of(self.lessons.as_deref()) && last.place(&self.state.library).is_some();
        self.offers = found.last.filter(of_these).map(|last| (last, None));
    }

    /// Goes on where the window stood the last time; says whether that was still asked.
    pub fn go_on(&mut self) -> bool {
        let Some((last, _)) = self.offers.take() else { return false };
        if let Some(keeper) = &mut self.keeper {
            keeper.goes_on(&last);
        }
        // What is not there any more is not missed.
        let _ = self.follow(last.link);
        true
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
    pub fn link(&self) -> Link {
        let shown = |(scene, _): &&(Arc<Scene>, PathBuf)| {
            self.state.view.mesh.as_ref().is_some_and(|mesh| Arc::ptr_eq(mesh, scene))
        };
        let mesh = self.mesh.as_ref().filter(shown).and_then(|(_, path)| named(path));
        Link::of(&self.state, mesh, self.kept.sight.aspect)
    }

    /// Asks whether to go on where the window stood, until somebody answers or does anything else.
    fn offer_to_go_on(&mut self, ui: &mut Ui) {
        let theme = self.theme();
        let Some((last, asked_at)) = &mut self.offers else { return };
        let now = self.state.target();
        let asked_at = asked_at.get_or_insert_with(|| now.clone());
        let place = last.place(&self.state.library).filter(|_| asked_at.same_page(now));
        let chosen = place.map_or(Some(go_on::Chosen::Begin), |place| go_on::bar(ui, &place, theme));
        match chosen {
            Some(go_on::Chosen::GoOn) => drop(self.go_on()),
            Some(go_on::Chosen::Begin) => self.offers = None,
            None => {}
        }
    }

    /// Which page of what is said is shown to a class, from 0 on, and how many there are.
    pub fn pages(&self) -> [usize; 2] {
        self.kept.pages.now()
    }

    /// How many strokes of the pen the class sees.
    pub fn strokes(&self) -> usize {
        self.marks.strokes()
    }

    /// Where the window stands; nothing while it goes somewhere else.
    fn stands(&self) -> Option<Last> {
        let stands = self.state.is_current() && self.reopens.is_none() && self.offers.is_none();
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

    /// The structures of the heat map that is shown, by their names.
    pub fn heat_names(&self) -> Vec<String> {
        let maps = self.underway.heat().0.and_then(|level| level.heated.maps());
        maps.map_or_else(Vec::new, |maps| maps.maps.iter().map(|map| map.name.clone()).collect())
    }

    /// The ray of the pixel of a heat map that was clicked last, and what was counted of it.
    pub fn stepped(&self) -> Option<(Ray, u32)> {
        self.stepped
    }

    /// Whether nothing is built beside the UI thread, not even what was given up.
    pub fn is_idle(&self) -> bool {
        self.underway.is_idle() && self.speaker.is_idle()
    }

    /// Does what a command says.
    pub fn run(&mut self, ui: &Ui, command: Command) {
        let context = ui.ctx();
        if self.kept.pages.turn(&self.state, command) {
            context.request_repaint();
            return;
        }
        match command {
            // The class sees no dialog: they open on the speaker's window, or in the study.
            Command::Palette | Command::Help | Command::Export | Command::Open | Command::Best
                if self.state.present && !self.state.lecture.speaker => {}
            Command::Skip if self.go_on() => {}
            Command::FullScreen => {
                let full = context.input(|input| input.viewport().fullscreen.unwrap_or(false));
                context.send_viewport_cmd(ViewportCommand::Fullscreen(!full));
            }
            Command::Palette => self.overlay.find(),
            Command::Help => self.overlay.help(self.state.present),
            Command::Export => self.overlay.export(&self.state, self.theme()),
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
                let now = themes.iter().position(|theme| theme.name == self.theme().name).unwrap_or(0);
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

    /// The theme of the page that is shown.
    fn theme(&self) -> &'static Theme {
        self.themes[usize::from(self.state.present)]
    }

    /// Sets the theme of the page that is shown; each has its own.
    fn set_theme(&mut self, theme: &'static Theme) {
        self.themes[usize::from(self.state.present)] = theme;
        let Remembered { theme: study, presenting, .. } = &mut self.remembered;
        theme.name.clone_into(if self.state.present { presenting } else { study });
    }

    /// The presenter's page fills the screen; the study is as large as it was.
    fn fill_screen(&mut self, ui: &Ui) {
        match (self.state.present, self.presented) {
            (true, None) => {
                let full = ui.input(|input| input.viewport().fullscreen.unwrap_or(false));
                self.presented = Some(full);
                ui.ctx().send_viewport_cmd(ViewportCommand::Fullscreen(true));
            }
            (false, Some(full)) => {
                self.presented = None;
                ui.ctx().send_viewport_cmd(ViewportCommand::Fullscreen(full));
            }
            _ => {}
        }
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
        exporting::copy(
            &mut self.underway.errands,
            window,
            self.state.view.step,
            sight.size * 2.0,
            self.themes[usize::from(self.state.present)],
        );
    }

    /// Says something for a while.
    fn say(&mut self, ui: &Ui, sentence: impl Into<String>) {
        self.notices().say(ui.ctx(), sentence);
    }

    /// Where sentences for the user stand: on the speaker's window, while that is open.
    fn notices(&mut self) -> &mut Notices {
        match self.state.present && self.state.lecture.speaker {
            true => &mut self.speaker.kept().notices,
            false => &mut self.kept.notices,
        }
    }

    /// Says what went wrong, until somebody closes it, and on the standard error.
    fn complain(&mut self, sentence: impl Into<String>) {
        let sentence = sentence.into();
        files::say(&sentence);
        self.notices().keep(sentence);
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
            // A class sees no dialog.
            News::Unwritten(fault) if self.state.present => self.complain(format!("Nothing was written: {fault}.")),
            News::Unwritten(fault) => {
                files::say(&fault.to_string());
                self.overlay.wrote(Err(fault));
            }
            News::Failed(sentence) => {
                self.reopens = None;
                self.complain(sentence);
            }
        }
    }

    /// The theme's colours and sizes for egui, when they are not set yet.
    fn dress(&mut self, ui: &mut Ui) {
        if self.styled != Some(self.theme().name) {
            self.styled = Some(self.theme().name);
            let style = visuals::style(self.theme());
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
        let theme = self.theme();
        let bar = Frame::new().fill(fill(theme, Role::Page)).inner_margin(Margin::symmetric(16, 0));
        let top = Panel::top("top").exact_size(48.0).frame(bar).resizable(false);
        match top.show(ui, |ui| top::bar(ui, &self.state, theme)).inner {
            Some(top::Asked::Command(command)) => self.run(ui, command),
            Some(top::Asked::Slide(slide)) => self.state.show_slide(slide),
            Some(top::Asked::Ray(ray)) => self.state.show_ray(RayChoice::Named(ray), false),
            Some(top::Asked::Mistake(mistake)) => self.break_it(ui, mistake),
            Some(top::Asked::Theme(theme)) => self.set_theme(theme),
            None => {}
        }
        self.offer_to_go_on(ui);
        let bottom = Panel::bottom("bottom").exact_size(80.0).frame(bar).resizable(false);
        let lit = self.lit();
        let pictures = self.kept.pictures.as_mut();
        let (asked, under) = bottom.show(ui, |ui| bottom::bar(ui, &self.state, pictures, theme, lit)).inner;
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
            let page = fill(self.theme(), Role::Page);
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
        let held = self.held.as_ref();
        let page = Page {
            state: held.map_or(&self.state, |held| &held.state),
            beside: held.map_or(self.underway.beside(), |held| held.beside.as_ref()),
            mesh: held.map_or(self.underway.mesh(), |held| held.mesh.as_ref()),
            making: self.underway.is_making(),
            heat,
            counting,
            lit: self.lit(),
            theme: self.theme(),
        };
        let under = match present {
            true => present::page(ui, page, &mut self.kept, &mut self.marks, &mut asked),
            false => study::page(ui, page, &mut self.kept, &mut self.remembered, &mut asked),
        };
        self.kept.hover(ui, under.or(in_bars));
        self.veil(ui, room);
        // What is held is only looked at.
        if self.held.is_none() {
            self.answer(ui, asked);
        }
    }

    /// Does what the panes ask for.
    fn answer(&mut self, ui: &Ui, asked: Vec<panes::Asked>) {
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
                panes::Asked::Quick(kind) => self.state.quick = kind,
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

    /// Keeps what the class sees while its page is held; what covers it and what points at it goes on.
    fn hold(&mut self) {
        let frozen = self.state.present && self.state.lecture.frozen;
        self.held = self.held.take().filter(|_| frozen);
        match &mut self.held {
            Some(held) => held.state.lecture = self.state.lecture.clone(),
            None if frozen => {
                let (beside, mesh) = (self.underway.beside().cloned(), self.underway.mesh().cloned());
                self.held = Some(Held { state: self.state.clone(), beside, mesh });
            }
            None => {}
        }
    }

    /// Shows the speaker's window, if it is open, and does what it asks for. Dialogs open there, where the class does not
    /// see them.
    fn speak(&mut self, ui: &Ui) {
        if !self.state.present {
            return self.speaker.end();
        }
        self.speaker.keep_time(&self.state, ui.input(|input| input.time));
        if !self.state.lecture.speaker {
            return self.speaker.rest();
        }
        let size = ui.ctx().content_rect().size().max(egui::vec2(160.0, 90.0));
        let (id, builder) = speaker::viewport(ui.input(|input| input.viewport().monitor_size));
        let context = ui.ctx().clone();
        context.show_viewport_immediate(id, builder, |ui, class| {
            if ui.input(|input| input.viewport().close_requested()) {
                self.state.lecture.speaker = false;
                return;
            }
            // Embedded in the class's window it has the same keys.
            if class != egui::ViewportClass::EmbeddedWindow {
                self.take_keys(ui);
            }
            let (heat, counting) = self.underway.heat();
            let (theme, making) = (self.theme(), self.underway.is_making());
            let (beside, mesh) = (self.underway.beside(), self.underway.mesh());
            let page = Page { state: &self.state, beside, mesh, making, heat, counting, lit: None, theme };
            let asked = self.speaker.show(ui, page, theme, size, &mut self.marks);
            for asked in asked {
                match asked {
                    AskedHere::Wall(asked) => self.answer(ui, vec![asked]),
                    AskedHere::Command(command) => self.run(ui, command),
                    AskedHere::Slide(slide) => self.state.show_slide(slide),
                    AskedHere::Step(step) => {
                        self.state.playing = false;
                        self.state.go(step);
                    }
                    AskedHere::Lengthen(_) | AskedHere::Restart => {}
                }
            }
            self.overlay(ui);
        });
    }

    /// Does what the keys say, while no dialog has them.
    fn take_keys(&mut self, ui: &Ui) {
        let busy = self.overlay.is_open();
        let escape = ui.input(|input| input.key_pressed(egui::Key::Escape)) && !busy;
        // What is held goes back to where it was, and nothing else happens.
        let takes_back = escape && self.kept.sight.let_go();
        if takes_back {
            self.state.take_back();
        } else if !busy {
            for command in keys::pressed(ui, self.state.present) {
                self.run(ui, command);
            }
        }
        if escape && !takes_back {
            self.state.picked = None;
            if self.state.lecture.cover.take().is_none() && self.state.present {
                self.state.apply(Command::Present);
            }
        }
    }

    /// Shows what lies over the page and does what it asks for.
    fn overlay(&mut self, ui: &Ui) {
        let tasks = self.underway.tasks();
        let asked = self.overlay.show(ui, &self.state, &tasks, &self.underway.judging, self.theme());
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

/// So many seconds after it was moved a mouse lies still before a class: nothing shows it, and it lights nothing up.
const RESTS: f32 = 2.0;

impl eframe::App for App {
    fn raw_input_hook(&mut self, context: &egui::Context, input: &mut egui::RawInput) {
        if !self.state.present {
            return;
        }
        let pointer = |input: &egui::InputState| {
            let pointer = &input.pointer;
            (pointer.time_since_last_movement(), pointer.any_down(), pointer.has_pointer())
        };
        let (still, down, there) = context.input(pointer);
        let moves =
            |event: &egui::Event| matches!(event, egui::Event::PointerMoved(_) | egui::Event::PointerButton { .. });
        if down || input.events.iter().any(moves) {
            return;
        }
        if there && still >= RESTS {
            input.events.push(egui::Event::PointerGone);
        } else if there {
            context.request_repaint_after_secs(RESTS - still);
        }
    }

    fn logic(&mut self, context: &egui::Context, _frame: &mut eframe::Frame) {
        self.watch_device(context);
    }

    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        self.dress(ui);
        self.take_keys(ui);
        if self.state.present && !ui.input(|input| input.pointer.has_pointer()) {
            ui.ctx().set_cursor_icon(egui::CursorIcon::None);
        }
        self.catch_up(ui);
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
