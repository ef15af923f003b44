//! Smooth shading: the normal at a point of a triangle, blended from those of the faces around its corners
//! (Gouraud's corner normals, blended as Phong does).

use std::collections::HashMap;

use glam::Vec3;
use raystep_accel::{PrimId, Primitives, Prims, Shape, Triangle};

/// Faces whose normals differ by more than this many degrees keep the edge between them: its cosine, 40°.
const CREASE: f32 = 0.766;

/// The faces around every corner of a mesh: their normals, as long as twice their area, by the corner's bits.
pub(super) struct Smooth {
    around: HashMap<[u32; 3], Vec<Vec3>>,
}

impl Smooth {
    /// Looks at all triangles; what is no mesh has no corners in common.
    pub(super) fn of(prims: &Prims) -> Smooth {
        let mut around: HashMap<_, Vec<Vec3>> = HashMap::new();
        if !matches!(prims, Prims::Instances(_)) {
            for prim in 0..prims.len() as u32 {
                let Shape::Triangle(face) = prims.shape(PrimId(prim)) else { continue };
                for corner in [face.a, face.b, face.c] {
                    around.entry(key(corner)).or_default().push(across(&face));
                }
            }
        }
        Smooth { around }
    }

    /// The normal at a point of a triangle, on the side of the triangle's own; nothing for other shapes, and where
    /// the faces around cancel each other.
    pub(super) fn normal(&self, shape: &Shape<'_>, at: Vec3) -> Option<Vec3> {
        let Shape::Triangle(face) = shape else { return None };
        let own = across(face);
        let area = own.length_squared();
        if area == 0.0 {
            return None;
        }
        // The shares of the corners: areas over the area.
        let share = |from: Vec3, to: Vec3| (to - from).cross(at - from).dot(own) / area;
        let corners =
            [(face.a, share(face.b, face.c)), (face.b, share(face.c, face.a)), (face.c, share(face.a, face.b))];
        let blended: Vec3 = corners.into_iter().map(|(corner, share)| self.at_corner(corner, own) * share).sum();
        blended.try_normalize()
    }

    /// The normal of a corner, as the face with this normal sees it: of the faces around that lie nearly as it does.
    fn at_corner(&self, corner: Vec3, own: Vec3) -> Vec3 {
        let unit = own.normalize_or_zero();
        let around = self.around.get(&key(corner)).map_or(&[][..], Vec::as_slice);
        let near = around.iter().filter(|other| other.normalize_or_zero().dot(unit) > CREASE);
        near.sum::<Vec3>().try_normalize().unwrap_or(unit)
    }
}

/// The normal of a triangle, as long as twice its area.
fn across(face: &Triangle) -> Vec3 {
    (face.b - face.a).cross(face.c - face.a)
}

/// Equal points have equal keys: both zeros are one.
fn key(corner: Vec3) -> [u32; 3] {
    corner.to_array().map(|x| (x + 0.0).to_bits())
}
