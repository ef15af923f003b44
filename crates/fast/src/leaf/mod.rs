//! Leaves: up to four triangles, their corners in lanes.

mod four;
mod meet;

pub(crate) use four::Four;
pub(crate) use meet::*;
