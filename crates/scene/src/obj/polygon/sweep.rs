//! What edges enclose, cut into triangles in one sweep (Garey, Johnson, Preparata and Tarjan 1978; de Berg et al.,
//! "Computational Geometry", chapter 3).
//!
//! Between two edges that follow one another on the sweep line lies a region, inside or outside. What the line has
//! passed of a region inside is a polygon that is monotone: every upright line cuts it once. Where the line meets a
//! corner that no edge leads to, such a polygon is divided; where it meets one that no edge leaves, two become one.

use std::collections::BTreeMap;

use super::lattice::{Active, Point, Segment, turn};
use crate::ObjError;
use crate::obj::progress::Progress;

/// Hands on the triangles of what the outline winds around. Edges must meet at ends only, and none may come twice.
pub(super) fn fill(
    edges: &[Segment],
    triangle: &mut dyn FnMut([Point; 3]),
    progress: &mut Progress<'_>,
) -> Result<(), ObjError> {
    let named = |id: usize| Active { edge: edges[id], id: id as u32 };
    let mut begin: Vec<Active> = (0..edges.len()).map(named).collect();
    let mut end = begin.clone();
    // By the point, then from below.
    begin.sort_unstable_by(|a, b| a.edge.from.cmp(&b.edge.from).then_with(|| a.cmp(b)));
    end.sort_unstable_by(|a, b| a.edge.to.cmp(&b.edge.to).then_with(|| a.cmp(b)));
    let (mut begin, mut end) = (&begin[..], &end[..]);
    let mut line = Line { above: BTreeMap::new(), triangle };
    while let Some(p) = begin.first().map(|a| a.edge.from).into_iter().chain(end.first().map(|a| a.edge.to)).min() {
        progress.step()?;
        let (begins, later) = begin.split_at(begin.iter().take_while(|active| active.edge.from == p).count());
        let (ends, later_ends) = end.split_at(end.iter().take_while(|active| active.edge.to == p).count());
        line.meet(p, ends, begins);
        (begin, end) = (later, later_ends);
    }
    Ok(())
}

/// The sweep line.
struct Line<'a> {
    /// The edges that it crosses, from below, each with the region above it.
    above: BTreeMap<Active, Region>,
    triangle: &'a mut dyn FnMut([Point; 3]),
}

impl Line<'_> {
    /// Takes the line over a point: edges end there, and edges begin.
    fn meet(&mut self, p: Point, ends: &[Active], begins: &[Active]) {
        let emit = &mut *self.triangle;
        // The regions between edges that end here end with them.
        let mut above = None;
        for edge in ends {
            if let Some(mut ended) = above.replace(self.above.remove(edge).unwrap_or_default()) {
                ended.close(p, emit);
            }
        }
        let Some(first) = ends.first().or(begins.first()) else { return };
        let mut outside = Region::default();
        let below = self.above.range_mut(..*first).next_back().map_or(&mut outside, |(_, region)| region);
        let mut above = match above {
            // The corner lies in the middle of a region.
            None => below.divide(p, emit),
            Some(mut above) => {
                below.add(p, Side::High, emit);
                above.add(p, Side::Low, emit);
                above
            }
        };
        let Some((last, others)) = begins.split_last() else {
            below.join(above);
            return;
        };
        let mut winding = below.winding;
        for edge in others {
            winding += edge.edge.winding;
            self.above.insert(*edge, Region::beginning(p, winding));
        }
        above.winding = winding + last.edge.winding;
        self.above.insert(*last, above);
    }
}

/// Which of its two edges a corner of a region lies on.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
enum Side {
    #[default]
    Low,
    High,
}

/// What lies between two edges.
#[derive(Default)]
struct Region {
    /// How often the outline winds around it.
    winding: i32,
    /// What the line has passed of it, if it lies inside; of two that became one, the lower and the upper part, until
    /// the line meets a corner of theirs.
    passed: Option<Chain>,
    upper: Option<Chain>,
}

impl Region {
    fn beginning(p: Point, winding: i32) -> Region {
        let passed = (winding != 0).then(|| Chain::beginning(p));
        Region { winding, passed, upper: None }
    }

    /// A corner on its lower or upper edge.
    fn add(&mut self, p: Point, side: Side, emit: &mut dyn FnMut([Point; 3])) {
        let mut emit = oriented(self.winding, emit);
        if let Some(mut upper) = self.upper.take() {
            // It closes the part that it lies on; the other one goes on.
            match side {
                Side::High => upper.close(p, &mut emit),
                Side::Low => {
                    if let Some(mut lower) = self.passed.replace(upper) {
                        lower.close(p, &mut emit);
                    }
                }
            }
        }
        if let Some(passed) = &mut self.passed {
            passed.add(p, side, &mut emit);
        }
    }

    /// A corner at which it ends.
    fn close(&mut self, p: Point, emit: &mut dyn FnMut([Point; 3])) {
        let mut emit = oriented(self.winding, emit);
        for chain in self.passed.iter_mut().chain(&mut self.upper) {
            chain.close(p, &mut emit);
        }
    }

    /// A corner in its middle: it keeps the part below, and hands on the part above.
    fn divide(&mut self, p: Point, emit: &mut dyn FnMut([Point; 3])) -> Region {
        let winding = self.winding;
        let mut emit = oriented(winding, emit);
        let upper = match (&mut self.passed, self.upper.take()) {
            (None, _) => None,
            (Some(lower), Some(mut upper)) => {
                lower.add(p, Side::High, &mut emit);
                upper.add(p, Side::Low, &mut emit);
                Some(upper)
            }
            // A line from the latest corner divides it; that corner lies on one of its edges.
            (Some(passed), None) => {
                let fresh = Chain::beginning(passed.latest());
                let (mut lower, mut upper) = match passed.side {
                    Side::Low => (fresh, std::mem::take(passed)),
                    Side::High => (std::mem::take(passed), fresh),
                };
                lower.add(p, Side::High, &mut emit);
                upper.add(p, Side::Low, &mut emit);
                *passed = lower;
                Some(upper)
            }
        };
        Region { winding, passed: upper, upper: None }
    }

    /// The region above becomes a part of it.
    fn join(&mut self, above: Region) {
        self.upper = above.passed;
    }
}

/// Hands on triangles that turn as the outline does.
fn oriented(winding: i32, emit: &mut dyn FnMut([Point; 3])) -> impl FnMut(Point, Point, Point) {
    move |a, b, c| match turn(a, b, c) {
        0 => {}
        left if (left > 0) == (winding > 0) => emit([a, b, c]),
        _ => emit([a, c, b]),
    }
}

/// What is not yet cut of a monotone polygon: its latest corners, all but the first of them on one side. They bend
/// inwards, else an ear could be cut off.
#[derive(Default)]
struct Chain {
    open: Vec<Point>,
    side: Side,
}

impl Chain {
    fn beginning(p: Point) -> Chain {
        Chain { open: vec![p], side: Side::Low }
    }

    fn latest(&self) -> Point {
        self.open[self.open.len() - 1]
    }

    /// The next corner.
    fn add(&mut self, p: Point, side: Side, emit: &mut impl FnMut(Point, Point, Point)) {
        if side == self.side {
            // Ears between the latest corners and this one.
            while let &[.., before, latest] = &self.open[..] {
                let left = turn(before, latest, p);
                if (side == Side::Low && left <= 0) || (side == Side::High && left >= 0) {
                    break;
                }
                emit(before, latest, p);
                self.open.pop();
            }
        } else {
            // From the other side all of them are seen.
            let latest = self.latest();
            self.close(p, emit);
            self.open.push(latest);
        }
        self.open.push(p);
        self.side = side;
    }

    /// The last corner: it sees all that is open.
    fn close(&mut self, p: Point, emit: &mut impl FnMut(Point, Point, Point)) {
        for pair in self.open.windows(2) {
            emit(pair[0], pair[1], p);
        }
        self.open.clear();
    }
}
