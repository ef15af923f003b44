//! A polygon cut into triangles, concave ones too.

use earcut::Earcut;
use glam::{DVec2, DVec3, Vec3};

/// Adds the triangles of a polygon in space to `triangles`; none if it has no area.
pub(super) fn cut(corners: &[Vec3], polygon: &[u32], triangles: &mut Vec<[u32; 3]>) {
    // Relative to the first corner and of size one, so that neither tiny nor far polygons lose digits.
    let first = corners[polygon[0] as usize].as_dvec3();
    let relative: Vec<DVec3> = polygon.iter().map(|&corner| corners[corner as usize].as_dvec3() - first).collect();
    let size = relative.iter().fold(0.0_f64, |size, p| size.max(p.abs().max_element()));
    if size == 0.0 {
        return;
    }
    let relative: Vec<DVec3> = relative.iter().map(|&p| p / size).collect();

    // Newell's normal; seen along its largest axis the polygon keeps its shape and its turn.
    let next = |i: usize| relative[(i + 1) % relative.len()];
    let normal = (0..relative.len()).fold(DVec3::ZERO, |sum, i| sum + relative[i].cross(next(i)));
    let flattened = |p: DVec3| -> DVec2 {
        let [x, y, z] = normal.abs().to_array();
        if z >= x && z >= y {
            DVec2::new(p.x, p.y)
        } else if x >= y {
            DVec2::new(p.y, p.z)
        } else {
            DVec2::new(p.z, p.x)
        }
    };
    let mut ears: Vec<u32> = Vec::new();
    Earcut::new().earcut(relative.iter().map(|&p| flattened(p).to_array()), &[], &mut ears);
    triangles.extend(ears.chunks_exact(3).map(|ear| [ear[0], ear[1], ear[2]].map(|i| polygon[i as usize])));
}
