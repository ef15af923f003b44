//! The fitting of a volume: the set in space, with the volume so far and what decides it.

mod space;

pub(crate) use space::space_of_fit;
