//! The planes of the slabs that are cut, and where they meet the line of the ray.

use glam::Vec3;
use raystep_accel::{
    Aabb, AnyBvh, Axis, ConvexCell, Direction, FreePlane, Interval, NodeId, Outline, Place, PrimId, Ray, Structure,
    Visit,
};

use super::{Drawing, line};
use crate::moments::{SlabCut, SlabTest};
use crate::theme::Role;
use crate::words::number;
use crate::world::{Form, convex};

/// Half the thickness of a wall that lies on a plane, in parts of the picture's diagonal.
const WALL: f32 = 0.004;

/// A plane whose normal is so much more upright than level is no line of a flat scene.
const LEVEL: f32 = 0.05;

/// Corners so near to the plane of a face, in parts of the hull's size, are its own.
const NEAR: f32 = 1e-5;

impl Drawing<'_> {
    /// Whether the walk is one slab test and nothing else: then all of it stays in the picture.
    pub(super) fn is_one_test(&self) -> bool {
        matches!(self.walk.structure, Structure::Slab(_))
    }

    /// The planes of the slabs that were cut, each with its number, and what lies between the two under
    /// consideration. At the verdict on a single box the planes stay, and those that decide stand out.
    pub(super) fn slabs(&mut self) {
        if let Some(Visit::Clip { place, face, .. }) = self.moment.event {
            self.face(place, face);
        }
        let Some(slab) = self.moment.slab.as_ref() else { return };
        let over = matches!(self.moment.event, Some(Visit::Volume { .. }));
        if over && !self.is_one_test() {
            return;
        }
        let deciding = if over { self.deciding(slab) } else { Vec::new() };
        for cut in slab.cuts.iter().filter(|cut| !self.walk.leaves_out(cut.axis)) {
            let now = !over && cut.axis == slab.axis;
            if now {
                self.between(slab, cut);
            }
            let planes = if cut.low == cut.high { vec![cut.low] } else { vec![cut.low, cut.high] };
            for at in planes {
                let role = if now || deciding.contains(&(cut.axis, at)) { Role::Plane } else { Role::Edge };
                // In space, the planes of all slabs together would be a thicket.
                if self.walk.flat || role == Role::Plane {
                    self.plane(role, slab, cut, at);
                }
            }
        }
    }

    /// Of a flat scene all primitives where its box has no depth: they stand on the plane that was cut, which covers them.
    pub(super) fn wall(&mut self) {
        let (walk, bounds) = (self.walk, self.walk.world());
        let Some(axis) = [Axis::X, Axis::Y].into_iter().find(|axis| bounds.extent()[*axis] == 0.0) else { return };
        if !walk.flat || !self.is_one_test() {
            return;
        }
        let mut wall = bounds;
        wall.min[axis] -= WALL * self.bounds.extent().length();
        wall.max[axis] += WALL * self.bounds.extent().length();
        let place = Some(Place::Prim(PrimId(0)));
        self.add(Role::Scene, place, Form::Box(wall));
        self.add(Role::Scene, place, Form::Label { at: wall.center(), within: Some(wall), text: "wall".to_owned() });
    }

    /// The planes that set the two ends of what is left: the latest entry and the earliest exit, and those of a slab
    /// in which the ray never is.
    fn deciding(&self, slab: &SlabTest) -> Vec<(Direction, f32)> {
        let ray = self.walk.ray;
        let cuts: Vec<&SlabCut> = slab.cuts.iter().filter(|cut| !self.walk.leaves_out(cut.axis)).collect();
        let ends = |end: usize| cuts.iter().filter_map(move |cut| Some((*cut, cut.t?[end])));
        let entry = ends(0).max_by(|(_, a), (_, b)| a.total_cmp(b)).filter(|(_, t)| *t > ray.t_min);
        let exit = ends(1).min_by(|(_, a), (_, b)| a.total_cmp(b)).filter(|(_, t)| *t < ray.t_max);
        let crossed = entry.into_iter().chain(exit).filter_map(|(cut, t)| {
            let (axis, at) = (cut.axis.axis()?, ray.at(t));
            let low = (at[axis] - cut.low).abs() <= (at[axis] - cut.high).abs();
            Some((cut.axis, if low { cut.low } else { cut.high }))
        });
        let never = cuts.iter().filter(|cut| !cut.inside).flat_map(|cut| [cut.low, cut.high].map(|at| (cut.axis, at)));
        crossed.chain(never).collect()
    }

    /// In a flat scene, the part of the picture that lies in a slab.
    fn between(&mut self, slab: &SlabTest, cut: &SlabCut) {
        let (Some(axis), true) = (cut.axis.axis(), self.walk.flat) else { return };
        let mut between = self.room(slab);
        between.min[axis] = cut.low;
        between.max[axis] = cut.high;
        self.add(Role::Ground, Some(slab.place), Form::Box(between));
    }

    /// A plane of a slab, with its number.
    fn plane(&mut self, role: Role, slab: &SlabTest, cut: &SlabCut, at: f32) {
        let both = if cut.low == cut.high { ", both" } else { "" };
        let text = format!("{} = {}{both}", cut.axis, number(at));
        let place = Some(slab.place);
        if let Some(axis) = cut.axis.axis() {
            let mut sheet = self.reach(slab, cut);
            sheet.min[axis] = at;
            sheet.max[axis] = at;
            self.add(role, place, Form::Sheet(sheet));
            self.add(role, place, Form::Label { at: sheet.center(), within: Some(sheet), text });
        } else if let (Place::Node(node), Structure::Bvh(tree)) = (slab.place, self.walk.structure)
            && let Some((normal, center)) = slanted(tree, node, cut.axis)
        {
            let at = at + normal.dot(center);
            let end = if self.walk.flat {
                self.line_of(role, slab.place, normal, at)
            } else {
                self.sheet_of(role, slab.place, &self.reach(slab, cut), FreePlane { normal, at })
            };
            if let Some(end) = end {
                self.note(role, place, end, text);
            }
        }
    }

    /// As much of space as the planes of a slab are drawn in, with where the ray crosses them.
    fn reach(&self, slab: &SlabTest, cut: &SlabCut) -> Aabb {
        let crossings = cut.t.into_iter().flatten().map(|t| self.walk.ray.at(t));
        let shown = crossings.filter(|at| !self.walk.flat && self.bounds.contains(*at));
        shown.fold(self.room(slab), Aabb::with_point)
    }

    /// In a solid scene, what of a plane that leans lies in a room. Returns its uppermost corner.
    fn sheet_of(&mut self, role: Role, place: Place, room: &Aabb, plane: FreePlane) -> Option<Vec3> {
        let Some(Form::Polygon(corners)) = convex::sheet(&ConvexCell::of(room), plane, false) else { return None };
        let upper = corners.iter().copied().max_by(|a, b| a.z.total_cmp(&b.z));
        self.add(role, Some(place), Form::Polygon(corners));
        upper
    }

    /// Where the ray, or the line that it lies on, meets what is cut.
    pub(super) fn cuts(&mut self) {
        match self.moment.event {
            Some(Visit::Roots { place, discriminant, t1, t2, .. }) if discriminant >= 0.0 => {
                self.ring(Role::Tick, Some(place), t1, Some(format!("t1 = {}", number(t1))));
                self.ring(Role::Tick, Some(place), t2, Some(format!("t2 = {}", number(t2))));
            }
            Some(Visit::Clip { place, t, .. }) => {
                self.ring(Role::Tick, Some(place), t, Some(format!("t = {}", number(t))));
            }
            Some(Visit::Volume { place, t_near, t_far, .. }) if t_near <= t_far || self.is_one_test() => {
                self.crossing(place, "t_near", t_near);
                self.crossing(place, "t_far", t_far);
            }
            Some(Visit::Volume { .. }) => {}
            _ => {
                let Some(slab) = self.moment.slab.as_ref() else { return };
                let now = |cut: &&SlabCut| cut.axis == slab.axis && !self.walk.leaves_out(cut.axis);
                let Some([t1, t2]) = slab.cuts.iter().find(now).and_then(|cut| cut.t) else { return };
                self.crossing(slab.place, "t1", t1);
                self.crossing(slab.place, "t2", t2);
            }
        }
    }

    /// A ring on the line of the ray; out of the picture, a word at its edge where the test is all there is.
    fn crossing(&mut self, place: Place, name: &str, t: f32) {
        let (at, text) = (self.walk.ray.at(t), format!("{name} = {}", number(t)));
        if !self.is_one_test() || self.bounds.contains(at) {
            self.ring(Role::Tick, Some(place), t, Some(text));
            return;
        }
        let line = line(self.walk, &self.bounds);
        if t.is_finite() && !line.is_empty() {
            let (end, where_to) = if t > line.far { (line.far, "further on") } else { (line.near, "further back") };
            self.note(Role::Tick, Some(place), self.walk.ray.at(end), format!("{text}, {where_to}"));
        }
    }

    /// A face of a hull; in a flat scene, the line of its plane.
    fn face(&mut self, place: Place, face: u32) {
        let (Place::Node(node), Structure::Bvh(bvh @ AnyBvh::Hull(tree))) = (place, self.walk.structure) else {
            return;
        };
        let hull = tree.volume(node);
        let Some(&(normal, offset)) = hull.planes.get(face as usize) else { return };
        let center = hull.bounds.center();
        if self.walk.flat {
            self.line_of(Role::Plane, place, normal, offset + normal.dot(center));
            return;
        }
        let Outline::Faces(faces) = bvh.outline(node) else { return };
        let near = NEAR * hull.bounds.extent().length();
        let lies = |corner: &Vec3| (normal.dot(*corner - center) - offset).abs() <= near;
        if let Some(corners) = faces.into_iter().find(|corners| corners.iter().all(lies)) {
            let middle = corners.iter().sum::<Vec3>() / corners.len() as f32;
            self.add(Role::Plane, Some(place), Form::Polygon(corners));
            self.note(Role::Plane, Some(place), middle, format!("face {face}"));
        }
    }

    /// In a flat scene, the line of a plane that leans, all through the picture. Returns a point near its end.
    fn line_of(&mut self, role: Role, place: Place, normal: Vec3, at: f32) -> Option<Vec3> {
        let (across, length) = (normal.with_z(0.0), normal.truncate().length());
        if !self.walk.flat || length < LEVEL * normal.length() {
            return None;
        }
        let room = self.bounds;
        // The point of the line nearest to the middle, and as far to both sides as the picture is wide.
        let middle = room.center().with_z(0.0);
        let foot = middle + across * ((at - across.dot(middle)) / (length * length));
        let along = Vec3::Z.cross(across) / length;
        let line = Ray::new(foot, along).ok()?;
        let everywhere = Interval::new(f32::NEG_INFINITY, f32::INFINITY);
        let part = raystep_accel::slab(&room, &line, everywhere, Place::World, &mut ());
        if part.is_empty() {
            return None;
        }
        self.add(role, Some(place), Form::Segment(line.at(part.near), line.at(part.far)));
        Some(line.at(part.near + (part.far - part.near) * 0.94))
    }

    /// A plane has no end: in a flat scene it runs through the picture, in a solid one beyond the box, as far as that
    /// is in the picture.
    fn room(&self, slab: &SlabTest) -> Aabb {
        if self.walk.flat {
            return self.bounds;
        }
        beyond(&self.walk.bounds(slab.place)).intersection(self.bounds)
    }
}

/// How far the planes of a box in space are drawn.
pub(super) fn beyond(bounds: &Aabb) -> Aabb {
    bounds.padded(0.15 * bounds.extent().max_element())
}

/// A direction between the axes as a vector, and the point that the planes across it are seen from.
fn slanted(tree: &AnyBvh, node: NodeId, across: Direction) -> Option<(Vec3, Vec3)> {
    match (tree, across) {
        (AnyBvh::Obb(tree), Direction::Own(axis)) => {
            let volume = tree.volume(node);
            Some((volume.axes[axis.index()], volume.center))
        }
        (_, Direction::Slanted(number)) => {
            let center = tree.outline(node).bounds().center();
            Some((*Direction::SLANTED_VECTORS.get(usize::from(number))?, center))
        }
        _ => None,
    }
}
