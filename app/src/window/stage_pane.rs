//! The stage: one picture of space, or two beside each other.

use std::sync::Arc;

use egui::{Align2, Rect, Ui, pos2, vec2};
use raystep_accel::{Cost, Place};
use raystep_figure::{Camera, Face, Figure, Look, Role, Space};

use super::app::App;
use super::beside::Drawn;
use super::columns::{self, strip};
use super::eye;
use super::outline::scaled;
use super::painter::{caption, paint_figure};
use super::pictures::Pane;
use super::playback::Playback;
use super::rival;
use super::space_pane::{Happened, Hold, Picture, glam_size};
use super::state::Beside;
use super::view::RayChoice;
use crate::export::camera::Seen;

/// Shows the stage in all the room there is; says which place the pointer is on.
pub(super) fn stages(app: &mut App, ui: &mut Ui) -> Option<Place> {
    let rect = ui.available_rect_before_wrap();
    if app.state.beside == Beside::Nothing {
        return stage(app, ui, rect, true, 1.0);
    }
    let half = (rect.width() * 0.5).floor();
    let left = Rect::from_min_size(rect.min, vec2(half, rect.height()));
    let right = Rect::from_min_max(rect.min + vec2(half, 0.0), rect.max);
    let (name, picture) = strip(left, STRIP);
    let mut under = None;
    if let Some(playback) = app.state.playback().cloned() {
        label(app, ui, name, super::top::kind_name(playback.rule.kind()));
        under = stage(app, ui, picture, false, 1.0);
        let so_far = app.pictures.as_ref().and_then(|pictures| playback.cost_at(&pictures.instant));
        bill(app, ui, picture, &playback, so_far);
    }
    let (name, picture) = strip(right, STRIP);
    rival::choice(app, ui, name);
    match app.second.shown().cloned() {
        Some(beside) => under = second(app, ui, picture, &beside).or(under),
        None => waiting(app, ui, picture),
    }
    ui.painter().vline(right.left(), rect.y_range(), super::visuals::line(app.theme, Role::Panel));
    under
}

/// What the stage stands on: in the study a pane, before a class the page itself.
fn ground(app: &App) -> Role {
    if app.state.present { Role::Page } else { Role::Panel }
}

/// The height of the names over two pictures.
const STRIP: f32 = 38.0;

fn label(app: &App, ui: &Ui, rect: Rect, text: &str) {
    let at = pos2(rect.left() + 14.0, rect.center().y);
    caption(ui.painter(), at, Align2::LEFT_CENTER, text, Face::Bold, 13.5, Role::Text, app.theme);
}

/// The picture of the walk, with the legend under it; lines and letters `scale` times as large as usual.
pub(super) fn stage(app: &mut App, ui: &mut Ui, rect: Rect, signs: bool, scale: f32) -> Option<Place> {
    let pictures = app.pictures.take();
    let Some(mut pictures) = pictures.filter(|_| app.state.playback().is_some()) else {
        waiting(app, ui, rect);
        return None;
    };
    let look = Look::WINDOW;
    let Some(space) = pictures.space.clone() else {
        app.pictures = Some(pictures);
        return columns::figure(app, ui, Pane::Picture, rect, &look);
    };
    let legend = if signs { pictures.legend_height(rect.width() - 28.0, &look) + 8.0 } else { 0.0 };
    let legend = if rect.height() > 260.0 { legend } else { 0.0 };
    let picture = Rect::from_min_max(rect.min, rect.max - vec2(0.0, legend));
    let camera = camera(app, &space, picture);
    let solid = !space.flat && app.solid.is_there();
    let figure = scaled(pictures.stage(&space, &camera, glam_size(picture) / scale, solid), scale);
    if solid {
        let (prims, mesh) = (&pictures.playback.play.scene.prims, pictures.playback.mesh.as_ref());
        app.solid.show(ui, picture, &space, prims, mesh, &camera, app.theme, ground(app), app.lit());
    }
    let name = "Space";
    let lit = app.lit();
    let happened = Picture {
        space: &space,
        figure: &figure,
        camera,
        ray: pictures.playback.play.tape.ray(),
        theme: app.theme,
        hovered: lit,
        live: true,
        painted: solid,
    }
    .show(ui, picture, name, &mut app.hold);
    if legend > 0.0 {
        let at = Rect::from_min_max(pos2(rect.left() + 14.0, picture.bottom()), rect.max);
        let drawn = pictures.pane(Pane::Legend, glam_size(at), &look, None, &app.tree, None);
        paint_figure(&ui.painter_at(at), at.min, drawn, app.theme, None);
    }
    app.pictures = Some(pictures);
    app.space_size = glam_size(picture);
    take(app, &happened, camera, picture)
}

/// Another walk of the same ray, at the same step.
fn second(app: &mut App, ui: &mut Ui, rect: Rect, beside: &Arc<Playback>) -> Option<Place> {
    let step = app.beside_step(beside);
    let Drawn { space: shown, cost, .. } = app.second.at(beside, step);
    let camera = camera(app, &shown, rect);
    let solid = !shown.flat && app.solid_beside.is_there();
    let figure: Figure = super::pictures::drawn(&shown, beside, &camera, glam_size(rect), solid);
    let ray = beside.play.tape.ray();
    let lit = app.lit();
    if solid {
        let (prims, mesh) = (&beside.play.scene.prims, beside.mesh.as_ref());
        app.solid_beside.show(ui, rect, &shown, prims, mesh, &camera, app.theme, ground(app), lit);
    }
    let picture = Picture {
        space: &shown,
        figure: &figure,
        camera,
        ray,
        theme: app.theme,
        hovered: lit,
        live: false,
        painted: solid,
    };
    let mut none = None;
    let happened = picture.show(ui, rect, "Space, beside", &mut none);
    bill(app, ui, rect, beside, cost);
    happened.hovered
}

/// What a walk has cost so far, at the foot of its picture.
fn bill(app: &App, ui: &Ui, rect: Rect, playback: &Playback, cost: Option<Cost>) {
    let Some(cost) = cost else { return };
    let all = raystep_accel::Primitives::len(&playback.play.scene.prims);
    let structure = &*playback.play.structure;
    let (tests, of) = raystep_figure::tested(structure, all, &cost);
    let mut says = format!("{tests} of {of} tested");
    match (cost.node_visits, cost.cell_steps) {
        (0, 0) => {}
        (0, cells) => says.push_str(&format!(" · {cells} {}", if cells == 1 { "cell" } else { "cells" })),
        (nodes, _) => says.push_str(&format!(" · {nodes} {}", if nodes == 1 { "node" } else { "nodes" })),
    }
    if structure.node_count() > 0 || structure.grid().is_some() {
        says.push_str(&format!(" · built in {} ms", raystep_figure::number(playback.seconds * 1000.0)));
    }
    let at = rect.left_bottom() + vec2(14.0, -16.0);
    caption(ui.painter(), at, Align2::LEFT_CENTER, &says, Face::Regular, 12.5, Role::Quiet, app.theme);
}

/// Where the stage is seen from now.
pub(super) fn camera(app: &App, space: &Space, rect: Rect) -> Camera {
    if let Some(camera) = app.still.filter(|_| app.hold.is_some()) {
        return camera;
    }
    // What somebody has set stays in the picture when that becomes narrower.
    if let Some(camera) = app.state.view.camera {
        return Seen { camera, aspect: app.aspect }.all_in(glam_size(rect));
    }
    let look = app.state.stage().and_then(|stage| stage.camera.as_ref()).filter(|_| !app.state.view.is_elsewhere());
    let scene = app.state.playback().map(|playback| &playback.play.scene);
    match scene {
        Some(scene) => eye::home(look, scene, &space.bounds, glam_size(rect)),
        None => eye::fitted(&space.bounds, glam_size(rect)),
    }
}

/// Width over height.
fn aspect(rect: Rect) -> f32 {
    rect.width() / rect.height().max(1.0)
}

/// Turns what happened in the picture into changes.
fn take(app: &mut App, happened: &Happened, camera: Camera, picture: Rect) -> Option<Place> {
    // The wheel has no beginning: its first turn away from the slide's own view can be undone.
    let wheeled = happened.camera.is_some() && app.hold.is_none() && app.state.view.camera.is_none();
    if happened.begins || wheeled {
        app.state.keep();
    }
    if happened.begins {
        // The picture stands still under a ray that is dragged.
        let ray = matches!(app.hold, Some(Hold::Origin | Hold::Head | Hold::New(_)));
        app.still = ray.then_some(camera);
    }
    if let Some(camera) = happened.camera {
        app.aspect = aspect(picture);
        app.state.turn(camera);
    }
    if let Some(ray) = happened.ray {
        app.state.show_ray(RayChoice::Own(ray), true);
    }
    if let Some(place) = happened.clicked {
        app.pick(place);
    }
    happened.hovered
}

/// Nothing to show yet.
fn waiting(app: &App, ui: &Ui, rect: Rect) {
    let says = if app.workshop.task().is_some() { "Building …" } else { "Nothing to show" };
    caption(ui.painter(), rect.center(), Align2::CENTER_CENTER, says, Face::Regular, 15.0, Role::Quiet, app.theme);
}

impl App {
    /// Moves the camera to where the walk stands.
    pub(super) fn frame_here(&mut self) {
        let Some(pictures) = &self.pictures else { return };
        let Some(space) = &pictures.space else { return };
        let reel = pictures.playback.reel();
        let still = reel.still(&pictures.instant);
        let bounds = still.here().map_or(space.bounds, |place| still.bounds(place));
        if bounds.is_empty() {
            return;
        }
        let rect = Rect::from_min_size(pos2(0.0, 0.0), vec2(800.0, 600.0));
        let camera = eye::framed(&camera(self, space, rect), &bounds, glam_size(rect));
        self.aspect = aspect(rect);
        self.state.look(Some(camera));
    }
}
