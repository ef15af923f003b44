//! Conifers: a straight trunk, whorls of boughs, twigs along them, and needles around those.

use glam::Vec3;

use super::growth::Growth;

/// Metres to the top, and from whorl to whorl.
const HIGH: f32 = 17.0;
const WHORL: f32 = 0.42;
/// Boughs of a whorl.
const BOUGHS: u32 = 8;
/// Metres from twig to twig.
const TWIG: f32 = 0.17;

/// A tree of at least so many triangles: z up, its foot at the origin.
pub(super) fn conifer(seed: u64, triangles: u32) -> Growth {
    let mut growing = Growth::new(seed);
    growing.tube(Vec3::ZERO, Vec3::Z * HIGH, [0.24, 0.02], 8);
    // A tree of few triangles has few twigs.
    let apart = TWIG * (1_000_000.0 / triangles.max(1) as f32).sqrt().clamp(1.0, 6.0);
    let mut twigs: Vec<[Vec3; 2]> = Vec::new();
    let mut height = 1.1;
    while height < HIGH - 0.25 {
        let reach = 0.3 + 3.7 * (1.0 - height / HIGH);
        for _ in 0..BOUGHS {
            let out = growing.aside();
            let level = Vec3::new(out.x, out.y, 0.0).normalize_or(Vec3::X);
            let length = reach * growing.random.range(0.75, 1.1);
            let foot = Vec3::Z * (height + growing.random.range(-0.18, 0.18));
            bough(&mut growing, foot, level, length, apart, &mut twigs);
        }
        height += WHORL;
    }
    // The very top.
    twigs.push([Vec3::Z * (HIGH - 0.5), Vec3::Z * 0.7]);
    let missing = triangles.saturating_sub(growing.wood());
    let each = missing.div_ceil(twigs.len() as u32).max(1);
    for [from, along] in twigs {
        for _ in 0..each {
            let foot = from + along * growing.random.unit();
            let way = (growing.aside() + along.normalize_or(Vec3::X) * 0.8).normalize_or(Vec3::X);
            let across = way.any_orthonormal_vector() * growing.random.range(0.004, 0.008);
            let long = growing.random.range(0.05, 0.09);
            growing.needle(foot, way * long, across);
        }
    }
    growing
}

/// A bough: it hangs a little, and its end looks up again.
fn bough(growing: &mut Growth, foot: Vec3, level: Vec3, length: f32, apart: f32, twigs: &mut Vec<[Vec3; 2]>) {
    let at = |share: f32| foot + level * (length * share) + Vec3::Z * (length * (0.28 * share * share - 0.42 * share));
    let aside = level.cross(Vec3::Z);
    for part in 0..3 {
        let [near, far] = [part, part + 1].map(|end| end as f32 / 3.0);
        growing.tube(at(near), at(far), [0.035 * (1.05 - near), 0.035 * (1.05 - far)], 3);
    }
    let mut along = 0.15;
    let mut left = 1.0;
    while along < length {
        let share = along / length;
        let long = (0.62 * (1.0 - share) + 0.18) * growing.random.range(0.7, 1.1);
        let hang = Vec3::Z * growing.random.range(-0.45, -0.05);
        let way = (level * 0.75 + aside * left + hang).normalize_or(level) * long.min(length * 0.6);
        growing.tube(at(share), at(share) + way, [0.008, 0.003], 3);
        twigs.push([at(share), way]);
        left = -left;
        along += apart;
    }
}
