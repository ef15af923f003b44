//! Where a slide plays: a scene, the structure over it, rays, and where it is seen from.

use std::sync::Arc;

use glam::{Vec2, Vec3};
use raystep_accel::{Aabb, BvhVolume, Ray};
use raystep_scene::{Scene, Scenes};

use crate::{Board, PairsTape, Plan, Planned, Spot};

/// The two kinds of stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum StageKind {
    /// A drawing in the plane.
    Flat,
    /// A scene in space.
    Solid,
}

impl StageKind {
    /// Both.
    pub const ALL: [StageKind; 2] = [StageKind::Flat, StageKind::Solid];

    /// `"flat"` or `"solid"`.
    pub fn name(self) -> &'static str {
        match self {
            StageKind::Flat => "flat",
            StageKind::Solid => "solid",
        }
    }
}

/// Where a slide plays.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// Flat or solid.
    pub kind: StageKind,
    /// The name of its scene.
    pub scene: String,
    /// The scenes of somebody's own among which that name is looked up first.
    pub scenes: Scenes,
    /// Which structure is built over it, and how.
    pub plan: Plan,
    /// Which structure plays beside, for its numbers on paper.
    pub beside: Option<Plan>,
    /// Its rays, at least two, the first the slide's own; none where a build is played. Where packets walk, the first ray
    /// of each stands for it.
    pub rays: Vec<NamedRay>,
    /// What is done to the structure once it is built, where a build is played.
    pub changes: Vec<Planned>,
    /// The structures that a ray walks side by side, where that is played: two or three.
    pub abreast: Vec<Plan>,
    /// The pairs that are tested, where that is played, by their places in [`raystep_accel::PAIRS`].
    pub pairs: Vec<u32>,
    /// The volume that is fitted, where that is played.
    pub volume: Option<BvhVolume>,
    /// What is filled, where a board is played.
    pub board: Option<Arc<Board>>,
    /// Where it is seen from, if not as its scene says.
    pub camera: Option<Look>,
    /// Down to which level the boxes of a tree are drawn in space; without it, those of the path alone.
    pub levels: Option<u32>,
    /// Where its scene is named.
    pub(crate) scene_spot: Spot,
    /// Where its camera stands.
    pub(crate) camera_spot: Spot,
}

impl Stage {
    /// Whether a setting, a key and a value, is one of the stage's own and can be; nothing if it is a parameter of the
    /// structure. What is a stage's own are the numbers of its board's meter, and the bodies of its pairs.
    pub fn own_setting(&self, key: &str, value: &str) -> Option<Result<(), String>> {
        if let Some(number) = self.board.as_ref().and_then(|board| board.number(key)) {
            return Some(number.read(value).map(drop));
        }
        let moves = self.pairs.iter().any(|pair| PairsTape::case_of(*pair, key).is_some());
        moves.then(|| PairsTape::read(key, value).map(drop))
    }

    /// Whether this scene is the stage's own as it is now.
    pub fn is_over(&self, scene: &Arc<Scene>) -> bool {
        match self.scenes.own(&self.scene) {
            Some(own) => Arc::ptr_eq(own, scene),
            None => scene.name == self.scene,
        }
    }

    /// Looks up scenes among these first.
    pub(crate) fn know(&mut self, scenes: &Scenes) {
        self.scenes = scenes.clone();
        if let Some(board) = &mut self.board {
            Arc::make_mut(board).scenes = scenes.clone();
        }
    }

    /// The ray of that name.
    pub fn ray(&self, name: &str) -> Option<&NamedRay> {
        self.rays.iter().find(|ray| ray.name == name)
    }
}

/// A ray with a name that says what is to be seen on it.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedRay {
    /// Its name, unique on its stage.
    pub name: String,
    /// The ray. Its direction has length one if the slide says `towards`, and stands as it is if it says
    /// `direction`.
    pub ray: Ray,
    /// The rays that walk with it, where it is the first of a packet.
    pub others: Vec<Ray>,
    /// Events that its walk must contain.
    pub promises: Vec<crate::Wait>,
    /// Where it stands in the file.
    pub(crate) spot: Spot,
    /// Where its name stands.
    pub(crate) name_spot: Spot,
}

/// Where a stage is seen from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Look {
    /// Straight down onto the plane.
    Flat {
        /// What lies in the middle.
        center: Vec2,
        /// World units from the middle to the upper edge.
        half_height: f32,
    },
    /// From a point in space.
    Solid {
        /// Where the eye is.
        eye: Vec3,
        /// What lies in the middle.
        target: Vec3,
        /// Which way is up.
        up: Vec3,
        /// Vertical angle of view in degrees.
        fov_degrees: f32,
    },
}

impl Look {
    /// Whether something of a box may be seen in a picture that is at most twice as wide as high.
    pub(crate) fn shows(&self, bounds: &Aabb) -> bool {
        const WIDE: f32 = 2.0;
        match *self {
            Look::Flat { center, half_height } => {
                let half = Vec2::new(half_height * WIDE, half_height);
                let (low, high) = (bounds.min.truncate(), bounds.max.truncate());
                (center - half).cmple(high).all() && (center + half).cmpge(low).all()
            }
            Look::Solid { eye, target, up, fov_degrees } => {
                let forward = (target - eye).normalize_or_zero();
                let right = forward.cross(up).normalize_or_zero();
                let page_up = right.cross(forward);
                let tall = (fov_degrees.to_radians() * 0.5).tan();
                let across = [right, -right].map(|side| forward * tall * WIDE + side);
                let along = [page_up, -page_up].map(|side| forward * tall + side);
                // Nothing is seen if all corners lie beyond one side of the view.
                let seen = |side: &Vec3| bounds.corners().iter().any(|corner| (*corner - eye).dot(*side) > 0.0);
                [forward].iter().chain(&across).chain(&along).all(seen)
            }
        }
    }
}
