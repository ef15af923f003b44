//! What a walk did, counted by whoever wants to know.

use raystep_accel::Cost;

/// Told what a walk does. Told to `()`, it compiles to nothing.
pub trait Count {
    /// A node was opened: `boxes` boxes were tested at once.
    #[inline(always)]
    fn node(&mut self, _boxes: u32) {}
    /// So many different triangles were tested at once.
    #[inline(always)]
    fn triangles(&mut self, _triangles: u32) {}
    /// So many of them could not be ruled out in single precision and went before the judge.
    #[inline(always)]
    fn judged(&mut self, _triangles: u32) {}
}

impl Count for () {}

/// What walks did, in numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Nodes or cells opened, and leaves.
    pub nodes: u64,
    /// Boxes tested, for all rays of a packet at once.
    pub boxes: u64,
    /// Triangles tested.
    pub triangles: u64,
    /// Triangles judged in double precision.
    pub judged: u64,
}

impl Count for Work {
    #[inline]
    fn node(&mut self, boxes: u32) {
        self.nodes += 1;
        self.boxes += u64::from(boxes);
    }

    #[inline]
    fn triangles(&mut self, triangles: u32) {
        self.nodes += 1;
        self.triangles += u64::from(triangles);
    }

    #[inline]
    fn judged(&mut self, triangles: u32) {
        self.judged += u64::from(triangles);
    }
}

/// The textbook's counter.
impl Count for Cost {
    #[inline]
    fn node(&mut self, boxes: u32) {
        self.node_visits += 1;
        self.box_tests += u64::from(boxes);
    }

    #[inline]
    fn triangles(&mut self, triangles: u32) {
        self.node_visits += 1;
        self.prim_tests += u64::from(triangles);
    }
}

impl<C: Count + ?Sized> Count for &mut C {
    #[inline(always)]
    fn node(&mut self, boxes: u32) {
        (**self).node(boxes);
    }

    #[inline(always)]
    fn triangles(&mut self, triangles: u32) {
        (**self).triangles(triangles);
    }

    #[inline(always)]
    fn judged(&mut self, triangles: u32) {
        (**self).judged(triangles);
    }
}

impl std::ops::AddAssign for Work {
    fn add_assign(&mut self, other: Work) {
        self.nodes += other.nodes;
        self.boxes += other.boxes;
        self.triangles += other.triangles;
        self.judged += other.judged;
    }
}
