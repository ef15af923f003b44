//! A drawing in world space, for any camera.

use glam::Vec3;
use raystep_accel::{Aabb, Place, PrimId};

use crate::Role;

/// What space shows at one step: lines, boxes, points and labels, in world coordinates. The primitives
/// themselves are drawn from the scene; those to which something happened have a [`Form::Prim`] mark.
#[derive(Clone, Debug, PartialEq)]
pub struct Space {
    /// What is drawn, later ones on top.
    pub marks: Vec<SpaceMark>,
    /// What a camera should show.
    pub bounds: Aabb,
    /// Whether the scene is flat: seen from straight above, boxes are rectangles.
    pub flat: bool,
}

/// A form with a meaning and, where it is about one, a place.
#[derive(Clone, Debug, PartialEq)]
pub struct SpaceMark {
    /// The drawn form.
    pub form: Form,
    /// What it means.
    pub role: Role,
    /// What it is about.
    pub place: Option<Place>,
}

/// A form in world space.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// The twelve edges and the faint faces of a box.
    Box(Aabb),
    /// A rectangle in a plane: a split, or a slab's face. One of the box's sides has no length.
    Sheet(Aabb),
    /// A straight line.
    Segment(Vec3, Vec3),
    /// A line with a head at its end.
    Arrow(Vec3, Vec3),
    /// A ring around a point.
    Point(Vec3),
    /// A primitive, to be drawn in the mark's role.
    Prim(PrimId),
    /// A label in a rounded box near a point.
    Label {
        /// What it labels.
        at: Vec3,
        /// The text.
        text: String,
    },
}
