//! A counter: what a walk cost.

use super::{Observer, Place, Visit};

/// What a walk cost, in counted operations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Primitives tested: the lecture's "intersection tests".
    pub prim_tests: u64,
    /// Volumes tested.
    pub box_tests: u64,
    /// Nodes entered, leaves included.
    pub node_visits: u64,
    /// Grid cells entered.
    pub cell_steps: u64,
    /// Split planes met.
    pub plane_tests: u64,
    /// Nodes put on the stack.
    pub pushes: u64,
    /// Nodes thrown away unopened.
    pub drops: u64,
    /// Tests that a mailbox saved.
    pub skips: u64,
    /// Slots of a hash table looked at.
    pub probes: u64,
}

impl Observer<Visit> for Cost {
    fn on(&mut self, event: Visit) {
        match event {
            Visit::Test { .. } => self.prim_tests += 1,
            Visit::Volume { .. } => self.box_tests += 1,
            Visit::Enter { place: Place::Cell(_), .. } => self.cell_steps += 1,
            Visit::Enter { .. } => self.node_visits += 1,
            Visit::Plane { .. } => self.plane_tests += 1,
            Visit::Push { .. } => self.pushes += 1,
            Visit::Drop { .. } => self.drops += 1,
            Visit::Skip { .. } => self.skips += 1,
            Visit::Probe { .. } => self.probes += 1,
            _ => {}
        }
    }
}

impl std::ops::AddAssign for Cost {
    fn add_assign(&mut self, other: Cost) {
        self.prim_tests += other.prim_tests;
        self.box_tests += other.box_tests;
        self.node_visits += other.node_visits;
        self.cell_steps += other.cell_steps;
        self.plane_tests += other.plane_tests;
        self.pushes += other.pushes;
        self.drops += other.drops;
        self.skips += other.skips;
        self.probes += other.probes;
    }
}
