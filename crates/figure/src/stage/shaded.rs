//! The scene itself, ray traced by our own structures: the ground of a solid picture without a GPU.

use glam::{Vec2, Vec3};
use raystep_accel::{Accel, BvhRule, Grow, Hit, Obb, Observer, Primitives, Prims, Ray, Rule, Shape, Structure};

use super::Camera;
use super::lens::Lens;
use crate::page::Image;
use crate::theme::{Color, Theme};

/// An image of a scene with the depth of every pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Shaded {
    /// The image, transparent where nothing is.
    pub image: Image,
    /// Depth of every pixel (near plane / distance), 0 where nothing is.
    depth: Vec<f32>,
}

/// Rays for a pixel on an edge: a grid of so many by so many.
const FINE: u32 = 3;

/// Renders the primitives in calm two-sided shading, `width` by `height` pixels; nothing if `go_on` says to
/// give up. A structure that would be slow at a whole picture (all but well grown trees) gives way to one made
/// for it: the answers are the same.
pub fn shaded(
    structure: &Structure,
    prims: &Prims,
    camera: &Camera,
    width: u32,
    height: u32,
    theme: &Theme,
    go_on: &dyn Fn() -> bool,
) -> Option<Shaded> {
    let size = Vec2::new(width as f32, height as f32);
    let own = match structure {
        Structure::Kd(_) | Structure::Bvh(_) if structure.node_count() * 4 >= prims.len() => None,
        _ => Some(Structure::build(prims, &Rule::Bvh(BvhRule::default()), &mut Patience(go_on)).ok()?),
    };
    let structure = own.as_ref().unwrap_or(structure);
    let scene = Scene { structure, prims, camera, size, lens: Lens::new(camera, size), theme };
    let mut samples: Vec<Sample> = Vec::with_capacity(width as usize * height as usize);
    for y in 0..height {
        if !go_on() {
            return None;
        }
        samples.extend((0..width).map(|x| scene.sample(Vec2::new(x as f32 + 0.5, y as f32 + 0.5))));
    }
    let mut rgba = Vec::with_capacity(samples.len() * 4);
    for (index, sample) in samples.iter().enumerate() {
        let (x, y) = (index as u32 % width, index as u32 / width);
        if x == 0 && !go_on() {
            return None;
        }
        let neighbours = [
            (x > 0).then(|| index - 1),
            (x + 1 < width).then(|| index + 1),
            (y > 0).then(|| index - width as usize),
            (y + 1 < height).then(|| index + width as usize),
        ];
        let edge = neighbours.into_iter().flatten().any(|other| sample.differs(&samples[other]));
        let color =
            if edge { scene.averaged(x, y) } else { [sample.color.r, sample.color.g, sample.color.b, sample.color.a] };
        rgba.extend(color);
    }
    let depth = samples.iter().map(|sample| sample.depth).collect();
    Some(Shaded { image: Image { width, height, rgba: rgba.into() }, depth })
}

/// Builds as long as somebody waits for it.
struct Patience<'a>(&'a dyn Fn() -> bool);

impl Observer<Grow> for Patience<'_> {
    fn on(&mut self, _: Grow) {}

    fn cancelled(&self) -> bool {
        !(self.0)()
    }
}

impl Shaded {
    /// Whether a surface lies before a point of a page of this size.
    pub(crate) fn hides(&self, at: Vec2, depth: f32, size: Vec2) -> bool {
        let pixel = at / size * Vec2::new(self.image.width as f32, self.image.height as f32);
        if pixel.min_element() < 0.0 || pixel.x >= self.image.width as f32 || pixel.y >= self.image.height as f32 {
            return false;
        }
        let index = pixel.y as usize * self.image.width as usize + pixel.x as usize;
        // A line on the surface itself is visible.
        self.depth[index] > depth * 1.004
    }
}

struct Scene<'a> {
    structure: &'a Structure,
    prims: &'a Prims,
    camera: &'a Camera,
    size: Vec2,
    lens: Lens,
    theme: &'a Theme,
}

/// What one ray of the picture found.
#[derive(Clone, Copy)]
struct Sample {
    color: Color,
    depth: f32,
}

impl Sample {
    /// Whether two neighbours belong to different surfaces.
    fn differs(&self, other: &Sample) -> bool {
        let step = |a: u8, b: u8| a.abs_diff(b) > 6;
        step(self.color.g, other.color.g) || self.color.a != other.color.a
    }
}

impl Scene<'_> {
    fn sample(&self, page: Vec2) -> Sample {
        let nothing = Sample { color: self.theme.clear(), depth: 0.0 };
        let Ok(ray) = self.camera.ray(page, self.size) else { return nothing };
        let Some(hit) = self.structure.intersect(self.prims, &ray, &mut ()) else { return nothing };
        let depth = self.lens.point(ray.at(hit.t)).map_or(0.0, |(_, depth)| depth);
        let normal = normal(&self.prims.met(&hit), &ray, hit);
        Sample { color: self.theme.surface(light(normal, ray.d)), depth }
    }

    /// The mean colour of several rays through a pixel.
    fn averaged(&self, x: u32, y: u32) -> [u8; 4] {
        let mut sum = [0_u32; 4];
        for index in 0..FINE * FINE {
            let within = Vec2::new((index % FINE) as f32 + 0.5, (index / FINE) as f32 + 0.5) / FINE as f32;
            let color = self.sample(Vec2::new(x as f32, y as f32) + within).color;
            let a = u32::from(color.a);
            for (sum, channel) in sum.iter_mut().zip([color.r, color.g, color.b]) {
                *sum += u32::from(channel) * a;
            }
            sum[3] += a;
        }
        let [r, g, b, a] = sum;
        let mean = |channel: u32| (channel + a / 2).checked_div(a).unwrap_or(0) as u8;
        [mean(r), mean(g), mean(b), (a / (FINE * FINE)) as u8]
    }
}

/// How bright a surface is, from 0 to 1: brightest where it faces the light over the viewer's shoulder.
fn light(normal: Vec3, d: Vec3) -> f32 {
    let d = d.normalize_or_zero();
    let facing = if normal.dot(d) > 0.0 { -normal } else { normal };
    let side = d.cross(Vec3::Y).normalize_or_zero();
    let lamp = (Vec3::Y * 0.7 - d - side * 0.5).normalize_or_zero();
    0.5 + 0.5 * facing.dot(lamp).max(0.0)
}

fn normal(shape: &Shape<'_>, ray: &Ray, hit: Hit) -> Vec3 {
    let upright = |from: Vec2, to: Vec2| (to - from).perp().extend(0.0);
    let normal = match shape {
        Shape::Triangle(triangle) => (triangle.b - triangle.a).cross(triangle.c - triangle.a),
        Shape::Sphere(sphere) => ray.at(hit.t) - sphere.center,
        Shape::Disc(disc) => disc.normal,
        Shape::Wall(wall) => upright(wall.from, wall.to),
        // The wall that was hit is the one whose t is the hit's.
        Shape::Prism(prism) => prism
            .walls()
            .find(|wall| Shape::Wall(*wall).intersect(ray) == Some(hit.t))
            .map_or(Vec3::Z, |wall| upright(wall.from, wall.to)),
        Shape::Cylinder(cylinder) => {
            let (axis, f) = (cylinder.to - cylinder.from, ray.at(hit.t) - cylinder.from);
            let height = f.dot(axis) / axis.length_squared();
            // On an end, unless it lies as far out as the round side.
            let out = f - axis * height;
            let is_round = out.length() > cylinder.radius * ROUND && (0.0..1.0).contains(&height);
            if is_round { out } else { axis }
        }
        Shape::Cone(cone) => {
            let (axis, f) = (cone.base - cone.apex, ray.at(hit.t) - cone.apex);
            let height = f.dot(axis) / axis.length_squared();
            // The round side leans outward and towards the apex; the base is as wide as it gets.
            let out = f - axis * height;
            let is_round = out.length() > cone.radius * height * ROUND;
            if is_round {
                out.normalize_or_zero() * axis.length() - axis.normalize_or_zero() * cone.radius
            } else {
                axis
            }
        }
        Shape::Polygon(polygon) => polygon.normal().as_vec3(),
        Shape::Box(bounds) => face_of(&Obb::from_aabb(bounds), ray.at(hit.t)),
        Shape::Obb(solid) => face_of(solid, ray.at(hit.t)),
    };
    normal.normalize_or_zero()
}

/// So far out, as a part of the radius, a point of a round solid counts as one of its round side.
const ROUND: f32 = 1.0 - 1e-4;

/// The normal of the side of a box that a point of its surface lies on: the one it reaches furthest along.
fn face_of(solid: &Obb, p: Vec3) -> Vec3 {
    let f = p - solid.center;
    let reach = |i: usize| f.dot(solid.axes[i]).abs() / solid.half[i].max(f32::MIN_POSITIVE);
    solid.axes[(0..3).fold(0, |best, i| if reach(i) > reach(best) { i } else { best })]
}
