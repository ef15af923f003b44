//! Edges cut where they touch or cross: a line sweeps over them (Shamos and Hoey 1976; Bentley and Ottmann 1979).

use std::cmp::Reverse;
use std::collections::{BTreeSet, BinaryHeap, HashMap};
use std::ops::Bound::{Excluded, Unbounded};

use glam::Vec3;

use super::lattice::{Active, Point, Segment};
use crate::ObjError;
use crate::obj::progress::Progress;

/// Cuts the edges of one polygon.
pub(super) struct Crossings<'a> {
    /// The corner at a point.
    pub(super) at: HashMap<Point, u32>,
    /// All corners of the file; those where edges cross are added.
    pub(super) corners: &'a mut Vec<Vec3>,
    /// So many times edges may still be cut.
    pub(super) room: &'a mut usize,
}

/// Edges that meet at ends only.
pub(super) struct Resolved {
    /// Each of them once.
    pub(super) edges: Vec<Segment>,
    /// Whether nothing had to be cut.
    pub(super) untouched: bool,
}

impl Crossings<'_> {
    /// Cuts edges until they meet at ends only; nothing if that takes too many cuts.
    ///
    /// Crossings are rounded to the lattice. That bends the edges through them a little, so that they may touch others
    /// that they passed before: the line sweeps again until it finds nothing. On such edges it makes no mistake.
    pub(super) fn resolve(
        &mut self,
        mut edges: Vec<Segment>,
        progress: &mut Progress<'_>,
    ) -> Result<Option<Resolved>, ObjError> {
        let mut untouched = true;
        loop {
            merge(&mut edges);
            let mut sweep = Sweep::over(edges);
            while sweep.next(self) {
                progress.step()?;
                if *self.room == 0 {
                    return Ok(None);
                }
            }
            if sweep.cuts == 0 {
                return Ok(Some(Resolved { edges: sweep.edges, untouched }));
            }
            untouched = false;
            edges = sweep.end();
        }
    }

    /// A cut of an edge: a new corner, where there is none.
    fn corner(&mut self, edge: &Segment, cut: Point) {
        let Self { at, corners, room } = self;
        **room = room.saturating_sub(1);
        if at.contains_key(&cut) {
            return;
        }
        let [from, to] = [edge.from, edge.to].map(|end| corners[at[&end] as usize].as_dvec3());
        // How far along the edge, by the coordinate in which it is longer.
        let part = |from: i64, to: i64, cut: i64| (cut - from) as f64 / (to - from) as f64;
        let (dx, dy) = (edge.to.x - edge.from.x, edge.to.y - edge.from.y);
        let part = match dx.abs() >= dy.abs() {
            true => part(edge.from.x, edge.to.x, cut.x),
            false => part(edge.from.y, edge.to.y, cut.y),
        };
        at.insert(cut, corners.len() as u32);
        corners.push((from + (to - from) * part).as_vec3());
    }
}

/// Edges that follow one another become one; those that cancel vanish.
fn merge(edges: &mut Vec<Segment>) {
    edges.sort_unstable_by_key(|edge| (edge.from, edge.to));
    edges.dedup_by(|next, kept| {
        let same = (next.from, next.to) == (kept.from, kept.to);
        if same {
            kept.winding += next.winding;
        }
        same
    });
    edges.retain(|edge| edge.winding != 0);
}

/// What happens where the line meets an end of an edge: edges that end go first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum What {
    Ends,
    Begins,
}

/// A line that sweeps over edges from left to right.
struct Sweep {
    edges: Vec<Segment>,
    /// The edges as they were when the line met them.
    met: Vec<Segment>,
    /// Those that the line crosses, from below.
    active: BTreeSet<Active>,
    events: BinaryHeap<Reverse<(Point, What, u32)>>,
    /// Where the line is.
    now: Point,
    cuts: usize,
    /// Cuts where the line has been: an edge as it was, and where to cut it.
    late: Vec<(u32, Segment, Point)>,
}

impl Sweep {
    fn over(edges: Vec<Segment>) -> Sweep {
        let events = edges.iter().zip(0..).map(|(edge, id)| Reverse((edge.from, What::Begins, id))).collect();
        let (met, active, now) = (edges.clone(), BTreeSet::new(), Point { x: 0, y: 0 });
        Sweep { edges, met, active, events, now, cuts: 0, late: Vec::new() }
    }

    /// On to the next end of an edge; `false` if there is none. Two edges that meet are neighbours before they do.
    fn next(&mut self, crossings: &mut Crossings<'_>) -> bool {
        let Some(Reverse((now, what, id))) = self.events.pop() else { return false };
        self.now = now;
        match what {
            What::Begins => {
                let edge = self.edges[id as usize];
                self.met[id as usize] = edge;
                self.events.push(Reverse((edge.to, What::Ends, id)));
                let [below, above] = self.neighbours(id);
                self.active.insert(Active { edge, id });
                self.meet(below, Some(id), crossings);
                self.meet(Some(id), above, crossings);
            }
            // It may have been cut since.
            What::Ends if self.edges[id as usize].to == now => {
                self.active.remove(&Active { edge: self.met[id as usize], id });
                let [below, above] = self.neighbours(id);
                self.meet(below, above, crossings);
            }
            What::Ends => {}
        }
        true
    }

    /// The active edges next to one that is not active.
    fn neighbours(&self, id: u32) -> [Option<u32>; 2] {
        let own = Active { edge: self.met[id as usize], id };
        let below = self.active.range(..own).next_back();
        let above = self.active.range((Excluded(own), Unbounded)).next();
        [below, above].map(|other| other.map(|other| other.id))
    }

    /// Cuts two edges where they meet.
    fn meet(&mut self, below: Option<u32>, above: Option<u32>, crossings: &mut Crossings<'_>) {
        let (Some(a), Some(b)) = (below, above) else { return };
        let [cut_a, cut_b] = self.edges[a as usize].meets(&self.edges[b as usize]);
        for (id, cut) in [(a, cut_a), (b, cut_b)] {
            if let Some(cut) = cut {
                self.cut(id, cut, crossings);
            }
        }
    }

    /// The line goes on with the left part; the right part begins at the cut.
    fn cut(&mut self, id: u32, at: Point, crossings: &mut Crossings<'_>) {
        let edge = self.edges[id as usize];
        crossings.corner(&edge, at);
        self.cuts += 1;
        if at < self.now || at <= edge.from || edge.to <= at {
            self.late.push((id, edge, at));
            return;
        }
        self.edges[id as usize].to = at;
        self.events.push(Reverse((at, What::Ends, id)));
        let (right, number) = (Segment { from: at, ..edge }, self.edges.len() as u32);
        self.edges.push(right);
        self.met.push(right);
        self.events.push(Reverse((at, What::Begins, number)));
    }

    /// The edges in the end.
    fn end(mut self) -> Vec<Segment> {
        for (id, edge, at) in self.late {
            // One that was cut elsewhere since is met again.
            if self.edges[id as usize] == edge {
                self.edges[id as usize] = Segment::new(edge.from, at, edge.winding);
                self.edges.push(Segment::new(at, edge.to, edge.winding));
            }
        }
        self.edges
    }
}
