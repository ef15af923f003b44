//! Polygons cut into triangles: concave ones, ones that touch or cross themselves, and ones of a million corners.
//!
//! A point lies in a polygon if its outline winds around it, once or more often. A small outline that does not touch
//! itself loses one ear after the other (earcut). Any other is laid on a lattice of whole numbers, where all questions
//! have exact answers ([`lattice`]); its edges are cut until they meet at ends only ([`crossings`]); and a line sweeps
//! over what they enclose and cuts it into triangles ([`sweep`]), in n log n for n edges.

mod crossings;
mod lattice;
mod sweep;

use std::collections::HashMap;

use earcut::Earcut;
use glam::{DVec2, DVec3, Vec3};

use crate::ObjError;
use crate::obj::progress::Progress;
use crossings::Crossings;
use lattice::Point;

/// Outlines with more corners are swept: clipping ears takes time that grows with the square of their number.
const MOST_EARS: usize = 1000;

/// In outlines with at most so many corners all pairs of edges are tried, to see whether they touch.
const MOST_PAIRS: usize = 8;

/// What became of a polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Cut {
    /// Triangles whose corners are its own.
    Plain,
    /// Triangles, some of which have corners where its edges cross.
    Crossed,
    /// Nothing: it has no area.
    Flat,
    /// Nothing: its edges cross too often.
    Tangled,
}

/// Cuts the polygons of one file.
pub(super) struct Cutter<'a> {
    /// The corners of the file, and those where edges cross.
    pub(super) corners: &'a mut Vec<Vec3>,
    /// The triangles so far.
    pub(super) triangles: &'a mut Vec<[u32; 3]>,
    /// So many times edges may still be cut where they touch or cross.
    pub(super) room: usize,
}

impl Cutter<'_> {
    /// Adds the triangles of a polygon in space.
    pub(super) fn cut(&mut self, polygon: &[u32], progress: &mut Progress<'_>) -> Result<Cut, ObjError> {
        let before = self.triangles.len();
        let Some(seen) = flattened(self.corners, polygon) else { return Ok(Cut::Flat) };
        let points = lattice::points(&seen);
        let added = if points.len() <= MOST_PAIRS && lattice::is_plain(&points) {
            self.clip_ears(polygon, &seen);
            0
        } else {
            match self.sweep(polygon, &seen, &points, progress)? {
                Some(added) => added,
                None => return Ok(Cut::Tangled),
            }
        };
        Ok(match self.triangles.len() - before {
            0 => Cut::Flat,
            _ if added > 0 => Cut::Crossed,
            _ => Cut::Plain,
        })
    }

    /// One ear after the other.
    fn clip_ears(&mut self, polygon: &[u32], seen: &[DVec2]) {
        let mut ears: Vec<u32> = Vec::new();
        Earcut::new().earcut(seen.iter().map(DVec2::to_array), &[], &mut ears);
        self.triangles.extend(ears.chunks_exact(3).map(|ear| [ear[0], ear[1], ear[2]].map(|i| polygon[i as usize])));
    }

    /// Whatever the outline is like. Says how many corners were added; nothing if its edges cross too often.
    fn sweep(
        &mut self,
        polygon: &[u32],
        seen: &[DVec2],
        points: &[Point],
        progress: &mut Progress<'_>,
    ) -> Result<Option<usize>, ObjError> {
        let at: HashMap<Point, u32> = points.iter().copied().zip(polygon.iter().copied()).collect();
        let distinct = at.len() == polygon.len();
        let own = self.corners.len();
        let mut crossings = Crossings { at, corners: self.corners, room: &mut self.room };
        let Some(resolved) = crossings.resolve(lattice::edges(points), progress)? else {
            self.corners.truncate(own);
            return Ok(None);
        };
        let at = crossings.at;
        if distinct && resolved.untouched && points.len() <= MOST_EARS {
            self.clip_ears(polygon, seen);
        } else {
            let mut add = |triangle: [Point; 3]| self.triangles.push(triangle.map(|point| at[&point]));
            sweep::fill(&resolved.edges, &mut add, progress)?;
        }
        Ok(Some(self.corners.len() - own))
    }
}

/// The polygon in its plane; nothing if all corners lie on a line.
fn flattened(corners: &[Vec3], polygon: &[u32]) -> Option<Vec<DVec2>> {
    // Relative to the first corner and of size one, so that neither tiny nor far polygons lose digits.
    let first = corners[polygon[0] as usize].as_dvec3();
    let relative: Vec<DVec3> = polygon.iter().map(|&corner| corners[corner as usize].as_dvec3() - first).collect();
    let size = relative.iter().fold(0.0_f64, |size, p| size.max(p.abs().max_element()));
    if size == 0.0 {
        return None;
    }
    let relative: Vec<DVec3> = relative.iter().map(|&p| p / size).collect();

    // Seen along the largest axis of its normal the polygon keeps its shape and its turn.
    let normal = normal(&relative);
    let [x, y, z] = normal.abs().to_array();
    let flat = |p: &DVec3| {
        if z >= x && z >= y {
            DVec2::new(p.x, p.y)
        } else if x >= y {
            DVec2::new(p.y, p.z)
        } else {
            DVec2::new(p.z, p.x)
        }
    };
    (normal != DVec3::ZERO).then(|| relative.iter().map(flat).collect())
}

/// Less of Newell's normal is the rounding of the corners, or of lobes that turn against each other.
const LOBES: f64 = 1e-5;

/// Across the polygon, whose first corner is 0 and whose size is 1.
fn normal(relative: &[DVec3]) -> DVec3 {
    // Newell's sum: what the corners enclose.
    let next = |i: usize| relative[(i + 1) % relative.len()];
    let newell = (0..relative.len()).fold(DVec3::ZERO, |sum, i| sum + relative[i].cross(next(i)));
    if newell.abs().max_element() > LOBES {
        return newell;
    }
    // Across the widest triangle: the corner furthest from the first one, and that furthest from the line of the two.
    let largest = |across: &dyn Fn(DVec3) -> DVec3| {
        relative.iter().map(|&p| across(p)).max_by(|a, b| a.length_squared().total_cmp(&b.length_squared()))
    };
    let furthest = largest(&|p| p).unwrap_or_default();
    largest(&|p| furthest.cross(p)).unwrap_or_default()
}
