//! A tree in a pane: all of it, as large as the room allows; of one that does not fit a part, and what the rest comes
//! to.

use glam::Vec2;

use super::branches::{Branches, Tree, TreeView};
use super::outside::Outside;
use super::pen::Pen;
use super::signs::{signs, write_signs};
use super::sizes::{LEAST, Sizes};
use crate::page::{Figure, Look};
use crate::theme::{Face, text_width};
use crate::world::Levels;

/// Trees with at most so many nodes are drawn whole where they fit.
const WHOLE: usize = 80;

/// How large digits may be, in parts of the text beside; larger ones only in a picture of nothing but the tree.
const PARTS: [f32; 9] = [2.2, 1.9, 1.6, 1.35, 1.15, 1.0, 0.92, 0.85, 0.74];
const IN_A_PANE: usize = 4;

/// How much air there may be around nodes.
const AIRS: [f32; 3] = [1.0, 0.5, 0.0];

/// Draws any tree into a pane.
pub(crate) fn draw_tree(tree: &dyn Tree, view: &TreeView, size: Vec2, look: &Look) -> Figure {
    let levels = tree.levels();
    let pane = Pane { tree, levels: &levels, view, size, look };
    let mut figure = Figure::new(size);
    if !pane.whole(&mut figure) {
        pane.part(&mut figure);
    }
    figure
}

/// How high a pane is in which all of a tree with few nodes finds room, with a heading over it.
pub(super) fn height(levels: &Levels, look: &Look) -> Option<f32> {
    let few = levels.counts().iter().sum::<usize>() <= WHOLE;
    let digits = digits(look, 1.0).last().copied()?;
    let top = look.heading(&mut Figure::default(), "", "");
    let tree = Sizes { digits, air: 0.0 }.height(levels.counts().len());
    few.then(|| (top + tree + look.margin()).max(look.text * 11.0))
}

/// The sizes that digits may have, the largest first; nothing that is larger than so many parts of the text.
fn digits(look: &Look, largest: f32) -> Vec<f32> {
    let parts = PARTS.iter().filter(|part| **part <= largest);
    let mut sizes: Vec<f32> = parts.map(|part| part * look.text).filter(|digits| *digits >= LEAST).collect();
    if sizes.is_empty() {
        sizes.push(LEAST);
    }
    sizes
}

/// What is drawn, and where.
struct Pane<'a> {
    tree: &'a dyn Tree,
    levels: &'a Levels,
    view: &'a TreeView,
    size: Vec2,
    look: &'a Look,
}

impl Pane<'_> {
    fn sizes(&self) -> Vec<f32> {
        digits(self.look, if self.look.titles { PARTS[IN_A_PANE] } else { PARTS[0] })
    }

    /// Whether what the marks mean stands at the foot: in a picture of nothing but a tree.
    fn signs_below(&self) -> bool {
        !self.look.titles && self.size.y > self.look.text * 20.0
    }

    fn pen(&self, sizes: Sizes, top: f32, right: f32) -> Pen<'_> {
        let margin = self.look.margin();
        let foot = if self.signs_below() { self.look.text * 1.3 } else { 0.0 };
        let (min, max) = (Vec2::new(margin, top), Vec2::new(right, self.size.y - margin * 0.5 - foot));
        Pen { tree: self.tree, levels: self.levels, sizes, min, max, alone: !self.look.titles }
    }

    /// The heading, with what the marks mean up to `right`. Returns where it ends: to the right and below.
    fn heading(&self, figure: &mut Figure, branches: &Branches, right: f32) -> Vec2 {
        let Pane { look, size, .. } = *self;
        let bottom = look.heading(figure, "Tree", "");
        let signs = signs(self.tree, branches);
        if look.titles {
            let left = look.margin() + text_width("Tree", Face::Bold, look.text * 0.95) + look.text * 1.4;
            let at = Vec2::new(left, look.margin() + look.text * 0.6);
            return Vec2::new(write_signs(figure, &signs, at, right, look), bottom);
        }
        if self.signs_below() {
            write_signs(figure, &signs, Vec2::new(look.margin(), size.y - look.margin()), right, look);
        }
        Vec2::new(0.0, bottom)
    }

    /// Draws the whole tree with digits as large as there is room for; says whether there is.
    fn whole(&self, figure: &mut Figure) -> bool {
        let (margin, right) = (self.look.margin(), self.size.x - self.look.margin());
        let top = self.look.heading(&mut Figure::default(), "", "");
        // Beside the heading where the upper nodes stand clear of it.
        let tops = if self.look.titles { &[top, margin * 0.5][..] } else { &[top] };
        let sizes = self.sizes().into_iter().flat_map(|digits| AIRS.map(|air| Sizes { digits, air }));
        for (sizes, &begin) in sizes.flat_map(|sizes| tops.iter().map(move |top| (sizes, top))) {
            let pen = self.pen(sizes, begin, right);
            let Some(branches) = pen.whole(self.view, WHOLE).filter(Branches::is_whole) else { continue };
            let places = pen.places(&branches);
            let end = self.heading(&mut Figure::default(), &branches, right);
            if begin >= top || pen.is_clear_of(end, &branches, &places) {
                self.heading(figure, &branches, right);
                pen.draw(figure, &branches, &places);
                return true;
            }
        }
        false
    }

    /// Draws what there is room for, the way down to it, and how much there is besides.
    fn part(&self, figure: &mut Figure) {
        let Pane { look, size, levels, .. } = *self;
        let outside = Outside::new(levels, size, look);
        let top = look.heading(&mut Figure::default(), "", "").max(outside.top());
        let right = size.x - look.margin() - outside.width();
        let sizes = self.sizes();
        // A small tree that does not fit is drawn as small as it may be, a large one so that its path is seen.
        let few = levels.counts().iter().sum::<usize>() <= WHOLE;
        let first = if few { sizes.len() - 1 } else { 0 };
        let pen = |digits: f32, air: f32, top: f32| self.pen(Sizes { digits, air }, top, right);
        let airs: &[f32] = if few { &[0.0] } else { &[0.4, 0.0] };
        let mut tried = sizes[first..].iter().flat_map(|&digits| airs.iter().map(move |&air| (digits, air)));
        let fits = tried.find(|&(digits, air)| pen(digits, air, top).part(self.view).above.is_empty());
        let pen = match fits {
            Some((digits, air)) => pen(digits, air, top),
            // Not even the smallest: room for the way down.
            None => pen(sizes[sizes.len() - 1], 0.0, top + look.line()),
        };
        let branches = pen.part(self.view);
        let places = pen.places(&branches);
        self.heading(figure, &branches, size.x - look.margin() - outside.heading_width());
        outside.crumbs(figure, self.tree, &branches.above, top, right);
        if !self.view.uncounted {
            outside.rows(figure, &branches, &places, top);
        }
        pen.draw(figure, &branches, &places);
    }
}
