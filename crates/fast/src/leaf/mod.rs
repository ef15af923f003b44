//! Leaves: up to four triangles, their corners in lanes.

mod any_ray;
mod four;
mod meet;
#[cfg(test)]
mod search;

pub(crate) use any_ray::any_ray;
pub(crate) use four::Four;
pub(crate) use meet::*;
