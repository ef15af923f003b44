//! A camera with a sun: it sees a scene through whatever answers its rays, with shadows and the sky's light.

use glam::{Vec2, Vec3};
use raystep_accel::{Cancelled, Cost, Grow, Hit, Observer, PrimId, Primitives, Prims, Ray, Shape, pinhole};
use raystep_scene::{Scene, View};

use super::care::Care;
use super::rows;
use super::smooth::Smooth;
use super::through::Through;

/// Rays for a pixel at an edge: a grid of so many by so many.
const FINE: u32 = 3;
/// Neighbours that differ by more than this lie at an edge.
const EDGE: f32 = 0.03;

/// Longer than any leaf or blade, in metres.
const LONG: f32 = 0.7;

/// What a camera saw.
pub(super) struct Seen {
    /// Four bytes for each pixel, rows from above.
    pub(super) rgba: Vec<u8>,
    /// Rays shot: to the eye and to the sun.
    pub(super) rays: u64,
    /// Tests of primitives, a ray.
    pub(super) tests: f64,
}

/// Where the sun stands: high, left of the eye and behind it.
fn sun(view: &View) -> Vec3 {
    let forward = (view.target - view.eye).normalize_or_zero();
    let right = forward.cross(view.up).normalize_or_zero();
    (view.up * 1.1 - right * 0.9 - forward * 0.35).normalize_or_zero()
}

/// A scene, how it is seen, and from where the sun shines.
pub(super) struct Camera<'a, T> {
    scene: &'a Scene,
    through: &'a T,
    view: View,
    sun: Vec3,
    smooth: &'a Smooth,
    size: [u32; 2],
    care: Care,
    /// How far the scene reaches: looked up once, not with every ray.
    far: f32,
}

/// What a row of pixels shows, and what its rays cost.
struct Line {
    colors: Vec<Vec3>,
    cost: Cost,
    rays: u64,
}

impl<'a, T: Through> Camera<'a, T> {
    /// A camera with so many pixels.
    pub(super) fn new(
        scene: &'a Scene,
        through: &'a T,
        view: View,
        smooth: &'a Smooth,
        size: [u32; 2],
        care: Care,
    ) -> Camera<'a, T> {
        let far = scene.bounds().extent().length().max(1e-6);
        Camera { scene, through, view, sun: sun(&view), smooth, size, care, far }
    }

    /// The same camera with so many pixels.
    pub(super) fn sized(self, size: [u32; 2]) -> Camera<'a, T> {
        Camera { size, ..self }
    }

    /// The same camera, its rays answered otherwise.
    pub(super) fn answered<O: Through>(&self, through: &'a O) -> Camera<'a, O> {
        let &Camera { scene, view, sun, smooth, size, care, far, .. } = self;
        Camera { scene, through, view, sun, smooth, size, care, far }
    }

    /// All pixels, one after the other.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub(super) fn colors(&self, watch: &impl Observer<Grow>) -> Result<Vec<Vec3>, Cancelled> {
        let [width, height] = self.size;
        let size = Vec2::new(width as f32, height as f32);
        let (mut cost, mut rays) = (Cost::default(), 0);
        let mut colors = Vec::with_capacity((width * height) as usize);
        for y in 0..height {
            if watch.cancelled() {
                return Err(Cancelled);
            }
            let middles = (0..width).map(|x| Vec2::new(x as f32 + 0.5, y as f32 + 0.5));
            colors.extend(middles.map(|middle| self.light(middle / size, &mut cost, &mut rays)));
        }
        Ok(colors)
    }

    /// All pixels, with smooth edges if it is careful, the rows side by side.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub(super) fn render(&self, watch: &impl Observer<Grow>) -> Result<Seen, Cancelled> {
        let [width, height] = self.size;
        let size = Vec2::new(width as f32, height as f32);
        let first = rows::each(height, watch, |y| {
            let mut line = Line { colors: Vec::with_capacity(width as usize), cost: Cost::default(), rays: 0 };
            for x in 0..width {
                let middle = Vec2::new(x as f32 + 0.5, y as f32 + 0.5) / size;
                let color = self.light(middle, &mut line.cost, &mut line.rays);
                line.colors.push(color);
            }
            line
        })?;
        // Leaves are smaller than a pixel anyhow; smooth things get smooth edges.
        let edges = self.care == Care::Full && !matches!(self.scene.prims, Prims::Instances(_));
        let color_at = |x: u32, y: u32| first.get(y as usize)?.colors.get(x as usize).copied();
        let lines = rows::each(height, watch, |y| {
            let mut line = Line { colors: first[y as usize].colors.clone(), cost: Cost::default(), rays: 0 };
            for x in (0..width).filter(|_| edges) {
                let own = first[y as usize].colors[x as usize];
                let beside = [color_at(x + 1, y), color_at(x, y + 1)];
                if beside.into_iter().flatten().any(|other| (other - own).abs().max_element() > EDGE) {
                    line.colors[x as usize] = self.averaged(x, y, size, &mut line.cost, &mut line.rays);
                }
            }
            line
        })?;
        let (mut cost, mut rays) = (Cost::default(), 0);
        for line in first.iter().chain(&lines) {
            cost += line.cost;
            rays += line.rays;
        }
        // Bytes as screens have them: the square root is near enough, and the same everywhere.
        let byte = |channel: f32| (channel.clamp(0.0, 1.0).sqrt() * 255.0 + 0.5) as u8;
        let colors = lines.iter().flat_map(|line| &line.colors);
        let rgba: Vec<u8> = colors.flat_map(|color| [byte(color.x), byte(color.y), byte(color.z), 255]).collect();
        let tests = cost.prim_tests as f64 / rays.max(1) as f64;
        Ok(Seen { rgba, rays, tests })
    }

    /// The light that comes through a point of the page: (0, 0) is its upper left corner, (1, 1) its lower right one.
    fn light(&self, at: Vec2, cost: &mut Cost, rays: &mut u64) -> Vec3 {
        let at = (at * 2.0 - 1.0) * Vec2::new(1.0, -1.0);
        let View { eye, target, up, fov_degrees } = self.view;
        match pinhole(eye, target, up, fov_degrees, at, self.size[0] as f32 / self.size[1] as f32) {
            Ok(ray) => self.color(&ray, cost, rays),
            Err(_) => Vec3::ONE,
        }
    }

    /// The mean of several rays through a pixel.
    fn averaged(&self, x: u32, y: u32, size: Vec2, cost: &mut Cost, rays: &mut u64) -> Vec3 {
        let mut sum = Vec3::ZERO;
        for sample in 0..FINE * FINE {
            let within = (Vec2::new((sample % FINE) as f32, (sample / FINE) as f32) + 0.5) / FINE as f32;
            sum += self.light((Vec2::new(x as f32, y as f32) + within) / size, cost, rays);
        }
        sum / (FINE * FINE) as f32
    }

    /// The light that comes along a ray, red, green and blue, 1 being white.
    fn color(&self, ray: &Ray, cost: &mut Cost, rays: &mut u64) -> Vec3 {
        *rays += 1;
        let sky = sky(ray.d.dot(self.view.up));
        let Some(hit) = self.through.nearest(ray, cost) else { return sky };
        let shape = self.scene.prims.met(&hit);
        let from = ray.at(hit.t);
        let flat = normal(&shape, ray);
        let side = if flat.dot(ray.d) > 0.0 { -1.0 } else { 1.0 };
        let facing = side * self.smooth.normal(&shape, from).unwrap_or(flat);
        let surface = self.surface(&hit, facing);
        let lit = facing.dot(self.sun).max(0.0);
        let shadow = Ray::new(from, self.sun).and_then(|ray| ray.within(hit.t.max(1.0) * 1e-3, f32::INFINITY));
        let dark = lit > 0.0
            && shadow.is_ok_and(|ray| {
                *rays += 1;
                self.through.any(&ray, cost)
            });
        let sun = if dark { 0.0 } else { lit };
        // From above comes the sky's light, from below that of the ground.
        let above = 0.5 + 0.5 * facing.dot(self.view.up);
        let light = Vec3::new(1.0, 0.95, 0.86) * (sun * 0.95) + Vec3::new(0.36, 0.42, 0.52) * (0.25 + 0.75 * above);
        // What lies far behind the middle of the picture fades into the sky.
        let behind = hit.t - (self.view.target - self.view.eye).length();
        let haze = (behind / self.far).clamp(0.0, 0.75);
        (surface * light).lerp(sky, haze * haze)
    }

    /// The colour of what was hit: porcelain, or outdoors ground, bark and leaves, each plant a little different.
    fn surface(&self, hit: &Hit, facing: Vec3) -> Vec3 {
        let Prims::Instances(instances) = &self.scene.prims else { return Vec3::new(0.72, 0.70, 0.66) };
        // The ground is the last thing that is placed.
        if hit.prim == PrimId(instances.len() as u32 - 1) {
            return Vec3::new(0.26, 0.25, 0.15);
        }
        let own = hit.prim.0.wrapping_mul(2_654_435_761) >> 8;
        let part = |shift: u32| ((own >> shift) & 63) as f32 / 63.0;
        // Trunk and boughs are long, leaves and blades are not.
        let bark = hit.inner.is_some_and(|inner| {
            let triangle = instances.triangle(hit.prim, inner);
            (triangle.b - triangle.a).length().max((triangle.c - triangle.a).length()) > LONG
        });
        let leaves = Vec3::new(0.16 + 0.16 * part(0), 0.30 + 0.14 * part(6), 0.08 + 0.05 * part(12));
        // Leaves let some light through.
        if bark { Vec3::new(0.22, 0.17, 0.12) } else { leaves * (0.9 + 0.25 * facing.dot(self.view.up).abs()) }
    }
}

/// The sky in a direction so far up.
fn sky(up: f32) -> Vec3 {
    Vec3::new(0.80, 0.87, 0.93).lerp(Vec3::new(0.27, 0.46, 0.74), up.clamp(0.0, 1.0).sqrt())
}

fn normal(shape: &Shape<'_>, ray: &Ray) -> Vec3 {
    match shape {
        Shape::Triangle(triangle) => (triangle.b - triangle.a).cross(triangle.c - triangle.a).normalize_or_zero(),
        // Pictures are made of triangles; anything else looks back at the eye.
        _ => -ray.d.normalize_or_zero(),
    }
}
