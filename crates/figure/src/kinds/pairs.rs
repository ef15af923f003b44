//! Pairs of objects and their tests: a matrix of pairs, the two in space, and the steps of the test.

use raystep_accel::{Aabb, Arrangement, Place, Trial};

use super::{Instant, Kind};
use crate::page::{Figure, Look};
use crate::panes::{
    Ask, Grip, Pane, Tried, listing, matrix_of_pairs, matrix_of_pairs_height, numbers, space_of_pair, steps,
};
use crate::theme::Role;
use crate::words::Fact;
use crate::world::{Depth, Space};

/// Tests of pairs of objects, one after the other.
#[derive(Clone, Copy, Debug)]
pub struct Pairs<'a> {
    /// How the objects lie, in the order in which they are tested.
    pub cases: &'a [Arrangement],
    /// What happens.
    pub events: &'a [Trial],
}

/// What the marks of space mean.
const SIGNS: &[(Role, &str)] = &[
    (Role::Ray, "ray"),
    (Role::Value, "first object"),
    (Role::Seen, "second object"),
    (Role::Live, "what is left, or the first one's shadow"),
    (Role::Here, "this step"),
    (Role::Plane, "plane"),
    (Role::Tick, "number of this step"),
    (Role::Hit, "they meet"),
    (Role::Best, "where they meet"),
    (Role::Missed, "apart"),
    (Role::Wrong, "decides that they are apart"),
];

impl<'a> Pairs<'a> {
    /// The test that a step belongs to, as far as it has come by then; before the first step, the first one.
    fn tried(&self, step: usize) -> Option<Tried<'a>> {
        let done = &self.events[..step.min(self.events.len())];
        let Some(last) = done.last() else {
            return Some(Tried { lies: self.cases.first()?, done });
        };
        let same = |trial: &&Trial| (trial.pair, trial.case) == (last.pair, last.case);
        let many = done.iter().rev().take_while(same).count();
        let lies = self.cases.iter().find(|lies| (lies.pair, lies.case) == (last.pair, last.case))?;
        Some(Tried { lies, done: &done[done.len() - many..] })
    }

    fn at(&self, at: &Instant) -> Option<Tried<'a>> {
        self.tried(*at.state())
    }
}

impl Kind for Pairs<'_> {
    fn len(&self) -> usize {
        self.events.len()
    }

    fn start(&self) -> Instant {
        Instant::new(0_usize)
    }

    fn advance(&self, at: &mut Instant, step: usize) {
        let done = at.state_mut::<usize>();
        *done = step.min(self.events.len()).max(*done);
    }

    fn panes(&self) -> Vec<Pane> {
        vec![Pane::Matrix, Pane::Ruler, Pane::RulerLine, Pane::Listing, Pane::Work]
    }

    fn draw(&self, at: &Instant, pane: Pane, ask: &Ask<'_>) -> Option<Figure> {
        let step: usize = *at.state();
        let Ask { size, ref look, .. } = *ask;
        Some(match pane {
            Pane::Matrix => matrix_of_pairs(self.cases, self.events, step, ask),
            Pane::Ruler | Pane::RulerLine => numbers(&self.tried(step)?, size, look),
            Pane::Listing => listing("Test", ask.lines, self.fact(step), false, size, look),
            Pane::Work => {
                let tried = self.tried(step)?;
                let tried = tried.done.iter().enumerate().skip(1);
                let done: Vec<(usize, &dyn Fact)> =
                    tried.map(|(index, trial)| -> (usize, &dyn Fact) { (index, trial) }).collect();
                steps("The test so far", &done, size, look)
            }
            _ => return None,
        })
    }

    fn fact(&self, step: usize) -> Option<&dyn Fact> {
        let event = self.events.get(step.checked_sub(1)?)?;
        Some(event)
    }

    fn space(&self, at: &Instant, _: Depth) -> Option<Space> {
        Some(space_of_pair(&self.at(at)?))
    }

    fn flat(&self) -> bool {
        false
    }

    fn signs(&self) -> &'static [(Role, &'static str)] {
        SIGNS
    }

    fn best(&self) -> Option<Pane> {
        Some(Pane::Matrix)
    }

    fn height(&self, pane: Pane, look: &Look) -> Option<f32> {
        match pane {
            Pane::Matrix => Some(matrix_of_pairs_height(self.cases, look)),
            Pane::RulerLine => Some(look.text * 8.0),
            _ => None,
        }
    }

    fn bounds(&self, at: &Instant, _: Place) -> Aabb {
        self.at(at).map_or(Aabb::EMPTY, |tried| space_of_pair(&tried).bounds)
    }

    fn tally(&self, at: &Instant) -> String {
        let pair = self.at(at).and_then(|tried| raystep_accel::PAIRS.get(tried.lies.pair as usize));
        pair.map_or_else(String::new, |pair| pair.name.replace('-', " "))
    }

    fn grip(&self, at: &Instant) -> Option<Grip> {
        let lies = self.at(at)?.lies;
        let at = lies.bodies[0].middle();
        Some(Grip { pair: lies.pair, case: lies.case, at, moved: lies.moved, name: lies.bodies[0].kind()?.word() })
    }
}
