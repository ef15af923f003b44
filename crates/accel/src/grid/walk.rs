//! Walking a grid, slide 20: from cell to cell along the ray (Amanatides and Woo 1987).

use super::Grid;
use crate::mailbox::Mailbox;
use crate::{
    Accel, Axis, Best, CellId, Ending, Hit, Interval, List, Observer, Place, PrimId, Primitives, Ray, Verdict, Visit,
    Want, slab, test,
};

impl Accel for Grid {
    fn walk(&self, prims: &impl Primitives, ray: &Ray, want: Want, watch: &mut impl Observer<Visit>) -> Option<Hit> {
        if !self.margin.covers(ray.o) {
            watch.on(Visit::Distant { reach: self.margin.reach });
            return List.walk(prims, ray, want, watch);
        }
        let mut best = Best::new(want);
        let mut mailbox = Mailbox::new();
        let end = |best: Best, why: Ending, watch: &mut _| {
            Observer::on(watch, Visit::End { why, hit: best.hit.is_some(), t: best.t() });
            best.hit
        };

        // Find the first cell: where the ray enters the box.
        let Some(mut crossing) = Crossing::begin(self, ray, watch) else {
            return end(best, Ending::Outside, watch);
        };
        loop {
            // Test what the cell refers to.
            let (cell, refs) = crossing.enter(watch);
            for &prim in refs {
                if self.mailbox && mailbox.holds(prim) {
                    watch.on(Visit::Skip { prim });
                    continue;
                }
                mailbox.put(prim);
                test(prims, prim, ray, &mut best, watch);
                if best.answered() {
                    return end(best, Ending::Found, watch);
                }
            }

            // Stop only if the best hit lies in this cell: beyond it, another cell may hold a nearer one.
            let t_far = crossing.t_far();
            if best.t() < t_far {
                return end(best, Ending::Settled, watch);
            }
            if best.hit.is_some() {
                watch.on(Visit::Beyond { cell, t: best.t(), t_far });
            }

            // On to the neighbour whose face comes first.
            if !crossing.step(watch) {
                return end(best, Ending::Exhausted, watch);
            }
        }
    }
}

/// Where a ray is in a grid: the cell, and the t of the face it leaves through along each axis.
pub(crate) struct Crossing<'a> {
    grid: &'a Grid,
    ray: &'a Ray,
    /// The cell, counted in cells.
    place: [u32; 3],
    /// The t at which the ray entered the cell.
    t: f32,
    /// The t at which it would leave through the next plane of each axis.
    next: [f32; 3],
    /// The ray's own range within the grid's box.
    range: Interval,
}

impl<'a> Crossing<'a> {
    /// Enters the grid's box; nothing if the ray misses it.
    #[inline]
    pub(crate) fn begin(grid: &'a Grid, ray: &'a Ray, watch: &mut impl Observer<Visit>) -> Option<Crossing<'a>> {
        if grid.bounds.is_empty() {
            return None;
        }
        let range = slab(&grid.bounds, ray, ray.range(), Place::World, watch);
        let Interval { near: t_near, far: t_far } = range;
        let verdict = if range.is_empty() { Verdict::Miss } else { Verdict::Hit };
        watch.on(Visit::Volume { place: Place::World, t_near, t_far, best_t: f32::INFINITY, verdict });
        if range.is_empty() {
            return None;
        }
        let place = Axis::ALL.map(|axis| {
            let (o, d) = (ray.o[axis], ray.d[axis]);
            grid.locate(axis, if d == 0.0 { o } else { o + t_near * d })
        });
        let mut crossing = Crossing { grid, ray, place, t: t_near, next: [0.0; 3], range };
        crossing.next = Axis::ALL.map(|axis| crossing.leaves(axis));
        Some(crossing)
    }

    /// Names the cell, with what it refers to.
    #[inline]
    pub(crate) fn enter(&self, watch: &mut impl Observer<Visit>) -> (CellId, &'a [PrimId]) {
        let cell = self.cell();
        let refs = self.grid.cell_prims(cell);
        let (t_near, t_far) = (self.t, self.t_far());
        watch.on(Visit::Enter { place: Place::Cell(cell), t_near, t_far, prims: refs.len() as u32, leaf: true });
        (cell, refs)
    }

    /// Where the ray leaves the cell, or ends in it.
    #[inline]
    pub(crate) fn t_far(&self) -> f32 {
        let t = self.next[self.axis().index()];
        // Rounding may put a face before the entry: t never falls.
        let t = if t < self.t { self.t } else { t };
        if t > self.range.far { self.range.far } else { t }
    }

    /// Steps over the face that comes first; `false` if that leads out of the grid or past the ray's end.
    #[inline]
    pub(crate) fn step(&mut self, watch: &mut impl Observer<Visit>) -> bool {
        let (axis, t) = (self.axis(), self.t_far());
        let (i, n) = (axis.index(), self.grid.resolution[axis.index()]);
        let last = if self.ray.d[axis] > 0.0 { self.place[i] + 1 == n } else { self.place[i] == 0 };
        // At infinity no primitive can be hit.
        let inside = !last && self.next[i] <= self.range.far && self.next[i] < f32::INFINITY;
        let [next_x, next_y, next_z] = self.next;

        watch.on(Visit::Step {
            cell: self.cell(),
            axis,
            t,
            next_x,
            next_y,
            next_z,
            delta_x: self.delta(Axis::X),
            delta_y: self.delta(Axis::Y),
            delta_z: self.delta(Axis::Z),
            inside,
        });
        if inside {
            self.place[i] = if self.ray.d[axis] > 0.0 { self.place[i] + 1 } else { self.place[i] - 1 };
            self.t = t;
            self.next[i] = self.leaves(axis);
        }
        inside
    }

    #[inline]
    fn cell(&self) -> CellId {
        let [x, y, z] = self.place;
        self.grid.cell_at(x, y, z)
    }

    /// The axis whose next plane comes first.
    #[inline]
    fn axis(&self) -> Axis {
        let [x, y, z] = self.next;
        if x <= y && x <= z {
            Axis::X
        } else if y <= z {
            Axis::Y
        } else {
            Axis::Z
        }
    }

    /// The t at which the ray leaves the cell along `axis`; never, if it runs parallel.
    #[inline]
    fn leaves(&self, axis: Axis) -> f32 {
        let (o, d, index) = (self.ray.o[axis], self.ray.d[axis], self.place[axis.index()]);
        if d == 0.0 { f32::INFINITY } else { (self.grid.plane(axis, index + u32::from(d > 0.0)) - o) / d }
    }

    /// How far apart in t the planes of an axis are: the lecture adds it, this walk shows it only.
    #[inline]
    fn delta(&self, axis: Axis) -> f32 {
        let width = self.grid.bounds.extent()[axis] / self.grid.resolution[axis.index()] as f32;
        if self.ray.d[axis] == 0.0 { f32::INFINITY } else { width / self.ray.d[axis].abs() }
    }
}
