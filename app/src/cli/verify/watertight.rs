//! Rays from inside a closed sphere: each must hit it.

use std::time::Instant;

use glam::Vec3;
use rayon::prelude::*;
use raystep_accel::{Aabb, Accel, List, Mesh, PrimId, Primitives, Prims, Random, Ray};
use raystep_figure::whole;
use raystep_scene::Scene;
use raystep_scene::trial::sphere;

use super::contender::{Built, Contender};
use super::{counted, stopped, unfinished};
use crate::cli::progress::bar;
use crate::fault::Fault;
use crate::files;

/// What rays aim at, in turn.
const AIMS: [&str; 4] = ["a vertex", "an edge", "a direction at random", "along an axis"];
/// So many rays are one piece of work for a thread.
const BLOCK: u64 = 4096;
/// One ray in so many is tried by brute force too.
const SAMPLE: u64 = 1024;

/// Rays shot and rays lost, for each of [`AIMS`], and by brute force.
type Lost = ([(u64, u64); AIMS.len()], (u64, u64));

/// Shoots `rays` from inside each sphere at a structure of each kind.
pub(super) fn run(rays: u64, seed: u64, kinds: &[&'static str]) -> Result<(), Fault> {
    let wrong = |error: &dyn std::fmt::Display| Fault::new(error.to_string());
    let begun = Instant::now();
    let (mut all_shot, mut all_lost) = (0, 0);
    for name in sphere::NAMES {
        let scene = Scene::named(name).map_err(|error| wrong(&error))?;
        let Prims::Mesh(mesh) = &scene.prims else { continue };
        let center = scene.bounds().center();
        files::print(&format!(
            "{}, {} triangles around ({}, {}, {}): {} at each of {}\n",
            scene.name,
            whole(mesh.len() as u64),
            center.x,
            center.y,
            center.z,
            counted(rays, "ray"),
            kinds.join(", ")
        ))?;
        let mut structures = Vec::new();
        for kind in kinds {
            // A builder breaks off only when all of this is stopped.
            structures.extend(Contender::spelt(kind)?.build(&scene));
        }
        if stopped() {
            break;
        }
        let bar = bar(rays, "rays");
        let blocks: Vec<Lost> = (0..rays.div_ceil(BLOCK))
            .into_par_iter()
            .map(|block| {
                let numbers = block * BLOCK..rays.min((block + 1) * BLOCK);
                bar.inc(numbers.end - numbers.start);
                if stopped() { Lost::default() } else { shoot(&scene.prims, center, &structures, seed, numbers) }
            })
            .collect();
        bar.finish_and_clear();
        let (aimed, brute) = blocks.into_iter().fold(Lost::default(), sum);
        for (aim, (shot, lost)) in AIMS.iter().zip(aimed) {
            files::print(&format!("  aimed at {aim:<24}{:>16} rays{:>8} lost\n", whole(shot), whole(lost)))?;
            all_shot += shot;
            all_lost += lost;
        }
        files::print(&format!("  a sample, by brute force{:>17} rays{:>8} lost\n", whole(brute.0), whole(brute.1)))?;
        all_lost += brute.1;
    }
    let what = if stopped() { "Stopped" } else { "Done" };
    files::print(&format!("{what} after {:.1} s: {} lost.\n", begun.elapsed().as_secs_f64(), whole(all_lost)))?;
    if all_lost > 0 {
        return Err(Fault::new(format!("{} left a closed sphere", counted(all_lost, "ray"))));
    }
    if stopped() {
        return Err(unfinished(all_shot, rays * sphere::NAMES.len() as u64));
    }
    Ok(())
}

fn shoot(prims: &Prims, center: Vec3, structures: &[Built], seed: u64, numbers: std::ops::Range<u64>) -> Lost {
    let Prims::Mesh(mesh) = prims else { return Lost::default() };
    let mut random = Random::new(Random::new(seed ^ numbers.start).bits());
    let (mut aimed, mut brute) = Lost::default();
    for number in numbers {
        if stopped() {
            break;
        }
        let aim = (number % AIMS.len() as u64) as usize;
        let Some(ray) = ray(mesh, center, aim, &mut random) else { continue };
        let lost = structures.iter().filter(|structure| structure.answers(prims, &ray).0.is_none()).count();
        aimed[aim] = (aimed[aim].0 + 1, aimed[aim].1 + u64::from(lost > 0));
        if number % SAMPLE < AIMS.len() as u64 {
            let lost = List.intersect(mesh, &ray, &mut ()).is_none();
            brute = (brute.0 + 1, brute.1 + u64::from(lost));
        }
        if lost > 0 {
            files::say(&format!("lost {ray:?}"));
        }
    }
    (aimed, brute)
}

/// From well inside the sphere.
fn ray(mesh: &Mesh, center: Vec3, aim: usize, random: &mut Random) -> Option<Ray> {
    let within = Aabb::new(Vec3::splat(-0.5), Vec3::splat(0.5));
    let mut anywhere = || within.min + within.extent() * Vec3::new(random.unit(), random.unit(), random.unit());
    let (o, other) = (center + anywhere(), anywhere());
    let triangle = mesh.triangle(PrimId(random.below(mesh.len() as u32)));
    let d = match aim {
        0 => triangle.a - o,
        1 => triangle.a.lerp(triangle.b, random.unit()) - o,
        2 => other,
        _ => Vec3::AXES[random.below(3) as usize] * [1.0, -1.0][random.below(2) as usize],
    };
    Ray::new(o, d).ok()
}

fn sum((mut aimed, brute): Lost, (more, by_brute): Lost) -> Lost {
    for (own, more) in aimed.iter_mut().zip(more) {
        *own = (own.0 + more.0, own.1 + more.1);
    }
    (aimed, (brute.0 + by_brute.0, brute.1 + by_brute.1))
}
