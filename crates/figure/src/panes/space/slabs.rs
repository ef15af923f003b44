//! The two planes of a slab that is being cut.

use glam::Vec3;
use raystep_accel::{Aabb, AnyBvh, Direction, Interval, NodeId, Place, Ray, Structure, Visit};

use super::Drawing;
use crate::moments::{SlabCut, SlabTest};
use crate::theme::Role;
use crate::words::number;
use crate::world::Form;

/// A plane whose normal is so much more upright than level is no line of a flat scene.
const LEVEL: f32 = 0.05;

impl Drawing<'_> {
    pub(super) fn slab(&mut self) {
        match self.moment.event {
            Some(Visit::Roots { place, discriminant, t1, t2, .. }) if discriminant >= 0.0 => {
                self.ring(Role::Tick, Some(place), t1, Some(format!("t1 = {}", number(t1))));
                self.ring(Role::Tick, Some(place), t2, Some(format!("t2 = {}", number(t2))));
            }
            Some(Visit::Clip { place, face, t, .. }) => {
                self.face(place, face);
                self.ring(Role::Tick, Some(place), t, Some(format!("t = {}", number(t))));
            }
            _ => {}
        }
        let Some(slab) = self.moment.slab.as_ref() else { return };
        if matches!(self.moment.event, Some(Visit::Volume { .. })) {
            return;
        }
        for cut in &slab.cuts {
            let drawn = cut.axis == slab.axis || (self.walk.flat && cut.axis < slab.axis);
            if drawn && !self.walk.leaves_out(cut.axis) {
                self.planes(slab, cut);
            }
        }
    }

    /// The planes of a slab across an axis; of other slabs only where the ray meets them.
    fn planes(&mut self, slab: &SlabTest, cut: &SlabCut) {
        let role = if cut.axis == slab.axis { Role::Plane } else { Role::Edge };
        if let Some(axis) = cut.axis.axis() {
            let room = self.room(slab);
            for at in [cut.low, cut.high] {
                let mut sheet = room;
                sheet.min[axis] = at;
                sheet.max[axis] = at;
                self.add(role, Some(slab.place), Form::Sheet(sheet));
            }
        } else if let (Place::Node(node), Structure::Bvh(tree)) = (slab.place, self.walk.structure)
            && let Some((normal, center)) = slanted(tree, node, cut.axis)
        {
            for at in [cut.low, cut.high] {
                self.line_of(role, slab.place, normal, at + normal.dot(center));
            }
        }
        if let (Some(ts), true) = (cut.t, cut.axis == slab.axis) {
            for (name, t) in ["t1", "t2"].into_iter().zip(ts) {
                self.ring(Role::Tick, Some(slab.place), t, Some(format!("{name} = {}", number(t))));
            }
        }
    }

    /// The plane of a face of a hull.
    fn face(&mut self, place: Place, face: u32) {
        let (Place::Node(node), Structure::Bvh(AnyBvh::Hull(tree))) = (place, self.walk.structure) else { return };
        let hull = tree.volume(node);
        if let Some(&(normal, offset)) = hull.planes.get(face as usize) {
            self.line_of(Role::Plane, place, normal, offset + normal.dot(hull.bounds.center()));
        }
    }

    /// In a flat scene, the line of a plane that leans, all through the picture.
    fn line_of(&mut self, role: Role, place: Place, normal: Vec3, at: f32) {
        let (across, length) = (normal.with_z(0.0), normal.truncate().length());
        if !self.walk.flat || length < LEVEL * normal.length() {
            return;
        }
        let room = self.bounds;
        // The point of the line nearest to the middle, and as far to both sides as the picture is wide.
        let middle = room.center().with_z(0.0);
        let foot = middle + across * ((at - across.dot(middle)) / (length * length));
        let along = Vec3::Z.cross(across) / length;
        let Ok(line) = Ray::new(foot, along) else { return };
        let everywhere = Interval::new(f32::NEG_INFINITY, f32::INFINITY);
        let part = raystep_accel::slab(&room, &line, everywhere, Place::World, &mut ());
        if !part.is_empty() {
            self.add(role, Some(place), Form::Segment(line.at(part.near), line.at(part.far)));
        }
    }

    /// A plane has no end: in a flat scene it runs through the picture, in a solid one beyond the box.
    fn room(&self, slab: &SlabTest) -> Aabb {
        if self.walk.flat {
            return self.bounds;
        }
        beyond(&self.walk.bounds(slab.place))
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
