//! The picture of space: drawn, hovered, clicked, turned, and its ray dragged.

use std::sync::Arc;

use egui::{PointerButton, Pos2, Rect, Response, Sense, Ui};
use glam::Vec3;
use raystep_accel::{Axis, HandCut, Place, Ray};
use raystep_figure::{Camera, Figure, Form, Grip, Role, Space, Theme, pointed_at};
use raystep_scene::Scene;

use super::hold::{Hold, Moved};
use super::knob::ring;
use crate::shown::eye;
use crate::window::look::painter::{line_at, paint_figure, paint_labels, place_at};

/// How near to its border a pane leaves the pointer to the border.
pub(super) const BORDER: f32 = 5.0;

/// What happened in the picture.
#[derive(Default)]
pub(crate) struct Happened {
    /// The place under the pointer.
    pub(crate) hovered: Option<Place>,
    /// The place clicked on; a click beside everything is `Some(None)`.
    pub(crate) clicked: Option<Option<Place>>,
    /// A change that undo shall take back in one begins.
    pub(crate) begins: bool,
    /// Another ray.
    pub(crate) ray: Option<Ray>,
    /// A part of a shape, moved.
    pub(crate) moved: Option<Moved>,
    /// A node that is cut elsewhere.
    pub(crate) cut: Option<HandCut>,
    /// The object of a pair, moved so far from where its arrangement has it.
    pub(crate) body: Option<(Grip, Vec3)>,
    /// Another camera.
    pub(crate) camera: Option<Camera>,
}

/// What is drawn.
pub(crate) struct Picture<'a> {
    pub(crate) space: &'a Space,
    pub(crate) figure: &'a Figure,
    pub(crate) camera: Camera,
    /// The ray; none where a build is played.
    pub(crate) ray: Option<Ray>,
    pub(crate) theme: &'a Theme,
    pub(crate) hovered: Option<Place>,
    /// Whether the ray can be dragged, if there is one.
    pub(crate) live: bool,
    /// Where the object of a pair can be taken in the hand.
    pub(crate) body: Option<Grip>,
    /// The scene whose shapes can be taken in the hand.
    pub(crate) scene: Option<&'a Arc<Scene>>,
    /// Whether planes can be, too.
    pub(crate) planes: bool,
    /// What is drawn instead while it moves.
    pub(crate) moving: Option<Arc<Figure>>,
    /// Whether all but the labels is painted already.
    pub(crate) painted: bool,
    /// The place whose surface a ray from the eye meets.
    pub(crate) surface: &'a dyn Fn(&Ray) -> Option<Place>,
}

impl Picture<'_> {
    /// Draws the picture in `rect` and says what happened there.
    pub(crate) fn show(&self, ui: &mut Ui, rect: Rect, name: &str, hold: &mut Option<Hold>) -> Happened {
        let response = ui.allocate_rect(rect, Sense::hover());
        let response = ui.interact(rect.shrink(BORDER), response.id.with("picture"), Sense::click_and_drag());
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, name));
        let painter = ui.painter_at(rect);
        if self.painted {
            paint_labels(&painter, rect.min, self.figure, self.theme, self.hovered);
        } else {
            let figure = self.moving.as_deref().unwrap_or(self.figure);
            paint_figure(&painter, rect.min, figure, self.theme, self.hovered);
        }
        let mut happened = Happened::default();
        let pointer = response.hover_pos().or(response.interact_pointer_pos());
        let grip = pointer.filter(|_| self.live).and_then(|pointer| self.grip(rect, pointer));
        if response.hovered() || response.dragged() {
            ui.ctx().set_cursor_icon(Hold::cursor(hold.as_ref(), grip.as_ref()));
            if let Some(at) = hold.is_none().then(|| self.knob(rect, grip.as_ref()?)).flatten() {
                ring(ui, at, self.theme, Role::Here);
            }
        }
        if response.hovered() {
            happened.hovered = pointer.and_then(|pointer| self.place(rect, pointer));
            if let (Some(pointer), Some(place)) = (pointer, happened.hovered.filter(|place| *place != Place::World)) {
                let at = pointer - rect.min;
                let name = pointed_at(place, glam::Vec2::new(at.x, at.y), glam_size(rect));
                paint_figure(&painter, rect.min, &name, self.theme, None);
            }
        }
        if response.clicked() {
            let at = response.interact_pointer_pos();
            happened.clicked = Some(at.and_then(|at| self.place(rect, at)));
        }
        self.drag(ui, &response, rect, hold, &mut happened);
        self.wheel(ui, &response, rect, &mut happened);
        if self.live {
            self.keys(ui, &response, rect, &mut happened);
        }
        happened
    }

    /// The place under the pointer: in a flat scene that of the smallest mark there, in a solid one that of the nearest
    /// line, ring or label, else the primitive whose surface is seen there. Planes and boxes are seen through.
    fn place(&self, rect: Rect, pointer: Pos2) -> Option<Place> {
        if self.space.flat {
            return place_at(self.figure, rect.min, pointer);
        }
        line_at(self.figure, rect.min, pointer).or_else(|| {
            let at = pointer - rect.min;
            let ray = self.camera.ray(glam::Vec2::new(at.x, at.y), glam_size(rect)).ok()?;
            (self.surface)(&ray)
        })
    }

    /// Taking hold, dragging and letting go.
    fn drag(&self, ui: &Ui, response: &Response, rect: Rect, hold: &mut Option<Hold>, happened: &mut Happened) {
        let size = glam_size(rect);
        if response.drag_started() {
            let press = ui.input(|input| input.pointer.press_origin());
            let shift = ui.input(|input| input.modifiers.shift);
            let first = response.drag_started_by(PointerButton::Primary);
            let grip = press.filter(|_| self.live && first).and_then(|press| self.grip(rect, press));
            *hold = Some(match (first, shift, grip, press) {
                (true, true, _, Some(press)) if self.live && self.ray.is_some() => {
                    Hold::New(self.world(rect, press, self.target()))
                }
                (true, _, Some(grip), _) => grip,
                (true, ..) => Hold::Turn,
                (false, ..) => Hold::Shift,
            });
            happened.begins = true;
        }
        if response.dragged()
            && let (Some(holding), Some(pointer)) = (hold.as_ref(), response.interact_pointer_pos())
        {
            let moved = response.drag_delta();
            let moved = glam::Vec2::new(moved.x, moved.y);
            match holding {
                Hold::Turn => happened.camera = Some(eye::turned(&self.camera, moved, size)),
                Hold::Shift => happened.camera = Some(eye::shifted(&self.camera, moved, size)),
                Hold::Origin => {
                    let ends = self.ends();
                    happened.ray = ends.and_then(|(origin, head)| self.drawn(self.world(rect, pointer, origin), head));
                }
                Hold::Head => {
                    let ends = self.ends();
                    happened.ray = ends.and_then(|(origin, head)| self.drawn(origin, self.world(rect, pointer, head)));
                }
                Hold::Body => {
                    let to = self.body.map(|body| (body, self.world(rect, pointer, body.at) - body.at + body.moved));
                    happened.body = to;
                }
                Hold::New(from) => happened.ray = self.drawn(*from, self.world(rect, pointer, *from)),
                Hold::Part(grasp) => {
                    happened.moved = Some(Moved { grasp: grasp.clone(), to: self.plane_point(rect, pointer) });
                }
                Hold::Plane(node, axis) => {
                    let at = self.plane_point(rect, pointer);
                    happened.cut = self.cut_at(*node, *axis, if *axis == Axis::Y { at.y } else { at.x });
                }
                Hold::Cut | Hold::Number(_) => {}
            }
        }
        if response.drag_stopped() {
            *hold = None;
        }
    }

    fn wheel(&self, ui: &Ui, response: &Response, rect: Rect, happened: &mut Happened) {
        let Some(pointer) = response.hover_pos() else { return };
        let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta.y, input.zoom_delta()));
        let factor = (scroll * 0.0025).exp() * pinch;
        if factor != 1.0 {
            let at = pointer - rect.min;
            happened.camera = Some(eye::nearer(&self.camera, factor, glam::Vec2::new(at.x, at.y), glam_size(rect)));
        }
    }

    /// Where the ray is seen to begin and to end.
    pub(super) fn ends(&self) -> Option<(Vec3, Vec3)> {
        let ray = self.ray?;
        let arrow = self.space.marks.iter().find_map(|mark| match mark.form {
            Form::Arrow(_, tip) if matches!(mark.role, Role::Ray | Role::Live) => Some(tip),
            _ => None,
        });
        Some((ray.o, arrow.unwrap_or_else(|| ray.at(1.0))))
    }

    /// A ray through two points; in a flat scene it stays in the plane.
    fn drawn(&self, from: Vec3, to: Vec3) -> Option<Ray> {
        let flat = |at: Vec3| if self.space.flat { at.truncate().extend(0.0) } else { at };
        let (from, to) = (flat(from), flat(to));
        let (along, ray) = ((to - from).try_normalize()?, self.ray?);
        Ray::new(from, along).ok()?.within(ray.t_min, ray.t_max).ok()
    }

    pub(super) fn world(&self, rect: Rect, pointer: Pos2, through: Vec3) -> Vec3 {
        let at = pointer - rect.min;
        eye::on_plane(&self.camera, glam::Vec2::new(at.x, at.y), glam_size(rect), through)
    }

    fn target(&self) -> Vec3 {
        match self.camera {
            Camera::Flat { center, .. } => center.extend(0.0),
            Camera::Solid { target, .. } => target,
        }
    }
}

/// The size of a rectangle in the figures' own type.
pub(crate) fn glam_size(rect: Rect) -> glam::Vec2 {
    glam::Vec2::new(rect.width(), rect.height())
}
