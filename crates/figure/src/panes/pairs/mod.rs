//! Pairs of objects: the matrix of their tests, the two in space, the numbers of the test, and its steps.

mod bodies;
mod grip;
mod matrix;
mod numbers;
mod space;
mod steps;
mod tried;

pub use grip::Grip;
pub(crate) use matrix::{matrix, matrix_height};
pub(crate) use numbers::numbers;
pub(crate) use space::space_of_pair;
pub(crate) use steps::steps;
pub(crate) use tried::Tried;
