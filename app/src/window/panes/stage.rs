//! The stage: one picture of space, or two beside each other.

use std::sync::Arc;

use egui::{Align2, Rect, Ui, pos2, vec2};
use raystep_accel::{Aabb, Accel, Place, Ray, Structure};
use raystep_figure::{Camera, Face, Look, Role, Still, axes};

use super::abreast;
use super::bill::{bill, verdict};
use super::figure;
use super::heat;
use super::hold::Hold;
use super::inset;
use super::levels;
use super::moving::Frame;
use super::page::{Asked, Kept, Page};
use super::rival;
use super::sight::Sight;
use super::space::{Happened, Picture, glam_size};
use crate::shown::beside::Beside;
use crate::shown::camera::Seen;
use crate::shown::eye;
use crate::shown::kind_name::kind_name;
use crate::shown::pictures::{Drawn, Pane, drawn};
use crate::shown::playback::Playback;
use crate::shown::state::State;
use crate::window::look::painter::{caption, paint_figure};
use crate::window::look::visuals::line;

/// Shows the stage in all the room there is; says which place the pointer is on.
pub(super) fn stages(ui: &mut Ui, page: Page<'_>, kept: &mut Kept, asked: &mut Vec<Asked>) -> Option<Place> {
    let rect = ui.available_rect_before_wrap();
    if page.state.beside == Beside::Nothing || page.state.heat().is_some() {
        return alone(ui, page, kept, rect, true, 1.0, asked);
    }
    together(ui, page, kept, rect, 1.0, asked)
}

/// The stage before a class, lines and letters `scale` times as large as usual.
pub(super) fn stage(
    ui: &mut Ui,
    page: Page<'_>,
    kept: &mut Kept,
    rect: Rect,
    signs: bool,
    scale: f32,
    asked: &mut Vec<Asked>,
) -> Option<Place> {
    let single = page.state.beside == Beside::Nothing || page.state.heat().is_some();
    match single || page.state.playback().is_none() {
        true => alone(ui, page, kept, rect, signs, scale, asked),
        false => together(ui, page, kept, rect, scale, asked),
    }
}

/// The walk and what stands beside it, each below its name.
fn together(
    ui: &mut Ui,
    page: Page<'_>,
    kept: &mut Kept,
    rect: Rect,
    scale: f32,
    asked: &mut Vec<Asked>,
) -> Option<Place> {
    let high = STRIP * scale;
    if matches!(page.state.beside, Beside::Abreast(_)) {
        let picture = if page.state.present {
            rect
        } else {
            let (name, picture) = strip(rect, high);
            rival::choice(ui, page, name, asked);
            picture
        };
        match page.beside {
            Some(walks) => abreast::show(ui, page, kept, walks, picture, scale),
            None => waiting(ui, page, picture),
        }
        return None;
    }
    let low = foot(page.state) * scale;
    let (left, right) = halves(page.state, rect, high + low);
    let (name, picture) = strip(left, high);
    let (picture, said) = picture.split_top_bottom_at_y(picture.bottom() - low);
    let mut under = None;
    if let Some(playback) = page.state.playback() {
        let mut own = name;
        if !page.state.present && rival::narrow(right) {
            own.max.x = rival::pace_apart(ui, page, name, asked);
        }
        label(ui, page, own, kind_name(playback.rule.kind()), scale);
        under = alone(ui, page, kept, picture, false, scale, asked);
        let so_far = kept.pictures.as_ref().and_then(|pictures| playback.cost_at(&pictures.instant));
        bill(ui, page, said, playback, so_far, scale);
    }
    let (name, picture) = strip(right, high);
    let (picture, said) = picture.split_top_bottom_at_y(picture.bottom() - low);
    if page.state.present {
        // A class chooses nothing.
        label(ui, page, name, rival::title(page.state), scale);
    } else {
        rival::choice(ui, page, name, asked);
    }
    match page.beside {
        Some(beside) => under = second(ui, page, kept, picture, said, beside, scale).or(under),
        None => waiting(ui, page, picture),
    }
    if right.left() > rect.left() {
        ui.painter().vline(right.left(), rect.y_range(), line(page.theme, Role::Panel));
    } else {
        ui.painter().hline(rect.x_range(), right.top(), line(page.theme, Role::Panel));
    }
    under
}

/// Two pictures side by side, or one over the other where that makes them larger.
fn halves(state: &State, rect: Rect, beside: f32) -> (Rect, Rect) {
    let extent = state.playback().map_or(glam::Vec3::ONE, |playback| playback.play.structure.bounds().extent());
    // In space it depends on the camera how wide a scene looks: about as wide as high.
    let flat = state.playback().is_some_and(|playback| playback.play.scene.flat);
    let shape = if flat { vec2(extent.x, extent.y) } else { vec2(1.0, 1.0) };
    let fits = |width: f32, height: f32| (width / shape.x.max(1e-9)).min((height - beside) / shape.y.max(1e-9));
    if fits(rect.width() * 0.5, rect.height()) >= fits(rect.width(), rect.height() * 0.5) {
        rect.split_left_right_at_fraction(0.5)
    } else {
        rect.split_top_bottom_at_fraction(0.5)
    }
}

/// What the stage stands on: in the study a pane, before a class the page itself.
fn ground(state: &State) -> Role {
    if state.present { Role::Page } else { Role::Panel }
}

/// Most primitives that are tried one by one to find the one under the pointer.
const TRIED: usize = 20_000;

/// The smallest letters of a board before a class, where others have their usual size.
const LEAST: f32 = 9.5;

/// On a large screen at home letters are such a part of a picture's height.
const LARGE: f32 = 66.0;

/// How a picture is set that fills the middle of the page, `scale` times as large as usual.
pub(super) fn look_of_picture(present: bool, height: f32, scale: f32) -> Look {
    let look = Look::WINDOW;
    // Before a class nothing is smaller than can be read from the last row.
    match present {
        true => Look { text: look.text * scale, least: LEAST * scale, ..look },
        false => Look { text: (look.text * scale).max(height / LARGE), ..look },
    }
}

/// The height of the names over two pictures.
const STRIP: f32 = 38.0;

/// The height of the room under two pictures for what their walks have cost: the verdict on a mistake has two lines
/// of its own over it.
fn foot(state: &State) -> f32 {
    if matches!(state.beside, Beside::Mistake(_)) { 70.0 } else { 30.0 }
}

/// A strip at the top of a picture for its name.
fn strip(rect: Rect, height: f32) -> (Rect, Rect) {
    (
        Rect::from_min_size(rect.min, vec2(rect.width(), height)),
        Rect::from_min_max(rect.min + vec2(0.0, height), rect.max),
    )
}

/// A name over a picture, set smaller where it is long.
fn label(ui: &Ui, page: Page<'_>, rect: Rect, text: &str, scale: f32) {
    let (indent, size) = (14.0 * scale, 13.5 * scale);
    let room = rect.width() - 2.0 * indent;
    let size = size * (room / raystep_figure::text_width(text, Face::Bold, size).max(1.0)).min(1.0);
    let at = pos2(rect.left() + indent, rect.center().y);
    caption(ui.painter(), at, Align2::LEFT_CENTER, text, Face::Bold, size, Role::Text, page.theme);
}

/// The picture of the walk, with the legend under it; lines and letters `scale` times as large as usual.
fn alone(
    ui: &mut Ui,
    page: Page<'_>,
    kept: &mut Kept,
    rect: Rect,
    signs: bool,
    scale: f32,
    asked: &mut Vec<Asked>,
) -> Option<Place> {
    if let Some(of) = page.state.heat() {
        heat::show(ui, page, kept, rect, of, scale, asked);
        return None;
    }
    let Kept { pictures, sight, tree, moving, .. } = kept;
    let Some(pictures) = pictures.as_mut().filter(|_| page.state.playback().is_some()) else {
        waiting(ui, page, rect);
        return None;
    };
    let look = Look::WINDOW;
    // A kind that draws the middle of the page itself needs no stage.
    let Some(space) = pictures.space.clone().filter(|_| !pictures.has(Pane::Picture)) else {
        let look = look_of_picture(page.state.present, rect.height(), scale);
        return figure::figure(ui, page, kept, Pane::Picture, rect, &look, asked);
    };
    let space = &*space;
    // The same room at every step: the picture stands still.
    let legend = if signs { Still::legend_room(rect.width() - 28.0, &look) } else { 0.0 };
    let legend = if rect.height() > 260.0 { legend } else { 0.0 };
    // What says how many boxes are drawn lies under the picture, never over it.
    let strip = if signs && !page.state.present { levels::room(&pictures.playback, rect.width()) } else { 0.0 };
    let picture = Rect::from_min_max(rect.min, rect.max - vec2(0.0, legend + strip));
    let camera = sight.camera(page.state, space, glam_size(picture));
    let solid = !space.flat && sight.solid.is_there();
    // Labels make room for the small picture in the corner.
    let inset = if solid { inset::of(sight, pictures, picture, &camera) } else { None };
    let kept = inset.as_ref().map(|inset| {
        let from = inset.rect.translate(-picture.min.to_vec2());
        [from.min, from.max].map(|at| glam::Vec2::new(at.x, at.y) / scale)
    });
    let figure = Arc::new(pictures.stage(kept, space, &camera, glam_size(picture) / scale, solid).scaled(scale));
    let moved = (!solid).then(|| moving.figure(ui, Frame::Space, picture, &figure).figure);
    if solid {
        let (prims, ground) = (&pictures.playback.play.scene.prims, ground(page.state));
        let (theme, lit) = (page.theme, pictures.lit(page.lit));
        sight.solid.show(ui, picture, space, prims, page.mesh, &camera, theme, ground, &lit);
    }
    let happened = Picture {
        space,
        figure: &figure,
        camera,
        ray: pictures.playback.play.tape.ray(),
        theme: page.theme,
        hovered: page.lit,
        live: true,
        body: pictures.grip(),
        scene: page.state.holdable(),
        planes: page.state.holds_planes(),
        moving: moved,
        painted: solid,
        surface: &|ray| surface(&pictures.playback, ray),
    }
    .show(ui, picture, "Space", &mut sight.hold);
    if strip > 0.0 {
        let at = Rect::from_min_max(picture.left_bottom(), rect.max - vec2(12.0, legend));
        levels::show(ui, page, pictures, at, asked);
    }
    if solid {
        paint_figure(&ui.painter_at(picture), picture.min, &axes(&camera, glam_size(picture)), page.theme, None);
    }
    if let Some(inset) = &inset {
        inset::show(ui, page, sight, pictures, inset);
    }
    if legend > 0.0 {
        let at = Rect::from_min_max(pos2(rect.left() + 14.0, rect.bottom() - legend), rect.max);
        let drawn = pictures.pane(Pane::Legend, glam_size(at), &look, None, tree, None);
        paint_figure(&ui.painter_at(at), at.min, &drawn, page.theme, None);
    }
    sight.size = glam_size(picture);
    take(page.state, sight, &happened, camera, asked);
    happened.hovered
}

/// Another walk of the same ray, at the same step; what it has cost is `said` under it.
fn second(
    ui: &mut Ui,
    page: Page<'_>,
    kept: &mut Kept,
    rect: Rect,
    said: Rect,
    beside: &Arc<Playback>,
    scale: f32,
) -> Option<Place> {
    let sight = &mut kept.sight;
    let shown = Drawn::of(sight.beside.take(), beside, page.state.beside_step(beside), page.state.depth());
    let space = &shown.space;
    let camera = sight.camera(page.state, space, glam_size(rect));
    let solid = !space.flat && sight.solid_beside.is_there();
    let mut figure = drawn(None, space, beside, &camera, glam_size(rect) / scale, solid).scaled(scale);
    if verdict(page.state, beside).is_some_and(|(_, role)| role == Role::Wrong) {
        // A hit that is not the answer does not look like one.
        for mark in figure.marks.iter_mut().filter(|mark| matches!(mark.role, Role::Hit | Role::Best)) {
            mark.role = Role::Wrong;
        }
    }
    if solid {
        let (prims, ground) = (&beside.play.scene.prims, ground(page.state));
        let lit = shown.lit(page.lit);
        sight.solid_beside.show(ui, rect, space, prims, page.mesh, &camera, page.theme, ground, &lit);
    }
    let picture = Picture {
        space,
        figure: &figure,
        camera,
        ray: beside.play.tape.ray(),
        theme: page.theme,
        hovered: page.lit,
        live: false,
        body: None,
        scene: None,
        planes: false,
        moving: None,
        painted: solid,
        surface: &|ray| surface(beside, ray),
    };
    let mut none = None;
    let happened = picture.show(ui, rect, "Space, beside", &mut none);
    bill(ui, page, said, beside, shown.cost, scale);
    sight.beside = Some(shown);
    happened.hovered
}

/// The primitive that a ray from the eye meets first. Brute force over very many would take too long for a frame.
fn surface(playback: &Playback, ray: &Ray) -> Option<Place> {
    let (structure, prims) = (&*playback.play.structure, &playback.play.scene.prims);
    let slow = matches!(structure, Structure::List(_) | Structure::Slab(_));
    if slow && raystep_accel::Primitives::len(prims) > TRIED {
        return None;
    }
    structure.intersect(prims, ray, &mut ()).map(|hit| Place::Prim(hit.prim))
}

/// Turns what happened in the picture into what is asked for.
fn take(state: &State, sight: &mut Sight, happened: &Happened, camera: Camera, asked: &mut Vec<Asked>) {
    // The wheel has no beginning: its first turn away from the slide's own view can be undone.
    let wheeled = happened.camera.is_some() && sight.hold.is_none() && state.view.camera.is_none();
    if happened.begins || wheeled {
        asked.push(Asked::Keep);
    }
    if happened.begins {
        // The picture stands still under what is dragged.
        let turns = matches!(sight.hold, None | Some(Hold::Turn | Hold::Shift));
        sight.still = (!turns).then_some(camera);
    }
    let aspect = sight.size.x / sight.size.y.max(1.0);
    let around = state.playback().map_or(Aabb::EMPTY, |playback| playback.play.structure.bounds());
    let turned = happened.camera.map(|wanted| eye::bounded(&camera, wanted, &around));
    asked.extend(turned.map(|camera| Asked::Turn(Seen { camera, aspect })));
    asked.extend(happened.ray.map(Asked::Ray));
    asked.extend(happened.body.map(|(grip, to)| Asked::Body(grip, to)));
    let moved = happened.moved.clone().map(Asked::Move);
    asked.extend(moved.into_iter().chain(happened.cut.map(Asked::Cut)));
    asked.extend(happened.clicked.map(Asked::Pick));
}

/// Nothing to show yet.
fn waiting(ui: &Ui, page: Page<'_>, rect: Rect) {
    let says = if page.making { "Building …" } else { "Nothing to show" };
    caption(ui.painter(), rect.center(), Align2::CENTER_CENTER, says, Face::Regular, 15.0, Role::Quiet, page.theme);
}
