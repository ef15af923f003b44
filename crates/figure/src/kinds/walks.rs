//! One ray's walks through several structures, side by side and in step along the ray.

use raystep_accel::{Aabb, Place, Prims};

use super::{Instant, Kind};
use crate::moments::{Moment, Walk};
use crate::page::Figure;
use crate::panes::{Ask, Pane, Walker, walks, worth_of_walks as worth};
use crate::words::{Fact, VolumeName};

/// Several walks of one ray. Their events are put in one order: that of t along the ray.
pub struct Walks<'a> {
    /// The walks, each with the name of its structure and a few words.
    pub walks: Vec<(String, String, Walk<'a>)>,
    /// Whose event each step is, and which of its events.
    pub order: &'a [(usize, usize)],
    /// How far along the ray each step has come.
    pub reached: &'a [f32],
}

impl Walks<'_> {
    /// Whose event a step is, the first one being 1.
    fn event(&self, step: usize) -> Option<(usize, usize)> {
        self.order.get(step.checked_sub(1)?).copied()
    }

    fn walkers<'a>(&'a self, moments: &'a [Moment]) -> Vec<Walker<'a>> {
        let pairs = self.walks.iter().zip(moments);
        pairs.map(|((name, note, walk), moment)| Walker { name, note, walk, moment }).collect()
    }
}

impl Kind for Walks<'_> {
    fn len(&self) -> usize {
        self.order.len()
    }

    fn start(&self) -> Instant {
        let moments: Vec<Moment> = self.walks.iter().map(|(.., walk)| Moment::start(walk)).collect();
        Instant::new(moments)
    }

    fn advance(&self, at: &mut Instant, step: usize) {
        let moments = at.state_mut::<Vec<Moment>>();
        let done: usize = moments.iter().map(|moment| moment.step).sum();
        for &(walker, event) in self.order.get(done..step.min(self.order.len())).unwrap_or_default() {
            if let (Some(moment), Some((.., walk))) = (moments.get_mut(walker), self.walks.get(walker)) {
                moment.advance(walk, event + 1);
            }
        }
    }

    fn panes(&self) -> Vec<Pane> {
        vec![Pane::Picture]
    }

    fn draw(&self, at: &Instant, pane: Pane, ask: &Ask<'_>) -> Option<Figure> {
        if pane != Pane::Picture {
            return None;
        }
        let moments: &Vec<Moment> = at.state();
        let done: usize = moments.iter().map(|moment| moment.step).sum();
        let t = done.checked_sub(1).and_then(|index| self.reached.get(index)).copied().unwrap_or(f32::NAN);
        Some(walks(&self.walkers(moments), t, ask))
    }

    fn worth(&self, at: &Instant, ask: &Ask<'_>) -> Option<f32> {
        let moments: &Vec<Moment> = at.state();
        Some(worth(&self.walkers(moments), ask))
    }

    fn fact(&self, step: usize) -> Option<&dyn Fact> {
        let (walker, event) = self.event(step)?;
        let event = self.walks.get(walker)?.2.events.get(event)?;
        Some(event)
    }

    fn whose(&self, step: usize) -> Option<&str> {
        let (walker, _) = self.event(step)?;
        self.walks.get(walker).map(|(name, ..)| name.as_str())
    }

    fn prims(&self) -> &Prims {
        self.walks.first().map_or(const { &Prims::Few(Vec::new()) }, |(.., walk)| walk.prims)
    }

    fn volume(&self) -> VolumeName {
        self.walks.first().map_or(VolumeName::BOX, |(.., walk)| VolumeName::of(walk.structure))
    }

    fn bounds(&self, at: &Instant, place: Place) -> Aabb {
        let walker = self.event(at.step()).map_or(0, |(walker, _)| walker);
        self.walks.get(walker).map_or(Aabb::EMPTY, |(.., walk)| walk.bounds(place))
    }

    fn tally(&self, at: &Instant) -> String {
        let moments: &Vec<Moment> = at.state();
        let tests =
            self.walks.iter().zip(moments).map(|((name, ..), moment)| format!("{name} {}", moment.cost.prim_tests));
        format!("tested: {}", tests.collect::<Vec<_>>().join(", "))
    }
}
