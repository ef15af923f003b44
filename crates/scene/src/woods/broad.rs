//! Broad-leaved trees: branches that fork, and leaves along the last of them.

use glam::Vec3;

use super::growth::Growth;

/// How a kind of tree grows.
pub(super) struct Habit {
    /// The length of its trunk, and its radius at the foot, in metres.
    trunk: [f32; 2],
    /// How far branches lean out.
    lean: f32,
    /// How much they strive upwards; below zero they hang.
    rise: f32,
    /// A branch beside that from which it forks.
    shorter: f32,
    /// The length of a leaf in metres, and half its width beside that.
    leaf: [f32; 2],
}

impl Habit {
    pub(super) const OAK: Habit =
        Habit { trunk: [2.9, 0.42], lean: 1.05, rise: 0.16, shorter: 0.74, leaf: [0.15, 0.36] };
    pub(super) const MAPLE: Habit =
        Habit { trunk: [3.2, 0.30], lean: 0.85, rise: 0.24, shorter: 0.73, leaf: [0.16, 0.42] };
    pub(super) const BIRCH: Habit =
        Habit { trunk: [4.6, 0.19], lean: 0.62, rise: 0.05, shorter: 0.67, leaf: [0.11, 0.38] };
}

/// How often branches fork, and into how many.
const FORKS: u32 = 5;

/// A tree of at least so many triangles: z up, its foot at the origin.
pub(super) fn broad(seed: u64, habit: &Habit, triangles: u32) -> Growth {
    // One leaf on a twig would be bare, a hundred a bush: between them lies the number of forks.
    let levels = (2..6).find(|levels| FORKS.pow(*levels) * 100 >= triangles).unwrap_or(6);
    let mut growing = Growth::new(seed);
    let mut twigs = Vec::new();
    branch(&mut growing, habit, [Vec3::ZERO, Vec3::Z * habit.trunk[0]], habit.trunk[1], [0, levels], &mut twigs);
    let missing = triangles.saturating_sub(growing.wood());
    let each = missing.div_ceil(2).div_ceil(twigs.len().max(1) as u32).max(1);
    for [from, along] in twigs {
        for _ in 0..each {
            let foot = from + along * growing.random.range(0.1, 1.1);
            let out = (growing.aside() - Vec3::Z * growing.random.range(0.0, 0.5)).normalize_or(Vec3::X);
            let size = habit.leaf[0] * growing.random.range(0.7, 1.2);
            growing.leaf(foot + out * 0.03, out, size, habit.leaf[1]);
        }
    }
    growing
}

/// A branch and those that fork from it; the last are twigs.
fn branch(
    growing: &mut Growth,
    habit: &Habit,
    [from, along]: [Vec3; 2],
    radius: f32,
    [level, levels]: [u32; 2],
    twigs: &mut Vec<[Vec3; 2]>,
) {
    let sides = [9, 7, 6, 5, 4, 3, 3][level.min(6) as usize];
    growing.tube(from, from + along, [radius, radius * 0.6], sides);
    if level == levels {
        twigs.push([from, along]);
        return;
    }
    for fork in 0..FORKS {
        // The first goes on nearly straight, the others lean out, and lower ones more.
        let (lean, place) = if fork == 0 { (0.22, 1.0) } else { (habit.lean, growing.random.range(0.45, 0.98)) };
        let aside = growing.aside();
        let aside = if level == 0 { Vec3::new(aside.x, aside.y, aside.z.abs() * 0.4) } else { aside };
        let hangs = if level >= 3 { habit.rise - 0.12 } else { habit.rise };
        let way = (along.normalize_or(Vec3::Z) + aside * lean + Vec3::Z * hangs).normalize_or(Vec3::Z);
        let length = along.length() * habit.shorter * growing.random.range(0.8, 1.15);
        let thinner = if fork == 0 { 0.62 } else { 0.48 };
        branch(growing, habit, [from + along * place, way * length], radius * thinner, [level + 1, levels], twigs);
    }
}
