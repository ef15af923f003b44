//! What a volume is worth, slide 52: how closely it follows a shape, and what that costs.

use glam::Vec3;

use super::{Hull, KDop, Volume};
use crate::geometry::digits::length;
use crate::{
    Aabb, Accel, Axes, BvhVolume, Interval, List, Measure, Obb, Place, PrimId, Primitives, Random, Ray, Sphere,
};

/// One volume around all primitives of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Appraisal {
    /// How much room it encloses.
    pub content: f64,
    /// Its surface.
    pub area: f32,
    /// How much memory it takes.
    pub bytes: usize,
    /// How many of the rays meet it.
    pub met: u32,
    /// How many of those meet none of the primitives.
    pub in_vain: u32,
}

impl Appraisal {
    /// Fits a volume around `prims`, of which there must be some, and shoots `rays` at it: straight lines
    /// between seeded random points of a sphere around everything, the same ones for every volume.
    pub fn of(prims: &impl Primitives, volume: BvhVolume, rays: u32, seed: u64) -> Appraisal {
        match volume {
            BvhVolume::Sphere => appraise::<Sphere>(prims, rays, seed),
            BvhVolume::Aabb => appraise::<Aabb>(prims, rays, seed),
            BvhVolume::Obb => appraise::<Obb>(prims, rays, seed),
            BvhVolume::KDop6 => appraise::<KDop<0, 0>>(prims, rays, seed),
            BvhVolume::KDop14 => appraise::<KDop<0, 4>>(prims, rays, seed),
            BvhVolume::KDop18 => appraise::<KDop<4, 6>>(prims, rays, seed),
            BvhVolume::KDop26 => appraise::<KDop<0, 10>>(prims, rays, seed),
            BvhVolume::Hull => appraise::<Hull>(prims, rays, seed),
        }
    }

    /// The share of rays that meet the volume and none of its primitives, among those that meet it.
    pub fn vain_share(&self) -> f32 {
        if self.met == 0 { 0.0 } else { self.in_vain as f32 / self.met as f32 }
    }
}

fn appraise<V: Volume>(prims: &impl Primitives, rays: u32, seed: u64) -> Appraisal {
    let ids = || (0..prims.len() as u32).map(PrimId);
    let bounds = ids().fold(Aabb::EMPTY, |all, prim| all.union(prims.bounds(prim)));
    let volume = V::fit(prims, ids(), &bounds, Axes::Xyz, &()).expect("nobody cancels");
    let (mut met, mut in_vain) = (0, 0);
    let mut random = Random::new(seed);
    let radius = length(bounds.extent()) * 0.5;
    for _ in 0..rays {
        let (from, to) = (on_sphere(&mut random) * radius, on_sphere(&mut random) * radius);
        let Ok(ray) = Ray::new(bounds.center() + from, to - from) else { continue };
        if !volume.meet(&ray, Interval::new(0.0, f32::INFINITY), Place::World, &mut ()).is_empty() {
            met += 1;
            in_vain += u32::from(!List.occluded(prims, &ray, &mut ()));
        }
    }
    Appraisal { content: volume.content(), area: volume.measure(Measure::Area), bytes: volume.bytes(), met, in_vain }
}

/// A direction, all equally likely: the first of some random points that lies in the unit ball.
fn on_sphere(random: &mut Random) -> Vec3 {
    loop {
        let p = Vec3::new(random.range(-1.0, 1.0), random.range(-1.0, 1.0), random.range(-1.0, 1.0));
        let length = p.length_squared();
        if (0.01..=1.0).contains(&length) {
            return p.normalize();
        }
    }
}
