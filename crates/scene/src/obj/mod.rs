//! Triangles from an OBJ file. tobj reads it; a guard stands before it.
//!
//! The guard decodes the bytes ([`text`]), checks every line with its number ([`guard`]) and hands tobj only
//! vertices and faces that are right, so nothing in a file can make it panic or open another file. Polygons
//! become triangles here ([`polygon`]), not by tobj's fan, which is wrong for concave ones.

mod guard;
mod polygon;
mod text;

use std::io::{self, BufRead, Read};

use glam::Vec3;
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
    let mut notes = Vec::new();
    let text = text::decode(bytes, file, &mut notes)?;
    let clean = guard::check(&text, file, &mut notes, &mut |part| progress(part * 0.4))?;
    drop(text);
    let faces = read_faces(&clean, file, &mut |part| progress(0.4 + part * 0.4))?;
    drop(clean);
    let mesh = triangulate(&faces, &mut notes, &mut |part| progress(0.8 + part * 0.2))?;
    if mesh.triangles.is_empty() {
        return Err(text::whole_file(file, "no face has any area, so there is nothing to hit").into());
    }
    Ok(Loaded { mesh, notes })
}

/// tobj's reading of text that the guard let through: one model, faces as they stand.
fn read_faces(clean: &str, file: &str, progress: &mut dyn FnMut(f32) -> bool) -> Result<tobj::Mesh, ObjError> {
    let options = tobj::LoadOptions { triangulate: false, single_index: false, ..Default::default() };
    let mut source = Source { left: clean.as_bytes(), len: clean.len(), next: 0, stopped: false, progress };
    // The guard passes no material library on, so there is never one to open.
    let read = tobj::load_obj_buf(&mut source, &options, |_| Err(tobj::LoadError::OpenFileFailed));
    if source.stopped {
        return Err(ObjError::Cancelled);
    }
    let (models, _) = read.map_err(|wrong| text::whole_file(file, format!("the file cannot be read: {wrong}")))?;
    Ok(models.into_iter().next().map(|model| model.mesh).unwrap_or_default())
}

/// Triangles in file order.
fn triangulate(
    faces: &tobj::Mesh,
    notes: &mut Vec<String>,
    progress: &mut dyn FnMut(f32) -> bool,
) -> Result<Mesh, ObjError> {
    let corners: Vec<Vec3> = faces.positions.chunks_exact(3).map(Vec3::from_slice).collect();
    let mut triangles = Vec::with_capacity(faces.indices.len() / 3);
    let (mut cut, mut flat, mut first) = (0, 0, 0);
    // tobj leaves the arities out when every face is a triangle.
    let arity = |face: usize| faces.face_arities.get(face).map_or(3, |&n| n as usize);
    for face in 0.. {
        let Some(indices) = faces.indices.get(first..first + arity(face)).filter(|indices| !indices.is_empty()) else {
            break;
        };
        first += indices.len();
        if face % 65_536 == 0 && !progress(first as f32 / faces.indices.len() as f32) {
            return Err(ObjError::Cancelled);
        }
        if let &[a, b, c] = indices {
            triangles.push([a, b, c]);
            continue;
        }
        let before = triangles.len();
        polygon::cut(&corners, indices, &mut triangles);
        cut += 1;
        flat += usize::from(triangles.len() == before);
    }
    if cut > 0 {
        notes.push(format!("{} cut into triangles", text::count(cut, "polygon")));
    }
    if flat > 0 {
        notes.push(format!("{} without area left out", text::count(flat, "polygon")));
    }
    let mesh = Mesh { corners, triangles };
    let thin = mesh.triangles.iter().filter(|corners| has_no_area(&mesh, corners)).count();
    if thin > 0 {
        notes.push(format!("{} without area kept: no ray meets it", text::count(thin, "triangle")));
    }
    Ok(mesh)
}

fn has_no_area(mesh: &Mesh, triangle: &[u32; 3]) -> bool {
    let [a, b, c] = triangle.map(|corner| mesh.corners[corner as usize].as_dvec3());
    (b - a).cross(c - a).length_squared() == 0.0
}

/// The text as tobj reads it, telling how far it is.
struct Source<'a> {
    left: &'a [u8],
    len: usize,
    /// How many bytes are left at the next report.
    next: usize,
    stopped: bool,
    progress: &'a mut dyn FnMut(f32) -> bool,
}

impl Read for Source<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.left.read(buffer)
    }
}

impl BufRead for Source<'_> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        let done = self.len - self.left.len();
        if done >= self.next {
            self.next = done + (1 << 18);
            if !(self.progress)(done as f32 / self.len.max(1) as f32) {
                self.stopped = true;
                return Err(io::Error::other("stopped"));
            }
        }
        Ok(self.left)
    }

    fn consume(&mut self, amount: usize) {
        self.left.consume(amount);
    }
}
