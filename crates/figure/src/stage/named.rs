//! What a label names, if that is a box or a place: where it may stand, and where it leads to.

use glam::Vec2;
use raystep_accel::{Aabb, Place};

use super::beside::{
    all_over, beside_box, beside_line, beside_shape, further, is_line, is_sheet, nearest, on_box, on_outline, outline,
};
use super::crop::polygon;
use super::lens::Lens;
use super::obstacles::area;
use super::spot::Spot;
use crate::page::{Figure, Ink};
use crate::world::Space;

/// What a label names.
pub(super) struct Named<'a> {
    bounds: Aabb,
    place: Option<Place>,
    flat: bool,
    /// What bounds its place on the page, if that is no box along the axes.
    shape: Vec<Vec2>,
    /// Whether that is what it names: it may name a plane of the place.
    all: bool,
    /// The lines of a primitive in space, as they are drawn.
    drawn: Vec<(Vec2, Vec2)>,
    /// The box of what lies flat, on the page.
    page: Option<Spot>,
    lens: &'a Lens,
}

impl<'a> Named<'a> {
    pub(super) fn new(bounds: Aabb, place: Option<Place>, space: &Space, lens: &'a Lens, figure: &Figure) -> Named<'a> {
        let corners = || Some((lens.point(bounds.min)?.0, lens.point(bounds.max)?.0));
        let page = corners().filter(|_| space.flat && !is_line(&bounds));
        let page = page.map(|(a, b)| Spot { min: a.min(b), max: a.max(b) });
        let own = figure.marks.iter().filter(|mark| mark.place == place && matches!(place, Some(Place::Prim(_))));
        let lines = own.filter(|_| !space.flat).filter_map(|mark| match &mark.ink {
            Ink::Line { points } => Some(points.windows(2).map(|ends| (ends[0], ends[1]))),
            _ => None,
        });
        let drawn = lines.flatten().collect();
        let shape = outline(space, place, lens);
        let reach = Spot::over(&shape);
        let all = page.zip(reach).is_some_and(|(page, reach)| page.is_near(reach));
        Named { bounds, place, flat: space.flat, shape, all, drawn, page, lens }
    }

    /// Where its label may stand, the best first.
    pub(super) fn candidates(&self, half: Vec2) -> Vec<Spot> {
        let mut spots = if self.flat && is_line(&self.bounds) {
            beside_line(&self.bounds, self.lens, half)
        } else if !self.flat && is_sheet(&self.bounds) {
            // A plane of a volume's: its label stands with the plane, not with the volume.
            beside_box(&self.bounds, self.lens, half, false, false)
        } else if self.shape.is_empty() {
            // A primitive that a label lies in is not seen.
            let inside = self.flat && !matches!(self.place, Some(Place::Prim(_)));
            beside_box(&self.bounds, self.lens, half, self.flat, inside)
        } else {
            let within = if self.all && self.is_place() { all_over(&self.shape, half) } else { Vec::new() };
            beside_shape(&self.shape, half, self.flat).into_iter().chain(within).collect()
        };
        // In a crowd there is room only further off.
        spots.extend(self.page.into_iter().flat_map(|page| further(page, half)));
        spots
    }

    /// The point of it that lies nearest to its label.
    pub(super) fn nearest(&self, spot: Spot) -> Option<Vec2> {
        match self.page {
            Some(_) if self.all && self.is_place() => on_outline(&self.shape, spot),
            Some(page) => Some(page.nearest(spot.center())),
            None if !self.drawn.is_empty() => nearest(self.drawn.iter().copied(), spot),
            // A box in space is drawn by its edges.
            None if !self.flat && !is_sheet(&self.bounds) && self.shape.is_empty() => {
                on_box(&self.bounds, self.lens, spot)
            }
            None => None,
        }
    }

    /// Whether a label would stand beside it. In a box there is room for its label: beside it lies another place.
    pub(super) fn is_beside(&self, spot: Spot) -> bool {
        let Some(page) = self.page.filter(|_| self.is_place()) else { return false };
        let (whole, shared) = match self.all {
            true => (area(&self.shape), area(&polygon(&self.shape, spot.min, spot.max))),
            false => (page.shared(page), page.shared(spot)),
        };
        shared < whole.min(spot.shared(spot)) * 0.9
    }

    fn is_place(&self) -> bool {
        matches!(self.place, Some(Place::Cell(_) | Place::Node(_)))
    }
}
