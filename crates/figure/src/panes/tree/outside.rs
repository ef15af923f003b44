//! What of a large tree is not drawn: the way down to what is, and how many nodes there are on each level.

use glam::Vec2;
use raystep_accel::{NodeId, Place};

use super::branches::{Branches, Tree};
use super::pen::text_role;
use crate::page::{Anchor, Figure, Look, write};
use crate::theme::{Face, Role, text_width};
use crate::words::whole;
use crate::world::Levels;

/// A pane narrower than so many letters has no room for a column beside the tree.
const NARROW: f32 = 36.0;

/// Of the ancestors, most that are named.
const NAMED: usize = 8;

/// A tree of which a part is drawn, in a pane.
pub(super) struct Outside<'a> {
    levels: &'a Levels,
    size: Vec2,
    look: &'a Look,
}

impl<'a> Outside<'a> {
    pub(super) fn new(levels: &'a Levels, size: Vec2, look: &'a Look) -> Outside<'a> {
        Outside { levels, size, look }
    }

    /// Whether the levels are counted in a column beside the tree.
    fn has_column(&self) -> bool {
        self.size.x >= self.look.text * NARROW
    }

    fn total(&self) -> usize {
        self.levels.counts().iter().sum()
    }

    /// Where what says how many nodes are drawn ends: without a heading it has a line of its own.
    pub(super) fn top(&self) -> f32 {
        if self.has_column() || !self.look.titles { self.look.margin() + self.look.text * 1.6 } else { 0.0 }
    }

    /// How wide the column beside the tree is, if there is one.
    pub(super) fn width(&self) -> f32 {
        let most = self.levels.counts().iter().max().copied().unwrap_or(0);
        let deepest = self.levels.deepest();
        let rows = [
            format!("level {deepest}: 36 of {}", count(most)),
            format!("levels {deepest}–{deepest}: {} more", count(self.total())),
        ];
        let wide = |row: &String| text_width(row, Face::Regular, self.look.small());
        if self.has_column() { rows.iter().map(wide).fold(0.0, f32::max) + self.look.text } else { 0.0 }
    }

    /// How much of the heading's line it takes up.
    pub(super) fn heading_width(&self) -> f32 {
        let longest = format!("36 of {} nodes drawn", count(self.total()));
        text_width(&longest, Face::Regular, self.look.small()) + self.look.text
    }

    /// In the heading how many nodes are drawn of all; beside each row how many of its level, above and below how many
    /// there are besides.
    pub(super) fn rows(&self, figure: &mut Figure, branches: &Branches, places: &[Vec2], top: f32) {
        let Outside { levels, size, look } = *self;
        let mut put = |y: f32, says: &str| {
            let at = Vec2::new(size.x - look.margin(), y);
            write(figure, Role::Quiet, None, at, says, look.small(), Face::Regular, Anchor::End);
        };
        let says = format!("{} of {} nodes drawn", branches.shown.len(), count(self.total()));
        put(look.margin() + look.text * 0.6, &says);
        let first = branches.shown.first().and_then(|branch| levels.level(branch.node));
        let Some(first) = first.filter(|_| self.has_column()) else { return };
        let counts = levels.counts();
        let range = |from: usize, to: usize| match from == to {
            true => format!("level {from}"),
            false => format!("levels {from}–{to}"),
        };
        if first > 0 {
            let (named, all) = (branches.above.len(), counts[..first].iter().sum::<usize>());
            put(top + look.text * 0.5, &format!("{}: {named} of {}", range(0, first - 1), count(all)));
        }
        let mut row = 0;
        loop {
            let in_row = branches.shown.iter().zip(places).filter(|(branch, _)| branch.level == row);
            let (drawn, y) = in_row.fold((0, 0.0), |(drawn, _), (_, at)| (drawn + 1, at.y));
            let level = first + row;
            let all = counts.get(level).copied().unwrap_or(0);
            let says = match drawn {
                0 => break,
                1 if all == 1 => format!("level {level}: 1 node"),
                _ if drawn == all => format!("level {level}: all {}", count(all)),
                _ => format!("level {level}: {drawn} of {}", count(all)),
            };
            put(y, &says);
            row += 1;
        }
        let deeper = counts.iter().skip(first + row).sum::<usize>();
        if deeper > 0 {
            let foot = places.iter().map(|at| at.y).fold(0.0, f32::max) + look.line();
            let foot = foot.min(size.y - look.small() * 0.6);
            put(foot, &format!("{}: {} more", range(first + row, levels.deepest()), count(deeper)));
        }
    }

    /// The ancestors that did not fit as a line of numbers, with what waits beside them.
    pub(super) fn crumbs(&self, figure: &mut Figure, tree: &dyn Tree, above: &[NodeId], top: f32, right: f32) {
        let (u, left) = (self.look.text, self.look.margin());
        let above: Vec<NodeId> = above.iter().copied().filter(|node| !tree.is_ground(*node)).collect();
        let sign = |text: &str| Piece { text: text.to_owned(), role: Role::Quiet, place: None, face: Face::Regular };
        let name = |node: NodeId, role| Piece {
            text: node.to_string(),
            role,
            place: Some(Place::Node(node)),
            face: Face::MonoMedium,
        };
        let wide = |piece: &Piece| text_width(&piece.text, piece.face, u) + u * 0.5;
        let fits = |line: &[Piece]| left + line.iter().map(wide).sum::<f32>() <= right;
        // The root, then the nearest ones, as many as fit; a gap between them says that there are more.
        let from = |near: usize| {
            let mut line = Vec::new();
            for (index, &node) in above.iter().enumerate().filter(|(index, _)| *index == 0 || *index >= near) {
                line.extend([name(node, text_role(Role::Seen)), sign("›")]);
                if index == 0 && near > 1 {
                    line.extend([sign("…"), sign("›")]);
                }
            }
            line
        };
        let nearest = above.len().saturating_sub(NAMED).max(1);
        let Some(line) = (nearest..=above.len()).map(from).find(|line| fits(line)) else { return };
        let beside = above.iter().flat_map(|&node| tree.children(node)).filter(|&n| tree.role(n) == Role::Waiting);
        let beside: Vec<NodeId> = beside.collect();
        // As many of them as there is room for, and how many more there are.
        let with = |count: usize| {
            let words = (!beside.is_empty()).then(|| sign("  waiting beside:"));
            let named = beside[..count].iter().map(|&node| name(node, Role::Waiting));
            let more = (count < beside.len()).then(|| sign(&format!("and {} more", beside.len() - count)));
            line.iter().cloned().chain(words).chain(named).chain(more).collect::<Vec<Piece>>()
        };
        let line = (0..=beside.len()).rev().map(with).find(|line| fits(line)).unwrap_or_else(|| line.clone());
        let mut at = Vec2::new(left, top + u * 0.5);
        for piece in line {
            write(figure, piece.role, piece.place, at, &piece.text, u, piece.face, Anchor::Start);
            at.x += wide(&piece);
        }
    }
}

/// A number of nodes, in words.
fn count(nodes: usize) -> String {
    whole(nodes as u64)
}

/// A piece of the line of ancestors.
#[derive(Clone)]
struct Piece {
    text: String,
    role: Role,
    place: Option<Place>,
    face: Face,
}
