//! What was counted.

use raystep_figure::whole;
use std::collections::BTreeMap;
use std::fmt;
use std::ops::AddAssign;

use raystep_accel::{Hit, PrimId, Primitives, Ray};

use super::cause::{CAUSES, cause};
use super::referee::{error, is_same};
use super::{counted, percent};

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
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Sample {
    rays: u64,
    /// Only the referee hits something.
    lost: u64,
    /// Only brute force hits something.
    gained: u64,
    /// Both hit, at different places.
    elsewhere: u64,
    /// How many differences have which of [`CAUSES`].
    causes: [u64; CAUSES.len()],
    /// The first ray that is not explained.
    pub(super) riddle: Option<String>,
    /// The largest relative error of t where both hit at the same place.
    error: f64,
}

impl Sample {
    /// One ray's answers compared: what brute force `found`, and what is `right`.
    pub(super) fn of(prims: &impl Primitives, ray: &Ray, found: Option<Hit>, right: Option<(f64, PrimId)>) -> Sample {
        let mut sample = Sample { rays: 1, ..Sample::default() };
        let found = found.map(|hit| (f64::from(hit.t), hit.prim));
        if is_same(ray, found, right, 0.0) {
            sample.error = found.zip(right).map_or(0.0, |(found, right)| error(ray, found.0, right.0, 0.0));
            return sample;
        }
        match (found, right) {
            (None, _) => sample.lost = 1,
            (_, None) => sample.gained = 1,
            _ => sample.elsewhere = 1,
        }
        let cause = cause(prims, ray, found, right);
        sample.causes[cause] = 1;
        if cause + 1 == CAUSES.len() {
            sample.riddle = Some(format!("{ray:?}"));
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
        self.causes.iter_mut().zip(other.causes).for_each(|(own, more)| *own += more);
        self.riddle = self.riddle.take().or(other.riddle);
        self.error = self.error.max(other.error);
    }
}

impl fmt::Display for Sample {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let differ = self.lost + self.gained + self.elsewhere;
        writeln!(
            f,
            "Brute force against double precision, on {}: {} ({}) differ \
             ({} only in double precision, {} only in brute force, {} elsewhere); \
             where both hit, t differs by {:.1e} of itself at most.",
            counted(self.rays, "ray"),
            whole(differ),
            percent(differ, self.rays),
            whole(self.lost),
            whole(self.gained),
            whole(self.elsewhere),
            self.error
        )?;
        if differ > 0 {
            writeln!(f, "Where they differ, brute force is")?;
        }
        for (cause, &rays) in CAUSES.iter().zip(&self.causes).filter(|(_, rays)| **rays > 0) {
            writeln!(f, "  {cause:<60}{:>12}{:>12}", whole(rays), percent(rays, differ))?;
        }
        if let Some(riddle) = &self.riddle {
            writeln!(f, "  the first of them: {riddle}")?;
        }
        Ok(())
    }
}
