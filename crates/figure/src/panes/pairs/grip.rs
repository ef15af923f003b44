//! What can be taken in the hand.

use glam::Vec3;

/// Where an object is taken in the hand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grip {
    /// The place of its pair in [`raystep_accel::PAIRS`].
    pub pair: u32,
    /// Which of the pair's arrangements it belongs to.
    pub case: u32,
    /// Where it is taken, in the world.
    pub at: Vec3,
    /// How far it was moved already.
    pub moved: Vec3,
    /// What it is.
    pub name: &'static str,
}
