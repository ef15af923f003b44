//! What the marks of a tree mean, in its heading.

use glam::Vec2;

use super::branches::{Branches, Tree};
use super::pen::{numbered, triangle};
use crate::page::{Anchor, Figure, Ink, Look, write};
use crate::theme::{Face, Role, text_width};

/// A mark of a tree that needs a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sign {
    /// A dot below a leaf.
    Prim,
    /// A dot with a number below a leaf.
    Prims,
    /// A triangle with a number below a node.
    Rest,
}

impl Sign {
    /// What it means.
    fn words(self) -> &'static str {
        match self {
            Sign::Prim => "a primitive",
            Sign::Prims => "so many primitives",
            Sign::Rest => "so many nodes below, not drawn",
        }
    }
}

/// The marks that occur in what is drawn.
pub(super) fn signs(tree: &dyn Tree, branches: &Branches) -> Vec<Sign> {
    let leaves = branches.shown.iter().filter(|branch| branch.is_leaf());
    let counts: Vec<usize> = leaves.map(|branch| tree.prims(branch.node).len()).collect();
    let mut signs = Vec::new();
    if counts.iter().any(|count| (1..=4).contains(count)) {
        signs.push(Sign::Prim);
    }
    if counts.iter().any(|count| *count > 4) {
        signs.push(Sign::Prims);
    }
    if branches.shown.iter().any(|branch| branch.closed) {
        signs.push(Sign::Rest);
    }
    signs
}

/// Writes signs with their words in a line from `at` on, as many as fit before `right`. Returns where the line ends.
pub(super) fn write_signs(figure: &mut Figure, signs: &[Sign], at: Vec2, right: f32, look: &Look) -> f32 {
    let size = look.small();
    let mut x = at.x;
    for &sign in signs {
        let mark = match sign {
            Sign::Prim => size * 0.5,
            Sign::Prims => size * 0.7 + text_width("n", Face::Regular, size),
            Sign::Rest => size * 1.35 + text_width("n", Face::Regular, size),
        };
        let gap = size * 0.4;
        let end = x + mark + gap + text_width(sign.words(), Face::Regular, size);
        if end > right {
            continue;
        }
        match sign {
            Sign::Prim => {
                let center = Vec2::new(x + size * 0.22, at.y);
                figure.add(Role::Scene, None, Ink::Circle { center, radius: size * 0.22 });
            }
            Sign::Prims => {
                numbered(figure, None, Vec2::new(x + size * 0.22, at.y), "n", size);
            }
            Sign::Rest => {
                figure.add(Role::Scene, None, triangle(Vec2::new(x + size * 0.6, at.y - size * 0.4), size));
                let text = Vec2::new(x + size * 1.35, at.y);
                write(figure, Role::Quiet, None, text, "n", size, Face::Regular, Anchor::Start);
            }
        }
        let text = Vec2::new(x + mark + gap, at.y);
        write(figure, Role::Quiet, None, text, sign.words(), size, Face::Regular, Anchor::Start);
        x = end + size * 1.4;
    }
    x
}
