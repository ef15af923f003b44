//! A primitive on its way down a BSP tree: the part of it that lies in the node, cut as a polygon is cut.

use std::rc::Rc;

use glam::{DVec3, Vec3};

use super::cell::{extent, kept};
use super::{ConvexCell, FreePlane};
use crate::{Aabb, PrimId, Shape, Wall};

/// A fragment refers to the primitive that it is of: rays test the whole. What is cut only says where.
#[derive(Clone, Debug)]
pub(super) struct Fragment {
    pub(super) prim: PrimId,
    body: Rc<Body>,
}

/// Where a fragment lies.
#[derive(Debug)]
enum Body {
    /// In some polygons, by their corners.
    Faces(Vec<Vec<DVec3>>),
    /// In a ball, or in a round plate across its axis. What is no polygon is not cut.
    Round { center: DVec3, radius: f64, axis: Option<DVec3> },
    /// Somewhere between some corners.
    Between(Vec<DVec3>),
}

impl Fragment {
    /// All of a primitive.
    pub(super) fn of(prim: PrimId, shape: &Shape<'_>) -> Fragment {
        let body = match shape {
            Shape::Sphere(ball) => {
                Body::Round { center: ball.center.as_dvec3(), radius: ball.radius.into(), axis: None }
            }
            Shape::Disc(plate) => Body::Round {
                center: plate.center.as_dvec3(),
                radius: plate.radius.into(),
                axis: plate.normal.as_dvec3().try_normalize(),
            },
            _ => faces(shape).map_or_else(|| Body::Between(corners(&shape.bounds())), Body::Faces),
        };
        Fragment { prim, body: Rc::new(body) }
    }

    /// Where along a direction it begins and ends.
    pub(super) fn extent(&self, along: DVec3) -> [f64; 2] {
        match &*self.body {
            Body::Faces(faces) => extent(faces, along),
            Body::Between(corners) => extent([corners], along),
            &Body::Round { center, radius, axis } => {
                // A plate reaches less far along its own axis than across it.
                let tilt = axis.map_or(0.0, |axis| along.dot(axis));
                let (at, reach) = (along.dot(center), radius * (along.length_squared() - tilt * tilt).max(0.0).sqrt());
                [at - reach, at + reach]
            }
        }
    }

    /// Its parts below and above a plane, each `pad` larger than that.
    pub(super) fn cut(&self, plane: FreePlane, pad: f64) -> [Fragment; 2] {
        [-1.0, 1.0].map(|side| match &*self.body {
            Body::Faces(faces) => {
                let part = |face: &Vec<DVec3>| kept(face, |p| side * plane.height(p) + pad);
                let faces = faces.iter().map(part).filter(|part| !part.is_empty()).collect();
                Fragment { prim: self.prim, body: Rc::new(Body::Faces(faces)) }
            }
            Body::Round { .. } | Body::Between(_) => self.clone(),
        })
    }
}

/// The eight corners of a box.
fn corners(bounds: &Aabb) -> Vec<DVec3> {
    let end = |upper: usize| if upper == 0 { bounds.min } else { bounds.max };
    (0..8).map(|i| Vec3::new(end(i & 1).x, end(i & 2).y, end(i & 4).z).as_dvec3()).collect()
}

/// A direction in which planes are worth weighing.
#[derive(Clone, Copy)]
pub(super) enum Proposal {
    /// On both sides of the fragment.
    Across(DVec3),
    /// Only where the fragment ends.
    Beyond(DVec3),
}

/// The directions of the planes that a primitive proposes: across its polygons, and outward across their
/// edges. What has none proposes the axes, and a plate its own.
pub(super) fn proposals(shape: &Shape<'_>) -> Vec<Proposal> {
    let Some(faces) = faces(shape) else {
        let own = if let Shape::Disc(plate) = shape { Some(plate.normal.as_dvec3()) } else { None };
        return own.into_iter().chain(DVec3::AXES).map(Proposal::Across).collect();
    };
    let mut all = Vec::new();
    for face in &faces {
        let edges = || face.iter().zip(face.iter().cycle().skip(1));
        let normal: DVec3 = edges().map(|(a, b)| (*a - face[0]).cross(*b - face[0])).sum();
        all.push(Proposal::Across(normal));
        all.extend(edges().map(|(a, b)| Proposal::Beyond((*b - *a).cross(normal))));
    }
    all
}

/// The polygons that a shape consists of, if it does.
fn faces(shape: &Shape<'_>) -> Option<Vec<Vec<DVec3>>> {
    let polygon = |corners: &[Vec3]| corners.iter().map(|p| p.as_dvec3()).collect();
    let upright = |Wall { from, to, z: [foot, head] }: Wall| {
        polygon(&[from.extend(foot), to.extend(foot), to.extend(head), from.extend(head)])
    };
    match shape {
        Shape::Triangle(t) => Some(vec![polygon(&[t.a, t.b, t.c])]),
        Shape::Polygon(flat) => Some(vec![polygon(flat.corners)]),
        Shape::Wall(wall) => Some(vec![upright(*wall)]),
        Shape::Prism(prism) => Some(prism.walls().map(upright).collect()),
        Shape::Box(bounds) => Some(ConvexCell::of(bounds).faces().map(|face| polygon(&face)).collect()),
        _ => None,
    }
}
