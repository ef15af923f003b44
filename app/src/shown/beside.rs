//! What is shown beside the walk.

/// What a second picture of space shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beside {
    /// There is none.
    Nothing,
    /// The same ray through another structure: its kind.
    Structure(&'static str),
    /// The same ray through several others, all side by side, in a flat scene.
    Abreast(Rivals),
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

/// Kinds of structures to compare with: some, each of them once.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rivals([Option<&'static str>; Rivals::MOST]);

impl Rivals {
    /// So many at most.
    pub const MOST: usize = 3;

    /// The first of these kinds, as many as there may be.
    pub fn of(kinds: impl IntoIterator<Item = &'static str>) -> Rivals {
        kinds.into_iter().fold(Rivals::default(), Rivals::with)
    }

    /// The kinds, in the order in which they were chosen.
    pub fn kinds(&self) -> impl Iterator<Item = &'static str> + '_ {
        self.0.iter().copied().flatten()
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.kinds().count()
    }

    /// Whether this kind is one of them.
    pub fn has(&self, kind: &str) -> bool {
        self.kinds().any(|own| own == kind)
    }

    /// These and another one, if there is room for it.
    #[must_use]
    pub fn with(mut self, kind: &'static str) -> Rivals {
        if !self.has(kind)
            && let Some(free) = self.0.iter_mut().find(|slot| slot.is_none())
        {
            *free = Some(kind);
        }
        self
    }

    /// These without one of them.
    #[must_use]
    pub fn without(self, kind: &str) -> Rivals {
        Rivals::of(self.kinds().filter(|own| *own != kind))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_kind_is_there_once_and_no_more_than_there_is_room() {
        let rivals = Rivals::of(["kd", "grid", "kd", "bvh", "octree"]);
        assert_eq!(rivals.kinds().collect::<Vec<_>>(), ["kd", "grid", "bvh"]);
        assert_eq!(rivals.without("grid").with("list").kinds().collect::<Vec<_>>(), ["kd", "bvh", "list"]);
        assert_eq!(rivals.without("octree"), rivals);
    }
}
