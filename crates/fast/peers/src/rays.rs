//! The rays, the same from run to run.

use glam::{Vec2, Vec3};
use raystep_accel::{Hit, Random, Ray, pinhole};

use crate::scenes::{Stage, bounds};

/// What is asked of rays of a kind.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Ask {
    Nearest,
    Any,
}

/// Rays of one kind.
#[derive(Clone)]
pub struct Rays {
    pub name: &'static str,
    pub ask: Ask,
    pub rays: Vec<Ray>,
}

/// All kinds: `many` rays each, a power of four.
pub fn kinds(stage: &Stage, many: usize, nearest: impl Fn(&[Ray]) -> Vec<Option<Hit>>) -> [Rays; 3] {
    let primary = primary(stage, many);
    let shadow = shadow(stage, &primary, &nearest(&primary));
    [
        Rays { name: "primary", ask: Ask::Nearest, rays: primary },
        Rays { name: "random", ask: Ask::Nearest, rays: random(stage, many) },
        Rays { name: "shadow", ask: Ask::Any, rays: shadow },
    ]
}

/// A picture as wide as high, in tiles of tiles: four pixels, four fours of them, and so on.
fn primary(stage: &Stage, many: usize) -> Vec<Ray> {
    let side = (many as f64).sqrt() as u32;
    let even = |number: usize| (0..16).fold(0u32, |bits, i| bits | ((number >> (2 * i)) as u32 & 1) << i);
    let pixel = |number: usize| {
        let at = Vec2::new(even(number) as f32 + 0.5, even(number >> 1) as f32 + 0.5) / side as f32 * 2.0 - 1.0;
        let view = &stage.view;
        pinhole(view.eye, view.target, view.up, view.fov_degrees, at, 1.0).expect("the view is a view")
    };
    (0..side as usize * side as usize).map(pixel).collect()
}

/// From anywhere in the box around everything, in any direction.
fn random(stage: &Stage, many: usize) -> Vec<Ray> {
    let bounds = bounds(&stage.mesh);
    let random = &mut Random::new(3);
    let mut rays = Vec::with_capacity(many);
    while rays.len() < many {
        let mut anywhere = || Vec3::new(random.unit(), random.unit(), random.unit());
        let o = bounds.min + bounds.extent() * anywhere();
        let d = anywhere() * 2.0 - 1.0;
        if (0.01..=1.0).contains(&d.length()) {
            rays.push(Ray::new(o, d.normalize()).expect("a direction"));
        }
    }
    rays
}

/// From where primary rays hit, in their order, to a lamp above the eye's side. As many as there are primary rays:
/// where too few hit, they are taken again, to a second lamp, a third ...
fn shadow(stage: &Stage, primary: &[Ray], hits: &[Option<Hit>]) -> Vec<Ray> {
    let bounds = bounds(&stage.mesh);
    let size = bounds.extent().max_element();
    let back = (stage.view.eye - stage.view.target).with_z(0.0).normalize();
    let random = &mut Random::new(4);
    let mut rays = Vec::with_capacity(primary.len());
    while rays.len() < primary.len() {
        let around = Vec3::new(random.range(-0.4, 0.4), random.range(-0.4, 0.4), random.range(0.4, 0.8));
        let lamp = stage.view.target + (back * 0.2 + around) * size;
        let before = rays.len();
        for (ray, hit) in primary.iter().zip(hits) {
            let Some(hit) = hit else { continue };
            if rays.len() == primary.len() {
                break;
            }
            let o = ray.at(hit.t * 0.999);
            rays.push(Ray::new(o, lamp - o).and_then(|ray| ray.within(0.0, 1.0)).expect("a way to the lamp"));
        }
        assert!(rays.len() > before, "no primary ray hits anything");
    }
    rays
}
