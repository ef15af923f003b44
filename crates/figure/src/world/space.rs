//! Forms in world space, each with a role and a place.

use glam::Vec3;
use raystep_accel::{Aabb, Place, PrimId, Sphere};

use crate::theme::Role;

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
    /// What of much is drawn, in a few words each.
    pub notes: Vec<String>,
}

/// How many boxes of a large tree a solid picture shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Depth {
    /// The end of the way to where things happen, and what hangs off it.
    #[default]
    Path,
    /// Besides, those of this level, the root's being 0, and of the leaves above it.
    Down(u32),
}

impl Default for Space {
    /// Nothing at all.
    fn default() -> Space {
        Space { marks: Vec::new(), bounds: Aabb::EMPTY, flat: true, notes: Vec::new() }
    }
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
    /// A sphere: a circle in a flat scene, its outline and two circles around it in a solid one.
    Sphere(Sphere),
    /// A convex body in a solid scene by its edges: its outline strong, the others faint where they are many.
    Body(Vec<[Vec3; 2]>),
    /// A flat convex polygon: a cell or a volume of a flat scene, or what of a plane lies in a cell of a solid one.
    Polygon(Vec<Vec3>),
    /// A straight line.
    Segment(Vec3, Vec3),
    /// A line with a head at its end.
    Arrow(Vec3, Vec3),
    /// A ring around a point.
    Point(Vec3),
    /// A primitive, to be drawn in the mark's role.
    Prim(PrimId),
    /// Coordinates of a flat scene, along the lower and the left edge of a box.
    Axes(Aabb),
    /// A number set small into what it names, where there is room for it.
    Number {
        /// What it names, if that is no primitive: it lies in one of its corners.
        within: Aabb,
        /// The number.
        text: String,
        /// How large it is, in parts of the usual.
        scale: f32,
    },
    /// A label in a rounded box.
    Label {
        /// What it labels, if that is a point.
        at: Vec3,
        /// What it labels, if that is a box: it lies in one of its corners. A box without depth is a plane: the label
        /// stands at one of its ends.
        within: Option<Aabb>,
        /// The text.
        text: String,
    },
}

/// How far what is drawn apart keeps from its neighbours, in parts of the scene's diagonal, and at most in parts of its
/// own side.
const GAP: f32 = 0.008;
const MOST: f32 = 0.08;

impl Form {
    /// A part of space that fills a box, a little smaller: where parts share their faces, lines of one would cover those
    /// of the other.
    pub(crate) fn apart(self, own: &Aabb, scene: &Aabb) -> Form {
        let gap = Vec3::splat(GAP * scene.extent().length()).min(own.extent() * MOST);
        let share = Vec3::ONE - 2.0 * gap / own.extent().max(Vec3::splat(f32::MIN_POSITIVE));
        let inwards = |at: Vec3| own.center() + (at - own.center()) * share;
        match self {
            Form::Box(bounds) => Form::Box(Aabb::new(inwards(bounds.min), inwards(bounds.max))),
            Form::Segment(from, to) => Form::Segment(inwards(from), inwards(to)),
            form => form,
        }
    }
}

/// The edges of a box, without those that have no length.
pub(crate) fn edges(bounds: &Aabb) -> Vec<[Vec3; 2]> {
    let corners = bounds.corners();
    let from = (0..8).flat_map(|index: usize| [1, 2, 4].map(|bit| (index, index | bit)));
    let edges = from.filter(|(from, to)| from != to).map(|(from, to)| [corners[from], corners[to]]);
    edges.filter(|[from, to]| from != to).collect()
}
