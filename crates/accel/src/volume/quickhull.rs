//! The convex hull of points (Barber, Dobkin and Huhdanpaa, "The quickhull algorithm", 1996), as planes.

use std::cmp::Ordering;

use glam::{DVec2, DVec3, Vec3};

use crate::events::patiently;
use crate::{Cancelled, Fit, Observer};

/// A plane of a hull: the hull lies where `n · p ≤ offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Face {
    /// Outward, length one.
    pub(super) n: DVec3,
    pub(super) offset: f64,
    /// Which of the faces ever made it is.
    pub(super) id: u32,
}

impl Face {
    fn through(n: DVec3, p: DVec3) -> Face {
        Face { n, offset: n.dot(p), id: 0 }
    }

    fn above(&self, p: DVec3) -> f64 {
        self.n.dot(p) - self.offset
    }
}

/// The planes of a hull, and which points are its corners.
pub(super) struct Found {
    pub(super) faces: Vec<Face>,
    pub(super) corners: Vec<usize>,
}

/// Points closer to a plane than this part of the hull's size count as lying in it.
const THIN: f64 = 1e-6;

/// The hull of at least one point. At most `most` corners are sought, those that stick out furthest first. The points
/// are seen from `base`, the middle of the box.
pub(super) fn quickhull(
    points: &[DVec3],
    base: DVec3,
    most: usize,
    watch: &mut impl Observer<Fit>,
) -> Result<Found, Cancelled> {
    let told = Told { points, base };
    // Two points far apart, the one furthest from their line, the one furthest from their plane.
    let a = furthest(points, DVec3::length_squared, watch)?;
    told.seed(a, points[a].length(), 1, watch);
    let b = furthest(points, |p| (p - points[a]).length_squared(), watch)?;
    let along = points[b] - points[a];
    let thin = along.length() * THIN;
    let Some(u) = along.try_normalize().filter(|_| thin > 0.0) else {
        return Ok(Found { faces: stick(points[a], points[a], DVec3::X), corners: vec![a] });
    };
    told.seed(b, along.length(), 2, watch);
    let off_line = |p: DVec3| (p - points[a]).reject_from_normalized(u);
    let c = furthest(points, |p| off_line(p).length_squared(), watch)?;
    if off_line(points[c]).length() <= thin {
        return Ok(Found { faces: stick(points[a], points[b], u), corners: vec![a, b] });
    }
    told.seed(c, off_line(points[c]).length(), 3, watch);
    let v = off_line(points[c]).normalize();
    let flat = Face::through(u.cross(v), points[a]);
    let d = furthest(points, |p| flat.above(p).abs(), watch)?;
    if flat.above(points[d]).abs() <= thin {
        return Ok(plate(points, points[a], u, v));
    }
    told.seed(d, flat.above(points[d]).abs(), 4, watch);
    solid(&told, [a, b, c, d], thin, most, watch)
}

/// The point for which `far` is largest.
fn furthest(points: &[DVec3], far: impl Fn(DVec3) -> f64, watch: &mut impl Observer<Fit>) -> Result<usize, Cancelled> {
    let mut found = Furthest::NONE;
    for point in patiently(points.iter().enumerate(), watch) {
        let (i, &p) = point?;
        found = found.or(far(p), i);
    }
    Ok(found.point)
}

/// The points, and where in the world they are seen from: what is told of them is the world's.
struct Told<'a> {
    points: &'a [DVec3],
    base: DVec3,
}

impl Told<'_> {
    fn at(&self, point: usize) -> Vec3 {
        (self.base + self.points[point]).as_vec3()
    }

    fn seed(&self, point: usize, far: f64, count: u32, watch: &mut impl Observer<Fit>) {
        let Vec3 { x, y, z } = self.at(point);
        watch.on(Fit::Seed { point: point as u32, x, y, z, far: far as f32, count });
    }

    fn apex(&self, point: usize, far: f64, count: usize, watch: &mut impl Observer<Fit>) {
        let Vec3 { x, y, z } = self.at(point);
        watch.on(Fit::Apex { point: point as u32, x, y, z, far: far as f32, count: count as u32 });
    }
}

/// Faces with numbers in their order.
fn numbered(faces: impl IntoIterator<Item = Face>) -> Vec<Face> {
    faces.into_iter().zip(0..).map(|(face, id)| Face { id, ..face }).collect()
}

/// A line or a point: planes at its ends and around it.
fn stick(from: DVec3, to: DVec3, along: DVec3) -> Vec<Face> {
    let (u, v) = along.any_orthonormal_pair();
    let sides = [u, -u, v, -v].map(|n| Face::through(n, from));
    numbered([Face::through(along, to), Face::through(-along, from)].into_iter().chain(sides))
}

/// Points in one plane: both sides of it, and a plane through each edge of their outline.
fn plate(points: &[DVec3], base: DVec3, u: DVec3, v: DVec3) -> Found {
    let flat: Vec<DVec2> = points.iter().map(|&p| DVec2::new(u.dot(p - base), v.dot(p - base))).collect();
    let corners = outline(&flat);
    let n = u.cross(v);
    let next = corners.iter().cycle().skip(1);
    let edges = corners.iter().zip(next).filter_map(|(&a, &b)| {
        let side = (points[b] - points[a]).cross(n).try_normalize()?;
        Some(Face::through(side, points[a]))
    });
    let faces = numbered([Face::through(n, base), Face::through(-n, base)].into_iter().chain(edges));
    Found { faces, corners }
}

/// The corners of the smallest convex polygon around points of a plane, against the clock (Andrew's monotone
/// chain, 1979).
pub fn outline(points: &[DVec2]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    let place = |a: DVec2, b: DVec2| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y));
    order.sort_by(|&a, &b| place(points[a], points[b]));
    order.dedup_by(|a, b| place(points[*a], points[*b]) == Ordering::Equal);
    if order.len() < 3 {
        return order;
    }
    let half = |order: &mut dyn Iterator<Item = usize>| {
        let mut chain: Vec<usize> = Vec::new();
        for i in order {
            while let [.., a, b] = chain[..] {
                if (points[b] - points[a]).perp_dot(points[i] - points[b]) > 0.0 {
                    break;
                }
                chain.pop();
            }
            chain.push(i);
        }
        chain.pop();
        chain
    };
    let mut lower = half(&mut order.iter().copied());
    lower.extend(half(&mut order.iter().rev().copied()));
    lower
}

/// The point that lies furthest out so far; of equals the first.
#[derive(Clone, Copy)]
struct Furthest {
    far: f64,
    point: usize,
}

impl Furthest {
    const NONE: Furthest = Furthest { far: f64::NEG_INFINITY, point: 0 };

    fn or(self, far: f64, point: usize) -> Furthest {
        if far > self.far || (far == self.far && point < self.point) { Furthest { far, point } } else { self }
    }
}

/// A triangle of the hull with the points that lie before it.
struct Triangle {
    corners: [usize; 3],
    face: Face,
    before: Vec<usize>,
    apex: Furthest,
}

/// A body: a tetrahedron that grows by the point furthest outside.
fn solid(
    told: &Told<'_>,
    first: [usize; 4],
    thin: f64,
    most: usize,
    watch: &mut impl Observer<Fit>,
) -> Result<Found, Cancelled> {
    let points = told.points;
    let middle = first.iter().map(|&i| points[i]).sum::<DVec3>() / 4.0;
    let triangle = |[a, b, c]: [usize; 3]| {
        let n = (points[b] - points[a]).cross(points[c] - points[a]).try_normalize()?;
        let face = Face::through(n, points[a]);
        Some(Triangle { corners: [a, b, c], face, before: Vec::new(), apex: Furthest::NONE })
    };
    // The four triangles of the tetrahedron, all turned outward.
    let [a, b, c, d] = first;
    let start = [[a, b, c], [a, b, d], [a, c, d], [b, c, d]].into_iter().filter_map(|corners| {
        let found = triangle(corners)?;
        if found.face.above(middle) > 0.0 { triangle([corners[0], corners[2], corners[1]]) } else { Some(found) }
    });
    let mut hull: Vec<Triangle> = start.collect();
    let mut made = 0;
    share(points, &mut hull, 0..points.len(), thin, watch)?;
    tell_made(&mut hull, &mut made, watch);
    let mut count = 4;
    while count < most {
        // The point furthest before any triangle.
        let all = hull.iter().map(|triangle| triangle.apex);
        let Furthest { far, point: apex } = all.fold(Furthest::NONE, |most, each| most.or(each.far, each.point));
        if far <= thin {
            break;
        }
        count += 1;
        told.apex(apex, far, count, watch);
        // What it sees goes; the edges between seen and unseen are joined to it.
        let (seen, kept): (Vec<Triangle>, Vec<Triangle>) =
            hull.into_iter().partition(|triangle| triangle.face.above(points[apex]) > thin);
        for triangle in &seen {
            watch.on(Fit::Hide { face: triangle.face.id });
        }
        let edges: Vec<[usize; 2]> =
            seen.iter().flat_map(|t| [[0, 1], [1, 2], [2, 0]].map(|[i, j]| [t.corners[i], t.corners[j]])).collect();
        let rim = edges.iter().filter(|&&[from, to]| !edges.contains(&[to, from]));
        let mut fresh: Vec<Triangle> = rim.filter_map(|&[from, to]| triangle([from, to, apex])).collect();
        let homeless = seen.into_iter().flat_map(|triangle| triangle.before).filter(|&i| i != apex);
        share(points, &mut fresh, homeless, thin, watch)?;
        tell_made(&mut fresh, &mut made, watch);
        hull = kept;
        hull.append(&mut fresh);
    }
    let far = hull.iter().map(|triangle| triangle.apex.far).fold(0.0, f64::max);
    let mut corners: Vec<usize> = hull.iter().flat_map(|triangle| triangle.corners).collect();
    corners.sort_unstable();
    corners.dedup();
    watch.on(Fit::Enough { faces: hull.len() as u32, corners: corners.len() as u32, far: far as f32 });
    Ok(Found { faces: distinct(hull.iter().map(|triangle| triangle.face)), corners })
}

/// Numbers triangles that came to be, and tells of each.
fn tell_made(fresh: &mut [Triangle], made: &mut u32, watch: &mut impl Observer<Fit>) {
    for triangle in fresh {
        let face = *made;
        (triangle.face.id, *made) = (face, face + 1);
        let [a, b, c] = triangle.corners.map(|corner| corner as u32);
        let (before, far) = (triangle.before.len() as u32, triangle.apex.far.max(0.0) as f32);
        watch.on(Fit::Make { face, a, b, c, before, far });
    }
}

/// Gives each point to the triangle that it lies furthest before; those before none lie inside.
fn share(
    points: &[DVec3],
    hull: &mut [Triangle],
    ids: impl Iterator<Item = usize>,
    thin: f64,
    watch: &mut impl Observer<Fit>,
) -> Result<(), Cancelled> {
    for i in patiently(ids, watch) {
        let i = i?;
        let best = hull.iter_mut().map(|triangle| (triangle.face.above(points[i]), triangle));
        if let Some((above, triangle)) = best.max_by(|a, b| a.0.total_cmp(&b.0))
            && above > thin
        {
            triangle.before.push(i);
            triangle.apex = triangle.apex.or(above, i);
        }
    }
    Ok(())
}

/// Triangles in one plane make one face.
fn distinct(faces: impl Iterator<Item = Face>) -> Vec<Face> {
    let mut kept: Vec<Face> = Vec::new();
    for face in faces {
        if !kept.iter().any(|other| (other.n - face.n).length_squared() <= THIN * THIN) {
            kept.push(face);
        }
    }
    kept
}
