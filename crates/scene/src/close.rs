//! A scene from near: what the shipped ones are about fills the picture.

use glam::Vec3;
use raystep_accel::{PrimId, Primitives};

use crate::shipped::{TEAPOT, WOODS};
use crate::stadium::STADIUM;
use crate::{Scene, View};

impl Scene {
    /// The object alone fills a picture of 4:3, seen from the side of [`Scene::view`]: of the teapot on its floor, the
    /// teapot.
    pub fn close_view(&self) -> View {
        if self.name == STADIUM || self.name.starts_with(WOODS) {
            // It is seen from near the teapot anyhow.
            return self.view;
        }
        let boxes = (0..self.prims.len() as u32).map(|prim| self.prims.bounds(PrimId(prim)));
        let mut corners: Vec<Vec3> = boxes.flat_map(|bounds| [bounds.min, bounds.max]).collect();
        if self.name == TEAPOT {
            // The floor is the last of its triangles.
            corners.truncate(corners.len() - 2);
        }
        let View { eye, target, up, .. } = self.view;
        View::filling(&corners, eye - target, up)
    }
}
