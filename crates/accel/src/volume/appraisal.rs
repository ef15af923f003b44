//! What a volume is worth, slide 52: how closely it follows a shape, and what that costs.

use glam::Vec3;

use super::{Hull, KDop, Outline, Volume, fit_around};
use crate::geometry::digits::length;
use crate::{
    Aabb, Accel, Axes, BvhVolume, Interval, List, Measure, Obb, Observer, Place, PrimId, Primitives, Random, Ray,
    Sphere, Visit,
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
    /// How many planes bound it; 0 of a sphere.
    pub planes: u32,
    /// How many slabs, faces or equations one test of it asks for, in the mean.
    pub cuts: f64,
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

    /// The surface of such a volume around `prims`, of which there must be some.
    pub fn outline(prims: &impl Primitives, volume: BvhVolume) -> Outline {
        fit_around(prims, volume, Axes::Xyz, &mut ()).expect("nobody cancels")
    }

    /// The share of rays that meet the volume and none of its primitives, among those that meet it.
    pub fn vain_share(&self) -> f32 {
        if self.met == 0 { 0.0 } else { self.in_vain as f32 / self.met as f32 }
    }
}

/// The box around all primitives.
fn around_all(prims: &impl Primitives) -> Aabb {
    (0..prims.len() as u32).map(PrimId).fold(Aabb::EMPTY, |all, prim| all.union(prims.bounds(prim)))
}

fn fit<V: Volume>(prims: &impl Primitives) -> V {
    let ids = (0..prims.len() as u32).map(PrimId);
    V::fit(prims, ids, &around_all(prims), Axes::Xyz, &mut ()).expect("nobody cancels")
}

/// Counts what cuts a ray in the test of a volume.
#[derive(Default)]
struct Cuts(u64);

impl Observer<Visit> for Cuts {
    fn on(&mut self, event: Visit) {
        let cuts =
            matches!(event, Visit::Divide { .. } | Visit::Parallel { .. } | Visit::Roots { .. } | Visit::Clip { .. });
        self.0 += u64::from(cuts);
    }
}

fn appraise<V: Volume>(prims: &impl Primitives, rays: u32, seed: u64) -> Appraisal {
    let bounds = around_all(prims);
    let volume: V = fit(prims);
    let (mut met, mut in_vain, mut shot, mut cuts) = (0, 0, 0_u32, Cuts::default());
    let mut random = Random::new(seed);
    let radius = length(bounds.extent()) * 0.5;
    for _ in 0..rays {
        let (from, to) = (on_sphere(&mut random) * radius, on_sphere(&mut random) * radius);
        let Ok(ray) = Ray::new(bounds.center() + from, to - from) else { continue };
        shot += 1;
        if !volume.meet(&ray, Interval::new(0.0, f32::INFINITY), Place::World, &mut cuts).is_empty() {
            met += 1;
            in_vain += u32::from(!List.occluded(prims, &ray, &mut ()));
        }
    }
    Appraisal {
        content: volume.content(),
        area: volume.measure(Measure::Area),
        bytes: volume.bytes(),
        planes: volume.planes(),
        cuts: cuts.0 as f64 / f64::from(shot.max(1)),
        met,
        in_vain,
    }
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
