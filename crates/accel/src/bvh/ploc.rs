//! The fast form of building from below (Meister and Bittner, "Parallel locally-ordered clustering for bounding
//! volume hierarchy construction", 2018): sets in Morton order look for their nearest among few neighbours.

use glam::Vec3;

use super::sapling::Sapling;
use crate::events::{BETWEEN_LOOKS, patiently, sort_patiently};
use crate::{Aabb, Cancelled, Draft, Grow, Observer, Primitives};

/// Joins everything; the root.
pub(super) fn join_all<D: Draft, P: Primitives>(
    tree: &mut Sapling<'_, D, P>,
    watch: &mut impl Observer<Grow>,
) -> Result<u32, Cancelled> {
    let sets = tree.sprout_all(watch)?;
    Ok(join_until(tree, sets, 1, watch)?[0])
}

/// Joins sets until at most `most` are left.
pub(super) fn join_until<D: Draft, P: Primitives>(
    tree: &mut Sapling<'_, D, P>,
    sets: Vec<u32>,
    most: usize,
    watch: &mut impl Observer<Grow>,
) -> Result<Vec<u32>, Cancelled> {
    if sets.len() <= most {
        return Ok(sets);
    }
    let all = Aabb::around(sets.iter().map(|&set| tree.bounds(set).center()));
    let place = |set| Ok((morton(tree.bounds(set).center(), &all), set));
    let mut places: Vec<(u64, u32)> = patiently(sets, watch).map(|set| place(set?)).collect::<Result<_, _>>()?;
    sort_patiently(&mut places, watch, |(a, _), (b, _)| a.cmp(b))?;
    for (rank, &(code, set)) in (0..).zip(&places) {
        let [first, second, third] = [1, 2, 3].map(|level| (code >> (3 * (BITS - level)) & 7) as u32);
        let Vec3 { x, y, z } = tree.bounds(set).center();
        watch.on(Grow::Rank { node: tree.id(set), rank, first, second, third, x, y, z });
    }
    let mut sets: Vec<u32> = places.into_iter().map(|(_, set)| set).collect();
    while sets.len() > most {
        // Each set finds its nearest among its neighbours in the order.
        let reach = tree.rule.search.max(1) as usize;
        let nearest: Vec<usize> = patiently(0..sets.len(), watch)
            .map(|i| {
                let i = i?;
                let around = (i.saturating_sub(reach)..sets.len().min(i + reach + 1)).filter(|&j| j != i);
                // Of equals the pair that stands together in twos: so whole piles are joined in few rounds.
                Ok(around.min_by_key(|&j| (tree.nearness(sets[i], sets[j]), i ^ j, i.min(j))).unwrap_or(i))
            })
            .collect::<Result<_, _>>()?;
        for (i, &near) in nearest.iter().enumerate().filter(|(i, near)| i != *near) {
            watch.on(Grow::Prefer { node: tree.id(sets[i]), nearest: tree.id(sets[near]) });
        }
        // Two that found each other are joined and keep the place of the first.
        let mut left = Vec::with_capacity(sets.len());
        for (i, &near) in nearest.iter().enumerate() {
            if i % BETWEEN_LOOKS == 0 && watch.cancelled() {
                return Err(Cancelled);
            }
            if nearest[near] != i || near == i {
                left.push(sets[i]);
            } else if i < near {
                left.push(tree.join(sets[i], sets[near], watch));
            }
        }
        sets = left;
    }
    // Whoever goes on counts on the order in which they came to be.
    sets.sort_unstable();
    Ok(sets)
}

/// Bits of each coordinate in a place on the curve.
const BITS: u32 = 20;

/// Where a point lies on the curve that visits a box's octants in order (Morton 1966): the bits of its
/// coordinates in turn.
fn morton(p: Vec3, all: &Aabb) -> u64 {
    let steps = (p - all.min) / all.extent().max(Vec3::splat(f32::MIN_POSITIVE)) * (1 << BITS) as f32;
    let spread = |x: f32| {
        let x = (x as u64).min((1 << BITS) - 1);
        (0..BITS).fold(0, |code, bit| code | (x >> bit & 1) << (3 * bit))
    };
    spread(steps.x) | spread(steps.y) << 1 | spread(steps.z) << 2
}
