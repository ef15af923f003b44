//! Rays over scenes, in rounds: the same rays for a seed, however many threads there are.

use std::path::Path;

use indicatif::ProgressBar;
use rayon::prelude::*;
use raystep_accel::{Accel, List, Primitives, Random, Ray, Rule, Structure};
use raystep_scene::trial::{rays::Targets, scenes::cases_of, sphere};
use raystep_scene::{Scene, scene_names};

use super::kept::{self, Difference};
use super::tally::{Sample, Tally};
use super::{referee, stopped};

/// What is shot at what.
pub(super) struct Campaign<'a> {
    /// The structures, with the line that spells each.
    pub(super) rules: Vec<(&'static str, Rule)>,
    /// Decides scenes and rays.
    pub(super) seed: u64,
    /// How many rays in all.
    pub(super) rays: u64,
    /// Where rays that show a difference are kept.
    pub(super) keep: &'a Path,
}

/// After so many rays the random scenes are drawn anew.
const ROUND: u64 = 2_000_000;
/// So many rays are one piece of work for a thread.
const BLOCK: u64 = 1020;
/// A scene that would get fewer rays than this is left out.
const FEWEST: u64 = 60;
/// Brute force would spend all its time in a scene of more primitives.
const LARGEST: usize = 30_000;
/// One ray in so many goes to the referee too.
const SAMPLE: u64 = 32;

/// A scene and its structures.
struct Stage<'a> {
    scene: &'a Scene,
    structures: Vec<(&'static str, Structure)>,
    targets: Targets,
    seed: u64,
}

impl Campaign<'_> {
    /// Shoots all rays, or as many as there is time for before Ctrl+C.
    pub(super) fn run(&self, bar: &ProgressBar) -> Tally {
        let mut tally = Tally::default();
        for round in 0..self.rays.div_ceil(ROUND) {
            let rays = ROUND.min(self.rays - round * ROUND);
            let scenes = scenes(self.seed.wrapping_add(round));
            for (i, (scene, share)) in scenes.iter().zip(shares(&scenes, rays)).enumerate() {
                if share > 0 && !stopped() {
                    let seed = mixed([self.seed, round, i as u64]);
                    tally += self.shoot(scene, seed, share, bar);
                }
            }
        }
        tally
    }

    fn shoot(&self, scene: &Scene, seed: u64, rays: u64, bar: &ProgressBar) -> Tally {
        let build = |&(line, rule): &(&'static str, Rule)| {
            let rule = if scene.flat { rule.flat() } else { rule };
            Structure::build(&scene.prims, &rule, &mut ()).ok().map(|structure| (line, structure))
        };
        let structures: Vec<_> = self.rules.par_iter().filter_map(build).collect();
        let all: Vec<&Structure> = structures.iter().map(|(_, structure)| structure).collect();
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
        let (mut tally, mut random) = (Tally::default(), Random::new(mixed([stage.seed, block, 0])));
        let prims = &stage.scene.prims;
        for number in numbers {
            // A few make no ray, as their direction is zero: then it is the next one's turn.
            let Some(ray) = (number as u32..).find_map(|i| stage.targets.ray(prims, i, &mut random)) else { continue };
            let right = List.intersect(prims, &ray, &mut ());
            tally.rays += 1;
            tally.hits += u64::from(right.is_some());
            for (line, structure) in &stage.structures {
                let found = kept::compare(structure, prims, &ray, right);
                let kind = line.split_whitespace().next().unwrap_or_default();
                let (answers, differences) = tally.kinds.entry(kind).or_default();
                *answers += 2;
                if let Err(found) = found {
                    *differences += 1;
                    Difference { scene: &stage.scene.name, line, ray, right, found }.keep(self.keep);
                }
            }
            if number.is_multiple_of(SAMPLE) && has_no_end(&ray) {
                tally.referee += Sample::of(&ray, right, referee::nearest(prims, &ray));
            }
        }
        tally
    }
}

/// The referee rounds otherwise: a ray that ends at its very hit is not for him.
fn has_no_end(ray: &Ray) -> bool {
    ray.t_min == 0.0 && ray.t_max == f32::INFINITY
}

/// The random scenes of a seed, then the spheres and what is shipped and not too large.
fn scenes(seed: u64) -> Vec<Scene> {
    let random = cases_of(seed).into_iter().map(|case| case.name);
    let fixed = sphere::NAMES.map(str::to_owned).into_iter().chain(scene_names());
    let scenes = random.chain(fixed).filter_map(|name| Scene::named(&name).ok());
    scenes.filter(|scene| scene.prims.len() <= LARGEST).collect()
}

/// How many rays each scene gets: brute force takes about the same time in each, so that a hundred small
/// scenes weigh as much as a hundred large ones.
fn shares(scenes: &[Scene], rays: u64) -> Vec<u64> {
    let weight = |scene: &Scene| 1.0 / (scene.prims.len() as f64 + 40.0);
    let all: f64 = scenes.iter().map(weight).sum();
    let mut shares: Vec<u64> = scenes.iter().map(|scene| (rays as f64 * weight(scene) / all) as u64).collect();
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
        let scenes = scenes(0);
        for rays in [1, 100, 10_000, 12_345_678] {
            assert_eq!(shares(&scenes, rays).iter().sum::<u64>(), rays);
        }
        assert!(shares(&scenes, ROUND).iter().all(|share| *share >= FEWEST));
    }

    #[test]
    fn a_seed_decides_everything() {
        let rules: Vec<_> = raystep_scene::trial::rules::rules().step_by(4).collect();
        let tally = |seed, threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let campaign = Campaign { rules: rules.clone(), seed, rays: 4000, keep: Path::new("unused") };
            pool.install(|| campaign.run(&ProgressBar::hidden()))
        };
        assert_eq!(tally(7, 1), tally(7, 3));
        assert_ne!(tally(7, 3), tally(8, 3));
    }
}
