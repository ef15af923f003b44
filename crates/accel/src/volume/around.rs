//! One volume around all primitives, fitted step by step, slides 49-52.

use super::{Hull, KDop, Outline, Volume};
use crate::events::patiently;
use crate::{Aabb, Axes, BvhVolume, Cancelled, Fit, Measure, Obb, Observer, PrimId, Primitives, Sphere};

/// Fits a volume around all of `prims` and tells how: the surface that comes out. Nothing is told of an empty set, which
/// has an empty box around it.
///
/// # Errors
/// `watch` asked to give up.
pub fn fit_around(
    prims: &impl Primitives,
    volume: BvhVolume,
    axes: Axes,
    watch: &mut impl Observer<Fit>,
) -> Result<Outline, Cancelled> {
    match volume {
        BvhVolume::Sphere => fit::<Sphere>(prims, axes, watch),
        BvhVolume::Aabb => fit_box(prims, axes, watch),
        BvhVolume::Obb => fit::<Obb>(prims, axes, watch),
        BvhVolume::KDop6 => fit::<KDop<0, 0>>(prims, axes, watch),
        BvhVolume::KDop14 => fit::<KDop<0, 4>>(prims, axes, watch),
        BvhVolume::KDop18 => fit::<KDop<4, 6>>(prims, axes, watch),
        BvhVolume::KDop26 => fit::<KDop<0, 10>>(prims, axes, watch),
        BvhVolume::Hull => fit::<Hull>(prims, axes, watch),
    }
}

fn ids(prims: &impl Primitives) -> impl Iterator<Item = PrimId> {
    (0..prims.len() as u32).map(PrimId)
}

fn fit<V: Volume>(prims: &impl Primitives, axes: Axes, watch: &mut impl Observer<Fit>) -> Result<Outline, Cancelled> {
    let bounds = ids(prims).fold(Aabb::EMPTY, |all, prim| all.union(prims.bounds(prim)));
    if prims.len() == 0 {
        return Ok(Outline::Box(bounds));
    }
    watch.on(Fit::Begin { prims: prims.len() as u32, bounds });
    let volume = V::fit(prims, ids(prims), &bounds, axes, watch)?;
    end(&volume, axes, watch);
    Ok(volume.outline())
}

/// The box along the axes is what the others begin with: it widens with one primitive after the other.
fn fit_box(prims: &impl Primitives, axes: Axes, watch: &mut impl Observer<Fit>) -> Result<Outline, Cancelled> {
    let mut bounds = Aabb::EMPTY;
    for prim in patiently(ids(prims), watch).collect::<Result<Vec<_>, _>>()? {
        let before = bounds;
        bounds = bounds.union(prims.bounds(prim));
        watch.on(Fit::Widen { prim, bounds, grown: bounds != before });
    }
    if prims.len() > 0 {
        end(&bounds, axes, watch);
    }
    Ok(Outline::Box(bounds))
}

fn end<V: Volume>(volume: &V, axes: Axes, watch: &mut impl Observer<Fit>) {
    let measure = if axes == Axes::Xy { Measure::Perimeter } else { Measure::Area };
    let (content, surface, bytes) = (volume.content() as f32, volume.measure(measure), volume.bytes() as u32);
    watch.on(Fit::End { planes: volume.planes(), content, surface, bytes });
}
