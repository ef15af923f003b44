//! What somebody has taken in the hand: shapes of the slide's scene, and a cut that is only tried.

use std::collections::BTreeSet;
use std::sync::Arc;

use glam::Vec2;
use raystep_accel::{HandCut, PrimId, Primitives};
use raystep_scene::{Part, Scene};

/// The most primitives of a scene that can be taken in the hand: all of it is built anew while they move.
pub(crate) const MOST: usize = 512;

/// The slide's scene with shapes where somebody has put them.
#[derive(Clone, Debug)]
pub struct OwnScene {
    /// The scene as it is now.
    pub scene: Arc<Scene>,
    /// The primitives that somebody has moved.
    pub moved: BTreeSet<PrimId>,
}

impl OwnScene {
    /// A part of a shape in a scene moved from one point to another; nothing if it would be no shape any more.
    pub(crate) fn of(
        scene: &Scene,
        before: Option<&OwnScene>,
        prim: PrimId,
        part: Part,
        [from, to]: [Vec2; 2],
    ) -> Option<OwnScene> {
        let mut scene = scene.with_moved(prim, part, from, to)?;
        let own = before.map_or_else(|| format!("{}{OWN}", scene.name), |before| before.scene.name.clone());
        scene.name = own;
        let mut moved = before.map_or_else(BTreeSet::new, |before| before.moved.clone());
        moved.insert(prim);
        Some(OwnScene { scene: Arc::new(scene), moved })
    }

    /// A scene with shapes where these numbers say, and a sentence for each that cannot be there.
    pub(crate) fn restored(scene: &Scene, shapes: &[(u32, Vec<f32>)]) -> (Option<OwnScene>, Vec<String>) {
        if !scene.flat || scene.prims.len() > MOST {
            return (None, vec![format!("{}: shapes are moved in flat scenes of at most {MOST}", scene.title)]);
        }
        let (mut scene, mut moved, mut wrong) = (scene.clone(), BTreeSet::new(), Vec::new());
        for (prim, numbers) in shapes {
            match scene.with_numbers(PrimId(*prim), numbers) {
                Ok(with) => {
                    scene = with;
                    moved.insert(PrimId(*prim));
                }
                Err(why) => wrong.push(format!("shape={prim}: {why}")),
            }
        }
        scene.name.push_str(OWN);
        let own = (!moved.is_empty()).then(|| OwnScene { scene: Arc::new(scene), moved });
        (own, wrong)
    }

    /// Where the shapes lie that were moved, in numbers.
    pub(crate) fn shapes(&self) -> Vec<(u32, Vec<f32>)> {
        self.moved.iter().filter_map(|prim| Some((prim.0, self.scene.numbers(*prim)?))).collect()
    }

    /// What was moved, in words: `3`, `3 and 5`, `1, 3 and 5`, or how many.
    pub(crate) fn told(&self) -> String {
        let names: Vec<String> = self.moved.iter().map(ToString::to_string).collect();
        match names.as_slice() {
            [] => "nothing".to_owned(),
            [only] => format!("Primitive {only}"),
            [most @ .., last] if most.len() < 6 => format!("Primitives {} and {last}", most.join(", ")),
            all => format!("{} primitives", all.len()),
        }
    }
}

impl PartialEq for OwnScene {
    fn eq(&self, other: &OwnScene) -> bool {
        Arc::ptr_eq(&self.scene, &other.scene)
    }
}

/// What stands behind the name of a scene that somebody has changed.
const OWN: &str = ", changed by hand";

/// A cut that is only tried: the builder says what it would cost, and builds as before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tried {
    /// The step at which it is tried.
    pub step: usize,
    /// The cut.
    pub cut: HandCut,
}
