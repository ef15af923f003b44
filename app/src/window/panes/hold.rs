//! What the pointer has hold of.

use std::sync::Arc;

use egui::CursorIcon;
use glam::{Vec2, Vec3};
use raystep_accel::{Axis, NodeId, PrimId};
use raystep_scene::{Part, Scene};

/// What the pointer has hold of.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Hold {
    /// The ray's origin; its head stays.
    Origin,
    /// The ray's head; its origin stays.
    Head,
    /// A new ray from here.
    New(Vec3),
    /// A part of a shape.
    Part(Grasp),
    /// The plane of a node, across this axis.
    Plane(NodeId, Axis),
    /// The cut that a builder weighs.
    Cut,
    /// The object of a pair that can be moved.
    Body,
    /// A number of a meter, by its place there.
    Number(usize),
    /// The camera.
    Turn,
    /// What the camera looks at.
    Shift,
}

/// A part of a shape, where it was taken, and the scene as it was then.
#[derive(Clone, Debug)]
pub(crate) struct Grasp {
    pub(crate) prim: PrimId,
    pub(crate) part: Part,
    pub(crate) from: Vec2,
    pub(crate) scene: Arc<Scene>,
}

impl PartialEq for Grasp {
    fn eq(&self, other: &Grasp) -> bool {
        (self.prim, self.part, self.from) == (other.prim, other.part, other.from)
            && Arc::ptr_eq(&self.scene, &other.scene)
    }
}

/// What is held of a shape, and where it is now.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Moved {
    pub(crate) grasp: Grasp,
    pub(crate) to: Vec2,
}

impl Hold {
    /// What the pointer looks like over what it can take, and while it holds it.
    pub(super) fn cursor(hold: Option<&Hold>, grip: Option<&Hold>) -> CursorIcon {
        match (hold, grip) {
            (Some(Hold::Plane(_, axis)), _) | (None, Some(Hold::Plane(_, axis))) => match axis {
                Axis::Y => CursorIcon::ResizeVertical,
                _ => CursorIcon::ResizeHorizontal,
            },
            (Some(Hold::Origin | Hold::Head | Hold::Part(_) | Hold::Body), _) => CursorIcon::Grabbing,
            (None, Some(Hold::Part(Grasp { part: Part::Whole, .. }))) => CursorIcon::Move,
            (None, Some(_)) => CursorIcon::Grab,
            _ => CursorIcon::Default,
        }
    }
}
