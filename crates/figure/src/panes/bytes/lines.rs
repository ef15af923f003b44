//! The cache lines that a ray has touched so far, slide 62: how many, and which of them.

use glam::Vec2;
use raystep_accel::{CacheLines, NodeId, Observer, Visit};

use crate::moments::Walk;
use crate::page::{Anchor, Figure, block, line, write};
use crate::theme::{Face, Role, text_width};
use crate::words::counted;

/// The lines that a walk has touched after `step` events, where nodes have so many bytes each. What happens within an
/// instance happens in another tree.
pub(super) fn touched(walk: &Walk<'_>, step: usize, node_bytes: usize) -> CacheLines {
    let mut lines = CacheLines::new(node_bytes);
    let mut within = false;
    for event in walk.events.iter().take(step) {
        match event {
            Visit::Local { .. } => within = true,
            Visit::World { .. } => within = false,
            _ if within => {}
            event => lines.on(*event),
        }
    }
    lines
}

/// Where a strip of lines stands.
pub(super) struct Strip {
    /// Its upper left corner.
    pub(super) corner: Vec2,
    /// How wide it may be, and how high it is.
    pub(super) size: Vec2,
}

impl Strip {
    /// Draws the lines of a tree with so many nodes: touched ones filled, those of the node at hand outlined. Of more
    /// lines than there is room for, only the touched ones stand there, with a gap where others lie between.
    pub(super) fn draw(&self, figure: &mut Figure, lines: &CacheLines, nodes: usize, at_hand: NodeId) {
        let all = lines.of(NodeId(nodes.saturating_sub(1) as u32)).end() + 1;
        let here = lines.of(at_hand);
        let least = self.size.y * 0.45;
        let whole = all as f32 * least <= self.size.x;
        // Each line with whether the one before it stands there, too.
        let shown: Vec<usize> = if whole { (0..all).collect() } else { lines.touched().iter().copied().collect() };
        let after_gap = |index: usize| index > 0 && shown[index] != shown[index - 1] + 1;
        let gaps = (0..shown.len()).filter(|index| after_gap(*index)).count();
        let places = shown.len() as f32 + gaps as f32 * GAP;
        let side = (self.size.x / places.max(1.0)).min(self.size.y * 1.3);
        let mut x = self.corner.x;
        for (index, number) in shown.iter().enumerate() {
            if after_gap(index) {
                let y = self.corner.y + self.size.y / 2.0;
                figure.add(Role::Hidden, None, line(Vec2::new(x, y), Vec2::new(x + side * GAP, y)));
                x += side * GAP;
            }
            let role = if lines.touched().contains(number) { Role::Hit } else { Role::Edge };
            figure.add(role, None, block(Vec2::new(x, self.corner.y), Vec2::new(side, self.size.y), 0.0));
            x += side;
        }
        // On top of its neighbours.
        if let Some(first) = shown.iter().position(|number| here.contains(number)) {
            let before = (0..=first).filter(|index| after_gap(*index)).count();
            let wide = shown.iter().filter(|number| here.contains(number)).count() as f32 * side;
            let left = self.corner.x + (first as f32 + before as f32 * GAP) * side;
            figure.add(Role::Here, None, block(Vec2::new(left, self.corner.y), Vec2::new(wide, self.size.y), 0.0));
        }
        let says = format!("of {} of 64 bytes", counted(all as u64, "line", "lines"));
        let others = if whole { "" } else { ", the others not drawn" };
        let size = self.size.y * 0.95;
        let left = x + self.size.y * 0.6;
        let fits = |says: &String| left + text_width(says, Face::Regular, size) <= self.corner.x + self.size.x;
        if let Some(says) = [format!("{says}{others}"), says].into_iter().find(fits) {
            let at = Vec2::new(left, self.corner.y + self.size.y / 2.0);
            write(figure, Role::Quiet, None, at, &says, size, Face::Regular, Anchor::Start);
        }
    }
}

/// What is left out between two lines, in parts of a line.
const GAP: f32 = 0.5;
