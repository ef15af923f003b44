//! The convex hull of points (Barber, Dobkin and Huhdanpaa, "The quickhull algorithm", 1996), as planes.

use std::cmp::Ordering;

use glam::{DVec2, DVec3};

use crate::events::patiently;
use crate::{Cancelled, Grow, Observer};

/// A plane of a hull: the hull lies where `n · p ≤ offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Face {
    /// Outward, length one.
    pub(super) n: DVec3,
    pub(super) offset: f64,
}

impl Face {
    fn through(n: DVec3, p: DVec3) -> Face {
        Face { n, offset: n.dot(p) }
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

/// The hull of at least one point. At most `most` corners are sought, those that stick out furthest first.
pub(super) fn quickhull(points: &[DVec3], most: usize, watch: &impl Observer<Grow>) -> Result<Found, Cancelled> {
    let furthest = |far: &dyn Fn(DVec3) -> f64| {
        let mut found = Furthest::NONE;
        for point in patiently(points.iter().enumerate(), watch) {
            let (i, &p) = point?;
            found = found.or(far(p), i);
        }
        Ok(found.point)
    };
    // Two points far apart, the one furthest from their line, the one furthest from their plane.
    let a = furthest(&|p| p.length_squared())?;
    let b = furthest(&|p| (p - points[a]).length_squared())?;
    let along = points[b] - points[a];
    let thin = along.length() * THIN;
    let Some(u) = along.try_normalize().filter(|_| thin > 0.0) else {
        return Ok(Found { faces: stick(points[a], points[a], DVec3::X), corners: vec![a] });
    };
    let off_line = |p: DVec3| (p - points[a]).reject_from_normalized(u);
    let c = furthest(&|p| off_line(p).length_squared())?;
    if off_line(points[c]).length() <= thin {
        return Ok(Found { faces: stick(points[a], points[b], u), corners: vec![a, b] });
    }
    let v = off_line(points[c]).normalize();
    let base = Face::through(u.cross(v), points[a]);
    let d = furthest(&|p| base.above(p).abs())?;
    if base.above(points[d]).abs() <= thin {
        return Ok(plate(points, points[a], u, v));
    }
    solid(points, [a, b, c, d], thin, most, watch)
}

/// A line or a point: planes at its ends and around it.
fn stick(from: DVec3, to: DVec3, along: DVec3) -> Vec<Face> {
    let (u, v) = along.any_orthonormal_pair();
    let sides = [u, -u, v, -v].map(|n| Face::through(n, from));
    [Face::through(along, to), Face::through(-along, from)].into_iter().chain(sides).collect()
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
    let faces = [Face::through(n, base), Face::through(-n, base)].into_iter().chain(edges).collect();
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
    points: &[DVec3],
    first: [usize; 4],
    thin: f64,
    most: usize,
    watch: &impl Observer<Grow>,
) -> Result<Found, Cancelled> {
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
    share(points, &mut hull, 0..points.len(), thin, watch)?;
    let mut count = 4;
    while count < most {
        // The point furthest before any triangle.
        let all = hull.iter().map(|triangle| triangle.apex);
        let Furthest { far, point: apex } = all.fold(Furthest::NONE, |most, each| most.or(each.far, each.point));
        if far <= thin {
            break;
        }
        // What it sees goes; the edges between seen and unseen are joined to it.
        let (seen, kept): (Vec<Triangle>, Vec<Triangle>) =
            hull.into_iter().partition(|triangle| triangle.face.above(points[apex]) > thin);
        let edges: Vec<[usize; 2]> =
            seen.iter().flat_map(|t| [[0, 1], [1, 2], [2, 0]].map(|[i, j]| [t.corners[i], t.corners[j]])).collect();
        let rim = edges.iter().filter(|&&[from, to]| !edges.contains(&[to, from]));
        let mut fresh: Vec<Triangle> = rim.filter_map(|&[from, to]| triangle([from, to, apex])).collect();
        let homeless = seen.into_iter().flat_map(|triangle| triangle.before).filter(|&i| i != apex);
        share(points, &mut fresh, homeless, thin, watch)?;
        hull = kept;
        hull.append(&mut fresh);
        count += 1;
    }
    let mut corners: Vec<usize> = hull.iter().flat_map(|triangle| triangle.corners).collect();
    corners.sort_unstable();
    corners.dedup();
    Ok(Found { faces: distinct(hull.iter().map(|triangle| triangle.face)), corners })
}

/// Gives each point to the triangle that it lies furthest before; those before none lie inside.
fn share(
    points: &[DVec3],
    hull: &mut [Triangle],
    ids: impl Iterator<Item = usize>,
    thin: f64,
    watch: &impl Observer<Grow>,
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
