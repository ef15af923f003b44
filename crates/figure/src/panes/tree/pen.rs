//! How the nodes of a tree are drawn: sizes, places, and marks.

use glam::Vec2;
use raystep_accel::{NodeId, Place};

use super::branches::{Branch, Branches, Room, Tree, TreeView, part, whole};
use super::sizes::Sizes;
use crate::page::{Anchor, Figure, Ink, block, line, write};
use crate::panes::lanes::{small_strip, strip_room};
use crate::theme::{Face, Role, text_width};
use crate::words;
use crate::world::Levels;

/// A leaf with more primitives than this shows their number.
const DOTS: usize = 4;

/// How large a cell of a strip is, in digits.
const CELL: f32 = 0.72;

/// How far a thick or a dashed rim lies further out than others, in digits.
const RIM: f32 = 0.12;

/// Sizes and places of one drawing.
pub(super) struct Pen<'a> {
    pub(super) tree: &'a dyn Tree,
    pub(super) levels: &'a Levels,
    pub(super) sizes: Sizes,
    /// What there is room for: the upper left and the lower right corner.
    pub(super) min: Vec2,
    pub(super) max: Vec2,
    /// Whether the tree is the whole picture: then it stands in the middle.
    pub(super) alone: bool,
}

impl Pen<'_> {
    /// Half the width of a node's mark: long numbers stretch the circle.
    fn half_width(&self, node: NodeId) -> f32 {
        if self.tree.is_ground(node) {
            return 0.0;
        }
        let text = text_width(&node.to_string(), Face::MonoMedium, self.sizes.digits);
        (text / 2.0 + self.sizes.ends()).max(self.sizes.radius())
    }

    /// How far a node with its axis or its dots reaches to both sides.
    pub(super) fn sides(&self, branch: &Branch) -> [f32; 2] {
        let half = self.half_width(branch.node);
        let strip = self.strip_room().map_or(0.0, |room| room.x + self.sizes.digits * 0.3);
        if branch.is_leaf() {
            let half = half.max(self.dots_width(branch.node) / 2.0);
            return if branch.left { [half + strip, half] } else { [half, half + strip] };
        }
        let wide = half + self.axis_width(branch.node) + strip;
        if branch.left { [wide, half] } else { [half, wide] }
    }

    /// How much room the axis beside a node takes.
    fn axis_width(&self, node: NodeId) -> f32 {
        self.tree
            .axis(node)
            .map_or(0.0, |axis| self.sizes.digits * 0.25 + text_width(axis.name(), Face::Regular, self.sizes.small()))
    }

    /// How large the strip of lanes beside a node is, where a packet walks.
    fn strip_room(&self) -> Option<Vec2> {
        self.tree.has_lanes().map(|lanes| strip_room(lanes, self.sizes.digits * CELL))
    }

    /// Who took part in a node, on the side where no edge runs, behind its axis.
    fn strip(&self, figure: &mut Figure, branch: &Branch, at: Vec2, half: f32) {
        let Some((lanes, room)) = self.tree.lanes(branch.node).zip(self.strip_room()) else { return };
        let axis = if branch.is_leaf() { 0.0 } else { self.axis_width(branch.node) };
        let gap = half + axis + self.sizes.digits * 0.3;
        let left = if branch.left { at.x - gap - room.x } else { at.x + gap };
        let corner = Vec2::new(left, at.y - room.y * 0.5);
        small_strip(figure, Some(Place::Node(branch.node)), lanes, corner, self.sizes.digits * CELL);
    }

    /// Half the width of what stands for the nodes below a closed one.
    pub(super) fn rest_width(&self, node: NodeId) -> f32 {
        let count = text_width(&words::whole(self.levels.below(node) as u64), Face::Regular, self.sizes.small());
        (count / 2.0).max(self.sizes.digits * CELL)
    }

    /// All of the tree with at most so many nodes, if it fits.
    pub(super) fn whole(&self, view: &TreeView, most: usize) -> Option<Branches> {
        self.with_room(false, |room| whole(self.tree, view, most, room))
    }

    /// What is drawn of a tree that does not fit.
    pub(super) fn part(&self, view: &TreeView) -> Branches {
        self.with_room(true, |room| part(self.tree, view, room))
    }

    fn with_room<R>(&self, closed: bool, choose: impl FnOnce(&Room<'_>) -> R) -> R {
        let room = self.max - self.min;
        choose(&Room {
            width: room.x,
            levels: self.sizes.rows(room.y, closed),
            gap: self.sizes.gap(),
            sides: &|branch| self.sides(branch),
            rest: &|node| self.rest_width(node),
        })
    }

    /// The middle of each node, spread out to fill the room, but not so far that siblings seem strangers.
    pub(super) fn places(&self, branches: &Branches) -> Vec<Vec2> {
        let room = self.max - self.min;
        let spread = (room.x / branches.tidy.width.max(1.0)).clamp(1.0, 3.0);
        let left = self.min.x + (room.x - branches.tidy.width * spread) / 2.0;
        let levels = branches.shown.iter().map(|branch| branch.level).max().unwrap_or(0);
        let closed = branches.shown.iter().any(|branch| branch.closed);
        let height = room.y - 2.0 * self.sizes.radius() - self.sizes.foot(closed);
        let step = (height / levels.max(1) as f32).min(self.sizes.digits * if self.alone { 5.2 } else { 3.8 });
        let spare = if self.alone { (height - step * levels as f32).max(0.0) / 2.0 } else { 0.0 };
        let top = self.min.y + self.sizes.radius() + spare;
        let x = branches.tidy.x.iter().map(|x| left + x * spread);
        branches.shown.iter().zip(x).map(|(branch, x)| Vec2::new(x, top + step * branch.level as f32)).collect()
    }

    /// Whether all nodes stand to the right of what lies to the left above `end`, or below it.
    pub(super) fn is_clear_of(&self, end: Vec2, branches: &Branches, at: &[Vec2]) -> bool {
        let clear = |(branch, at): (&Branch, &Vec2)| {
            at.y - self.sizes.radius() >= end.y || at.x - self.sides(branch)[0] >= end.x
        };
        branches.shown.iter().zip(at).all(clear)
    }

    pub(super) fn draw(&self, figure: &mut Figure, branches: &Branches, at: &[Vec2]) {
        let path = self.tree.path();
        for (index, branch) in branches.shown.iter().enumerate() {
            if self.tree.is_ground(branch.node) {
                continue;
            }
            for &child in &branch.children {
                self.edge(figure, &path, (branch, at[index]), (&branches.shown[child], at[child]));
            }
        }
        for (branch, at) in branches.shown.iter().zip(at).filter(|(branch, _)| !self.tree.is_ground(branch.node)) {
            self.node(figure, branch, *at);
        }
    }

    /// From rim to rim; thick on the path. To many children from below to above, so that it runs through none of them, and
    /// first down along one stem, below the dots of the leaves beside.
    fn edge(&self, figure: &mut Figure, path: &[NodeId], from: (&Branch, Vec2), to: (&Branch, Vec2)) {
        let along = (to.1 - from.1).normalize_or_zero();
        let child = to.0.node;
        let role = match self.tree.role(child) {
            _ if path.contains(&child) && path.contains(&from.0.node) => Role::Here,
            Role::Guess => Role::Edge,
            role => role,
        };
        let place = Some(Place::Node(child));
        if from.0.children.len() > 2 {
            let below = Vec2::new(0.0, self.sizes.radius() + 1.0);
            let (begins, ends) = (from.1 + below, to.1 - below);
            let stem = (self.sizes.digits * 0.75).min((ends.y - begins.y) * 0.75);
            figure.add(role, place, Ink::Line { points: vec![begins, begins + Vec2::new(0.0, stem), ends] });
            return;
        }
        let (begins, ends) = (along * self.rim(from.0, along), along * self.rim(to.0, along));
        figure.add(role, place, line(from.1 + begins, to.1 - ends));
    }

    /// How far the rim of a node's mark lies from its middle in a direction, and a point more.
    fn rim(&self, branch: &Branch, along: Vec2) -> f32 {
        let (half, radius) = (self.half_width(branch.node), self.sizes.radius());
        let (across, up) = (along.x.abs().max(1e-6), along.y.abs().max(1e-6));
        let rim = match half - radius {
            _ if branch.is_leaf() => (half / across).min(radius / up),
            // Through the straight side of a stretched circle, or through one of its round ends.
            straight if radius / up * across <= straight => radius / up,
            straight => straight * across + (radius * radius - (straight * up).powi(2)).max(0.0).sqrt(),
        };
        rim + 1.0
    }

    /// A circle for an inner node with its axis beside it, a square for a leaf with its primitives below.
    fn node(&self, figure: &mut Figure, branch: &Branch, at: Vec2) {
        let (node, place) = (branch.node, Some(Place::Node(branch.node)));
        let role = self.tree.role(node);
        let (half, radius) = (self.half_width(node), self.sizes.radius());
        // A thick or dashed rim lies further out, off the number.
        let out =
            if matches!(role, Role::Here | Role::Waiting | Role::Dropped) { self.sizes.digits * RIM } else { 0.0 };
        let corner = Vec2::new(half, radius) + out;
        let ink = match branch.is_leaf() {
            false if half <= radius => Ink::Circle { center: at, radius: radius + out },
            false => block(at - corner, 2.0 * corner, radius + out),
            true => block(at - corner, 2.0 * corner, self.sizes.digits * 0.28),
        };
        figure.add(role, place, ink);
        let says = node.to_string();
        write(figure, text_role(role), place, at, &says, self.sizes.digits, Face::MonoMedium, Anchor::Middle);
        if let Some(axis) = self.tree.axis(node).filter(|_| !branch.is_leaf()) {
            // On the side where no edge runs: away from the parent.
            let (side, anchor) = if branch.left { (-1.0, Anchor::End) } else { (1.0, Anchor::Start) };
            let beside = at + Vec2::new(side * (half + 1.6 * out + self.sizes.digits * 0.2), -self.sizes.digits * 0.3);
            write(figure, Role::Quiet, place, beside, axis.name(), self.sizes.small(), Face::Regular, anchor);
        }
        self.strip(figure, branch, at, half);
        if branch.is_leaf() {
            self.dots(figure, node, at + Vec2::new(0.0, radius + self.sizes.digits * 0.45));
        } else if branch.closed {
            self.rest(figure, node, at + Vec2::new(0.0, radius));
        }
    }

    /// How wide the dots of a leaf are, or one dot with their number.
    fn dots_width(&self, node: NodeId) -> f32 {
        match self.tree.prims(node).len() {
            0 => 0.0,
            many if many > DOTS => {
                3.2 * self.sizes.dot() + text_width(&words::whole(many as u64), Face::Regular, self.sizes.small())
            }
            few => self.sizes.apart() * (few as f32 - 1.0) + 2.0 * self.sizes.dot(),
        }
    }

    /// A dot for each primitive of a leaf; of many, their number.
    fn dots(&self, figure: &mut Figure, node: NodeId, at: Vec2) {
        let prims = self.tree.prims(node);
        let first = at.x - self.dots_width(node) / 2.0 + self.sizes.dot();
        if prims.len() > DOTS {
            numbered(
                figure,
                Some(Place::Node(node)),
                Vec2::new(first, at.y + self.sizes.digits * 0.1),
                &words::whole(prims.len() as u64),
                self.sizes.small(),
            );
            return;
        }
        for (index, prim) in prims.into_iter().enumerate() {
            let center = Vec2::new(first + self.sizes.apart() * index as f32, at.y);
            let ink = Ink::Circle { center, radius: self.sizes.dot() };
            figure.add(self.tree.prim_role(prim), Some(Place::Prim(prim)), ink);
        }
    }

    /// A triangle for all that hangs below a closed node, with how many nodes that is.
    fn rest(&self, figure: &mut Figure, node: NodeId, tip: Vec2) {
        let place = Some(Place::Node(node));
        figure.add(Role::Scene, place, triangle(tip, self.sizes.digits));
        let at = tip + Vec2::new(0.0, self.sizes.digits * 1.4);
        let says = words::whole(self.levels.below(node) as u64);
        write(figure, Role::Quiet, place, at, &says, self.sizes.small(), Face::Regular, Anchor::Middle);
    }
}

/// What stands for the nodes below a closed one.
pub(super) fn triangle(tip: Vec2, digits: f32) -> Ink {
    let (base, half) = (tip + Vec2::new(0.0, digits * 0.8), Vec2::new(digits * 0.6, 0.0));
    Ink::Area { points: vec![tip, base + half, base - half] }
}

/// A dot with the number of primitives that it stands for; `at` is the middle of the dot.
pub(super) fn numbered(figure: &mut Figure, place: Option<Place>, at: Vec2, count: &str, size: f32) {
    let radius = size * 0.22;
    figure.add(Role::Scene, place, Ink::Circle { center: at, radius });
    let text = at + Vec2::new(2.2 * radius, 0.0);
    write(figure, Role::Quiet, place, text, count, size, Face::Regular, Anchor::Start);
}

/// Text in nodes of no particular state is plain.
pub(super) fn text_role(role: Role) -> Role {
    match role {
        Role::Edge => Role::Text,
        other => other,
    }
}
