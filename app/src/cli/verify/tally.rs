//! What was counted.

use std::collections::BTreeMap;
use std::fmt;
use std::ops::AddAssign;

use raystep_accel::{Hit, PrimId, Ray};

use super::{counted, percent, thousands};

/// What came of some rays.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Tally {
    /// Scenes shot at, rounds apart.
    pub(super) scenes: u64,
    /// Rays shot.
    pub(super) rays: u64,
    /// Rays for which brute force found something.
    pub(super) hits: u64,
    /// For each kind of structure, answers compared and differences found.
    pub(super) kinds: BTreeMap<&'static str, (u64, u64)>,
    /// Brute force before the referee.
    pub(super) referee: Sample,
}

impl Tally {
    /// Answers that were not those of brute force.
    pub(super) fn differences(&self) -> u64 {
        self.kinds.values().map(|(_, differences)| differences).sum()
    }
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Tally) {
        self.scenes += other.scenes;
        self.rays += other.rays;
        self.hits += other.hits;
        for (kind, (answers, differences)) in other.kinds {
            let own = self.kinds.entry(kind).or_default();
            *own = (own.0 + answers, own.1 + differences);
        }
        self.referee += other.referee;
    }
}

/// Brute force in single precision against the referee in double precision.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Sample {
    rays: u64,
    /// Only the referee hits something.
    lost: u64,
    /// Only brute force hits something.
    gained: u64,
    /// Both hit, at different places.
    elsewhere: u64,
    /// The largest relative error of t where both hit at the same place.
    error: f64,
}

/// Two t further apart than this part of them are different places.
const APART: f64 = 1e-4;

impl Sample {
    /// One ray's answers compared.
    pub(super) fn of(ray: &Ray, found: Option<Hit>, right: Option<(f64, PrimId)>) -> Sample {
        let mut sample = Sample { rays: 1, ..Sample::default() };
        match (found, right) {
            (None, None) => {}
            (None, Some(_)) => sample.lost = 1,
            (Some(_), None) => sample.gained = 1,
            (Some(found), Some((t, _))) => {
                // A hit at the origin itself has no relative error but that of the origin's own coordinates.
                let (o, d) = (ray.o.as_dvec3(), ray.d.as_dvec3());
                let least = o.length() * f64::from(f32::EPSILON) / d.length();
                let error = (f64::from(found.t) - t).abs() / t.abs().max(least).max(f64::from(f32::MIN_POSITIVE));
                if error > APART {
                    sample.elsewhere = 1;
                } else {
                    sample.error = error;
                }
            }
        }
        sample
    }
}

impl AddAssign for Sample {
    fn add_assign(&mut self, other: Sample) {
        self.rays += other.rays;
        self.lost += other.lost;
        self.gained += other.gained;
        self.elsewhere += other.elsewhere;
        self.error = self.error.max(other.error);
    }
}

impl fmt::Display for Sample {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let differ = self.lost + self.gained + self.elsewhere;
        writeln!(
            f,
            "Brute force against double precision, on {}: {} ({}) differ, as a ray at an edge may \
             ({} only in double precision, {} only in brute force, {} elsewhere); \
             where both hit, t differs by {:.1e} of itself at most.",
            counted(self.rays, "ray"),
            thousands(differ),
            percent(differ, self.rays),
            thousands(self.lost),
            thousands(self.gained),
            thousands(self.elsewhere),
            self.error
        )
    }
}
