//! Scenes, structures and rays out of bytes, so that every few bytes mean something.

use glam::{Quat, Vec2, Vec3};
use raystep_accel::{Aabb, Cone, Cylinder, Disc, Obb, Polygon, Prism, Ray, Shape, Sphere, Triangle, Wall};

/// Bytes that are read from the front; what is missing is 0.
pub(super) struct Bytes<'a>(pub(super) &'a [u8]);

/// Numbers are no nearer to zero than this, unless they are zero, and no further from it.
const NEAREST: f32 = 1e-6;
const FURTHEST: f32 = 1e6;

/// How large coordinates are: a power of two, so that scaled numbers touch as exactly as small ones.
const SCALES: [f32; 8] = [1.0, 1.0, 1.0, 1.0, 0.5, 1024.0, 1.0 / 4_194_304.0, 16_777_216.0];

impl Bytes<'_> {
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    pub(super) fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        *first
    }

    pub(super) fn below(&mut self, n: usize) -> usize {
        usize::from(self.byte()) % n
    }

    pub(super) fn scale(&mut self) -> f32 {
        SCALES[self.below(SCALES.len())]
    }

    /// A small whole number, mostly; else one beside it, a fraction, a zero of either sign, or anything finite.
    fn number(&mut self) -> f32 {
        let whole = f32::from(self.byte() as i8 % 6);
        let number = match self.byte() % 16 {
            0..8 => whole,
            8 => whole.next_up(),
            9 => whole.next_down(),
            10 | 11 => whole + f32::from(self.byte()) / 256.0,
            12 => whole / 3.0,
            13 => -0.0,
            14 => whole * 16.0 * f32::EPSILON,
            _ => f32::from_bits(u32::from_le_bytes([self.byte(), self.byte(), self.byte(), self.byte()])),
        };
        if number == 0.0 || (NEAREST..=FURTHEST).contains(&number.abs()) { number } else { whole }
    }

    fn point(&mut self) -> Vec3 {
        Vec3::new(self.number(), self.number(), self.number())
    }

    fn flat(&mut self) -> Vec2 {
        Vec2::new(self.number(), self.number())
    }

    fn radius(&mut self) -> f32 {
        self.number().abs().max(1.0 / 1024.0)
    }

    /// Three axes at right angles.
    fn turn(&mut self) -> [Vec3; 3] {
        let [x, y, z, w] = [self.number(), self.number(), self.number(), self.number()];
        let length = (x * x + y * y + z * z + w * w).sqrt();
        let turn = if length < 1e-3 { Quat::IDENTITY } else { Quat::from_xyzw(x, y, z, w) / length };
        Vec3::AXES.map(|axis| turn * axis)
    }

    /// Three to six points in a plane.
    fn outline(&mut self) -> Vec<Vec2> {
        let count = 3 + self.below(4);
        let mut corners: Vec<Vec2> = (0..count).map(|_| self.flat()).collect();
        corners.dedup();
        if corners.len() < 3 || corners.first() == corners.last() {
            corners = vec![Vec2::ZERO, Vec2::X, Vec2::Y];
        }
        corners
    }

    /// A ray, if these bytes make one.
    pub(super) fn ray(&mut self, scale: f32, is_flat: bool) -> Option<Ray> {
        let (mut o, mut d) = (self.point() * scale, self.point());
        if is_flat {
            (o.z, d.z) = (0.0, 0.0);
        }
        let ray = Ray::new(o, d).ok()?;
        match self.byte() % 4 {
            0 => ray.within(self.number().abs() * scale, f32::INFINITY).ok(),
            1 => ray.within(0.0, self.number().abs() * scale).ok(),
            _ => Some(ray),
        }
    }
}

/// Outlines, which shapes only borrow.
#[derive(Default)]
pub(super) struct Outlines {
    flat: Vec<Vec<Vec2>>,
    solid: Vec<Vec<Vec3>>,
}

/// A shape before its outline is lent to it.
pub(super) enum Draft {
    Whole(Shape<'static>),
    Prism(usize),
    Polygon(usize),
}

impl Outlines {
    /// Reads a shape.
    pub(super) fn draft(&mut self, bytes: &mut Bytes<'_>, scale: f32, is_flat: bool) -> Draft {
        let z = [-0.25 * scale, 0.25 * scale];
        if is_flat {
            return match bytes.below(3) {
                0 => Draft::Whole(Shape::Sphere(Sphere {
                    center: (bytes.flat() * scale).extend(0.0),
                    radius: bytes.radius() * scale,
                })),
                1 => Draft::Whole(Shape::Wall(Wall { from: bytes.flat() * scale, to: bytes.flat() * scale, z })),
                _ => {
                    self.flat.push(bytes.outline().into_iter().map(|corner| corner * scale).collect());
                    Draft::Prism(self.flat.len() - 1)
                }
            };
        }
        let point = |bytes: &mut Bytes<'_>| bytes.point() * scale;
        Draft::Whole(match bytes.below(9) {
            0..3 => Shape::Triangle(Triangle { a: point(bytes), b: point(bytes), c: point(bytes) }),
            3 => Shape::Sphere(Sphere { center: point(bytes), radius: bytes.radius() * scale }),
            4 => Shape::Disc(Disc {
                center: point(bytes),
                normal: bytes.point().normalize_or(Vec3::Z),
                radius: bytes.radius() * scale,
            }),
            5 => {
                let (from, to) = axis(point(bytes), point(bytes), scale);
                Shape::Cylinder(Cylinder { from, to, radius: bytes.radius() * scale })
            }
            6 => {
                let (apex, base) = axis(point(bytes), point(bytes), scale);
                Shape::Cone(Cone { apex, base, radius: bytes.radius() * scale })
            }
            7 => {
                let (a, b) = (point(bytes), point(bytes));
                if bytes.byte().is_multiple_of(2) {
                    Shape::Box(Aabb::new(a.min(b), a.max(b)))
                } else {
                    Shape::Obb(Obb { center: a, axes: bytes.turn(), half: (b - a).abs() })
                }
            }
            _ => {
                // In a plane across an axis, or across a diagonal.
                let (at, kind) = (point(bytes), bytes.below(4));
                let corner = |p: Vec2| match kind {
                    0 => Vec3::new(p.x, p.y, 0.0),
                    1 => Vec3::new(0.0, p.x, p.y),
                    2 => Vec3::new(p.y, 0.0, p.x),
                    _ => Vec3::new(p.x, p.y, p.x),
                };
                self.solid.push(bytes.outline().into_iter().map(|p| at + corner(p) * scale).collect());
                return Draft::Polygon(self.solid.len() - 1);
            }
        })
    }

    /// The shape of a draft.
    pub(super) fn shape(&self, draft: &Draft, scale: f32) -> Shape<'_> {
        match draft {
            Draft::Whole(shape) => *shape,
            Draft::Prism(index) => {
                Shape::Prism(Prism { outline: &self.flat[*index], z: [-0.25 * scale, 0.25 * scale] })
            }
            Draft::Polygon(index) => Shape::Polygon(Polygon { corners: &self.solid[*index] }),
        }
    }
}

/// Two points that differ.
fn axis(from: Vec3, to: Vec3, scale: f32) -> (Vec3, Vec3) {
    (from, if from == to { from + Vec3::X * scale } else { to })
}
