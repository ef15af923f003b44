//! The building of a structure.

use glam::Vec2;
use raystep_accel::{Aabb, Grow, HandCut, Place, Primitives, Prims, Structure};

use super::detail::{Detail, small};
use super::{Guess, Instant, Kind};
use crate::moments::{Build, GrowMoment};
use crate::page::{Figure, Look};
use crate::panes::{
    Ask, CutLine, Pane, TreeView, beside_plots, bin_of_build, cells_of_build, changed_height, changed_of_build, costs,
    cut_line, cut_to, depth_of_build, ghost_of_build, legend, listing, space_of_build_to, stack_of_build,
    symbol_of_build_at, timeline_of_build, tree_height, tree_of_build, tree_with, weighed, weighing, work_of_build,
};
use crate::theme::Role;
use crate::words::{Fact, Symbol, VolumeName, counted};
use crate::world::{Depth, Form, Space};

impl Build<'_> {
    /// Whether ways to divide a node are weighed against each other: an octree has no choice, a cut in the middle is the
    /// only one, and sets that are joined are compared otherwise.
    fn weighs(&self) -> bool {
        let mut weighed = self.events.iter().filter(|event| matches!(event, Grow::Weigh { .. })).map(Grow::place);
        let mut last = weighed.next();
        weighed.any(|place| last.replace(place) == Some(place))
    }

    /// Whether sets are joined along a curve.
    fn follows_a_curve(&self) -> bool {
        matches!(self.structure, Structure::Bvh(_))
            && self.events.iter().any(|event| matches!(event, Grow::Rank { .. }))
    }

    /// The box of the set that the one under consideration has just chosen; empty if it has chosen none.
    fn chosen(&self, moment: &GrowMoment) -> Aabb {
        let Some(Grow::Prefer { nearest, .. }) = moment.event else { return Aabb::EMPTY };
        moment.nodes.get(&nearest).map_or(Aabb::EMPTY, |node| node.bounds)
    }

    /// Whether a flat scene is divided by planes along the axes, or by shares of its primitives.
    fn weighs_in_the_plane(&self) -> bool {
        self.flat && matches!(self.structure, Structure::Kd(_) | Structure::Bvh(_)) && self.weighs()
    }
}

impl Kind for Build<'_> {
    fn len(&self) -> usize {
        self.events.len()
    }

    fn start(&self) -> Instant {
        Instant::new(GrowMoment::default())
    }

    fn advance(&self, at: &mut Instant, step: usize) {
        at.state_mut::<GrowMoment>().advance(self.events, step);
    }

    fn panes(&self) -> Vec<Pane> {
        let mut panes = vec![Pane::Tree, Pane::Cells, Pane::Listing, Pane::Changed, Pane::Work, Pane::Timeline];
        // The cells of a grid are not weighed, and are filled one after the other.
        if self.structure.node_count() > 0 {
            panes.extend([Pane::RulerLine, Pane::Stack, Pane::Bin]);
        }
        if self.structure.node_count() > 0 && self.weighs() {
            panes.push(Pane::Ruler);
        }
        // What is weighed stands on the same axes as the space that it divides.
        if self.weighs_in_the_plane() {
            panes.retain(|pane| !matches!(pane, Pane::Ruler | Pane::RulerLine));
            panes.push(Pane::Picture);
        }
        panes
    }

    fn draw(&self, at: &Instant, pane: Pane, ask: &Ask<'_>) -> Option<Figure> {
        let moment: &GrowMoment = at.state();
        let Ask { size, ref look, hide, .. } = *ask;
        let nodes = self.structure.node_count() > 0;
        let ruler = nodes && !self.weighs_in_the_plane();
        Some(match pane {
            Pane::Picture if self.weighs_in_the_plane() => weighing(self, moment, &legible(ask)),
            // Between two weighings there is nothing but the tree so far.
            Pane::RulerLine if ruler && moment.weighed.is_empty() => {
                tree_of_build(moment, &TreeView::default(), size, look)
            }
            Pane::Ruler | Pane::RulerLine if ruler && self.weighs() => {
                costs(moment, VolumeName::of(self.structure), hide, size, look)
            }
            Pane::Tree => {
                let touched = self.change(moment).map(|change| self.touched(moment, change)).unwrap_or_default();
                tree_with(moment, touched, ask.view.unwrap_or(&TreeView::default()), size, look)
            }
            Pane::Cells => cells_of_build(self, moment, size, look),
            Pane::Listing => listing("Build", ask.lines, self.fact(at.step()), self.flat, size, look),
            Pane::Stack if nodes => stack_of_build(self, moment, size, look),
            Pane::Bin if nodes => bin_of_build(self, moment, size, look),
            Pane::Work => work_of_build(self, moment, size, look),
            Pane::Timeline => timeline_of_build(self, at.step(), ask),
            _ => return None,
        })
    }

    fn is_bare(&self, at: &Instant, pane: Pane) -> bool {
        let moment: &GrowMoment = at.state();
        pane == Pane::Ruler && moment.node.is_none() && moment.weighed.is_empty()
    }

    fn fact(&self, step: usize) -> Option<&dyn Fact> {
        let event = self.events.get(step.checked_sub(1)?)?;
        Some(event)
    }

    fn space(&self, at: &Instant, depth: Depth) -> Option<Space> {
        let mut space = space_of_build_to(self, at.state(), depth);
        if self.weighs_in_the_plane() {
            beside_plots(&mut space, at.state());
        }
        Some(space)
    }

    fn depth(&self, at: &Instant, asked: Depth) -> Depth {
        depth_of_build(self, at.state(), asked)
    }

    fn deepest(&self) -> Option<u32> {
        let deepest = self.nodes.levels().deepest() as u32;
        (!self.flat && deepest > 0).then_some(deepest)
    }

    fn outline(&self, at: &Instant, place: Place) -> Vec<Form> {
        let bounds = Kind::bounds(self, at, place);
        match place {
            Place::Prim(prim) if prim.index() < self.prims.len() => vec![Form::Prim(prim)],
            Place::Node(node) => self.look(at.state(), node, bounds),
            Place::Cell(_) if !bounds.is_empty() => vec![Form::Box(bounds)],
            _ => Vec::new(),
        }
    }

    fn ghost(&self, before: &Instant, at: &Instant, space: &mut Space) {
        ghost_of_build(self, before.state(), at.state(), space);
    }

    fn changed(&self, before: &Instant, at: &Instant, ask: &Ask<'_>) -> Option<Figure> {
        Some(changed_of_build(self, before.state(), at.state(), ask.hide, ask.size, &ask.look))
    }

    fn symbol_at(&self, at: &Instant, ask: &Ask<'_>, point: Vec2) -> Option<Symbol> {
        symbol_of_build_at(self, at.step(), ask, point)
    }

    fn prims(&self) -> &Prims {
        self.prims
    }

    fn flat(&self) -> bool {
        self.flat
    }

    fn volume(&self) -> VolumeName {
        VolumeName::of(self.structure)
    }

    fn signs(&self) -> &'static [(Role, &'static str)] {
        match () {
            () if self.structure.grid().is_some() => legend::OF_GRID,
            () if !self.changes.is_empty() => legend::OF_CHANGE,
            () if self.follows_a_curve() => legend::OF_CURVE,
            () => match self.structure {
                Structure::Octree(_) => &legend::OF_OCTREE,
                Structure::Bsp(_) => &legend::OF_BSP,
                _ => &legend::OF_BUILD,
            },
        }
    }

    fn best(&self) -> Option<Pane> {
        Pane::best_of(self.structure).filter(|pane| *pane != Pane::Slabs)
    }

    fn height(&self, pane: Pane, look: &Look) -> Option<f32> {
        match pane {
            Pane::Ruler => Some(look.text * 13.0),
            Pane::RulerLine => Some(look.text * 9.0),
            Pane::Tree => tree_height(self.nodes, look),
            // Where it is cut, how many on each side with which chance, the cost and the least.
            Pane::Changed if self.weighs() => Some(changed_height(6, look)),
            _ => None,
        }
    }

    fn stacked(&self, at: &Instant) -> usize {
        let moment: &GrowMoment = at.state();
        if self.joins() { moment.apart().len().min(JOINED) } else { moment.waiting.len() }
    }

    fn here(&self, at: &Instant) -> Option<Place> {
        at.state::<GrowMoment>().event.map(|event| event.place())
    }

    fn bounds(&self, at: &Instant, place: Place) -> Aabb {
        let moment: &GrowMoment = at.state();
        match place {
            Place::World => moment.bounds,
            Place::Node(node) => moment.nodes.get(&node).map_or(Aabb::EMPTY, |node| node.bounds),
            Place::Cell(cell) => self.structure.grid().map_or(Aabb::EMPTY, |grid| grid.cell_bounds(cell)),
            Place::Prim(prim) => self.prims.bounds(prim),
        }
    }

    /// The primitive that is put somewhere, or the node under consideration, with what it has chosen.
    fn detail(&self, at: &Instant) -> Option<Detail> {
        let moment: &GrowMoment = at.state();
        // Some of what lies around a primitive shows where it is; a node has its neighbours.
        let (place, bounds, air) = match (moment.prim, moment.node.and_then(|node| moment.nodes.get_key_value(&node))) {
            (Some(prim), None) => (Place::Prim(prim), self.prims.bounds(prim), 0.6),
            (_, Some((id, node))) => (Place::Node(*id), node.bounds.union(self.chosen(moment)), 0.15),
            _ => return None,
        };
        let bounds = small(bounds, self.structure.bounds(), air)?;
        Some(Detail { title: format!("{place}, from near"), bounds, focus: bounds.center() })
    }

    fn tally(&self, at: &Instant) -> String {
        let moment: &GrowMoment = at.state();
        if let Some(change) = self.change(moment) {
            return counted(self.touched(moment, change).len() as u64, "node looked at", "nodes looked at");
        }
        let stored = counted(moment.tally.stored, "reference stored", "references stored");
        weighed(self, moment).map_or_else(|| stored.clone(), |weighed| format!("{weighed} · {stored}"))
    }

    fn cut_line(&self, at: &Instant, ask: &Ask<'_>) -> Option<CutLine> {
        cut_line(self, at.state(), &legible(ask)).filter(|_| self.weighs_in_the_plane())
    }

    fn cut_to(&self, at: &Instant, ask: &Ask<'_>, point: Vec2) -> Option<HandCut> {
        cut_to(self, at.state(), &legible(ask), point).filter(|_| self.weighs_in_the_plane())
    }

    fn guess(&self, at: &mut Instant, guesses: &[Guess]) {
        let plane = |guess: &Guess| guess.plane.map(|(across, at)| (across, at, guess.text.clone()));
        at.state_mut::<GrowMoment>().guesses = guesses.iter().filter_map(plane).collect();
    }
}

/// Of the sets that are left to be joined there is room for so many.
const JOINED: usize = 4;

/// Letters that leave the picture of a weighing its room.
fn legible<'a>(ask: &Ask<'a>) -> Ask<'a> {
    let Ask { size, look, .. } = *ask;
    Ask { look: Look { text: look.text.min(size.x / 42.0).min(size.y / 28.0), ..look }, ..*ask }
}
