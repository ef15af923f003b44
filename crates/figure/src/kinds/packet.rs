//! The walk of a packet: several rays that go through a tree together.

use raystep_accel::{Aabb, Cost, Place, Primitives, Prims};

use super::{Guess, Instant, Kind};
use crate::moments::{PacketMoment, PacketWalk};
use crate::page::{Figure, Look};
use crate::panes::{
    Ask, Pane, TreeView, bin_of_packet, legend, listing_of_packet, matrix, matrix_height, rulers, rulers_height,
    space_of_packet, stack_of_packet, tree_height, tree_of_packet,
};
use crate::theme::Role;
use crate::words::{Fact, VolumeName, counted, mask};
use crate::world::{Depth, Form, Space, SpaceMark};

impl Kind for PacketWalk<'_> {
    fn len(&self) -> usize {
        self.events.len()
    }

    fn start(&self) -> Instant {
        Instant::new(PacketMoment::start())
    }

    fn advance(&self, at: &mut Instant, step: usize) {
        at.state_mut::<PacketMoment>().advance(self, step);
    }

    fn panes(&self) -> Vec<Pane> {
        vec![Pane::Ruler, Pane::RulerLine, Pane::Tree, Pane::Listing, Pane::Stack, Pane::Bin, Pane::Work]
    }

    fn draw(&self, at: &Instant, pane: Pane, ask: &Ask<'_>) -> Option<Figure> {
        let moment: &PacketMoment = at.state();
        let Ask { size, ref look, hide, .. } = *ask;
        let there = self.rays.len();
        Some(match pane {
            Pane::Ruler => rulers(self, moment, hide, size, look),
            Pane::RulerLine => rulers(self, moment, hide, size, &Look { titles: false, ..*look }),
            Pane::Tree => tree_of_packet(self, moment, ask.view.unwrap_or(&TreeView::default()), size, look),
            Pane::Listing => {
                let lanes = moment.event.map(|event| event.lanes);
                listing_of_packet(ask.lines, self.fact(at.step()), lanes, there, self.flat, size, look)
            }
            Pane::Stack => stack_of_packet(self, moment, hide, size, look),
            Pane::Bin => bin_of_packet(moment, size, look),
            Pane::Work => matrix(self, moment, hide, size, look),
            _ => return None,
        })
    }

    fn fact(&self, step: usize) -> Option<&dyn Fact> {
        let event = self.events.get(step.checked_sub(1)?)?;
        Some(event)
    }

    fn space(&self, at: &Instant, depth: Depth) -> Option<Space> {
        Some(space_of_packet(self, at.state(), depth))
    }

    fn deepest(&self) -> Option<u32> {
        let deepest = self.nodes.levels().deepest() as u32;
        (!self.flat && deepest > 0).then_some(deepest)
    }

    fn outline(&self, _: &Instant, place: Place) -> Vec<Form> {
        match place {
            Place::Prim(prim) if prim.index() < self.prims.len() => vec![Form::Prim(prim)],
            Place::Node(node) => self.nodes.look(self.structure, node, PacketWalk::bounds(self, place), self.flat),
            _ => Vec::new(),
        }
    }

    fn ghost(&self, before: &Instant, at: &Instant, space: &mut Space) {
        let here = |at: &Instant| at.state::<PacketMoment>().here.map(|(node, _)| node);
        let Some(left) = here(before).filter(|left| here(at) != Some(*left)) else { return };
        let place = Place::Node(left);
        let forms = self.nodes.look(self.structure, left, PacketWalk::bounds(self, place), self.flat);
        let marks = forms.into_iter().map(|form| SpaceMark { form, role: Role::Ghost, place: Some(place) });
        space.marks.splice(0..0, marks);
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
        legend::OF_PACKET
    }

    fn best(&self) -> Option<Pane> {
        Some(Pane::Tree)
    }

    fn height(&self, pane: Pane, look: &Look) -> Option<f32> {
        match pane {
            Pane::Ruler => Some(rulers_height(self.rays.len(), look)),
            Pane::RulerLine => Some(rulers_height(self.rays.len(), &Look { titles: false, ..*look })),
            Pane::Tree => tree_height(self.nodes, look),
            Pane::Work => Some(matrix_height(self.rays.len(), look)),
            _ => None,
        }
    }

    fn stacked(&self, at: &Instant) -> usize {
        let moment: &PacketMoment = at.state();
        moment.stack.len() + usize::from(moment.taken.is_some())
    }

    fn here(&self, at: &Instant) -> Option<Place> {
        at.state::<PacketMoment>().here.map(|(node, _)| Place::Node(node))
    }

    fn bounds(&self, _: &Instant, place: Place) -> Aabb {
        PacketWalk::bounds(self, place)
    }

    fn cost(&self, at: &Instant) -> Option<Cost> {
        let moment: &PacketMoment = at.state();
        let (node_visits, prim_tests, skips) = (moment.fill.visits, moment.tests, moment.skips);
        Some(Cost { node_visits, prim_tests, skips, ..Cost::default() })
    }

    fn tally(&self, at: &Instant) -> String {
        let moment: &PacketMoment = at.state();
        let lanes = moment.here.map_or_else(String::new, |(_, lanes)| format!(" \u{b7} {}", mask(lanes)));
        let many = counted(moment.fill.visits, "node", "nodes");
        format!("{many}, lanes full {} of {}{lanes}", moment.fill.lane_visits, moment.fill.lanes)
    }

    fn guess(&self, at: &mut Instant, guesses: &[Guess]) {
        let places = guesses.iter().filter_map(|guess| Some((guess.place?, guess.text.clone())));
        at.state_mut::<PacketMoment>().guesses = places.collect();
    }
}
