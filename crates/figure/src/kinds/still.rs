//! One step of a walk or of a build, and every picture of it.

use glam::Vec2;
use raystep_accel::{Aabb, Event, Place, Primitives};

use crate::moments::{Build, GrowMoment, Moment, Walk};
use crate::page::{Figure, Look};
use crate::panes::{
    ListingLine, TreeView, bytes, cells, cells_of_build, changed, changed_of_build, costs, ghost, ghost_of_build,
    legend, line_at, listing, ruler, ruler_height, ruler_line, ruler_line_height, slabs, space, space_of_build, stack,
    stack_of_build, symbol_at, symbol_of_build_at, tested, timeline, timeline_of_build, tree, tree_of_build, work,
    work_of_build,
};

use super::Instant;
use crate::theme::Role;
use crate::words::{Symbol, counted};
use crate::world::Space;

/// One step, with what it belongs to. Window and page draw this and need not know which of the two it is.
#[derive(Clone, Copy)]
pub enum Still<'a> {
    /// Of a walk.
    Walk(&'a Walk<'a>, &'a Moment),
    /// Of a build.
    Build(&'a Build<'a>, &'a GrowMoment),
}

impl Still<'_> {
    /// The event that it shows.
    pub fn event(&self) -> Option<Event> {
        match self {
            Still::Walk(_, moment) => moment.event.map(Event::Walk),
            Still::Build(_, moment) => moment.event.map(Event::Build),
        }
    }

    /// Whether the scene is flat.
    pub fn flat(&self) -> bool {
        match self {
            Still::Walk(walk, _) => walk.flat,
            Still::Build(build, _) => build.flat,
        }
    }

    /// What the part of space is called where it happens; nothing if that is everywhere or over.
    pub fn here(&self) -> Option<Place> {
        match self {
            Still::Walk(_, moment) => match &moment.inside {
                Some(inside) => Some(Place::Prim(inside.instance)),
                None => moment.here.or(moment.event.map(|event| event.place())),
            },
            Still::Build(_, moment) => moment.event.map(|event| event.place()),
        }
    }

    /// The box of a place as far as it is known.
    pub fn bounds(&self, place: Place) -> Aabb {
        match (self, place) {
            (Still::Walk(walk, _), place) => walk.bounds(place),
            (Still::Build(_, moment), Place::World) => moment.bounds,
            (Still::Build(_, moment), Place::Node(node)) => {
                moment.nodes.get(&node).map_or(Aabb::EMPTY, |node| node.bounds)
            }
            (Still::Build(build, _), Place::Cell(cell)) => {
                build.structure.grid().map_or(Aabb::EMPTY, |grid| grid.cell_bounds(cell))
            }
            (Still::Build(build, _), Place::Prim(prim)) => build.prims.bounds(prim),
        }
    }

    /// Space.
    pub fn space(&self) -> Space {
        match self {
            Still::Walk(walk, moment) => space(walk, moment),
            Still::Build(build, moment) => space_of_build(build, moment),
        }
    }

    /// The ruler of t, or the costs of the splits. While a question asks, what answers it is hidden.
    pub fn ruler(&self, hide: bool, size: Vec2, look: &Look) -> Figure {
        match self {
            Still::Walk(walk, moment) => ruler(walk, moment, hide, size, look),
            Still::Build(_, moment) => costs(moment, hide, size, look),
        }
    }

    /// Whether there is a ruler to show: the cells of a grid are not weighed.
    pub fn has_ruler(&self) -> bool {
        match self {
            Still::Walk(..) => true,
            Still::Build(build, _) => build.structure.node_count() > 0,
        }
    }

    /// The same on one line, for the far end of a lecture hall.
    pub fn ruler_line(&self, hide: bool, size: Vec2, look: &Look) -> Figure {
        match self {
            Still::Walk(walk, moment) => ruler_line(walk, moment, hide, size, look),
            // Between two weighings there is nothing but the tree so far.
            Still::Build(_, moment) if moment.weighed.is_empty() => {
                tree_of_build(moment, &TreeView::default(), size, look)
            }
            Still::Build(_, moment) => costs(moment, hide, size, look),
        }
    }

    /// How high that line is.
    pub fn ruler_line_height(&self, look: &Look) -> f32 {
        match self {
            Still::Walk(walk, _) => ruler_line_height(walk, look),
            Still::Build(..) => look.text * 9.0,
        }
    }

    /// How high the ruler or the costs are.
    pub fn ruler_height(&self, look: &Look) -> f32 {
        match self {
            Still::Walk(walk, _) => ruler_height(walk, look),
            Still::Build(..) => look.text * 13.0,
        }
    }

    /// The tree, finished or growing.
    pub fn tree(&self, view: &TreeView, size: Vec2, look: &Look) -> Figure {
        match self {
            Still::Walk(walk, moment) => tree(walk, moment, view, size, look),
            Still::Build(_, moment) => tree_of_build(moment, view, size, look),
        }
    }

    /// The cell where the walk stands, or the cells that a primitive is put into.
    pub fn cells(&self, hide: bool, size: Vec2, look: &Look) -> Figure {
        match self {
            Still::Walk(walk, moment) => cells(walk, moment, hide, size, look),
            Still::Build(build, moment) => cells_of_build(build, moment, size, look),
        }
    }

    /// The values that have changed since an earlier instant.
    pub fn changed(&self, before: &Instant, size: Vec2, look: &Look) -> Figure {
        match (self, before) {
            (Still::Walk(walk, moment), Instant::Walk(before)) => changed(walk, before, moment, size, look),
            (Still::Build(_, moment), Instant::Build(before)) => changed_of_build(before, moment, size, look),
            _ => Figure::new(size),
        }
    }

    /// Puts the outline of the place where an earlier instant stood below the marks of space.
    pub fn ghost(&self, before: &Instant, space: &mut Space) {
        match (self, before) {
            (Still::Walk(walk, moment), Instant::Walk(before)) => ghost(walk, before, moment, space),
            (Still::Build(build, moment), Instant::Build(before)) => ghost_of_build(build, before, moment, space),
            _ => {}
        }
    }

    /// The slab intervals; a build has none. While a question asks, what they come to is hidden.
    pub fn slabs(&self, hide: bool, size: Vec2, look: &Look) -> Figure {
        match self {
            Still::Walk(walk, moment) => slabs(walk, moment, hide, size, look),
            Still::Build(..) => Figure::new(size),
        }
    }

    /// The node where the walk stands, as it lies in memory; a build has none. `hide` leaves its fields empty.
    pub fn bytes(&self, hide: bool, size: Vec2, look: &Look) -> Figure {
        match self {
            Still::Walk(walk, moment) => bytes(walk, moment, hide, size, look),
            Still::Build(..) => Figure::new(size),
        }
    }

    /// What waits, with the current place on top if `here`.
    pub fn stack(&self, here: bool, size: Vec2, look: &Look) -> Figure {
        match self {
            Still::Walk(walk, moment) => stack(walk, moment, here, size, look),
            Still::Build(_, moment) => stack_of_build(moment, here, size, look),
        }
    }

    /// Whether there is a stack to show: the cells of a grid are filled one after the other.
    pub fn has_stack(&self) -> bool {
        let structure = match self {
            Still::Walk(walk, _) => walk.structure,
            Still::Build(build, _) => build.structure,
        };
        structure.node_count() > 0
    }

    /// How many rows its stack has.
    pub fn stacked(&self) -> usize {
        match self {
            Still::Walk(_, moment) => moment.stack.len(),
            Still::Build(_, moment) => moment.waiting.len(),
        }
    }

    /// The work so far, for a walk beside that of another.
    pub fn work(&self, beside: Option<(&str, u64)>, size: Vec2, look: &Look) -> Figure {
        match self {
            Still::Walk(walk, moment) => work(walk, moment, beside, size, look),
            Still::Build(build, moment) => work_of_build(build, moment, size, look),
        }
    }

    /// The work so far in a few words.
    pub fn tally(&self) -> String {
        match self {
            Still::Walk(walk, moment) => {
                let (tests, tested) = tested(walk.structure, walk.prims.len(), &moment.cost);
                format!("{tests} of {tested} tested")
            }
            Still::Build(_, moment) => {
                let tally = &moment.tally;
                let weighed = counted(tally.weighed, "split weighed", "splits weighed");
                let stored = counted(tally.stored, "reference stored", "references stored");
                if tally.weighed > 0 { format!("{weighed} · {stored}") } else { stored }
            }
        }
    }

    /// The algorithm with the line of this step.
    pub fn listing(&self, lines: &[ListingLine<'_>], size: Vec2, look: &Look) -> Figure {
        let (title, flat) = match self {
            Still::Walk(walk, _) => ("Walk", walk.flat),
            Still::Build(build, _) => ("Build", build.flat),
        };
        listing(title, lines, self.event().as_ref(), flat, size, look)
    }

    /// Which line of the listing stands at this height.
    pub fn line_at(&self, lines: &[ListingLine<'_>], size: Vec2, look: &Look, y: f32) -> Option<usize> {
        line_at(lines, self.event().as_ref(), self.flat(), size, look, y)
    }

    /// The symbol whose name stands at this point of the timeline's legend.
    pub fn symbol_at(&self, hide_ahead: bool, size: Vec2, look: &Look, point: Vec2) -> Option<Symbol> {
        match self {
            Still::Walk(walk, moment) => symbol_at(walk, moment.step, hide_ahead, size, look, point),
            Still::Build(build, moment) => symbol_of_build_at(build, moment.step, hide_ahead, size, look, point),
        }
    }

    /// The track of all steps.
    pub fn timeline(&self, hide_ahead: bool, size: Vec2, look: &Look) -> Figure {
        match self {
            Still::Walk(walk, moment) => timeline(walk, moment.step, hide_ahead, size, look),
            Still::Build(build, moment) => timeline_of_build(build, moment.step, hide_ahead, size, look),
        }
    }

    /// What the marks of space mean.
    pub fn legend(&self, space: &Space, size: Vec2, look: &Look) -> Figure {
        legend::legend(space, self.words(), size, look)
    }

    /// How much room a legend of this width has at every step, so that what stands beside it never moves.
    pub fn legend_room(width: f32, look: &Look) -> f32 {
        legend::legend_room(width, look)
    }

    /// How high a legend of this width becomes.
    pub fn legend_height(&self, space: &Space, width: f32, look: &Look) -> f32 {
        legend::legend_height(space, self.words(), width, look)
    }

    fn words(&self) -> &'static [(Role, &'static str)] {
        match self {
            Still::Walk(..) => legend::OF_WALK,
            Still::Build(..) => legend::OF_BUILD,
        }
    }
}
