//! The origin that saves digits.

use glam::DVec3;

/// Single precision keeps 24 binary digits: rounding moves a coordinate by up to this part of it.
const ROUNDING: f64 = 1.0 / (1 << 24) as f64;

/// More than this part of the shortest edge shows.
const SHOWS: f64 = 1e-4;

/// A move pays where it saves three binary digits or more.
const PAYS: f64 = 8.0;

/// What to subtract from the coordinates of faces before they are rounded to single precision: along each axis 0, or
/// a whole number near the middle (a round part of one where all is smaller).
///
/// It is 0 where rounding moves no corner by more than a part in 10⁴ of the shortest edge, and along axes where the
/// coordinates are hardly larger than the mesh itself, so that moving it would save nothing.
pub(super) fn origin(faces: &tobj::Mesh, arities: impl Iterator<Item = usize>) -> DVec3 {
    let corner = |corner: u32| DVec3::from_slice(&faces.positions[3 * corner as usize..]);
    let corners = || faces.positions.chunks_exact(3).map(DVec3::from_slice);
    let low = corners().fold(DVec3::INFINITY, DVec3::min);
    let high = corners().fold(DVec3::NEG_INFINITY, DVec3::max);
    let (far, half) = (low.abs().max(high.abs()), (high - low) * 0.5);
    // Most meshes lie where they are.
    if !(far.cmpge(half * PAYS) & far.cmpgt(DVec3::ZERO)).any() {
        return DVec3::ZERO;
    }

    let (mut shortest, mut rest) = (f64::INFINITY, &faces.indices[..]);
    for arity in arities {
        let (face, others) = rest.split_at(arity.min(rest.len()));
        for (a, b) in face.iter().zip(face.iter().cycle().skip(1)) {
            let length = corner(*a).distance(corner(*b));
            shortest = if length > 0.0 { shortest.min(length) } else { shortest };
        }
        rest = others;
    }
    let unit = unit(half.max_element());
    let middle = ((low + half) / unit).round() * unit;
    let left = (low - middle).abs().max((high - middle).abs());
    let pays = far.cmpge(left * PAYS);
    let shows = pays & (far * ROUNDING).cmpgt(DVec3::splat(SHOWS * shortest));
    if shows.any() { DVec3::select(pays, middle, DVec3::ZERO) } else { DVec3::ZERO }
}

/// 1, or the largest power of two that is not larger than half of the mesh if that is smaller.
fn unit(half: f64) -> f64 {
    let mut unit = 1.0;
    while half > 0.0 && unit > half {
        unit *= 0.5;
    }
    unit
}
