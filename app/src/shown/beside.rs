//! What is shown beside the walk.

/// What a second picture of space shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beside {
    /// There is none.
    Nothing,
    /// The same ray through another structure: its kind.
    Structure(&'static str),
    /// The mistake with this place in the list of those that fit the structure.
    Mistake(usize),
}

/// How two walks keep in step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pace {
    /// Both have taken so many steps.
    Event,
    /// Both have come so far along the ray.
    T,
}
