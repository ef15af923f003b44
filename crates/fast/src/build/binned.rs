//! The tree, from the root down: at each node the split of least cost among the planes between bins (Wald 2007), the two
//! halves at the same time.

use glam::Vec4;

use raystep_accel::Mesh;

use super::reference::{Box4, Reference};
use super::spatial::{Parts, Spatial};
use super::{Knot, Settings, Tree};

/// The most bins along an axis, where many triangles are to be split.
const BINS: usize = 16;
/// The bins of a small node.
const FEW_BINS: usize = 8;
/// So many triangles make a small node.
const FEW: usize = 48;
/// So many triangles are worth a thread of their own.
const WORTH_A_THREAD: usize = 4096;
/// Below this depth a node is halved by number: whatever the triangles are, no branch grows longer than this and the
/// halvings that are left.
const DEEPEST: u32 = 64;

/// Builds it; with settings that ask for it, nodes are also split in space.
pub(crate) fn build(mesh: &Mesh, mut references: Vec<Reference>, bounds: Box4, settings: &Settings) -> Tree {
    let count = references.len();
    let spatial = if settings.splits > 0 { Spatial::of(mesh, &bounds) } else { None };
    if spatial.is_some() {
        references.resize(count + count * settings.splits as usize / 100, Reference::NONE);
    }
    let mut pairs = vec![[Knot::EMPTY; 2]; references.len().saturating_sub(1)];
    let growing = Growing { leaf: settings.leaf.clamp(1, 4) as usize, spatial };
    let mut root = Knot::EMPTY;
    let place = Place { first: 0, pair: 0, depth: 0 };
    let depth =
        if count == 0 { 0 } else { growing.grow(&mut root, &bounds, &mut references, count, &mut pairs, place) };
    let prims = references.iter().map(Reference::prim).collect();
    Tree { root, pairs, prims, depth, parted: growing.spatial.is_some() }
}

struct Growing<'a> {
    leaf: usize,
    spatial: Option<Spatial<'a>>,
}

/// Where a node stands.
#[derive(Clone, Copy)]
struct Place {
    /// The number of its first reference, among all.
    first: u32,
    /// The number of its children's pair, among all.
    pair: u32,
    depth: u32,
}

/// Where a node is split.
struct Split {
    axis: usize,
    /// The first bin that belongs to the right.
    bin: u32,
    cost: f32,
    bounds: [Box4; 2],
}

/// How references fall into bins.
#[derive(Clone, Copy)]
struct Bins {
    from: Vec4,
    per_length: Vec4,
}

impl Bins {
    fn over(middles: &Box4, bins: usize) -> Bins {
        // A reference at the upper end falls into the last bin.
        let per_length = Vec4::splat((bins - 1) as f32) / (middles.high - middles.low);
        let per_length = Vec4::select(per_length.cmplt(Vec4::splat(1e30)), per_length, Vec4::ZERO);
        Bins { from: middles.low, per_length }
    }

    /// The bin of a reference along each axis; always below 32.
    #[inline]
    fn of(&self, reference: &Reference) -> [u32; 4] {
        // Added to 2²³, a number is rounded to a whole one, which the last bits then say.
        const WHOLE: f32 = (1 << 23) as f32;
        let place = (reference.middle() - self.from) * self.per_length + Vec4::splat(WHOLE);
        place.to_array().map(|place| place.to_bits() & 31)
    }
}

impl Growing<'_> {
    /// Makes the node over `count` references; behind them there is room for more, for what is split in space. Its children
    /// and all below them go into `pairs`. Returns the number of levels.
    fn grow(
        &self,
        knot: &mut Knot,
        bounds: &Box4,
        references: &mut [Reference],
        count: usize,
        pairs: &mut [[Knot; 2]],
        Place { first, pair, depth }: Place,
    ) -> u32 {
        if count <= self.leaf {
            let bounds = self.spatial.as_ref().map_or(*bounds, |spatial| {
                let widened = references[..count].iter().map(|reference| spatial.widened(reference));
                widened.fold(Box4::EMPTY, |all, own| all.union(&own))
            });
            *knot = Knot::leaf(bounds.aabb(), first, count as u32);
            return 1;
        }
        let Halves { counts: [on_left, on_right], middle, bounds: [left_bounds, right_bounds] } =
            self.halve(references, count, depth);
        let (left_references, right_references) = references.split_at_mut(middle);
        // With room for n references there is room for n − 1 pairs: one for the children, the others for theirs.
        let Some(([children], below)) = pairs.split_first_chunk_mut::<1>() else { return 1 };
        let (left_pairs, right_pairs) = below.split_at_mut(middle - 1);
        let left_place = Place { first, pair: pair + 1, depth: depth + 1 };
        let right_place = Place { first: first + middle as u32, pair: pair + middle as u32, depth: depth + 1 };
        let [left, right] = children;
        let worth_it = on_left.min(on_right) >= WORTH_A_THREAD;
        let mut grow_left = || self.grow(left, &left_bounds, left_references, on_left, left_pairs, left_place);
        let mut grow_right = || self.grow(right, &right_bounds, right_references, on_right, right_pairs, right_place);
        let (left_depth, right_depth) =
            if worth_it { rayon::join(grow_left, grow_right) } else { (grow_left(), grow_right()) };
        let bounds = match &self.spatial {
            Some(_) => left.bounds.union(right.bounds),
            None => bounds.aabb(),
        };
        *knot = Knot::inner(bounds, pair);
        1 + left_depth.max(right_depth)
    }

    /// Sorts references into two parts.
    fn halve(&self, references: &mut [Reference], count: usize, depth: u32) -> Halves {
        let spare = references.len() - count;
        let (own, bounds) = match object_split(&references[..count], depth) {
            Some((bins, split)) => {
                if let Some(spatial) = self.spatial.as_ref().filter(|_| spare > 0) {
                    let [left, right] = &split.bounds;
                    let parts = spatial.parts(&references[..count], &left.common(right), split.cost, references.len());
                    if let Some(parts) = parts {
                        return Halves::of_parts(references, &parts);
                    }
                }
                let own =
                    partition(&mut references[..count], |reference| bins.of(reference)[split.axis & 3] < split.bin);
                (own, split.bounds)
            }
            None => (0, [Box4::EMPTY; 2]),
        };
        if 0 < own && own < count {
            return Halves::with_room(references, [own, count - own], bounds);
        }
        // Nothing parts them: half of them here, half of them there.
        let half = count / 2;
        let bounds = [Box4::around(&references[..half]), Box4::around(&references[half..count])];
        Halves::with_room(references, [half, count - half], bounds)
    }
}

/// A node in two parts, each with room behind it.
struct Halves {
    counts: [usize; 2],
    /// Where the second part begins.
    middle: usize,
    bounds: [Box4; 2],
}

impl Halves {
    /// Where the second part of so many begins if both have room according to their numbers.
    fn middle(all: usize, [on_left, on_right]: [usize; 2]) -> usize {
        let count = on_left + on_right;
        on_left + ((all - count) as u64 * on_left as u64 / count as u64) as usize
    }

    /// Of parts that stand side by side.
    fn with_room(references: &mut [Reference], counts: [usize; 2], bounds: [Box4; 2]) -> Halves {
        let middle = Halves::middle(references.len(), counts);
        if middle != counts[0] {
            references.copy_within(counts[0]..counts[0] + counts[1], middle);
        }
        Halves { counts, middle, bounds }
    }

    fn of_parts(references: &mut [Reference], parts: &Parts) -> Halves {
        let counts = [parts.left.len(), parts.right.len()];
        let middle = Halves::middle(references.len(), counts);
        references[..counts[0]].copy_from_slice(&parts.left);
        references[middle..middle + counts[1]].copy_from_slice(&parts.right);
        Halves { counts, middle, bounds: parts.bounds }
    }
}

/// The best split by triangles of a node, if any plane between bins parts them.
fn object_split(references: &[Reference], depth: u32) -> Option<(Bins, Split)> {
    if depth >= DEEPEST {
        return None;
    }
    let mut middles = Box4::EMPTY;
    for reference in references {
        middles.add_point(reference.middle());
    }
    let few = references.len() <= FEW;
    let bins = Bins::over(&middles, if few { FEW_BINS } else { BINS });
    let split = if few { best_split::<FEW_BINS>(references, &bins) } else { best_split::<BINS>(references, &bins) };
    split.map(|split| (bins, split))
}

/// The best plane between bins, if any lies between references.
#[inline]
fn best_split<const N: usize>(references: &[Reference], bins: &Bins) -> Option<Split> {
    // One bin more than can be needed, for places that are no number.
    let mut boxes = [[Box4::EMPTY; 32]; 3];
    let mut counts = [[0u32; 32]; 3];
    for reference in references {
        let [x, y, z, _] = bins.of(reference);
        for (axis, bin) in [x, y, z].into_iter().enumerate() {
            boxes[axis][bin as usize].add(reference);
            counts[axis][bin as usize] += 1;
        }
    }
    let mut best: Option<Split> = None;
    let mut least = f32::INFINITY;
    for axis in 0..3 {
        if bins.per_length[axis] == 0.0 {
            continue;
        }
        // From the right: the cost of everything from a bin on.
        let mut right_costs = [0.0; N];
        let mut rights = [Box4::EMPTY; N];
        let (mut right, mut count) = (Box4::EMPTY, 0);
        for bin in (1..N).rev() {
            right = right.union(&boxes[axis][bin]);
            count += counts[axis][bin];
            rights[bin] = right;
            right_costs[bin] = right.area() * count as f32;
        }
        let (mut left, mut count) = (Box4::EMPTY, 0);
        for bin in 1..N {
            left = left.union(&boxes[axis][bin - 1]);
            count += counts[axis][bin - 1];
            if count == 0 || count as usize == references.len() {
                continue;
            }
            let cost = left.area() * count as f32 + right_costs[bin];
            if cost < least {
                least = cost;
                best = Some(Split { axis, bin: bin as u32, cost, bounds: [left, rights[bin]] });
            }
        }
    }
    best
}

/// Moves those that belong to the left before the others; how many they are.
#[inline]
fn partition(references: &mut [Reference], is_left: impl Fn(&Reference) -> bool) -> usize {
    let (mut low, mut high) = (0, references.len());
    loop {
        while low < high && is_left(&references[low]) {
            low += 1;
        }
        while low < high && !is_left(&references[high - 1]) {
            high -= 1;
        }
        if low >= high {
            return low;
        }
        references.swap(low, high - 1);
        low += 1;
        high -= 1;
    }
}
