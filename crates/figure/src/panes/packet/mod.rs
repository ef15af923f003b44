//! The panes of a packet: several rays in space, along t, in the tree, on the stack, and how full their lanes were.

mod lanes;
mod matrix;
mod rulers;
mod space;
mod stack;
mod together;
mod tree;

pub(crate) use lanes::listing_of_packet;
pub(crate) use matrix::{matrix, matrix_height};
pub(crate) use rulers::{rulers, rulers_height};
pub(crate) use space::space_of_packet;
pub(crate) use stack::stack_of_packet;
pub(crate) use tree::tree_of_packet;
