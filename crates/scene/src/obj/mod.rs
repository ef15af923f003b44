//! Triangles from an OBJ file. tobj reads it; a guard stands before it.
//!
//! The guard decodes the bytes ([`text`]), checks every line with its number ([`guard`]) and hands tobj only
//! vertices and faces that are right, so nothing in a file can make it panic or open another file. Coordinates are read
//! in double precision; where that saves digits they are moved before they are rounded ([`origin`]). Polygons become
//! triangles here ([`polygon`]), not by tobj's fan, which is wrong for concave ones.

mod guard;
mod keywords;
mod left_out;
mod origin;
mod polygon;
mod progress;
mod text;

use std::io::{self, BufRead, Read};

use glam::{DVec3, Vec3};
use raystep_accel::Mesh;
use thiserror::Error;

use crate::SceneError;
use polygon::{Cut, Cutter};
use progress::Progress;

/// What a file held.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// Its triangles: primitive `i` is triangle `i` in file order, polygons cut into triangles where they stand.
    pub mesh: Mesh,
    /// What was subtracted from the file's coordinates, so that single precision keeps their digits; mostly 0.
    pub origin: DVec3,
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
    let mut progress = Progress::new(progress);
    let text = text::decode(bytes, file, &mut notes)?;
    let clean = guard::check(&text, file, &mut notes, progress.until(0.4))?;
    drop(text);
    let faces = read_faces(&clean, file, progress.until(0.8))?;
    drop(clean);
    let origin = origin::origin(&faces, arities(&faces));
    if origin != DVec3::ZERO {
        let [x, y, z] = (DVec3::ZERO - origin).to_array();
        notes.push(format!(
            "coordinates were moved by ({x}, {y}, {z}): single precision would lose their last digits; \
             rays from a file or the command line are moved alike"
        ));
    }
    let (mesh, tangled) = triangulate(&faces, origin, &mut notes, progress.until(1.0))?;
    if mesh.triangles.is_empty() {
        let why = match tangled {
            0 => "no face has any area",
            _ => "edges of its polygons touch or cross more than 250,000 times",
        };
        return Err(text::whole_file(file, format!("{why}, so there is nothing to hit")).into());
    }
    Ok(Loaded { mesh, origin, notes })
}

/// tobj's reading of text that the guard let through: one model, faces as they stand.
fn read_faces(clean: &str, file: &str, progress: &mut Progress<'_>) -> Result<tobj::Mesh, ObjError> {
    let options = tobj::LoadOptions { triangulate: false, single_index: false, ..Default::default() };
    let mut source = Source { left: clean.as_bytes(), len: clean.len(), stopped: false, progress };
    // The guard passes no material library on, so there is never one to open.
    let read = tobj::load_obj_buf(&mut source, &options, |_| Err(tobj::LoadError::OpenFileFailed));
    if source.stopped {
        return Err(ObjError::Cancelled);
    }
    let (models, _) = read.map_err(|wrong| text::whole_file(file, format!("the file cannot be read: {wrong}")))?;
    Ok(models.into_iter().next().map(|model| model.mesh).unwrap_or_default())
}

/// How many corners each face has.
fn arities(faces: &tobj::Mesh) -> impl Iterator<Item = usize> {
    // tobj leaves them out when every face is a triangle.
    let triangles = if faces.face_arities.is_empty() { faces.indices.len() / 3 } else { 0 };
    faces.face_arities.iter().map(|&arity| arity as usize).chain(std::iter::repeat_n(3, triangles))
}

/// So many times edges of one polygon are cut where they touch or cross, and those of one file.
const MOST_CUTS: usize = 250_000;
const MOST_CUTS_IN_ALL: usize = 1_000_000;

/// Triangles in file order, and how many polygons were left out because their edges cross too often.
fn triangulate(
    faces: &tobj::Mesh,
    origin: DVec3,
    notes: &mut Vec<String>,
    progress: &mut Progress<'_>,
) -> Result<(Mesh, usize), ObjError> {
    let corner = |p: &[f64]| (DVec3::from_slice(p) - origin).as_vec3();
    let mut corners: Vec<Vec3> = faces.positions.chunks_exact(3).map(corner).collect();
    let mut triangles = Vec::with_capacity(faces.indices.len() / 3);
    let mut cutter = Cutter { corners: &mut corners, triangles: &mut triangles, room: 0 };
    let mut left = MOST_CUTS_IN_ALL;
    let (mut cut, mut crossed, mut flat, mut tangled, mut first) = (0, 0, 0, 0, 0);
    for arity in arities(faces) {
        let face = &faces.indices[first..first + arity];
        progress.reach(first, faces.indices.len())?;
        first += arity;
        if let &[a, b, c] = face {
            cutter.triangles.push([a, b, c]);
            continue;
        }
        cutter.room = left.min(MOST_CUTS);
        let room = cutter.room;
        let cut_so = cutter.cut(face, progress)?;
        left -= room - cutter.room;
        match cut_so {
            Cut::Plain => cut += 1,
            Cut::Crossed => (cut, crossed) = (cut + 1, crossed + 1),
            Cut::Flat => flat += 1,
            Cut::Tangled => tangled += 1,
        }
    }
    for (n, says) in [
        (cut, "cut into triangles"),
        (crossed, "with edges that cross, cut there: inside is what the outline winds around"),
        (flat, "without area left out"),
        (
            tangled,
            "left out: edges of one touch or cross more than 250,000 times, or those of this file 1,000,000 times",
        ),
    ] {
        if n > 0 {
            notes.push(format!("{} {says}", text::count(n, "polygon")));
        }
    }
    let mesh = Mesh { corners, triangles };
    let thin = mesh.triangles.iter().filter(|corners| has_no_area(&mesh, corners)).count();
    if thin > 0 {
        notes.push(format!("{} without area kept: no ray meets it", text::count(thin, "triangle")));
    }
    Ok((mesh, tangled))
}

fn has_no_area(mesh: &Mesh, triangle: &[u32; 3]) -> bool {
    let [a, b, c] = triangle.map(|corner| mesh.corners[corner as usize].as_dvec3());
    (b - a).cross(c - a).length_squared() == 0.0
}

/// The text as tobj reads it, telling how far it is.
struct Source<'a, 'b> {
    left: &'a [u8],
    len: usize,
    stopped: bool,
    progress: &'a mut Progress<'b>,
}

impl Read for Source<'_, '_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.left.read(buffer)
    }
}

impl BufRead for Source<'_, '_> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        self.progress.reach(self.len - self.left.len(), self.len).map_err(|stop| {
            self.stopped = true;
            io::Error::other(stop)
        })?;
        Ok(self.left)
    }

    fn consume(&mut self, amount: usize) {
        self.left.consume(amount);
    }
}
