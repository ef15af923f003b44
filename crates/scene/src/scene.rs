//! A scene: primitives and how to look at them.

use glam::{DVec3, Vec3};
use raystep_accel::{Aabb, PrimId, Primitives, Prims};

use crate::{ObjError, SceneError, View, flat, read_obj};

/// What a ray walks through.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The name by which slides ask for it.
    pub name: String,
    /// A few words.
    pub title: String,
    /// The primitives; their ids are their places in the file.
    pub prims: Prims,
    /// Whether it lives in the plane: rays at z = 0, seen from straight above.
    pub flat: bool,
    /// Where it is first seen from.
    pub view: View,
    /// A sentence or more about it: its source, or what to look for. May be empty.
    pub note: String,
    /// What was subtracted from its file's coordinates, so that single precision keeps their digits; mostly 0.
    pub origin: DVec3,
}

impl Scene {
    /// A flat scene from TOML. `name` names both the scene and, in errors, the file.
    ///
    /// # Errors
    /// What is wrong in `text`, where, and what is allowed there.
    pub fn from_toml(text: &str, name: &str) -> Result<Scene, SceneError> {
        let flat::Flat { title, note, shapes } = flat::parse(text, name)?;
        let prims = Prims::Few(shapes);
        let view = View::fitting(&bounds(&prims), Vec3::Z, Vec3::Y);
        Ok(Scene { name: name.to_owned(), title, prims, flat: true, view, note, origin: DVec3::ZERO })
    }

    /// A scene from the bytes of an OBJ file, y up. What the reader repaired stands in `note`, a line each.
    ///
    /// # Errors
    /// What is wrong in the file, or that `progress` (see [`read_obj`]) asked to stop.
    pub fn from_obj(bytes: &[u8], file: &str, progress: &mut dyn FnMut(f32) -> bool) -> Result<Scene, ObjError> {
        let loaded = read_obj(bytes, file, progress)?;
        let prims = Prims::Mesh(loaded.mesh);
        let view = View::fitting(&bounds(&prims), Vec3::new(0.5, 0.45, 1.0), Vec3::Y);
        Ok(Scene {
            name: file.to_owned(),
            title: file.to_owned(),
            prims,
            flat: false,
            view,
            note: loaded.notes.join("\n"),
            origin: loaded.origin,
        })
    }

    /// A point of the scene's file as the primitives count it.
    pub fn moved(&self, p: DVec3) -> Vec3 {
        (p - self.origin).as_vec3()
    }

    /// A point of the primitives as the scene's file counts it.
    pub fn moved_back(&self, p: Vec3) -> DVec3 {
        p.as_dvec3() + self.origin
    }

    /// The smallest box around all primitives.
    pub fn bounds(&self) -> Aabb {
        bounds(&self.prims)
    }
}

pub(crate) fn bounds(prims: &Prims) -> Aabb {
    (0..prims.len()).fold(Aabb::EMPTY, |all, i| all.union(prims.bounds(PrimId(i as u32))))
}
