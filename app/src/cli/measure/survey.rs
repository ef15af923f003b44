//! Counting what the rays of a picture cost.

use std::time::Instant;

use glam::{Vec2, Vec3};
use indicatif::ProgressBar;
use rayon::prelude::*;
use raystep_accel::{Aabb, Accel, Cost, Interval, Place, Primitives, Ray, Structure, slab};
use raystep_figure::Camera;

use crate::fault::Fault;

/// What one structure cost over all rays.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Survey {
    /// Rays shot.
    pub(super) rays: u64,
    /// Rays that meet the box around everything.
    pub(super) box_rays: u64,
    /// Rays that hit a primitive.
    pub(super) hit_rays: u64,
    /// What all of them cost.
    pub(super) all: Cost,
    /// Tests of rays that meet the box.
    pub(super) box_tests: u64,
    /// Tests of rays that hit.
    pub(super) hit_tests: u64,
}

impl Survey {
    /// Tests per ray.
    pub(super) fn tests_per_ray(&self) -> f64 {
        self.all.prim_tests as f64 / self.rays.max(1) as f64
    }

    /// Tests per ray that meets the box.
    pub(super) fn tests_per_box_ray(&self) -> f64 {
        self.box_tests as f64 / self.box_rays.max(1) as f64
    }

    /// Tests per ray that hits.
    pub(super) fn tests_per_hit_ray(&self) -> f64 {
        self.hit_tests as f64 / self.hit_rays.max(1) as f64
    }

    /// Nodes or cells entered, per ray.
    pub(super) fn visits_per_ray(&self) -> f64 {
        (self.all.node_visits + self.all.cell_steps) as f64 / self.rays.max(1) as f64
    }

    /// Volumes tested, per ray.
    pub(super) fn boxes_per_ray(&self) -> f64 {
        self.all.box_tests as f64 / self.rays.max(1) as f64
    }

    fn count(&mut self, cost: Cost, meets_box: bool, hits: bool) {
        self.rays += 1;
        self.all += cost;
        if meets_box {
            self.box_rays += 1;
            self.box_tests += cost.prim_tests;
        }
        if hits {
            self.hit_rays += 1;
            self.hit_tests += cost.prim_tests;
        }
    }

    fn with(mut self, other: Survey) -> Survey {
        self.rays += other.rays;
        self.box_rays += other.box_rays;
        self.hit_rays += other.hit_rays;
        self.all += other.all;
        self.box_tests += other.box_tests;
        self.hit_tests += other.hit_tests;
        self
    }
}

/// The rays of a picture, one through the middle of each pixel.
pub(super) fn rays(camera: &Camera, size: Vec2) -> Result<Vec<Ray>, Fault> {
    let (width, height) = (size.x as u32, size.y as u32);
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| Vec2::new(x as f32 + 0.5, y as f32 + 0.5)));
    let wrong = |error: raystep_accel::RayError| Fault::new(format!("the camera shoots no rays: {error}"));
    pixels.map(|pixel| camera.ray(pixel, size).map_err(wrong)).collect()
}

/// A shadow ray begins this part of its way to the light off the surface.
const OFF_SURFACE: f32 = 1e-4;

/// Shoots the rays and, with a light, from each hit a shadow ray.
pub(super) fn survey(
    structure: &Structure,
    prims: &(impl Primitives + Sync),
    bounds: &Aabb,
    rays: &[Ray],
    light: Option<Vec3>,
    bar: &ProgressBar,
) -> Survey {
    let meets_box = |ray: &Ray| {
        let within: Interval = slab(bounds, ray, ray.range(), Place::World, &mut ());
        !bounds.is_empty() && !within.is_empty()
    };
    let one = |ray: &Ray| {
        let (mut survey, mut cost) = (Survey::default(), Cost::default());
        let hit = structure.intersect(prims, ray, &mut cost);
        survey.count(cost, meets_box(ray), hit.is_some());
        if let (Some(light), Some(hit)) = (light, hit) {
            let from = ray.at(hit.t);
            let shadow = Ray::new(from, light - from).and_then(|ray| ray.within(OFF_SURFACE, 1.0));
            if let Ok(shadow) = shadow {
                let mut cost = Cost::default();
                let dark = structure.occluded(prims, &shadow, &mut cost);
                survey.count(cost, meets_box(&shadow), dark);
            }
        }
        bar.inc(1);
        survey
    };
    rays.par_iter().map(one).reduce(Survey::default, Survey::with)
}

/// Runs `build` and says how many milliseconds it took.
pub(super) fn timed<T>(build: impl FnOnce() -> T) -> (T, f64) {
    let begun = Instant::now();
    let built = build();
    (built, begun.elapsed().as_secs_f64() * 1e3)
}
