//! How large the nodes of a tree are drawn, and how close.

/// Digits are never smaller, in points.
pub(super) const LEAST: f32 = 11.0;

/// Sizes in points; all follow from the digits and the air.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sizes {
    /// Size of the digits in nodes.
    pub(super) digits: f32,
    /// How much air there is around a node: 1 is the usual, 0 next to none.
    pub(super) air: f32,
}

impl Sizes {
    /// Half the height of a node.
    pub(super) fn radius(self) -> f32 {
        self.digits * (0.64 + 0.31 * self.air)
    }

    /// Room at both ends of a node's number.
    pub(super) fn ends(self) -> f32 {
        self.digits * (0.24 + 0.16 * self.air)
    }

    /// Least distance between levels: the dots of a leaf stand between them.
    pub(super) fn step(self) -> f32 {
        2.0 * self.radius() + self.digits * (0.9 + 0.3 * self.air)
    }

    /// Least distance between neighbours.
    pub(super) fn gap(self) -> f32 {
        self.digits * (0.4 + 0.8 * self.air)
    }

    /// Size of what is written beside nodes: a little smaller, if that can be read.
    pub(super) fn small(self) -> f32 {
        (self.digits * 0.92).max(self.digits.min(LEAST))
    }

    /// Radius of a dot.
    pub(super) fn dot(self) -> f32 {
        self.digits * 0.2
    }

    /// Distance between two dots.
    pub(super) fn apart(self) -> f32 {
        self.digits * 0.54
    }

    /// What lies below the last row of nodes: dots, or what stands for the nodes below a closed one.
    pub(super) fn foot(self, closed: bool) -> f32 {
        self.digits * if closed { 2.05 } else { 0.75 }
    }

    /// How high a tree with so many levels is at least.
    pub(super) fn height(self, levels: usize) -> f32 {
        self.step() * levels.saturating_sub(1) as f32 + 2.0 * self.radius() + self.foot(false)
    }

    /// How many rows of nodes fit into a height, if some of those in the last one are closed or none is.
    pub(super) fn rows(self, height: f32, closed: bool) -> usize {
        let between = height - 2.0 * self.radius() - self.foot(closed);
        if between < 0.0 { 1 } else { (between / self.step()) as usize + 1 }
    }
}
