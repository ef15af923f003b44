//! Rays over scenes, in rounds: the same rays for a seed, however many threads there are.

use std::path::Path;

use indicatif::ProgressBar;
use rayon::prelude::*;
use raystep_accel::{Primitives, Prims, Random, Ray, Structure};
use raystep_scene::trial::rays::{AIMS, Targets};
use raystep_scene::trial::{crowd, scenes::cases_of, sphere};
use raystep_scene::{Scene, scene_names};

use super::contender::{Built, Contender};
use super::kept::{self, Difference};
use super::tally::{Sample, Tally};
use super::{referee, stopped};

/// What is shot at what.
pub(super) struct Campaign<'a> {
    /// The structures, with the line that spells each.
    pub(super) rules: Vec<(&'static str, Contender)>,
    /// Decides scenes and rays.
    pub(super) seed: u64,
    /// How many rays in all.
    pub(super) rays: u64,
    /// Whether each ray is asked of one structure of each kind only: of another one for the next ray.
    pub(super) in_turn: bool,
    /// Where rays that show a difference are kept.
    pub(super) keep: &'a Path,
}

/// After so many rays the scenes of a seed are drawn anew.
const ROUND: u64 = 2_000_000;
/// So many rays are one piece of work for a thread.
const BLOCK: u64 = 54 * AIMS as u64;
/// A scene that would get fewer rays than this is left out.
const FEWEST: u64 = 60;
/// Brute force would spend all its time in a scene of more primitives.
const LARGEST: usize = 30_000;
/// One ray in so many goes to the referee too.
const SAMPLE: u64 = 32;
/// From so many rays on a crowd that nothing can part is tried as well, by its share of them or at least by some.
const CROWDED: u64 = 100_000;
const LEAST: u64 = 19;

/// A scene and its structures.
struct Stage<'a> {
    scene: &'a Scene,
    structures: Vec<(&'static str, Built)>,
    targets: Targets,
    seed: u64,
}

impl Stage<'_> {
    /// All structures, or only the one of each kind whose turn it is.
    fn asked(&self, turn: Option<usize>) -> impl Iterator<Item = &(&'static str, Built)> {
        let kinds = self.structures.chunk_by(|(a, _), (b, _)| kind_of(a) == kind_of(b));
        kinds.flat_map(move |kind| match turn {
            Some(turn) => std::slice::from_ref(&kind[turn % kind.len()]),
            None => kind,
        })
    }
}

/// The kind of structure that a line spells.
fn kind_of(line: &'static str) -> &'static str {
    line.split_whitespace().next().unwrap_or_default()
}

impl Campaign<'_> {
    /// Shoots all rays, or as many as there is time for before Ctrl+C.
    pub(super) fn run(&self, bar: &ProgressBar) -> Tally {
        let mut tally = Tally::default();
        let standing = self.fitting(standing());
        let mut owed = vec![0; standing.len()];
        for round in 0..self.rays.div_ceil(ROUND) {
            if stopped() {
                break;
            }
            let rays = ROUND.min(self.rays - round * ROUND);
            let drawn = self.fitting(drawn(self.seed.wrapping_add(round)));
            let all: Vec<&Scene> = drawn.iter().chain(&standing).collect();
            let mut shares = shares(&all, rays);
            for (owed, share) in owed.iter_mut().zip(shares.split_off(drawn.len())) {
                *owed += share;
            }
            tally += self.shoot_all(&drawn, &shares, round, bar);
        }
        // Scenes that stay the same get what all rounds left to them at once: some take long to build.
        tally += self.shoot_all(&standing, &owed, u64::MAX, bar);
        tally += self.shoot_into_the_crowd(bar);
        tally
    }

    /// The scenes over which some of the structures can stand.
    fn fitting(&self, scenes: Vec<Scene>) -> Vec<Scene> {
        let fits = |scene: &Scene| self.rules.iter().any(|(_, contender)| contender.fits(scene));
        scenes.into_iter().filter(fits).collect()
    }

    /// A few rays more at a crowd, by one structure of each kind: that it is built at all is the test.
    fn shoot_into_the_crowd(&self, bar: &ProgressBar) -> Tally {
        let Some(scene) = named([crowd::NAME.to_owned()].into_iter(), usize::MAX).pop() else {
            return Tally::default();
        };
        if self.rays < CROWDED || stopped() {
            return Tally::default();
        }
        let mut rules = self.rules.clone();
        rules.dedup_by_key(|(line, _)| kind_of(line));
        let rays = (self.rays / scene.prims.len() as u64).max(LEAST);
        bar.inc_length(rays);
        Campaign { rules, ..*self }.shoot(&scene, self.seed, rays, bar)
    }

    /// Shoots at each scene its share of a round's rays.
    fn shoot_all(&self, scenes: &[Scene], shares: &[u64], round: u64, bar: &ProgressBar) -> Tally {
        let mut tally = Tally::default();
        for (i, (scene, &share)) in scenes.iter().zip(shares).enumerate() {
            if share > 0 && !stopped() {
                tally += self.shoot(scene, mixed([self.seed, round, i as u64]), share, bar);
            }
        }
        tally
    }

    fn shoot(&self, scene: &Scene, seed: u64, rays: u64, bar: &ProgressBar) -> Tally {
        let build = |(line, contender): &(&'static str, Contender)| Some((*line, contender.build(scene)?));
        let structures: Vec<_> = self.rules.par_iter().filter_map(build).collect();
        if stopped() {
            return Tally::default();
        }
        let all: Vec<&Structure> = structures.iter().filter_map(|(_, built)| built.textbook()).collect();
        let targets = Targets::of(&scene.prims, scene.flat, &all);
        let stage = Stage { scene, structures, targets, seed };
        // In the order of the blocks, whichever thread shot them.
        let blocks: Vec<Tally> = (0..rays.div_ceil(BLOCK))
            .into_par_iter()
            .map(|block| {
                let numbers = block * BLOCK..rays.min((block + 1) * BLOCK);
                bar.inc(numbers.end - numbers.start);
                if stopped() { Tally::default() } else { self.block(&stage, block, numbers) }
            })
            .collect();
        let mut tally = Tally { scenes: 1, ..Tally::default() };
        for block in blocks {
            tally += block;
        }
        tally
    }

    fn block(&self, stage: &Stage<'_>, block: u64, numbers: std::ops::Range<u64>) -> Tally {
        let [mut random, mut turns] = [0, 1].map(|own| Random::new(mixed([stage.seed, block, own])));
        let mut tally = Tally::default();
        let prims = &stage.scene.prims;
        for number in numbers {
            if stopped() {
                break;
            }
            // A few make no ray, as their direction is zero: then it is the next one's turn.
            let Some(ray) = (number as u32..).find_map(|i| stage.targets.ray(prims, i, &mut random)) else { continue };
            let right = prims.brute_force(&ray);
            tally.rays += 1;
            tally.hits += u64::from(right.is_some());
            let turn = self.in_turn.then(|| turns.bits() as usize);
            for (line, structure) in stage.asked(turn) {
                let found = kept::compare(structure, prims, &ray, right);
                let kind = kind_of(line);
                let (answers, differences) = tally.kinds.entry(kind).or_default();
                *answers += 2;
                if let Err(found) = found {
                    *differences += 1;
                    Difference { scene: &stage.scene.name, line, ray, right, found }.keep(self.keep);
                }
            }
            if number.is_multiple_of(SAMPLE) && is_for_the_referee(prims, &ray) {
                let mut sample = Sample::of(prims, &ray, right, referee::nearest(prims, &ray));
                sample.riddle = sample.riddle.map(|ray| format!("{}, {ray}", stage.scene.name));
                tally.referee += sample;
            }
        }
        tally
    }
}

/// The referee rounds otherwise: a ray that ends at its very hit is not for him. And of an instance he would
/// see the box only.
fn is_for_the_referee(prims: &Prims, ray: &Ray) -> bool {
    ray.t_min == 0.0 && ray.t_max == f32::INFINITY && !matches!(prims, Prims::Instances(_))
}

/// The scenes that a seed draws by lot.
fn drawn(seed: u64) -> Vec<Scene> {
    named(cases_of(seed).into_iter().map(|case| case.name), LARGEST)
}

/// The scenes that are the same for every seed: the spheres and what is shipped.
fn standing() -> Vec<Scene> {
    named(sphere::NAMES.map(str::to_owned).into_iter().chain(scene_names()), LARGEST)
}

/// The scenes of these names that have no more than so many primitives.
fn named(names: impl Iterator<Item = String>, largest: usize) -> Vec<Scene> {
    let scenes = names.filter_map(|name| Scene::named(&name).ok());
    scenes.filter(|scene| scene.prims.len() <= largest).collect()
}

/// How many rays each scene gets: brute force takes about the same time in each, so that a hundred small
/// scenes weigh as much as a hundred large ones.
fn shares(scenes: &[&Scene], rays: u64) -> Vec<u64> {
    let weight = |scene: &&Scene| 1.0 / (scene.prims.len() as f64 + 40.0);
    let weights: Vec<f64> = scenes.iter().map(weight).collect();
    let all: f64 = weights.iter().sum();
    let mut shares: Vec<u64> = weights.iter().map(|weight| (rays as f64 * weight / all) as u64).collect();
    shares.iter_mut().filter(|share| **share < FEWEST).for_each(|share| *share = 0);
    // What is left over goes to the first scenes.
    let spent: u64 = shares.iter().sum();
    let kept = shares.iter().filter(|share| **share > 0).count().max(1) as u64;
    let mut over = rays - spent.min(rays);
    let each = over.div_ceil(kept);
    for share in shares.iter_mut().filter(|share| **share > 0) {
        let more = each.min(over);
        *share += more;
        over -= more;
    }
    if let Some(first) = shares.first_mut() {
        *first += over;
    }
    shares
}

/// One number that depends on all of them.
fn mixed(numbers: [u64; 3]) -> u64 {
    numbers.into_iter().fold(1, |mixed, number| Random::new(mixed ^ number).bits())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_ray_goes_to_a_scene() {
        let (drawn, standing) = (drawn(0), standing());
        let scenes: Vec<&Scene> = drawn.iter().chain(&standing).collect();
        for rays in [1, 100, 10_000, 12_345_678] {
            assert_eq!(shares(&scenes, rays).iter().sum::<u64>(), rays);
        }
        assert!(shares(&scenes, ROUND).iter().all(|share| *share >= FEWEST));
    }

    #[test]
    fn a_seed_decides_everything() {
        let rules: Vec<_> = Contender::all().step_by(4).collect();
        let tally = |seed, threads, in_turn| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let campaign = Campaign { rules: rules.clone(), seed, rays: 4000, in_turn, keep: Path::new("unused") };
            pool.install(|| campaign.run(&ProgressBar::hidden()))
        };
        for in_turn in [false, true] {
            assert_eq!(tally(7, 1, in_turn), tally(7, 3, in_turn));
            assert_ne!(tally(7, 3, in_turn), tally(8, 3, in_turn));
        }
        let answers = |in_turn| tally(7, 2, in_turn).kinds.into_iter().map(|(kind, (answers, _))| (kind, answers));
        let sum = |in_turn| answers(in_turn).map(|(_, answers)| answers).sum::<u64>();
        let all = 2 * tally(7, 2, true).rays;
        for (kind, answers) in answers(true) {
            // Fast structures stand over triangles alone: they are not asked in every scene.
            let fast = kind.starts_with("fast-");
            assert!(if fast { (1..=all).contains(&answers) } else { answers == all }, "{kind}: {answers} of {all}");
        }
        assert!(sum(false) > sum(true));
    }
}
