//! Pairs of objects: the matrix of their tests, the two in space, the numbers of the test, and its steps.

mod bodies;
mod matrix;
mod numbers;
mod space;
mod steps;

use glam::Vec3;
use raystep_accel::{Arrangement, Trial};

pub(crate) use matrix::{matrix, matrix_height};
pub(crate) use numbers::numbers;
pub(crate) use space::space_of_pair;
pub(crate) use steps::steps;

/// A test of two objects, as far as it has come.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tried<'a> {
    /// How the two lie.
    pub(crate) lies: &'a Arrangement,
    /// What has happened since they were laid out.
    pub(crate) done: &'a [Trial],
}

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

impl Tried<'_> {
    /// What happened last.
    fn last(&self) -> Option<&Trial> {
        self.done.last()
    }
}
