//! What panes and dialogs ask for.

use egui::Ui;

use super::App;
use crate::shown::heat::sentence;
use crate::shown::view::RayChoice;
use crate::window::panes::{self, Moved};
use crate::window::{dialogs, keys};

impl App {
    /// Does what the panes ask for.
    pub(super) fn answer(&mut self, ui: &Ui, asked: Vec<panes::Asked>) {
        for asked in asked {
            match asked {
                panes::Asked::Command(command) => self.run(ui, command),
                panes::Asked::Slide(slide) => self.state.show_slide(slide),
                panes::Asked::Pick(place) => self.state.pick(place, keys::shift(ui)),
                panes::Asked::Line(line) => self.state.run_to_line(line, keys::shift(ui)),
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
                panes::Asked::Stop(task) => self.underway.stop(&task, &mut self.state),
            }
        }
    }

    /// Shows what lies over the page and does what it asks for.
    pub(super) fn overlay(&mut self, ui: &Ui) {
        let asked = self.overlay.show(ui, &self.state, &self.underway.judging, self.theme());
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
            }
        }
    }
}
