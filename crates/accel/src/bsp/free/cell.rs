//! What of space a BSP tree's node covers: a box cut by planes, which is convex.

use glam::{DVec3, Vec3};

use super::FreePlane;
use crate::objects::clipped;
use crate::{Aabb, Measure};

/// A convex part of space by its faces. Only builders and pictures need it; a walk does without.
#[derive(Clone, Debug, PartialEq)]
pub struct ConvexCell {
    /// The first is the floor, as long as planes stand upright.
    faces: Vec<Face>,
}

/// A face, its corners anticlockwise for who looks at it from outside.
#[derive(Clone, Debug, PartialEq)]
struct Face {
    /// Pointing outward; all of the cell lies at or below `at` along it.
    normal: DVec3,
    at: f64,
    corners: Vec<DVec3>,
}

impl ConvexCell {
    /// All of a box.
    pub fn of(bounds: &Aabb) -> ConvexCell {
        if bounds.is_empty() {
            return ConvexCell { faces: Vec::new() };
        }
        let (min, max) = (bounds.min.as_dvec3(), bounds.max.as_dvec3());
        let face = |z: usize, is_upper: bool| {
            let (x, y) = ((z + 1) % 3, (z + 2) % 3);
            let mut corners = [[min[x], min[y]], [max[x], min[y]], [max[x], max[y]], [min[x], max[y]]].map(|[u, v]| {
                let mut corner = if is_upper { max } else { min };
                (corner[x], corner[y]) = (u, v);
                corner
            });
            let mut normal = DVec3::AXES[z];
            if !is_upper {
                corners.reverse();
                normal = -normal;
            }
            Face { normal, at: normal.dot(corners[0]), corners: corners.to_vec() }
        };
        ConvexCell { faces: [2, 0, 1].into_iter().flat_map(|z| [face(z, false), face(z, true)]).collect() }
    }

    /// The box around it.
    pub fn bounds(&self) -> Aabb {
        Aabb::around(self.faces.iter().flat_map(|face| &face.corners).map(|p| p.as_vec3()))
    }

    /// The corners of each face in order; in a flat scene, those of the floor come first.
    pub fn faces(&self) -> impl Iterator<Item = Vec<Vec3>> + '_ {
        self.faces.iter().map(|face| face.corners.iter().map(|p| p.as_vec3()).collect())
    }

    /// Where its corners lie along a direction: the first and the last.
    pub(super) fn extent(&self, along: DVec3) -> [f64; 2] {
        extent(self.faces.iter().map(|face| &face.corners), along)
    }

    /// The polygon in which a plane cuts it; no corners if it passes beside.
    pub fn section(&self, plane: FreePlane) -> Vec<Vec3> {
        self.sheet(plane).iter().map(|p| p.as_vec3()).collect()
    }

    /// Starts from a sheet larger than the cell; every face cuts off what lies outside.
    fn sheet(&self, plane: FreePlane) -> Vec<DVec3> {
        let corners: Vec<DVec3> = self.faces.iter().flat_map(|face| &face.corners).copied().collect();
        let Some(&first) = corners.first() else { return Vec::new() };
        let normal = plane.normal.as_dvec3();
        let middle = first - normal * (plane.height(first) / normal.length_squared());
        let size = corners.iter().map(|p| p.distance(first)).fold(0.0, f64::max) * 2.0;
        let (u, v) = normal.normalize().any_orthonormal_pair();
        let (u, v) = if u.cross(v).dot(normal) < 0.0 { (v, u) } else { (u, v) };
        let mut sheet: Vec<DVec3> =
            [-u - v, u - v, u + v, v - u].into_iter().map(|corner| middle + corner * size).collect();
        for face in &self.faces {
            sheet = kept(&sheet, |p| face.at - face.normal.dot(p));
        }
        sheet
    }

    /// What lies below a plane, and what above.
    pub(crate) fn cut(&self, plane: FreePlane) -> [ConvexCell; 2] {
        let sheet = self.sheet(plane);
        [1.0, -1.0].map(|side| {
            let clip = |face: &Face| Face { corners: kept(&face.corners, |p| -side * plane.height(p)), ..face.clone() };
            let mut faces: Vec<Face> = self.faces.iter().map(clip).collect();
            let mut corners = sheet.clone();
            if side < 0.0 {
                corners.reverse();
            }
            faces.push(Face { normal: plane.normal.as_dvec3() * side, at: f64::from(plane.at) * side, corners });
            faces.retain(|face| face.corners.len() > 2);
            ConvexCell { faces }
        })
    }

    /// The size of its surface, or the length of its outline in a flat scene.
    pub fn measure(&self, measure: Measure) -> f32 {
        self.size(measure) as f32
    }

    /// The same in double precision.
    pub(super) fn size(&self, measure: Measure) -> f64 {
        match measure {
            Measure::Area => self.faces.iter().map(|face| area(&face.corners).length() / 2.0).sum(),
            Measure::Perimeter => self.floor().map_or(0.0, outline),
        }
    }

    /// The measures of what lies below a plane and above it, without cutting.
    pub(super) fn halves(&self, plane: FreePlane, measure: Measure) -> [f64; 2] {
        match measure {
            Measure::Area => {
                let (mut below, mut above, mut open) = (0.0, 0.0, DVec3::ZERO);
                for face in &self.faces {
                    let mut part = Area::default();
                    clipped(&face.corners, |p| -plane.height(p), |p| part.add(p));
                    below += part.sum.length();
                    above += (area(&face.corners) - part.sum).length();
                    open += part.sum;
                }
                // The areas of a closed surface, as vectors, sum to zero: what is missing is the cut's.
                let section = open.length();
                [below + section, above + section].map(|twice| twice / 2.0)
            }
            Measure::Perimeter => [-1.0, 1.0]
                .map(|side| self.floor().map_or(0.0, |floor| outline(&kept(floor, |p| side * plane.height(p))))),
        }
    }

    /// The corners of the floor; in a flat scene all there is to see.
    fn floor(&self) -> Option<&[DVec3]> {
        self.faces.first().map(|face| face.corners.as_slice())
    }
}

/// Where along a direction the corners of some faces begin and end.
pub(super) fn extent(faces: impl IntoIterator<Item: AsRef<[DVec3]>>, along: DVec3) -> [f64; 2] {
    let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
    for face in faces {
        for &p in face.as_ref() {
            let at = along.dot(p);
            (low, high) = (low.min(at), high.max(at));
        }
    }
    [low, high]
}

/// The part of a polygon where `inside` is not negative.
pub(super) fn kept(corners: &[DVec3], inside: impl Fn(DVec3) -> f64) -> Vec<DVec3> {
    let mut part = Vec::with_capacity(corners.len() + 1);
    clipped(corners, inside, |p| part.push(p));
    part
}

/// Twice the area of a polygon while its corners come in, as a vector across it.
#[derive(Default)]
struct Area {
    first: Option<DVec3>,
    last: DVec3,
    sum: DVec3,
}

impl Area {
    fn add(&mut self, p: DVec3) {
        if let Some(first) = self.first {
            self.sum += (self.last - first).cross(p - first);
        } else {
            self.first = Some(p);
        }
        self.last = p;
    }
}

/// Twice the area of a polygon, as a vector across it.
fn area(corners: &[DVec3]) -> DVec3 {
    let mut area = Area::default();
    for &p in corners {
        area.add(p);
    }
    area.sum
}

/// How long it is around a polygon.
fn outline(corners: &[DVec3]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| a.distance(*b)).sum()
}
