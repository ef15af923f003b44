//! Primitives as ink.

use glam::Vec3;
use raystep_accel::{Place, PrimId, Primitives, Prims, Shape, Sphere, Wall};

use super::Stage;
use crate::page::Ink;
use crate::theme::Role;
use crate::world::{circles, contour, faces, lines, ring};

impl Stage<'_> {
    pub(super) fn prim(&mut self, prims: &Prims, prim: PrimId, role: Role) {
        let place = Some(Place::Prim(prim));
        match prims.shape(prim) {
            Shape::Triangle(triangle) => self.area(&[triangle.a, triangle.b, triangle.c], role, place),
            Shape::Sphere(sphere) => self.disc(&sphere, role, place),
            Shape::Disc(disc) => self.area(&ring(disc.center, disc.normal, disc.radius), role, place),
            Shape::Wall(wall) if self.flat => {
                let (from, to) = (wall.from.extend(0.0), wall.to.extend(0.0));
                self.line(from, to, role, place);
            }
            Shape::Wall(wall) => self.area(&upright(&wall), role, place),
            Shape::Prism(prism) if self.flat => {
                let outline: Vec<Vec3> = prism.outline.iter().map(|corner| corner.extend(0.0)).collect();
                self.area(&outline, role, place);
            }
            Shape::Prism(prism) => prism.walls().for_each(|wall| self.area(&upright(&wall), role, place)),
            Shape::Polygon(polygon) => self.area(polygon.corners, role, place),
            solid @ (Shape::Cylinder(_) | Shape::Cone(_) | Shape::Box(_) | Shape::Obb(_)) => {
                for face in faces(&solid) {
                    self.area(&face, role, place);
                }
            }
        }
    }

    pub(super) fn area(&mut self, corners: &[Vec3], role: Role, place: Option<Place>) {
        // What a surface covers in part is outlined only.
        if self.depth.is_some() && self.covered(corners) {
            for (index, &from) in corners.iter().enumerate() {
                self.line(from, corners[(index + 1) % corners.len()], role, place);
            }
            return;
        }
        self.tint(corners, role, place);
    }

    /// A polygon with its tint, whatever lies before it.
    pub(super) fn tint(&mut self, corners: &[Vec3], role: Role, place: Option<Place>) {
        if let Some(points) = self.lens.polygon(corners) {
            self.figure.add(role, place, Ink::Area { points });
        }
    }

    /// Whether something lies before the middle of a polygon or before a point near one of its corners.
    fn covered(&self, corners: &[Vec3]) -> bool {
        let Some(shaded) = self.depth else { return false };
        let middle = corners.iter().copied().sum::<Vec3>() / corners.len() as f32;
        let probes = corners.iter().map(|corner| corner.lerp(middle, 0.25)).chain([middle]);
        let mut seen = probes.filter_map(|probe| self.lens.point(probe));
        seen.any(|(at, depth)| shaded.hides(at, depth, self.figure.size))
    }

    /// A sphere that is transparent: its outline, and two faint circles around it.
    pub(super) fn globe(&mut self, sphere: &Sphere, role: Role, place: Option<Place>) {
        for circle in circles(sphere) {
            self.path(&circle, Role::Hidden, place);
        }
        if let Some(contour) = contour(sphere, self.lens.eye()) {
            self.path(&contour, role, place);
        }
    }

    /// A body that is transparent.
    pub(super) fn body(&mut self, edges: &[[Vec3; 2]], role: Role, place: Option<Place>) {
        let (rim, faint) = lines(edges, self.lens.eye());
        for [from, to] in faint {
            self.line(from, to, Role::Hidden, place);
        }
        for path in rim {
            self.path(&path, role, place);
        }
    }

    pub(super) fn disc(&mut self, sphere: &Sphere, role: Role, place: Option<Place>) {
        if let Some((center, _)) = self.lens.point(sphere.center) {
            let radius = sphere.radius * self.lens.scale_at(sphere.center);
            self.figure.add(role, place, Ink::Circle { center, radius });
        }
    }
}

fn upright(wall: &Wall) -> [Vec3; 4] {
    let [foot, head] = wall.z;
    [wall.from.extend(foot), wall.to.extend(foot), wall.to.extend(head), wall.from.extend(head)]
}
