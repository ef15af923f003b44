//! Leaves: up to four triangles, their corners in lanes.

mod four;
mod meet;
#[cfg(test)]
mod search;

pub(crate) use four::Four;
pub(crate) use meet::*;
