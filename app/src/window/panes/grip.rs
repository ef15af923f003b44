//! What in the picture of space can be taken, by the pointer and by keyboard.

use egui::{Key, Pos2, Rect, Response, Ui};
use glam::{Vec2, Vec3};
use raystep_accel::{Aabb, Axis, HandCut, NodeId, Place, PrimId, Primitives, Shape};
use raystep_figure::{Camera, Form, Role};
use raystep_scene::{Part, Scene};

use super::hold::{Grasp, Hold, Moved};
use super::knob::{GRIP, arrows, knob};
use super::space::{Happened, Picture, glam_size};

/// How near to a corner, a rim, a side or a plane the pointer must be, in points.
const NEAR: f32 = 7.0;

/// By so many points of the page an arrow moves an object of a pair finely; usually by ten times as many.
const BODY_STEP: f32 = 1.0;

/// The most parts of a scene that can have the focus, one after the other.
const FOCUSED: usize = 80;

impl Picture<'_> {
    /// The end of the ray under the pointer.
    fn ray_end(&self, rect: Rect, pointer: Pos2) -> Option<Hold> {
        let (origin, head) = self.ends()?;
        let near = |world: Vec3| {
            let (page, _) = self.camera.project(world, glam_size(rect))?;
            Some((rect.min + egui::vec2(page.x, page.y)).distance(pointer) <= GRIP)
        };
        if near(origin) == Some(true) {
            return Some(Hold::Origin);
        }
        (near(head) == Some(true)).then_some(Hold::Head)
    }

    /// The object of a pair, if it is taken under the pointer.
    fn body_under(&self, rect: Rect, pointer: Pos2) -> Option<Hold> {
        let (page, _) = self.camera.project(self.body?.at, glam_size(rect))?;
        ((rect.min + egui::vec2(page.x, page.y)).distance(pointer) <= GRIP).then_some(Hold::Body)
    }

    /// The same by keyboard: to the left and right, up and down as the camera sees it.
    fn body_keys(&self, ui: &Ui, response: &Response, rect: Rect, happened: &mut Happened) {
        let Some(body) = self.body else { return };
        let Some((page, _)) = self.camera.project(body.at, glam_size(rect)) else { return };
        let place = rect.min + egui::vec2(page.x, page.y);
        let id = response.id.with("body");
        let name = format!("The {} that can be moved", body.name);
        let Some((by, first)) = self.knocked(ui, id, place, &name, BODY_STEP) else { return };
        happened.begins |= first;
        let to = self.world(rect, place + egui::vec2(by.x, -by.y), body.at);
        happened.body = Some((body, to - body.at + body.moved));
    }

    /// What can be taken under the pointer: an end of the ray, a plane, a part of a shape.
    pub(super) fn grip(&self, rect: Rect, pointer: Pos2) -> Option<Hold> {
        self.ray_end(rect, pointer).or_else(|| self.body_under(rect, pointer)).or_else(|| {
            let (scene, from) = (self.scene?, self.plane_point(rect, pointer));
            let near = NEAR * self.units(rect);
            // A corner or a side is smaller than a plane, and a plane than a shape.
            let part = scene.part_at(from, near);
            let of_shape = |(prim, part)| Hold::Part(Grasp { prim, part, from, scene: scene.clone() });
            match part {
                Some((_, Part::Whole)) | None => {
                    let plane = self.sheets().find(|(_, axis, sheet)| is_near(sheet, *axis, from, near));
                    plane.map(|(node, axis, _)| Hold::Plane(node, axis)).or(part.map(of_shape))
                }
                Some(edge) => Some(of_shape(edge)),
            }
        })
    }

    /// Where a small thing that can be taken lies on the page: all but whole shapes and planes.
    pub(super) fn knob(&self, rect: Rect, grip: &Hold) -> Option<Pos2> {
        let Hold::Part(Grasp { prim, part, from, scene }) = grip else { return None };
        let at = match part {
            Part::Corner(_) => scene.parts().into_iter().find(|(p, q, _)| (p, q) == (prim, part)).map(|part| part.2)?,
            Part::Rim | Part::Side(_) => *from,
            Part::Whole => return None,
        };
        self.on_page(rect, at)
    }

    /// The planes that can be taken: the node, the axis, the part of the plane in the node.
    fn sheets(&self) -> impl Iterator<Item = (NodeId, Axis, Aabb)> + '_ {
        let marks = self.space.marks.iter().filter(|mark| self.planes && mark.role == Role::Plane);
        marks.filter_map(|mark| match (&mark.form, mark.place) {
            (Form::Sheet(sheet), Some(Place::Node(node))) => {
                let extent = sheet.extent();
                let axis = if extent.x == 0.0 { Axis::X } else { Axis::Y };
                (extent.x == 0.0 || extent.y == 0.0).then_some((node, axis, *sheet))
            }
            _ => None,
        })
    }

    /// The cut of a node at a coordinate, on the scene's grid.
    pub(super) fn cut_at(&self, node: NodeId, axis: Axis, value: f32) -> Option<HandCut> {
        let at = self.scene?.on_grid(value);
        let bounds = self.space.bounds;
        (bounds.min[axis] < at && at < bounds.max[axis]).then_some(HandCut { node, axis, at })
    }

    /// The point of a flat scene under the pointer.
    pub(super) fn plane_point(&self, rect: Rect, pointer: Pos2) -> Vec2 {
        self.world(rect, pointer, Vec3::ZERO).truncate()
    }

    /// How long a point of the page is in a flat scene.
    fn units(&self, rect: Rect) -> f32 {
        match self.camera {
            Camera::Flat { half_height, .. } => 2.0 * half_height / rect.height().max(1.0),
            Camera::Solid { .. } => 0.0,
        }
    }

    fn on_page(&self, rect: Rect, at: Vec2) -> Option<Pos2> {
        let (page, _) = self.camera.project(at.extend(0.0), glam_size(rect))?;
        Some(rect.min + egui::vec2(page.x, page.y))
    }

    /// The same by keyboard: every part and plane can have the focus, and the arrows move it; with Shift finely.
    pub(super) fn keys(&self, ui: &Ui, response: &Response, rect: Rect, happened: &mut Happened) {
        self.body_keys(ui, response, rect, happened);
        let Some(scene) = self.scene else { return };
        let parts = scene.parts();
        if parts.len() > FOCUSED {
            return;
        }
        for (prim, part, at) in parts {
            let Some(place) = self.on_page(rect, at).filter(|place| rect.contains(*place)) else { continue };
            let name = part_name(scene, prim, part);
            let knob = response.id.with(("shape", prim.0, part));
            let Some((by, first)) = self.knocked(ui, knob, place, &name, scene.step()) else { continue };
            happened.begins |= first;
            let grasp = Grasp { prim, part, from: at, scene: scene.clone() };
            happened.moved = Some(Moved { grasp, to: at + by });
        }
        // A plane may be drawn in parts: the focus takes it as one.
        let mut sheets: Vec<_> = self.sheets().collect();
        sheets.sort_by_key(|(node, ..)| *node);
        sheets.dedup_by_key(|(node, ..)| *node);
        for (node, axis, sheet) in sheets {
            let middle = sheet.center().truncate();
            let Some(place) = self.on_page(rect, middle).filter(|place| rect.contains(*place)) else { continue };
            let (knob, name) = (response.id.with(("plane", node.0)), format!("Plane of node {node}, across {axis}"));
            let Some((by, first)) = self.knocked(ui, knob, place, &name, scene.step()) else { continue };
            let (from, by) = if axis == Axis::Y { (middle.y, by.y) } else { (middle.x, by.x) };
            happened.cut = self.cut_at(node, axis, from + by).filter(|_| by != 0.0);
            happened.begins |= first && happened.cut.is_some();
        }
    }

    /// By how much the arrows move what has the focus, and whether that is a change of its own.
    fn knocked(&self, ui: &Ui, id: egui::Id, place: Pos2, name: &str, step: f32) -> Option<(Vec2, bool)> {
        let knob = knob(ui, id, place, name, self.theme)?;
        let mut moved = None;
        for (key, first, fine) in arrows(ui, knob.id) {
            let by = if fine { step } else { step * 10.0 };
            let by = match key {
                Key::ArrowLeft => Vec2::new(-by, 0.0),
                Key::ArrowRight => Vec2::new(by, 0.0),
                Key::ArrowUp => Vec2::new(0.0, by),
                _ => Vec2::new(0.0, -by),
            };
            let (before, began) = moved.unwrap_or((Vec2::ZERO, false));
            moved = Some((before + by, began || first));
        }
        moved
    }
}

/// Whether a point lies at a plane.
fn is_near(sheet: &Aabb, axis: Axis, at: Vec2, near: f32) -> bool {
    let around = sheet.padded(near);
    let (across, along) = if axis == Axis::Y { (Axis::Y, Axis::X) } else { (Axis::X, Axis::Y) };
    let at = at.extend(0.0);
    (at[across] - sheet.min[across]).abs() <= near && around.min[along] <= at[along] && at[along] <= around.max[along]
}

/// What a part is called for whoever cannot see it.
fn part_name(scene: &Scene, prim: PrimId, part: Part) -> String {
    let shape = match scene.prims.shape(prim) {
        Shape::Sphere(_) => "Disc",
        Shape::Wall(_) => "Segment",
        Shape::Prism(prism) if prism.outline.len() == 3 => "Triangle",
        _ => "Polygon",
    };
    match part {
        Part::Whole => format!("{shape} {prim}"),
        Part::Corner(index) => format!("{shape} {prim}, corner {}", index + 1),
        Part::Side(index) => format!("{shape} {prim}, side {}", index + 1),
        Part::Rim => format!("{shape} {prim}, rim"),
    }
}
