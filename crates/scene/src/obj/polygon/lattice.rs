//! Points with whole coordinates, on which every question has an exact answer.

use std::cmp::Ordering;

use glam::DVec2;

/// The largest coordinate. A turn is the difference of two products of two differences: it stays below 2⁶¹.
const LAST: f64 = ((1 << 30) - 1) as f64;

/// A point of the lattice. The sweep meets points from left to right, and from below where they are equally far.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Point {
    pub(super) x: i64,
    pub(super) y: i64,
}

/// The lattice points nearest to `seen`, which fill the lattice along both axes: single precision tells apart 2²⁴
/// places, the lattice 2³⁰.
pub(super) fn points(seen: &[DVec2]) -> Vec<Point> {
    let low = seen.iter().copied().fold(DVec2::INFINITY, DVec2::min);
    let extent = seen.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max) - low;
    let place = |p: f64, extent: f64| if extent > 0.0 { (p / extent * LAST).round() as i64 } else { 0 };
    seen.iter().map(|p| Point { x: place(p.x - low.x, extent.x), y: place(p.y - low.y, extent.y) }).collect()
}

/// The edges of a closed outline.
pub(super) fn edges(points: &[Point]) -> Vec<Segment> {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).filter(|(a, b)| a != b).map(|(a, b)| Segment::new(*a, *b, 1)).collect()
}

/// Whether no corner comes twice and edges meet at their ends only: every pair is tried.
pub(super) fn is_plain(points: &[Point]) -> bool {
    let edges = edges(points);
    let pairs = || (0..edges.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    edges.len() == points.len()
        && pairs().all(|(i, j)| points[i] != points[j] && edges[i].meets(&edges[j]) == [None, None])
}

/// Twice the area of a triangle: positive if it turns left, 0 if its corners lie on a line.
#[inline]
pub(super) fn turn(a: Point, b: Point, c: Point) -> i64 {
    (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
}

/// An edge between two points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Segment {
    /// The end that the sweep meets first.
    pub(super) from: Point,
    /// The other one.
    pub(super) to: Point,
    /// How much more often the outline winds around what lies above than around what lies below.
    pub(super) winding: i32,
}

impl Segment {
    /// The edge from `a` to `b`, of which `winding` follow one another.
    pub(super) fn new(a: Point, b: Point, winding: i32) -> Segment {
        if a < b { Segment { from: a, to: b, winding } } else { Segment { from: b, to: a, winding: -winding } }
    }

    /// Where it is to be cut, and where the other one is, so that both meet at ends only.
    pub(super) fn meets(&self, other: &Segment) -> [Option<Point>; 2] {
        let [a, b] = [other.from, other.to].map(|end| turn(self.from, self.to, end));
        let [c, d] = [self.from, self.to].map(|end| turn(other.from, other.to, end));
        if a.signum() * b.signum() < 0 && c.signum() * d.signum() < 0 {
            // They cross: at the part c / (c − d) of this one, rounded to the lattice.
            let at = |from: i64, to: i64| from + rounded(i128::from(to - from) * i128::from(c), i128::from(c - d));
            let at = Point { x: at(self.from.x, self.to.x), y: at(self.from.y, self.to.y) };
            return [self, other].map(|edge| (at != edge.from && at != edge.to).then_some(at));
        }
        // An end of one lies on the other.
        let on = |edge: &Segment, ends: [(i64, Point); 2]| {
            ends.into_iter().find(|&(turn, end)| turn == 0 && edge.from < end && end < edge.to).map(|(_, end)| end)
        };
        [on(self, [(a, other.from), (b, other.to)]), on(other, [(c, self.from), (d, self.to)])]
    }
}

/// The whole number nearest to a quotient.
fn rounded(over: i128, under: i128) -> i64 {
    let (over, under) = if under < 0 { (-over, -under) } else { (over, under) };
    (2 * over + under).div_euclid(2 * under) as i64
}

/// An edge that the sweep line crosses. Those that it crosses at once are ordered from below.
#[derive(Clone, Copy, Debug)]
pub(super) struct Active {
    pub(super) edge: Segment,
    /// Its number.
    pub(super) id: u32,
}

impl Ord for Active {
    fn cmp(&self, other: &Active) -> Ordering {
        let (a, b) = (&self.edge, &other.edge);
        // Seen from the edge that began first: does the other begin above it, or at least go up from it?
        let side = |first: &Segment, then: &Segment| match turn(first.from, first.to, then.from) {
            0 => turn(first.from, first.to, then.to),
            side => side,
        };
        let above = if a.from <= b.from { side(a, b) } else { -side(b, a) };
        0.cmp(&above).then(self.id.cmp(&other.id))
    }
}

impl PartialOrd for Active {
    fn partial_cmp(&self, other: &Active) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Active {
    fn eq(&self, other: &Active) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Active {}
