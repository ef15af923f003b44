//! The tree, from the root down: at each node the split of least cost among the planes between bins (Wald 2007), the two
//! halves at the same time.

use glam::Vec4;

use super::reference::{Box4, Reference};
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

/// Builds it.
pub(crate) fn build(mut references: Vec<Reference>, bounds: Box4, settings: &Settings) -> Tree {
    let mut pairs = vec![[Knot::EMPTY; 2]; references.len().saturating_sub(1)];
    let leaf = settings.leaf.clamp(1, 4) as usize;
    let growing = Growing { leaf };
    let mut root = Knot::EMPTY;
    let depth =
        if references.is_empty() { 0 } else { growing.grow(&mut root, &bounds, &mut references, 0, &mut pairs, 0, 0) };
    let prims = references.iter().map(Reference::prim).collect();
    Tree { root, pairs, prims, depth }
}

struct Growing {
    leaf: usize,
}

/// Where a node is split.
struct Split {
    axis: usize,
    /// The first bin that belongs to the right.
    bin: u32,
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

impl Growing {
    /// Makes the node over some references, the first of which is number `first` of all; its children and all below
    /// them go into `pairs`, the first of which is number `pair` of all. Returns the number of levels.
    fn grow(
        &self,
        knot: &mut Knot,
        bounds: &Box4,
        references: &mut [Reference],
        first: u32,
        pairs: &mut [[Knot; 2]],
        pair: u32,
        depth: u32,
    ) -> u32 {
        if references.len() <= self.leaf {
            *knot = Knot::leaf(bounds.aabb(), first, references.len() as u32);
            return 1;
        }
        let (middle, [left_bounds, right_bounds]) = part(references, depth);
        *knot = Knot::inner(bounds.aabb(), pair);
        let (left_references, right_references) = references.split_at_mut(middle);
        // A node of n references has at most n − 1 pairs below it: one for its children, the others for theirs.
        let Some(([children], below)) = pairs.split_first_chunk_mut::<1>() else { return 1 };
        let (left_pairs, right_pairs) = below.split_at_mut(middle - 1);
        let (left_pair, right_pair) = (pair + 1, pair + middle as u32);
        let [left, right] = children;
        let worth_it = left_references.len().min(right_references.len()) >= WORTH_A_THREAD;
        let mut grow_left = || self.grow(left, &left_bounds, left_references, first, left_pairs, left_pair, depth + 1);
        let right_first = first + middle as u32;
        let mut grow_right =
            || self.grow(right, &right_bounds, right_references, right_first, right_pairs, right_pair, depth + 1);
        let (left_depth, right_depth) =
            if worth_it { rayon::join(grow_left, grow_right) } else { (grow_left(), grow_right()) };
        1 + left_depth.max(right_depth)
    }
}

/// Sorts references into two parts: where the second begins, and the boxes around both.
fn part(references: &mut [Reference], depth: u32) -> (usize, [Box4; 2]) {
    if depth < DEEPEST {
        let mut middles = Box4::EMPTY;
        for reference in references.iter() {
            middles.add_point(reference.middle());
        }
        let few = references.len() <= FEW;
        let bins = Bins::over(&middles, if few { FEW_BINS } else { BINS });
        let split = if few { best_split::<FEW_BINS>(references, &bins) } else { best_split::<BINS>(references, &bins) };
        if let Some(Split { axis, bin, bounds }) = split {
            let middle = partition(references, |reference| bins.of(reference)[axis & 3] < bin);
            if 0 < middle && middle < references.len() {
                return (middle, bounds);
            }
        }
    }
    // Nothing parts them: half of them here, half of them there.
    let middle = references.len() / 2;
    let around = |references: &[Reference]| {
        let mut bounds = Box4::EMPTY;
        for reference in references {
            bounds.add(reference);
        }
        bounds
    };
    (middle, [around(&references[..middle]), around(&references[middle..])])
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
                best = Some(Split { axis, bin: bin as u32, bounds: [left, rights[bin]] });
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
