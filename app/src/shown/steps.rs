//! Which steps one stops at.

use raystep_accel::{Event, Grain};
use raystep_lesson::Tape;

/// The events of a tape as steps: step `n` is the state after `n` events.
#[derive(Clone, Copy, Debug)]
pub struct Steps<'a> {
    /// What happened.
    pub tape: &'a Tape,
    /// Whether events that concern z are passed over.
    pub flat: bool,
    /// The steps of the slide's beats: every grain stops there, since something is said there.
    pub beats: &'a [Option<usize>],
}

impl Steps<'_> {
    /// The last step.
    pub fn last(&self) -> usize {
        self.tape.len()
    }

    /// Whether stepping by this grain stops at a step. The two ends always count.
    pub fn stops(&self, step: usize, grain: Grain) -> bool {
        if step == 0 || step == self.last() || self.beats.contains(&Some(step)) {
            return true;
        }
        self.tape.event(step - 1).is_some_and(|event| self.shown(&event) && event.grain() as u8 >= grain as u8)
    }

    /// The next stop after a step; the step itself at the end.
    pub fn next(&self, step: usize, grain: Grain) -> usize {
        (step + 1..=self.last()).find(|&step| self.stops(step, grain)).unwrap_or(step)
    }

    /// The stop before a step; the step itself at the beginning.
    pub fn previous(&self, step: usize, grain: Grain) -> usize {
        (0..step).rev().find(|&step| self.stops(step, grain)).unwrap_or(step)
    }

    /// Whether a step is shown at all: a flat scene passes over what concerns z.
    pub fn shows(&self, step: usize) -> bool {
        step.checked_sub(1).and_then(|index| self.tape.event(index)).is_some_and(|event| self.shown(&event))
    }

    fn shown(&self, event: &Event) -> bool {
        !(self.flat && event.concerns_z())
    }
}

/// The grain that is coarser by one; visits are the coarsest.
pub(crate) fn coarser(grain: Grain) -> Grain {
    match grain {
        Grain::Arithmetic => Grain::Decision,
        Grain::Decision | Grain::Visit => Grain::Visit,
    }
}

/// What a grain is called on its drop-down.
pub(crate) fn grain_name(grain: Grain) -> &'static str {
    match grain {
        Grain::Arithmetic => "by arithmetic",
        Grain::Decision => "by decision",
        Grain::Visit => "by visit",
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use raystep_accel::{Axis, NodeId, Place, PrimId, Ray, Visit};
    use raystep_lesson::WalkTape;

    use super::*;

    fn tape() -> Tape {
        let place = Place::Node(NodeId(0));
        let order = |axis| Visit::Order { place, axis, t1: 0.0, t2: 1.0, swapped: false };
        let events = vec![
            order(Axis::X.into()),
            order(Axis::Z.into()),
            Visit::Enter { place, t_near: 0.0, t_far: 1.0, prims: 1, leaf: true },
            Visit::Test { prim: PrimId(0), t: 0.5, hit: true },
            Visit::End { why: raystep_accel::Ending::Exhausted, hit: true, t: 0.5 },
        ];
        let ray = Ray::new(Vec3::ZERO, Vec3::X).unwrap();
        Tape::Walk(WalkTape { ray, events, lost: 0, hit: None })
    }

    #[test]
    fn coarse_steps_pass_over_fine_ones_and_flat_scenes_over_z() {
        let tape = tape();
        let walk = |grain, flat| {
            let steps = Steps { tape: &tape, flat, beats: &[] };
            let mut at = vec![0];
            while *at.last().unwrap() < steps.last() {
                at.push(steps.next(*at.last().unwrap(), grain));
            }
            at
        };
        assert_eq!(walk(Grain::Arithmetic, false), [0, 1, 2, 3, 4, 5]);
        assert_eq!(walk(Grain::Arithmetic, true), [0, 1, 3, 4, 5]);
        assert_eq!(walk(Grain::Decision, true), [0, 3, 4, 5]);
        assert_eq!(walk(Grain::Visit, true), [0, 3, 5]);
    }

    #[test]
    fn every_grain_stops_at_beats() {
        let tape = tape();
        let steps = Steps { tape: &tape, flat: true, beats: &[None, Some(1), Some(4)] };
        let stops = |grain| (0..=5).filter(|&step| steps.stops(step, grain)).collect::<Vec<_>>();
        assert_eq!(stops(Grain::Arithmetic), [0, 1, 3, 4, 5]);
        assert_eq!(stops(Grain::Decision), [0, 1, 3, 4, 5]);
        assert_eq!(stops(Grain::Visit), [0, 1, 3, 4, 5]);
    }

    #[test]
    fn back_is_the_way_forth() {
        let tape = tape();
        let steps = Steps { tape: &tape, flat: true, beats: &[Some(3), None] };
        for grain in [Grain::Arithmetic, Grain::Decision, Grain::Visit] {
            for step in (0..steps.last()).filter(|&step| steps.stops(step, grain)) {
                assert_eq!(steps.previous(steps.next(step, grain), grain), step);
            }
        }
        assert_eq!((steps.previous(0, Grain::Visit), steps.next(5, Grain::Visit)), (0, 5));
    }
}
