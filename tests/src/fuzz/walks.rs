//! Rays through structures, with brute force as the judge.

use raystep_accel::{Accel, Hit, List, Primitives, Ray, Shape, Structure};

use super::Target;
use super::decode::{Bytes, Draft, Outlines};
use crate::rules::rules;

pub(super) const TARGET: Target = Target { name: "walks", body: walks, words: &[], seeds: &[] };

/// Shapes of a scene, and rays shot at it.
const MOST: usize = 24;

/// Builds a structure over a scene and shoots rays at it: the answers are those of brute force, to the bit.
///
/// # Panics
/// If they are not.
pub fn walks(bytes: &[u8]) {
    let mut bytes = Bytes(bytes);
    let (line, rule) = rules().nth(bytes.below(rules().count())).expect("there are that many rules");
    let (is_flat, scale) = (bytes.byte().is_multiple_of(3), bytes.scale());
    let rule = if is_flat { rule.flat() } else { rule };
    let mut outlines = Outlines::default();
    let count = bytes.below(MOST + 1);
    let drafts: Vec<Draft> = (0..count).map(|_| outlines.draft(&mut bytes, scale, is_flat)).collect();
    let shapes: Vec<Shape<'_>> = drafts.iter().map(|draft| outlines.shape(draft, scale)).collect();
    let prims = shapes.as_slice();
    let structure = Structure::build(&prims, &rule, &mut ()).expect("nobody cancels");
    for _ in 0..MOST {
        if let Some(ray) = bytes.ray(scale, is_flat) {
            agrees(line, &structure, &prims, &ray);
        }
        if bytes.is_empty() {
            break;
        }
    }
}

fn agrees(line: &str, structure: &Structure, prims: &impl Primitives, ray: &Ray) {
    let bits = |hit: Option<Hit>| hit.map(|hit| (hit.t.to_bits(), hit.prim));
    let right = List.intersect(prims, ray, &mut ());
    let found = structure.intersect(prims, ray, &mut ());
    assert!(bits(found) == bits(right), "{line}: {found:?} instead of {right:?}\n{ray:?}");
    let occluded = structure.occluded(prims, ray, &mut ());
    assert!(occluded == right.is_some(), "{line}: occluded = {occluded}, hit = {right:?}\n{ray:?}");
}
