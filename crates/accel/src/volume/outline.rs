//! The surface of a volume: what is drawn, and what its size is.

use glam::{DVec2, DVec3, Vec3};

use super::quickhull::outline;
use crate::{Aabb, Axis, Measure, Sphere};

/// The surface of a volume.
#[derive(Clone, Debug, PartialEq)]
pub enum Outline {
    /// Of an axis-aligned box.
    Box(Aabb),
    /// Of a sphere.
    Sphere(Sphere),
    /// Flat faces, each by its corners in order.
    Faces(Vec<Vec<Vec3>>),
}

impl Outline {
    /// The body that lies behind some planes, given by normals and offsets as seen from `center`. It must be
    /// bounded; it may be flat.
    pub fn of_planes(center: Vec3, planes: impl Iterator<Item = (DVec3, f64)>) -> Outline {
        let planes: Vec<(DVec3, f64)> = planes.map(|(n, offset)| (n.normalize(), offset / n.length())).collect();
        let reach = planes.iter().map(|(_, offset)| offset.abs()).fold(0.0, f64::max);
        let thin = reach * 1e-6;
        let face = |&(n, offset): &(DVec3, f64)| {
            // A large square in the plane, cut by all the others.
            let (u, v) = n.any_orthonormal_pair();
            let square = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
            let start = square.map(|(x, y)| n * offset + (u * x + v * y) * (1000.0 * reach)).to_vec();
            let others = planes.iter().filter(|&&(m, other)| (m, other) != (n, offset));
            others.fold(start, |polygon, &(m, other)| cut(&polygon, |p| other + thin - m.dot(p)))
        };
        let faces = planes.iter().map(face).filter(|polygon| polygon.len() > 2);
        Outline::Faces(
            faces.map(|polygon| polygon.iter().map(|&p| (p + center.as_dvec3()).as_vec3()).collect()).collect(),
        )
    }

    /// The box around it.
    pub fn bounds(&self) -> Aabb {
        match self {
            Outline::Box(bounds) => *bounds,
            Outline::Sphere(sphere) => sphere.bounds(),
            Outline::Faces(faces) => Aabb::around(faces.iter().flatten().copied()),
        }
    }

    /// Its area, or the length around what it covers of the x, y plane.
    pub fn measure(&self, measure: Measure) -> f32 {
        match (self, measure) {
            (Outline::Box(bounds), _) => bounds.measure(measure),
            (Outline::Sphere(sphere), Measure::Area) => 4.0 * std::f32::consts::PI * sphere.radius * sphere.radius,
            (Outline::Sphere(sphere), Measure::Perimeter) => 2.0 * std::f32::consts::PI * sphere.radius,
            (Outline::Faces(faces), Measure::Area) => faces.iter().map(|face| area(face).length()).sum::<f64>() as f32,
            (Outline::Faces(faces), Measure::Perimeter) => {
                let flat: Vec<DVec2> = faces.iter().flatten().map(|p| p.truncate().as_dvec2()).collect();
                let around = outline(&flat);
                let next = around.iter().cycle().skip(1);
                around.iter().zip(next).map(|(&a, &b)| flat[a].distance(flat[b])).sum::<f64>() as f32
            }
        }
    }

    /// The volume inside it.
    pub fn content(&self) -> f64 {
        match self {
            Outline::Box(bounds) => bounds.extent().max(Vec3::ZERO).as_dvec3().element_product(),
            Outline::Sphere(sphere) => 4.0 / 3.0 * std::f64::consts::PI * f64::from(sphere.radius).powi(3),
            Outline::Faces(faces) => {
                // A pyramid over each face, with its tip in the middle.
                let middle = self.bounds().center().as_dvec3();
                let pyramid = |face: &Vec<Vec3>| (face[0].as_dvec3() - middle).dot(area(face)).abs() / 3.0;
                faces.iter().map(pyramid).sum()
            }
        }
    }

    /// The polygon that a plane of constant z cuts out of its faces; nothing of a sphere.
    pub fn section(&self, z: f32) -> Vec<Vec3> {
        let Outline::Faces(faces) = self else { return Vec::new() };
        let mut points: Vec<DVec2> = Vec::new();
        for face in faces {
            let next = face.iter().cycle().skip(1);
            for (a, b) in face.iter().zip(next) {
                let (from, to) = (a[Axis::Z] - z, b[Axis::Z] - z);
                if from == 0.0 {
                    points.push(a.truncate().as_dvec2());
                } else if (from < 0.0) != (to < 0.0) {
                    points.push(a.lerp(*b, from / (from - to)).truncate().as_dvec2());
                }
            }
        }
        outline(&points).into_iter().map(|i| points[i].as_vec2().extend(z)).collect()
    }
}

/// A polygon's normal, as long as its area.
fn area(face: &[Vec3]) -> DVec3 {
    let first = face[0].as_dvec3();
    let pairs = face.windows(2).map(|pair| (pair[0].as_dvec3() - first).cross(pair[1].as_dvec3() - first));
    pairs.sum::<DVec3>() * 0.5
}

/// The part of a convex polygon where `inside` is not negative (Sutherland and Hodgman 1974).
fn cut(polygon: &[DVec3], inside: impl Fn(DVec3) -> f64) -> Vec<DVec3> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (i, &p) in polygon.iter().enumerate() {
        let q = polygon[(i + 1) % polygon.len()];
        let (a, b) = (inside(p), inside(q));
        if a >= 0.0 {
            kept.push(p);
        }
        // The edge crosses the plane: keep the crossing.
        if (a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0) {
            kept.push(p + (q - p) * (a / (a - b)));
        }
    }
    kept
}
