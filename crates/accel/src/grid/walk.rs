//! Walking a grid, slides 20 and 24: from cell to cell along the ray (Amanatides and Woo 1987), and through the
//! grids within cells.

use super::{Cells, GridOf, Lattice};
use crate::common::{Mailbox, test_each};
use crate::{
    Accel, Axis, Best, CellId, Ending, Hit, Interval, List, Observer, Place, PrimId, Primitives, Ray, Verdict, Visit,
    Want, slab,
};

impl<C: Cells> Accel for GridOf<C> {
    fn walk(&self, prims: &impl Primitives, ray: &Ray, want: Want, watch: &mut impl Observer<Visit>) -> Option<Hit> {
        if let Some(why) = self.margin.bars(ray) {
            watch.on(why);
            return List.walk(prims, ray, want, watch);
        }
        let mut best = Best::new(want);
        // Find the first cell: where the ray enters the box.
        let why = match Crossing::begin(&self.lattice, ray, watch) {
            None => Ending::Outside,
            Some(crossing) => {
                let mut mailbox = Mailbox::new();
                self.cross(prims, crossing, &mut best, &mut mailbox, watch).unwrap_or(Ending::Exhausted)
            }
        };
        watch.on(Visit::End { why, hit: best.hit.is_some(), t: best.t() });
        best.hit
    }
}

impl<C: Cells> GridOf<C> {
    /// Walks from cell to cell until the answer is known; says why, or nothing if the ray leaves the cells first.
    #[inline]
    fn cross(
        &self,
        prims: &impl Primitives,
        mut crossing: Crossing<'_>,
        best: &mut Best,
        mailbox: &mut Mailbox,
        watch: &mut impl Observer<Visit>,
    ) -> Option<Ending> {
        loop {
            // Test what the cell refers to.
            let (cell, refs) = self.enter(&crossing, watch);
            test_each(refs, self.mailbox.then_some(&mut *mailbox), prims, crossing.ray, best, watch);
            if best.answered() {
                return Some(Ending::Found);
            }

            // A cell with a grid of its own: cross that, then go on from here as if nothing had happened.
            if let Some(finer) = self.cells.within(cell) {
                let inner = crossing.within(finer, watch);
                if let Some(why) = self.cross(prims, inner, best, mailbox, watch) {
                    return Some(why);
                }
                crossing.resume(watch);
            }

            // Stop only if the best hit lies in this cell: beyond it, another cell may hold a nearer one.
            let t_far = crossing.t_far();
            if best.t() < t_far {
                return Some(Ending::Settled);
            }
            if best.hit.is_some() {
                watch.on(Visit::Beyond { cell, t: best.t(), t_far });
            }

            // On to the neighbour whose face comes first.
            if !crossing.step(watch) {
                return None;
            }
        }
    }

    /// Names the cell in which a ray is, with what it refers to.
    #[inline]
    pub(crate) fn enter(&self, crossing: &Crossing<'_>, watch: &mut impl Observer<Visit>) -> (CellId, &[PrimId]) {
        let cell = crossing.cell();
        let refs = self.cells.look_up(cell, watch);
        let (t_near, t_far) = (crossing.t, crossing.t_far());
        let leaf = self.cells.within(cell).is_none();
        watch.on(Visit::Enter { place: Place::Cell(cell), t_near, t_far, prims: refs.len() as u32, leaf });
        (cell, refs)
    }
}

/// Where a ray is among equal cells: in which, and the t of the face it leaves through along each axis.
pub(crate) struct Crossing<'a> {
    lattice: &'a Lattice,
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
    /// Enters the box around the cells; nothing if the ray misses it.
    #[inline]
    pub(crate) fn begin(lattice: &'a Lattice, ray: &'a Ray, watch: &mut impl Observer<Visit>) -> Option<Crossing<'a>> {
        if lattice.bounds.is_empty() {
            return None;
        }
        let range = slab(&lattice.bounds, ray, ray.range(), Place::World, watch);
        let Interval { near: t_near, far: t_far } = range;
        let verdict = if range.is_empty() { Verdict::Miss } else { Verdict::Hit };
        watch.on(Visit::Volume { place: Place::World, t_near, t_far, best_t: f32::INFINITY, verdict });
        (!range.is_empty()).then(|| Crossing::over(lattice, ray, range))
    }

    /// In the cell where `range` begins.
    #[inline]
    fn over(lattice: &'a Lattice, ray: &'a Ray, range: Interval) -> Crossing<'a> {
        let begins = |axis: Axis| {
            let (o, d) = (ray.o[axis], ray.d[axis]);
            lattice.locate(axis, if d == 0.0 { o } else { o + range.near * d })
        };
        let place = [begins(Axis::X), begins(Axis::Y), begins(Axis::Z)];
        let mut crossing = Crossing { lattice, ray, place, t: range.near, next: [0.0; 3], range };
        crossing.next = Axis::ALL.map(|axis| crossing.leaves(axis));
        crossing
    }

    /// Down into the grid within this cell, for the part of the ray that lies in the cell.
    fn within<'b>(&self, finer: &'b Lattice, watch: &mut impl Observer<Visit>) -> Crossing<'b>
    where
        'a: 'b,
    {
        let [nx, ny, nz] = finer.resolution;
        let (t_near, t_far) = (self.t, self.t_far());
        watch.on(Visit::Descend { cell: self.cell(), nx, ny, nz, t_near, t_far });
        Crossing::over(finer, self.ray, Interval::new(t_near, t_far))
    }

    /// Back from the grid within this cell.
    fn resume(&self, watch: &mut impl Observer<Visit>) {
        let [next_x, next_y, next_z] = self.next;
        let (t_near, t_far) = (self.t, self.t_far());
        watch.on(Visit::Ascend { cell: self.cell(), t_near, t_far, next_x, next_y, next_z });
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
        let (i, n) = (axis.index(), self.lattice.resolution[axis.index()]);
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
        self.lattice.cell_at(x, y, z)
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
        if d == 0.0 { f32::INFINITY } else { (self.lattice.plane(axis, index + u32::from(d > 0.0)) - o) / d }
    }

    /// How far apart in t the planes of an axis are: the lecture adds it, this walk shows it only.
    #[inline]
    fn delta(&self, axis: Axis) -> f32 {
        let width = self.lattice.bounds.extent()[axis] / self.lattice.resolution[axis.index()] as f32;
        if self.ray.d[axis] == 0.0 { f32::INFINITY } else { width / self.ray.d[axis].abs() }
    }
}
