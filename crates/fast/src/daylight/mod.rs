//! Pictures by daylight: a sun and its shadows, the sky's light where leaves let it through, and haze that grows with the
//! distance. What surfaces look like, the caller knows.

mod sky;

use glam::{Vec2, Vec3};
use raystep_accel::{Hit, Random, Ray, Want, pinhole};

use crate::{Fast, Work};
use sky::Sky;

/// What rays meet looks like.
pub trait Surface: Sync {
    /// How the surface that was hit looks, at that point of it.
    fn look(&self, hit: &Hit, point: Vec3) -> Matter;
}

/// How a surface looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matter {
    /// Across it, on either side, length one.
    pub normal: Vec3,
    /// Red, green and blue: the parts of the light that it gives back.
    pub color: Vec3,
    /// The part of the light on its other side that comes through.
    pub through: f32,
}

/// From where a picture is seen, and by what light. z is up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Daylight {
    /// Where the eye is.
    pub eye: Vec3,
    /// What lies in the middle of the picture.
    pub target: Vec3,
    /// The vertical angle of view in degrees.
    pub fov_degrees: f32,
    /// Pixels across and down.
    pub size: [u32; 2],
    /// Rays from the eye for each pixel.
    pub samples: u32,
    /// Towards the sun, length one.
    pub sun: Vec3,
    /// At this distance two thirds of what is seen are haze.
    pub haze: f32,
    /// How far away leaves still keep off the sky's light.
    pub shade: f32,
}

/// A row of pixels, and what its rays cost.
#[derive(Clone, Debug, Default)]
pub struct Line {
    /// Four bytes for each pixel: red, green, blue, and 255.
    pub rgba: Vec<u8>,
    /// Rays from the eye.
    pub seen: u64,
    /// Rays to the sun and to the sky.
    pub lit: u64,
    /// What all of them cost.
    pub work: Work,
}

impl Daylight {
    /// A row, counted from above. The same on any number of threads.
    pub fn row(&self, y: u32, scene: &impl Fast, surface: &impl Surface) -> Line {
        let [width, height] = self.size;
        let size = Vec2::new(width as f32, height as f32);
        let sky = Sky { sun: self.sun };
        let mut line = Line::default();
        // The samples of a pixel lie in a grid, each anywhere in its square.
        let side = (1..).find(|side| side * side >= self.samples).unwrap_or(1);
        for x in 0..width {
            let mut random = Random::new(u64::from(y) << 32 | u64::from(x));
            random.bits();
            let mut light = Vec3::ZERO;
            for sample in 0..self.samples {
                let within = Vec2::new((sample % side) as f32, (sample / side) as f32);
                let within = (within + Vec2::new(random.unit(), random.unit())) / side as f32;
                let at = ((Vec2::new(x as f32, y as f32) + within) / size * 2.0 - 1.0) * Vec2::new(1.0, -1.0);
                let ray = pinhole(self.eye, self.target, Vec3::Z, self.fov_degrees, at, size.x / size.y);
                light += ray.map_or(Vec3::ZERO, |ray| self.seen(&ray, scene, surface, &sky, &mut random, &mut line));
            }
            let [r, g, b] = developed(light / self.samples.max(1) as f32);
            line.rgba.extend([r, g, b, 255]);
        }
        line
    }

    /// The light that comes along a ray from the eye.
    fn seen(
        &self,
        ray: &Ray,
        scene: &impl Fast,
        surface: &impl Surface,
        sky: &Sky,
        random: &mut Random,
        line: &mut Line,
    ) -> Vec3 {
        line.seen += 1;
        let Some(hit) = scene.walk(ray, Want::Nearest, &mut line.work) else { return sky.seen(ray.d) };
        let point = ray.at(hit.t);
        let Matter { normal, color, through } = surface.look(&hit, point);
        let facing = if normal.dot(ray.d) > 0.0 { -normal } else { normal };
        // Off the surface, further where numbers are coarser.
        let off = 2e-3 + hit.t * 2e-5;
        let mut is_free = |way: Vec3, from: f32, to: f32| {
            line.lit += 1;
            let free = Ray::new(point, way).and_then(|ray| ray.within(from, to));
            free.is_ok_and(|ray| scene.walk(&ray, Want::Any, &mut line.work).is_none())
        };
        let towards = facing.dot(self.sun);
        let falls = if towards > 0.0 { towards } else { -towards * through };
        let sun = if falls > 0.0 && is_free(self.sun, off, f32::INFINITY) { falls } else { 0.0 };
        // One way to the sky, more often a steep one.
        let way = (facing + sphere(random) * 0.98).normalize_or(facing);
        let open = if way.z > 0.0 && is_free(way, off, self.shade) { 1.0 } else { 0.18 };
        let above = 0.35 + 0.65 * (0.5 + 0.5 * facing.z);
        let light = sky.sunlight() * sun + sky.light() * (above * open);
        let clear = (-hit.t / self.haze).exp();
        // Sunlight gets greener through leaves.
        let color = if towards > 0.0 { color } else { color * Vec3::new(1.05, 1.1, 0.7) };
        (color * light).lerp(sky.haze(ray.d), 1.0 - clear)
    }
}

/// A direction, all alike likely.
fn sphere(random: &mut Random) -> Vec3 {
    loop {
        let v = Vec3::new(random.range(-1.0, 1.0), random.range(-1.0, 1.0), random.range(-1.0, 1.0));
        let square = v.length_squared();
        if square > 0.01 && square <= 1.0 {
            return v / square.sqrt();
        }
    }
}

/// Light as a screen shows it: bright things are kept from burning out (Narkowicz 2015), and bytes are as sRGB has them.
fn developed(light: Vec3) -> [u8; 3] {
    let x = light.max(Vec3::ZERO);
    let film = (x * (x * 2.51 + 0.03)) / (x * (x * 2.43 + 0.59) + 0.14);
    let byte = |part: f32| (part.clamp(0.0, 1.0).powf(1.0 / 2.2) * 255.0 + 0.5) as u8;
    [byte(film.x), byte(film.y), byte(film.z)]
}

#[cfg(test)]
mod tests {
    use raystep_accel::{Mesh, PrimId};

    use super::*;
    use crate::{Bvh8, Settings};

    struct Grey;

    impl Surface for Grey {
        fn look(&self, hit: &Hit, _: Vec3) -> Matter {
            assert!(hit.prim < PrimId(4));
            Matter { normal: Vec3::Z, color: Vec3::splat(0.5), through: 0.0 }
        }
    }

    #[test]
    fn what_lies_in_the_shadow_is_darker_and_what_is_far_is_hazy() {
        // A floor, and a plate that floats above the part of it on the left.
        let plate = |x: f32, half: f32, z: f32| {
            [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(u, v)| Vec3::new(x + u * half, v * half, z))
        };
        let mesh = Mesh {
            corners: [plate(0.0, 10.0, 0.0), plate(-3.0, 2.0, 9.0)].concat(),
            triangles: vec![[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]],
        };
        let scene = Bvh8::build(&mesh, &Settings::default());
        let day = Daylight {
            eye: Vec3::new(0.0, -0.01, 8.0),
            target: Vec3::ZERO,
            fov_degrees: 60.0,
            size: [16, 8],
            samples: 4,
            sun: Vec3::Z,
            haze: 1e6,
            shade: 1.0,
        };
        let line = day.row(4, &scene, &Grey);
        let bright =
            |line: &Line, x: usize| line.rgba[4 * x..4 * x + 3].iter().map(|byte| u32::from(*byte)).sum::<u32>();
        assert_eq!((line.rgba.len(), line.seen), (64, 64));
        assert!(bright(&line, 4) + 60 < bright(&line, 12), "{:?}", line.rgba);
        let hazy = Daylight { haze: 1.0, ..day }.row(4, &scene, &Grey);
        let differs = |line: &Line| bright(line, 4).abs_diff(bright(line, 12));
        assert!(differs(&hazy) * 10 < differs(&line), "{:?}", hazy.rgba);
        assert_eq!(line.rgba, day.row(4, &scene, &Grey).rgba);
    }
}
