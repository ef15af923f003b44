//! A heat map where space would be: its rays are those of the same camera, and each pixel leads into a walk.

use std::sync::Arc;

use egui::{
    Align, Align2, ComboBox, CursorIcon, Label, Layout, PointerButton, Rect, RichText, Sense, Ui, UiBuilder, vec2,
};
use raystep_accel::{Aabb, Prims};
use raystep_fast::FastKind;
use raystep_figure::{Ask, Camera, Face, Look, Maps, Role};
use raystep_lesson::Column;

use super::page::{Asked, Kept, Page};
use super::rival;
use super::space::{BORDER, glam_size};
use crate::shown::beside::Beside;
use crate::shown::board::counted;
use crate::shown::camera::Seen;
use crate::shown::command::Command;
use crate::shown::eye;
use crate::shown::heat::{Walked, Wish};
use crate::shown::kind_name::kind_name;
use crate::shown::playback::Playback;
use crate::window::look::controls;
use crate::window::look::fonts::font;
use crate::window::look::painter::{caption, paint_figure};
use crate::window::look::visuals::ink;
use crate::window::work::heating::Level;

/// The height of the strip with what is counted; where it is narrower than this it has two rows.
const STRIP: f32 = 38.0;
const ONE_ROW: f32 = 640.0;
/// In a narrower strip the way back has one word.
const FEW_WORDS: f32 = 400.0;

/// Shows the map in a rectangle, with what is counted above it unless a class is shown it.
pub(super) fn show(
    ui: &mut Ui,
    page: Page<'_>,
    kept: &mut Kept,
    rect: Rect,
    of: Column,
    scale: f32,
    asked: &mut Vec<Asked>,
) {
    let study = !page.state.present;
    let rows = if rect.width() < ONE_ROW { 2.0 } else { 1.0 };
    let strip = Rect::from_min_size(rect.min, vec2(rect.width(), if study { STRIP * rows } else { 0.0 }));
    let room = Rect::from_min_max(strip.left_bottom(), rect.max);
    let look = Look { text: Look::WINDOW.text * scale, titles: false, least: 0.0 };
    let Some(wish) = wish(page, kept, room, of, &look) else { return };
    let camera = wish.camera;
    if study {
        choices(ui, page, strip, of, asked);
    }
    let size = wish.size;
    if kept.heat.ask_for(wish) {
        // What is asked for now is begun with the next frame.
        ui.ctx().request_repaint();
    }
    let response = ui.allocate_rect(room, Sense::hover());
    let response = ui.interact(room.shrink(BORDER), response.id.with("heat"), Sense::click_and_drag());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "Each ray and its cost"));
    let around = page.state.playback().map_or(Aabb::EMPTY, |playback| playback.play.structure.bounds());
    turn(ui, &response, page, camera, size, &around, asked);
    let Some(level) = page.heat else {
        let says = "Counting …";
        caption(ui.painter(), room.center(), Align2::CENTER_CENTER, says, Face::Regular, 15.0, Role::Quiet, page.theme);
        return;
    };
    let heated = &level.heated;
    let ask = Ask::new(glam_size(room), look);
    let figure = kept.heat.figure(heated, &ask);
    let painter = ui.painter_at(room);
    paint_figure(&painter, room.min, &figure, page.theme, None);
    let instant = heated.instant();
    let reel = heated.reel();
    let still = reel.still(&instant);
    let point = |pointer: egui::Pos2| glam::Vec2::new(pointer.x - room.left(), pointer.y - room.top());
    let hovered = response.hover_pos().filter(|_| !response.dragged());
    let Some(pixel) = hovered.and_then(|pointer| still.pixel_at(&ask, point(pointer))) else { return };
    if let Some(probe) = still.probe(&ask, &pixel) {
        paint_figure(&painter, room.min, &probe, page.theme, None);
    }
    ui.ctx().set_cursor_icon(CursorIcon::PointingHand);
    if response.clicked()
        && let Some(ray) = heated.ray_of(&pixel)
    {
        let camera = eye::aside(&heated.wish.camera);
        let seen = Seen { camera, aspect: size.x / size.y };
        asked.push(Asked::PixelRay { ray, count: pixel.count, of: heated.wish.of, seen });
    }
}

/// What is to be counted: through the structure that is shown, the one beside it, and one at full speed.
fn wish(page: Page<'_>, kept: &mut Kept, room: Rect, of: Column, look: &Look) -> Option<Wish> {
    let pictures = kept.pictures.as_ref()?;
    let space = pictures.space.as_deref()?;
    let playback = page.state.playback()?;
    let beside = page.beside.filter(|_| matches!(page.state.beside, Beside::Structure(_)));
    let named = |playback: &Playback| {
        let walked = Walked::Textbook(playback.play.structure.clone());
        (kind_name(playback.rule.kind()).to_owned(), walked)
    };
    let scene = &playback.play.scene;
    let fast =
        page.state.quick.and_then(|kind| Some((kind_name(kind.name()).to_owned(), kept.heat.fast(scene, kind)?)));
    let own = std::iter::once(named(playback));
    let structures: Vec<_> = own.chain(beside.map(|beside| named(beside))).chain(fast).collect();
    let size = Maps::picture(glam_size(room), structures.len(), look);
    // What is seen fills the width; higher than wide there would be nothing but sky.
    let size = glam::Vec2::new(size.x, size.y.min(size.x)).floor();
    let camera = kept.sight.camera(page.state, space, size);
    Some(Wish { scene: playback.play.scene.clone(), structures, of, camera, size })
}

/// What is counted, what stands beside, and the way back: in one row, or in two.
fn choices(ui: &mut Ui, page: Page<'_>, strip: Rect, of: Column, asked: &mut Vec<Asked>) {
    let narrow = strip.width() < ONE_ROW;
    let (first, second) = strip.split_top_bottom_at_y(strip.top() + STRIP);
    let set = |row: Rect| {
        let inner = row.shrink2(vec2(12.0, 3.0));
        UiBuilder::new().max_rect(inner).layout(Layout::right_to_left(Align::Center))
    };
    let note = |ui: &mut Ui| {
        if let Some(level) = page.heat {
            let says = RichText::new(so_far(level, page.counting)).small().color(ink(page.theme, Role::Quiet));
            ui.add(Label::new(says).truncate());
        }
    };
    if narrow {
        ui.scope_builder(set(second), |ui| {
            beside(ui, page, asked);
            ui.with_layout(Layout::left_to_right(Align::Center), note);
        });
    }
    ui.scope_builder(set(first), |ui| {
        let back = if strip.width() < FEW_WORDS { "Back" } else { "Back to the picture" };
        let back = ui.button(back).on_hover_text(Command::Heat.tip());
        if back.clicked() {
            asked.push(Asked::Command(Command::Heat));
        }
        if !narrow {
            beside(ui, page, asked);
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            ui.label(RichText::new("Heat map").font(font(Face::Bold, 13.5)));
            let combo = ComboBox::from_id_salt("counted").width(150.0).selected_text(words(of)).show_ui(ui, |ui| {
                for other in Column::COUNTS {
                    if ui.selectable_label(other == of, words(other)).clicked() {
                        asked.push(Asked::Count(other));
                    }
                }
            });
            controls::name(&combo.response, "What is counted");
            if !narrow {
                note(ui);
            }
        });
    });
}

/// What stands beside: a structure, one at full speed.
fn beside(ui: &mut Ui, page: Page<'_>, asked: &mut Vec<Asked>) {
    if let Beside::Structure(kind) = page.state.beside {
        asked.extend(rival::structures(ui, page.state, kind).map(Asked::Compare));
        ui.label("beside");
    }
    let triangles = |playback: &Arc<Playback>| matches!(playback.play.scene.prims, Prims::Mesh(_));
    if page.state.playback().is_some_and(triangles) {
        asked.extend(quick(ui, page.state.quick).map(Asked::Quick));
    }
}

/// Which structure at full speed stands beside, or none.
fn quick(ui: &mut Ui, now: Option<FastKind>) -> Option<Option<FastKind>> {
    let name = |kind: Option<FastKind>| kind.map_or("none at full speed", |kind| kind_name(kind.name()));
    let mut chosen = None;
    let combo = ComboBox::from_id_salt("quick").width(132.0).selected_text(name(now)).show_ui(ui, |ui| {
        for kind in std::iter::once(None).chain(FastKind::ALONE.map(Some)) {
            if ui.selectable_label(kind == now, name(kind)).clicked() {
                chosen = Some(kind);
            }
        }
    });
    controls::name(&combo.response, "At full speed beside it");
    chosen
}

/// How many rays the map is made of.
fn so_far(level: &Level, counting: bool) -> String {
    let [across, down] = level.heated.rays;
    match level.pixel {
        _ if counting => format!("{across} × {down} rays, more are under way"),
        1 => format!("{across} × {down} rays in {} s", raystep_figure::number(level.seconds as f32)),
        pixel => format!("{across} × {down} rays: a pixel is {pixel} × {pixel} points"),
    }
}

fn words(of: Column) -> String {
    format!("{} per ray", counted(of))
}

/// The camera is moved as over the picture of space.
fn turn(
    ui: &Ui,
    response: &egui::Response,
    page: Page<'_>,
    camera: Camera,
    size: glam::Vec2,
    around: &Aabb,
    asked: &mut Vec<Asked>,
) {
    let aspect = size.x / size.y.max(1.0);
    let delta = response.drag_delta();
    let drag = glam::Vec2::new(delta.x, delta.y);
    let moved = match () {
        () if response.dragged_by(PointerButton::Primary) => Some(eye::turned(&camera, drag, size)),
        () if response.dragged() => Some(eye::shifted(&camera, drag, size)),
        () => None,
    };
    if response.drag_started() {
        asked.push(Asked::Keep);
    }
    if let Some(moved) = moved.filter(|_| drag != glam::Vec2::ZERO) {
        asked.push(Asked::Turn(Seen { camera: eye::bounded(&camera, moved, around), aspect }));
    }
    if response.hover_pos().is_none() {
        return;
    }
    let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta.y, input.zoom_delta()));
    let factor = (scroll * 0.0025).exp() * pinch;
    if factor != 1.0 {
        if page.state.view.camera.is_none() {
            asked.push(Asked::Keep);
        }
        let nearer = eye::nearer(&camera, factor, size * 0.5, size);
        asked.push(Asked::Turn(Seen { camera: eye::bounded(&camera, nearer, around), aspect }));
    }
}
