//! A tree as nodes and edges: where the walk stands, what waits, what was seen and what never will be.

mod branches;
mod build;
mod tidy;

use std::collections::BTreeMap;

use glam::Vec2;
use raystep_accel::{Direction, NodeId, Place, PrimId};

pub use branches::TreeView;
use branches::{Branch, Branches, MOST, Room, Tree, branches, count_below};
pub(crate) use build::node_role;
pub use build::tree_of_build;

use crate::moments::{Moment, Walk};
use crate::page::{Anchor, Figure, Ink, Look, block, line, write};
use crate::theme::{Face, Role, text_width};

/// More nodes than this below a closed one are not counted.
const COUNTED: usize = 9999;

/// The structure's tree at a moment of a walk; empty for a structure without nodes.
pub fn tree(walk: &Walk<'_>, moment: &Moment, view: &TreeView, size: Vec2, look: &Look) -> Figure {
    if walk.structure.node_count() == 0 {
        let mut figure = Figure::new(size);
        look.nothing(&mut figure, "Tree", "This structure has no tree.");
        return figure;
    }
    draw_tree(&Walked { walk, moment }, view, size, look)
}

/// A finished tree with the states that a walk gives its nodes.
struct Walked<'a> {
    walk: &'a Walk<'a>,
    moment: &'a Moment,
}

impl Tree for Walked<'_> {
    fn children(&self, node: NodeId) -> Vec<NodeId> {
        self.walk.structure.children(node)
    }

    fn axis(&self, node: NodeId) -> Option<Direction> {
        self.walk.structure.split(node).map(|(axis, _)| axis)
    }

    fn prims(&self, node: NodeId) -> Vec<PrimId> {
        self.walk.structure.leaf_prims(node).to_vec()
    }

    fn role(&self, node: NodeId) -> Role {
        let place = Place::Node(node);
        match self.moment {
            moment if moment.here == Some(place) => Role::Here,
            moment if moment.guesses.iter().any(|(guess, _)| *guess == place) => Role::Guess,
            moment if moment.waiting(node).is_some() => Role::Waiting,
            moment if moment.seen.contains(&place) => Role::Seen,
            moment if moment.dropped.contains(&place) => Role::Dropped,
            _ => Role::Edge,
        }
    }

    fn prim_role(&self, prim: PrimId) -> Role {
        match self.moment.test_of(prim) {
            _ if self.moment.best.is_some_and(|best| best.prim == prim) => Role::Best,
            Some(test) if test.t.is_some() => Role::Hit,
            Some(_) => Role::Missed,
            None => Role::Scene,
        }
    }

    fn path(&self) -> Vec<NodeId> {
        // Only children of nodes that were entered are ever entered.
        let places = self.moment.seen.iter().chain(&self.moment.here);
        let mut parents = BTreeMap::new();
        let mut last = None;
        for place in places {
            let Place::Node(node) = *place else { continue };
            parents.extend(self.children(node).into_iter().map(|child| (child, node)));
            last = Some(node);
        }
        let mut path: Vec<NodeId> = std::iter::successors(last, |node| parents.get(node).copied()).collect();
        path.reverse();
        if path.is_empty() { vec![NodeId::ROOT] } else { path }
    }
}

/// Draws any tree into a pane.
fn draw_tree(tree: &impl Tree, view: &TreeView, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    let u = look.text;
    let top = look.heading(&mut figure, "Tree", "dots: primitives of a leaf");

    // As large as lets the whole tree be drawn, or of a large one the whole path; if no size does, the smallest
    // and the part that fits.
    let small = count_below(tree, view.focus.unwrap_or(NodeId::ROOT), MOST) <= MOST;
    // A picture of nothing but the tree has room for larger marks than a pane beside others.
    let scales: &[f32] = match (small, look.titles) {
        (true, false) => &[2.6, 2.2, 1.9, 1.6, 1.3, 1.0, 0.85, 0.7],
        (true, true) => &[1.0, 0.85, 0.7],
        (false, false) => &[1.9, 1.6, 1.3, 1.0],
        (false, true) => &[1.0, 0.85],
    };
    let mut drawn = None;
    for scale in scales {
        let digit = text_width("0", Face::Mono, u * scale * 0.88);
        let pen = Pen { u: u * scale, digit, size, top, margin: look.margin(), alone: !look.titles };
        let branches = branches(tree, view, &pen.room(tree));
        let enough = if small { branches.whole() } else { branches.above.is_empty() };
        drawn = Some((pen, branches));
        if enough {
            break;
        }
    }
    if let Some((pen, branches)) = drawn {
        pen.draw(&mut figure, tree, &branches);
    }
    figure
}

/// Sizes and places of one drawing.
struct Pen {
    /// Size of the text around; a node's mark is a little larger.
    u: f32,
    /// Width of a digit of a node's number.
    digit: f32,
    size: Vec2,
    top: f32,
    margin: f32,
    /// Whether the tree is the whole picture: then it stands in the middle.
    alone: bool,
}

impl Pen {
    fn radius(&self) -> f32 {
        self.u * 0.85
    }

    /// Half the width of a node's mark: long numbers stretch the circle.
    fn half_width(&self, node: NodeId) -> f32 {
        let text = self.digit * (node.0.checked_ilog10().unwrap_or(0) + 1) as f32;
        (text / 2.0 + self.u * 0.35).max(self.radius())
    }

    /// Least distance between levels.
    fn step(&self) -> f32 {
        self.u * 2.05
    }

    /// A node with a plane has its axis beside it.
    fn room<'a>(&'a self, tree: &'a impl Tree) -> Room<impl Fn(NodeId) -> f32 + 'a> {
        let letter = |node| if tree.axis(node).is_some() { self.u * 0.35 } else { 0.0 };
        let height = self.size.y - self.top - 2.0 * self.radius() - self.u * 1.9;
        Room {
            width: self.size.x - 2.0 * self.margin - self.u,
            levels: (height / self.step()).max(0.0) as usize + 1,
            gap: self.u * 1.1,
            half_width: move |node| self.half_width(node) + letter(node),
        }
    }

    fn draw(&self, figure: &mut Figure, tree: &impl Tree, branches: &Branches) {
        let top = if branches.above.is_empty() { self.top } else { self.draw_above(figure, tree, &branches.above) };

        // Spread out to fill the pane, but not so far that siblings seem strangers.
        let width = self.size.x - 2.0 * self.margin - self.u;
        let spread = (width / branches.tidy.width.max(1.0)).min(3.0);
        let left = (self.size.x - branches.tidy.width * spread) / 2.0;
        let levels = branches.shown.iter().map(|branch| branch.level).max().unwrap_or(0);
        let height = self.size.y - top - 2.0 * self.radius() - self.u * 1.9;
        let step = (height / levels.max(1) as f32).min(self.u * if self.alone { 5.2 } else { 3.6 });
        let top = if self.alone { top + (height - step * levels as f32).max(0.0) / 2.0 } else { top };
        let at = |index: usize| {
            let y = top + self.radius() + step * branches.shown[index].level as f32;
            Vec2::new(left + branches.tidy.x[index] * spread, y)
        };

        let path = tree.path();
        for (index, branch) in branches.shown.iter().enumerate() {
            for &child in &branch.children {
                self.edge(figure, tree, &path, (branch, at(index)), (&branches.shown[child], at(child)));
            }
        }
        // A node's axis stands on the side where no edge runs: away from its parent.
        let mut left_of_parent = vec![false; branches.shown.len()];
        for branch in &branches.shown {
            for &child in &branch.children[..branch.children.len() / 2] {
                left_of_parent[child] = true;
            }
        }
        for (index, branch) in branches.shown.iter().enumerate() {
            self.node(figure, tree, branch, at(index), left_of_parent[index]);
        }
    }

    /// From rim to rim; thick on the path.
    fn edge(&self, figure: &mut Figure, tree: &impl Tree, path: &[NodeId], from: (&Branch, Vec2), to: (&Branch, Vec2)) {
        let along = (to.1 - from.1).normalize_or_zero();
        let child = to.0.node;
        let role = match tree.role(child) {
            _ if path.contains(&child) && path.contains(&from.0.node) => Role::Here,
            Role::Guess => Role::Edge,
            role => role,
        };
        figure.add(
            role,
            Some(Place::Node(child)),
            line(from.1 + along * self.rim(from.0, along), to.1 - along * self.rim(to.0, along)),
        );
    }

    /// How far the rim of a node's mark lies from its middle in a direction, and a point more.
    fn rim(&self, branch: &Branch, along: Vec2) -> f32 {
        let (half, radius) = (self.half_width(branch.node), self.radius());
        let leaf = branch.children.is_empty() && !branch.closed;
        let (across, up) = (along.x.abs().max(1e-6), along.y.abs().max(1e-6));
        let rim = match half - radius {
            _ if leaf => (half / across).min(radius / up),
            // Through the straight side of a stretched circle, or through one of its round ends.
            straight if radius / up * across <= straight => radius / up,
            straight => straight * across + (radius * radius - (straight * up).powi(2)).max(0.0).sqrt(),
        };
        rim + 1.0
    }

    /// A circle for an inner node with its axis beside it, a square for a leaf with its primitives below.
    fn node(&self, figure: &mut Figure, tree: &impl Tree, branch: &Branch, at: Vec2, left: bool) {
        let (node, u) = (branch.node, self.u);
        let place = Some(Place::Node(node));
        let role = tree.role(node);
        let (half, radius) = (self.half_width(node), self.radius());
        let leaf = branch.children.is_empty() && !branch.closed;
        let corner = Vec2::new(half, radius);
        let ink = match leaf {
            false if half <= radius => Ink::Circle { center: at, radius },
            false => block(at - corner, 2.0 * corner, radius),
            true => block(at - corner, 2.0 * corner, u * 0.25),
        };
        figure.add(role, place, ink);
        write(figure, text_role(role), place, at, &node.to_string(), u * 0.88, Face::MonoMedium, Anchor::Middle);
        if let Some(axis) = tree.axis(node) {
            let (side, anchor) = if left { (-1.0, Anchor::End) } else { (1.0, Anchor::Start) };
            let beside = at + Vec2::new(side * (half + u * 0.25), -u * 0.5);
            write(figure, Role::Quiet, place, beside, axis.name(), u * 0.88, Face::Regular, anchor);
        }
        if leaf {
            self.dots(figure, tree, node, at + Vec2::new(0.0, radius + u * 0.6));
        } else if branch.closed {
            self.rest(figure, tree, node, at + Vec2::new(0.0, radius));
        }
    }

    /// A dot for each primitive of a leaf; of many, their number.
    fn dots(&self, figure: &mut Figure, tree: &impl Tree, node: NodeId, at: Vec2) {
        let prims = tree.prims(node);
        let (radius, apart) = (self.u * 0.2, self.u * 0.6);
        if prims.len() > 4 {
            let place = Some(Place::Node(node));
            let says = prims.len().to_string();
            let dot = at - Vec2::new(text_width(&says, Face::Regular, self.u * 0.8) / 2.0 + radius, 0.0);
            figure.add(Role::Scene, place, Ink::Circle { center: dot, radius });
            let at = dot + Vec2::new(2.0 * radius, 0.0);
            write(figure, Role::Quiet, place, at, &says, self.u * 0.8, Face::Regular, Anchor::Start);
            return;
        }
        let first = at.x - apart * (prims.len() as f32 - 1.0) / 2.0;
        for (index, prim) in prims.into_iter().enumerate() {
            let center = Vec2::new(first + apart * index as f32, at.y);
            figure.add(tree.prim_role(prim), Some(Place::Prim(prim)), Ink::Circle { center, radius });
        }
    }

    /// A triangle for all that hangs below a closed node, with how many nodes that is.
    fn rest(&self, figure: &mut Figure, tree: &impl Tree, node: NodeId, tip: Vec2) {
        let (u, place) = (self.u, Some(Place::Node(node)));
        let base = tip + Vec2::new(0.0, u * 0.75);
        let half = Vec2::new(u * 0.6, 0.0);
        figure.add(Role::Scene, place, Ink::Area { points: vec![tip, base + half, base - half] });
        let count = count_below(tree, node, COUNTED) - 1;
        let says = if count > COUNTED - 1 { format!("{COUNTED}+") } else { count.to_string() };
        let at = base + Vec2::new(0.0, u * 0.6);
        write(figure, Role::Quiet, place, at, &says, u * 0.8, Face::Regular, Anchor::Middle);
    }

    /// The ancestors that did not fit as a line of numbers, with what waits beside them. Returns where
    /// the tree begins.
    fn draw_above(&self, figure: &mut Figure, tree: &impl Tree, above: &[NodeId]) -> f32 {
        let u = self.u;
        let (mut x, y) = (self.margin, self.top + u * 0.6);
        let mut put = |role, place, text: &str, face| {
            let width = text_width(text, face, u);
            if x + width < self.size.x - self.margin {
                write(figure, role, place, Vec2::new(x, y), text, u, face, Anchor::Start);
                x += width + u * 0.5;
            }
        };
        // The root, then the nearest ones, as many as fit; a gap between them says that there are more.
        let wide = |node: &NodeId| {
            let sign = text_width("›", Face::Regular, u) + u * 0.5;
            text_width(&node.to_string(), Face::MonoMedium, u) + u * 0.5 + sign
        };
        let room = self.size.x - 2.0 * self.margin - u * 3.0;
        let fits = |near: usize| above.iter().take(1).chain(&above[near..]).map(wide).sum::<f32>() <= room;
        let near = (above.len().saturating_sub(8).max(1)..above.len()).find(|&near| fits(near)).unwrap_or(above.len());
        for (index, &node) in above.iter().enumerate().filter(|(index, _)| *index == 0 || *index >= near) {
            put(text_role(Role::Seen), Some(Place::Node(node)), &node.to_string(), Face::MonoMedium);
            put(Role::Quiet, None, "›", Face::Regular);
            if index == 0 && near > 1 {
                put(Role::Quiet, None, "…", Face::Regular);
                put(Role::Quiet, None, "›", Face::Regular);
            }
        }
        let beside = above.iter().flat_map(|&node| tree.children(node)).filter(|&n| tree.role(n) == Role::Waiting);
        for (index, node) in beside.enumerate() {
            if index == 0 {
                put(Role::Quiet, None, "   waiting beside:", Face::Regular);
            }
            put(Role::Waiting, Some(Place::Node(node)), &node.to_string(), Face::MonoMedium);
        }
        y + u * 1.0
    }
}

/// Text in nodes of no particular state is plain.
fn text_role(role: Role) -> Role {
    match role {
        Role::Edge => Role::Text,
        other => other,
    }
}
