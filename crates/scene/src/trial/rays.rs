//! Rays to disagree about: most of them touch something exactly.

use glam::Vec3;
use raystep_accel::{
    Aabb, Accel, Axis, List, NodeId, Obb, Outline, PrimId, Primitives, Prims, Random, Ray, Shape, Structure,
};

/// What rays of a scene aim at.
pub struct Targets {
    bounds: Aabb,
    flat: bool,
    /// For each primitive points on it: corners, middles of edges, the centroid.
    points: Vec<Vec<Vec3>>,
    /// For each axis where something lies exactly: corners, faces of boxes, planes of structures.
    places: [Vec<f32>; 3],
    /// Three points in each of some planes that stand as they like: those of BSP trees, and the faces of volumes.
    planes: Vec<[Vec3; 3]>,
}

/// In how many ways rays are aimed; each is tried once in so many rays.
pub const AIMS: u32 = 19;

/// Of each tree so many nodes at most give their planes.
const NODES: usize = 48;

impl Targets {
    /// What rays aim at in a scene with these structures.
    pub fn of(prims: &Prims, flat: bool, structures: &[&Structure]) -> Targets {
        let ids = || (0..prims.len() as u32).map(PrimId);
        let points: Vec<_> = ids().map(|prim| points_on(&prims.shape(prim))).collect();
        let mut corners: Vec<Vec3> = points.iter().flatten().copied().collect();
        let mut bounds = Aabb::EMPTY;
        for prim in ids() {
            let own = prims.bounds(prim);
            bounds = bounds.union(own);
            corners.extend([own.min, own.max]);
        }
        for structure in structures {
            corners.extend(structure.node_bounds().iter().flat_map(|bounds| [bounds.min, bounds.max]));
            if let Some(grid) = structure.grid() {
                let cells = (0..grid.cell_count() as u32).map(raystep_accel::CellId);
                corners.extend(cells.step_by(7).map(|cell| grid.cell_bounds(cell).max));
            }
        }
        corners.retain(|p| p.is_finite());
        if bounds.is_empty() {
            bounds = Aabb::new(Vec3::splat(-1.0), Vec3::ONE);
            corners.push(Vec3::ZERO);
        }
        let places = Axis::ALL.map(|axis| corners.iter().map(|p| p[axis]).collect());
        let mut planes: Vec<_> = structures.iter().flat_map(|structure| planes_of(structure)).collect();
        planes.retain(|points| points.iter().all(|p| p.is_finite()));
        Targets { bounds, flat, points, places, planes }
    }

    /// A ray, one of many kinds in turn. `i` says which.
    pub fn ray(&self, prims: &Prims, i: u32, random: &mut Random) -> Option<Ray> {
        let (mut o, mut d) = self.line(i, random);
        d = self.as_long_as(d, i / AIMS);
        if self.flat && !i.is_multiple_of(5) {
            (o.z, d.z) = (0.0, 0.0);
        }
        let ray = Ray::new(o, d).ok()?;
        self.range(ray, prims, i, random)
    }

    /// The longest side of the box around everything.
    fn size(&self) -> f32 {
        self.bounds.extent().max_element().max(f32::from_bits(1))
    }

    /// The direction in one of many lengths.
    fn as_long_as(&self, d: Vec3, number: u32) -> Vec3 {
        let along = d / d.abs().max_element();
        match number % 10 {
            3 => d * 1e9,
            4 => d * 1e-9,
            5 => d * 0.37,
            6 => along,
            // So slow that t comes near the largest number, and so fast that it comes near the smallest.
            7 => along * (self.size() * 1e-37).max(1e-43),
            8 => along * ((self.size() * 1e38).min(1e36) * 100.0),
            _ => d,
        }
    }

    /// An origin and a direction.
    fn line(&self, i: u32, random: &mut Random) -> (Vec3, Vec3) {
        let size = self.size();
        let outside = self.bounds.center() + direction(random) * size * random.range(0.9, 3.0);
        match i % AIMS {
            // From outside to anywhere.
            0 => (outside, self.inside(random) - outside),
            // From anywhere inside.
            1 => (self.inside(random), direction(random)),
            // Along an axis, through where something lies exactly; the other components are zeros of either sign.
            2 | 3 => {
                let axis = random.below(3) as usize;
                let mut d = Vec3::ZERO * direction(random);
                d[axis] = if random.below(2) == 0 { 1.0 } else { -1.0 };
                let mut o = self.place(random);
                if i % AIMS == 2 {
                    o[axis] = self.bounds.center()[axis] - d[axis] * size * 2.0;
                }
                (o, d)
            }
            // In the plane of a face, across one axis.
            4 => {
                let (mut o, mut d) = (self.place(random), direction(random));
                d[random.below(3) as usize] *= 0.0;
                if random.below(2) == 0 {
                    o -= d * size * 2.0;
                }
                (o, d)
            }
            // At corners, edges and middles of primitives.
            5 | 6 => (outside, self.point(random) - outside),
            7 => (self.inside(random), self.point(random) - self.inside(random)),
            // From a point on a primitive, away or to another one.
            8 => (self.point(random), direction(random)),
            9 => {
                let from = self.point(random);
                (from, self.point(random) - from)
            }
            // Along an edge, in the plane of a primitive, or tangent to a sphere.
            10 => {
                let (a, b) = self.two_points(random);
                (a - (b - a) * 2.0, b - a)
            }
            // At the corners and edges of the box around everything.
            11 => {
                let mut at = self.bounds.center();
                for axis in Axis::ALL {
                    at[axis] = [self.bounds.min[axis], at[axis], self.bounds.max[axis]][random.below(3) as usize];
                }
                (outside, at - outside)
            }
            // Diagonally over lattice points.
            12 => {
                let d =
                    Vec3::new(random.below(3) as f32 - 1.0, random.below(3) as f32 - 1.0, random.below(3) as f32 - 1.0);
                (self.place(random) - d * size, d)
            }
            // Nearly along an axis.
            13 => {
                let mut d = direction(random) * 10f32.powi(-(random.below(30) as i32));
                d[random.below(3) as usize] = 1.0;
                (self.point(random) - d * size * 2.0, d)
            }
            // From far away, on both sides of what a margin covers.
            14 => {
                let o = self.bounds.center() + direction(random) * size * random.range(50.0, 120.0);
                (o, self.point(random) - o)
            }
            15 => {
                let o = self.bounds.center() + direction(random) * size * 10f32.powi(random.below(6) as i32);
                (o, self.inside(random) - o)
            }
            // Along an axis, from as far away as numbers go.
            16 => {
                let (mut o, mut d) = (self.place(random), Vec3::ZERO);
                let axis = random.below(3) as usize;
                d[axis] = if random.below(2) == 0 { 1.0 } else { -1.0 };
                o[axis] -= d[axis] * size * 10f32.powi(random.below(38) as i32);
                (o.clamp(Vec3::splat(-3e38), Vec3::splat(3e38)), d)
            }
            // Within a plane of a structure.
            17 if !self.planes.is_empty() => {
                let [a, b, c] = self.planes[random.below(self.planes.len() as u32) as usize];
                let at = [a, b.lerp(c, random.unit()), a.lerp(b, 0.5)][random.below(3) as usize];
                let d = [b - a, c - a, (b - a) + (c - a) * random.unit()][random.below(3) as usize];
                (if random.below(2) == 0 { at - d * 2.0 } else { at }, d)
            }
            // Away from everything.
            _ => (outside, outside - self.inside(random)),
        }
    }

    /// Every third ray ends or begins at its hit, or one step of the numbers beside it.
    fn range(&self, ray: Ray, prims: &Prims, i: u32, random: &mut Random) -> Option<Ray> {
        let Some(hit) = i.is_multiple_of(3).then(|| List.intersect(prims, &ray, &mut ())).flatten() else {
            return Some(ray);
        };
        let end = [hit.t, hit.t.next_up(), hit.t.next_down()][random.below(3) as usize];
        if random.below(2) == 0 { ray.within(0.0, end) } else { ray.within(end, f32::INFINITY) }.ok()
    }

    fn inside(&self, random: &mut Random) -> Vec3 {
        self.bounds.min + self.bounds.extent() * Vec3::new(random.unit(), random.unit(), random.unit())
    }

    fn place(&self, random: &mut Random) -> Vec3 {
        let mut one = |places: &[f32]| places[random.below(places.len() as u32) as usize];
        Vec3::from(self.places.each_ref().map(|places| one(places)))
    }

    fn point(&self, random: &mut Random) -> Vec3 {
        self.two_points(random).0
    }

    /// Two points of the same primitive.
    fn two_points(&self, random: &mut Random) -> (Vec3, Vec3) {
        if self.points.is_empty() {
            return (Vec3::ZERO, Vec3::X);
        }
        let points = &self.points[random.below(self.points.len() as u32) as usize];
        let mut one = || points[random.below(points.len() as u32) as usize];
        (one(), one())
    }
}

/// Three points in each plane of some nodes.
fn planes_of(structure: &Structure) -> Vec<[Vec3; 3]> {
    let nodes = (0..structure.node_count() as u32).step_by(structure.node_count().div_ceil(NODES).max(1)).map(NodeId);
    let faces = nodes.flat_map(|node| match structure {
        Structure::Bsp(tree) => tree.plane(node).map(|plane| tree.cell(node).section(plane)).into_iter().collect(),
        Structure::Bvh(tree) => match tree.outline(node) {
            Outline::Faces(faces) => faces,
            Outline::Sphere(ball) => {
                let r = ball.radius;
                let pole = ball.center + Vec3::X * r;
                vec![vec![pole, pole + Vec3::Y * r, pole + Vec3::Z * r]]
            }
            // Its faces are among the places.
            Outline::Box(_) => Vec::new(),
        },
        _ => Vec::new(),
    });
    faces.filter_map(|face| face.first_chunk().copied()).collect()
}

fn direction(random: &mut Random) -> Vec3 {
    Vec3::new(random.range(-1.0, 1.0), random.range(-1.0, 1.0), random.range(-1.0, 1.0))
}

fn points_on(shape: &Shape<'_>) -> Vec<Vec3> {
    let polygon = |corners: &[Vec3]| {
        let next = corners.iter().cycle().skip(1);
        let middles: Vec<Vec3> = corners.iter().zip(next).map(|(&a, &b)| a * 0.5 + b * 0.5).collect();
        let centroid = corners.iter().sum::<Vec3>() / corners.len() as f32;
        [corners, &middles, &[centroid]].concat()
    };
    match shape {
        Shape::Triangle(t) => polygon(&[t.a, t.b, t.c]),
        Shape::Sphere(s) => {
            // Its poles, and the corners of the square around a meridian: between them runs a tangent.
            let r = s.radius;
            let ends = Vec3::AXES.into_iter().flat_map(|axis| [axis * r, axis * -r]);
            let square = [Vec3::new(r, r, 0.0), Vec3::new(r, -r, 0.0), Vec3::new(-r, r, 0.0), Vec3::new(0.0, r, r)];
            ends.chain(square).chain([Vec3::ZERO]).map(|p| s.center + p).collect()
        }
        Shape::Disc(d) => {
            let u = d.normal.any_orthonormal_vector() * d.radius;
            let v = d.normal.cross(u);
            vec![d.center, d.center + u, d.center - u, d.center + v, d.center - v]
        }
        Shape::Cylinder(c) => {
            let rim = (c.to - c.from).normalize_or(Vec3::X).any_orthonormal_vector() * c.radius;
            vec![c.from, c.to, c.from + rim, c.from - rim, c.to + rim, c.to - rim]
        }
        Shape::Cone(c) => {
            let rim = (c.base - c.apex).normalize_or(Vec3::X).any_orthonormal_vector() * c.radius;
            vec![c.apex, c.base, c.base + rim, c.base - rim]
        }
        Shape::Polygon(p) => polygon(p.corners),
        Shape::Box(b) => Obb::from_aabb(b).corners().to_vec(),
        Shape::Obb(o) => [&o.corners()[..], &[o.center]].concat(),
        Shape::Wall(w) => polygon(&[w.from.extend(0.0), w.to.extend(0.0), w.to.extend(w.z[1]), w.from.extend(w.z[0])]),
        Shape::Prism(p) => polygon(&p.outline.iter().map(|p| p.extend(0.0)).collect::<Vec<_>>()),
    }
}
