//! What is seen through each pixel: how far away it is, which way it faces, how it looks in the light. Hits come of a fast
//! structure where there is one over such primitives: it answers as those of the textbook do, to the bit.

use std::fmt::Write;
use std::time::{Duration, Instant};

use glam::{Vec2, Vec3};
use rayon::prelude::*;
use raystep_accel::{Accel, Hit, Prims, Ray, Shape};
use raystep_fast::{Bvh8, Fast, Settings, TwoLevels};
use raystep_figure::{Camera, Image};
use raystep_scene::Scene;

use crate::shown::heat::Walked;

/// What of it is told.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Sees {
    /// How far away it is, along the ray.
    Depth,
    /// Which way it faces.
    Normal,
    /// How it looks in the light of a sun.
    Shaded,
}

/// What is seen, pixel by pixel, rows from above.
pub(super) struct Seen {
    sees: Sees,
    rays: [u32; 2],
    /// What each pixel's ray meets; nothing where it meets nothing.
    pixels: Vec<Option<Met>>,
    /// How long that took, the building not counted.
    pub(super) took: Duration,
}

/// What a ray meets.
#[derive(Clone, Copy)]
struct Met {
    t: f32,
    /// Towards the eye, length one.
    normal: Vec3,
    /// The part of the sun's light that falls on it.
    lit: f32,
}

/// What answers rays.
enum Quick<'a> {
    Mesh(Bvh8),
    Instances(TwoLevels),
    Walked(&'a Walked, &'a Prims),
}

impl Quick<'_> {
    fn nearest(&self, ray: &Ray) -> Option<Hit> {
        match self {
            Quick::Mesh(tree) => tree.intersect(ray),
            Quick::Instances(tree) => tree.intersect(ray),
            Quick::Walked(Walked::Textbook(structure), prims) => structure.intersect(*prims, ray, &mut ()),
            Quick::Walked(Walked::Fast(fast), _) => fast.intersect(ray),
        }
    }

    fn any(&self, ray: &Ray) -> bool {
        match self {
            Quick::Mesh(tree) => tree.occluded(ray),
            Quick::Instances(tree) => tree.occluded(ray),
            Quick::Walked(Walked::Textbook(structure), prims) => structure.occluded(*prims, ray, &mut ()),
            Quick::Walked(Walked::Fast(fast), _) => fast.occluded(ray),
        }
    }
}

impl Seen {
    /// Looks through each of so many pixels across and down.
    pub(super) fn of(scene: &Scene, walked: &Walked, camera: Camera, rays: [u32; 2], sees: Sees) -> Seen {
        let quick = match (walked, &scene.prims) {
            (Walked::Textbook(_), Prims::Mesh(mesh)) => Quick::Mesh(Bvh8::build(mesh, &Settings::default())),
            (Walked::Textbook(_), Prims::Instances(instances)) => {
                Quick::Instances(TwoLevels::build(instances, &Settings::default()))
            }
            (walked, prims) => Quick::Walked(walked, prims),
        };
        let size = Vec2::new(rays[0] as f32, rays[1] as f32);
        let sun = sun(&camera, size);
        let begun = Instant::now();
        let row = |y: u32| {
            let pixel = |x: u32| {
                let ray = camera.ray(Vec2::new(x as f32 + 0.5, y as f32 + 0.5), size).ok()?;
                met(&ray, scene, &quick, sun, sees == Sees::Shaded)
            };
            (0..rays[0]).map(pixel).collect::<Vec<_>>()
        };
        let pixels = (0..rays[1]).into_par_iter().map(row).collect::<Vec<_>>().concat();
        Seen { sees, rays, pixels, took: begun.elapsed() }
    }

    /// The picture: nearer is lighter; x, y and z of a normal are red, green and blue, none being half of it.
    pub(super) fn image(&self) -> Image {
        let depths = || self.pixels.iter().flatten().map(|met| met.t);
        let (near, far) = depths().fold((f32::INFINITY, 0.0_f32), |(near, far), t| (near.min(t), far.max(t)));
        let byte = |part: f32| (part.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
        let color = |met: &Option<Met>| {
            let part = match (met, self.sees) {
                (None, Sees::Shaded) => Vec3::new(0.86, 0.92, 0.97),
                (None, _) => Vec3::ZERO,
                (Some(met), Sees::Depth) => {
                    Vec3::splat(1.0 - 0.85 * (met.t - near) / (far - near).max(f32::MIN_POSITIVE))
                }
                (Some(met), Sees::Normal) => met.normal * 0.5 + 0.5,
                (Some(met), Sees::Shaded) => {
                    let light = Vec3::new(1.0, 0.95, 0.86) * met.lit + Vec3::new(0.26, 0.29, 0.34);
                    let color = Vec3::new(0.72, 0.70, 0.66) * light;
                    Vec3::new(color.x.sqrt(), color.y.sqrt(), color.z.sqrt())
                }
            };
            [byte(part.x), byte(part.y), byte(part.z), 255]
        };
        let rgba: Vec<u8> = self.pixels.iter().flat_map(color).collect();
        Image { width: self.rays[0], height: self.rays[1], rgba: rgba.into() }
    }

    /// A line for each row of pixels: t of each, three numbers of each normal, or the part of the light; nothing between
    /// the commas where nothing is met.
    pub(super) fn numbers(&self) -> String {
        let mut text = String::new();
        for row in self.pixels.chunks(self.rays[0].max(1) as usize) {
            for (index, met) in row.iter().enumerate() {
                if index > 0 {
                    text.push(',');
                }
                let _ = match (met, self.sees) {
                    (None, Sees::Normal) => write!(text, ",,"),
                    (None, _) => Ok(()),
                    (Some(met), Sees::Depth) => write!(text, "{}", met.t),
                    (Some(met), Sees::Normal) => write!(text, "{},{},{}", met.normal.x, met.normal.y, met.normal.z),
                    (Some(met), Sees::Shaded) => write!(text, "{}", met.lit),
                };
            }
            text.push('\n');
        }
        text
    }
}

/// What a ray meets, and whether the sun shines on it if that is asked.
fn met(ray: &Ray, scene: &Scene, quick: &Quick<'_>, sun: Vec3, shaded: bool) -> Option<Met> {
    let hit = quick.nearest(ray)?;
    let flat = match scene.prims.met(&hit) {
        Shape::Triangle(triangle) => (triangle.b - triangle.a).cross(triangle.c - triangle.a).normalize_or_zero(),
        // Anything else looks back at the eye.
        _ => -ray.d.normalize_or_zero(),
    };
    let normal = if flat.dot(ray.d) > 0.0 { -flat } else { flat };
    let falls = normal.dot(sun).max(0.0);
    let free = |hit: &Hit| {
        let towards = Ray::new(ray.at(hit.t), sun).and_then(|ray| ray.within(hit.t.max(1.0) * 1e-3, f32::INFINITY));
        towards.is_ok_and(|ray| !quick.any(&ray))
    };
    let lit = if shaded && falls > 0.0 && free(&hit) { falls } else { 0.0 };
    Some(Met { t: hit.t, normal, lit })
}

/// High, left of the eye and behind it.
fn sun(camera: &Camera, size: Vec2) -> Vec3 {
    let along =
        |x: f32, y: f32| camera.ray(Vec2::new(x, y) * size, size).map_or(Vec3::Z, |ray| ray.d.normalize_or_zero());
    let (forward, right, up) = (along(0.5, 0.5), along(1.0, 0.5) - along(0.0, 0.5), along(0.5, 0.0) - along(0.5, 1.0));
    (up.normalize_or_zero() * 1.1 - right.normalize_or_zero() * 0.9 - forward * 0.35).normalize_or(Vec3::Z)
}
