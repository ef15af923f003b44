//! A ray's walk.

use glam::Vec2;
use raystep_accel::{Aabb, AnyBvh, Cost, Place, Primitives, Prims, Structure, Visit};

use super::detail::{Detail, small};
use super::{Guess, Instant, Kind};
use crate::moments::{Moment, Walk};
use crate::page::{Figure, Look};
use crate::panes::{
    Ask, Pane, RulerScale, TreeView, bin, bytes, bytes_height, cells, changed, ghost, legend, listing, ruler_height,
    ruler_line_height, ruler_line_of, ruler_of, ruler_scale, slabs, space_to, stack, symbol_at, tests_of, timeline,
    tree, tree_height, work,
};
use crate::theme::Role;
use crate::words::{Fact, Symbol, VolumeName, whole};
use crate::world::{Depth, Form, Space};

impl Kind for Walk<'_> {
    fn len(&self) -> usize {
        self.events.len()
    }

    fn start(&self) -> Instant {
        Instant::new(Moment::start(self))
    }

    fn advance(&self, at: &mut Instant, step: usize) {
        at.state_mut::<Moment>().advance(self, step);
    }

    fn panes(&self) -> Vec<Pane> {
        let mut panes = vec![
            Pane::Ruler,
            Pane::RulerLine,
            Pane::Tree,
            Pane::Cells,
            Pane::Slabs,
            Pane::Listing,
            Pane::Changed,
            Pane::Work,
            Pane::Timeline,
        ];
        if matches!(self.structure, Structure::Slab(_) | Structure::Kd(_) | Structure::HashedGrid(_)) {
            panes.push(Pane::Bytes);
        }
        // Without nodes nothing ever waits.
        if self.structure.node_count() > 0 {
            panes.extend([Pane::Stack, Pane::Bin]);
        }
        panes
    }

    fn draw(&self, at: &Instant, pane: Pane, ask: &Ask<'_>) -> Option<Figure> {
        let moment: &Moment = at.state();
        let Ask { size, ref look, hide, .. } = *ask;
        Some(match pane {
            Pane::Ruler => ruler_of(self, moment, ask.part, hide, size, look),
            Pane::RulerLine => ruler_line_of(self, moment, ask.part, hide, size, look),
            Pane::Tree => tree(self, moment, ask.view.unwrap_or(&TreeView::default()), size, look),
            Pane::Cells => cells(self, moment, hide, size, look),
            Pane::Slabs => slabs(self, moment, hide, size, look),
            Pane::Bytes if self.panes().contains(&Pane::Bytes) => bytes(self, moment, hide, size, look),
            Pane::Listing => listing("Walk", ask.lines, self.fact(at.step()), self.flat, size, look),
            Pane::Stack if self.structure.node_count() > 0 => stack(self, moment, size, look),
            Pane::Bin if self.structure.node_count() > 0 => bin(moment, size, look),
            Pane::Work => work(self, moment, ask.beside, size, look),
            Pane::Timeline => timeline(self, at.step(), ask),
            _ => return None,
        })
    }

    fn fact(&self, step: usize) -> Option<&dyn Fact> {
        let event = self.events.get(step.checked_sub(1)?)?;
        Some(event)
    }

    fn space(&self, at: &Instant, depth: Depth) -> Option<Space> {
        Some(space_to(self, at.state(), depth))
    }

    fn deepest(&self) -> Option<u32> {
        let deepest = self.nodes.levels().deepest() as u32;
        (!self.flat && deepest > 0).then_some(deepest)
    }

    fn outline(&self, at: &Instant, place: Place) -> Vec<Form> {
        let bounds = Kind::bounds(self, at, place);
        match place {
            Place::Prim(prim) if prim.index() < self.prims.len() => vec![Form::Prim(prim)],
            Place::Node(node) => self.nodes.look(self.structure, node, bounds, self.flat),
            Place::Cell(_) if !bounds.is_empty() => vec![Form::Box(bounds)],
            _ => Vec::new(),
        }
    }

    fn ghost(&self, before: &Instant, at: &Instant, space: &mut Space) {
        ghost(self, before.state(), at.state(), space);
    }

    fn changed(&self, before: &Instant, at: &Instant, ask: &Ask<'_>) -> Option<Figure> {
        Some(changed(self, before.state(), at.state(), ask.hide, ask.size, &ask.look))
    }

    fn scale(&self, at: &Instant, pane: Pane, ask: &Ask<'_>) -> Option<RulerScale> {
        let on_line = pane == Pane::RulerLine;
        let is_ruler = on_line || pane == Pane::Ruler;
        is_ruler.then(|| ruler_scale(self, at.state(), ask.part, on_line, ask.size, &ask.look))
    }

    fn symbol_at(&self, at: &Instant, ask: &Ask<'_>, point: Vec2) -> Option<Symbol> {
        symbol_at(self, at.step(), ask, point)
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
        match (self.structure, self.flat) {
            (Structure::Bvh(AnyBvh::Sphere(_)), true) => &legend::OF_SPHERES,
            (Structure::Bvh(AnyBvh::Sphere(_)), false) => &legend::OF_SOLID_SPHERES,
            (_, true) => &legend::OF_WALK,
            (_, false) => &legend::OF_SOLID_WALK,
        }
    }

    fn best(&self) -> Option<Pane> {
        Pane::best_of(self.structure)
    }

    fn height(&self, pane: Pane, look: &Look) -> Option<f32> {
        match pane {
            Pane::Ruler => Some(ruler_height(self, look)),
            Pane::RulerLine => Some(ruler_line_height(self, look)),
            Pane::Tree => tree_height(self.nodes, look),
            Pane::Bytes => bytes_height(self, look),
            _ => None,
        }
    }

    fn stacked(&self, at: &Instant) -> usize {
        at.state::<Moment>().stack.len()
    }

    fn here(&self, at: &Instant) -> Option<Place> {
        let moment: &Moment = at.state();
        match &moment.inside {
            Some(inside) => Some(Place::Prim(inside.instance)),
            None => moment.here.or(moment.event.map(|event| event.place())),
        }
    }

    fn bounds(&self, _: &Instant, place: Place) -> Aabb {
        Walk::bounds(self, place)
    }

    /// The nearest hit when the walk is over, else the node or the cell where it stands.
    fn detail(&self, at: &Instant) -> Option<Detail> {
        let moment: &Moment = at.state();
        let over = matches!(moment.event, Some(Visit::End { .. }));
        // What is thrown away is seen once more.
        let dropped = match moment.event {
            Some(Visit::Drop { node, .. }) => Some(Place::Node(node)),
            _ => None,
        };
        let (title, place) = match (over, moment.best, moment.here.or(dropped)) {
            (true, Some(hit), _) => ("the hit, from near".to_owned(), Place::Prim(hit.prim)),
            (false, _, Some(here @ (Place::Node(_) | Place::Cell(_)))) => (format!("{here}, from near"), here),
            _ => return None,
        };
        // Some of what lies around it shows where it is.
        let bounds = small(Walk::bounds(self, place), self.world(), if over { 0.4 } else { 0.1 })?;
        // A large triangle may be hit where it is seen well enough.
        let hit = moment.best.filter(|_| over).map(|hit| self.ray.at(hit.t));
        Some(Detail { title, bounds, focus: hit.unwrap_or(bounds.center()) })
    }

    fn cost(&self, at: &Instant) -> Option<Cost> {
        Some(at.state::<Moment>().cost)
    }

    fn tally(&self, at: &Instant) -> String {
        let (tests, says) = tests_of(self, at.state::<Moment>());
        format!("{} {says}", whole(tests))
    }

    fn guess(&self, at: &mut Instant, guesses: &[Guess]) {
        let places = guesses.iter().filter_map(|guess| Some((guess.place?, guess.text.clone())));
        at.state_mut::<Moment>().guesses = places.collect();
    }
}
