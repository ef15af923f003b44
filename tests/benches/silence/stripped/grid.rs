//! The walk of the uniform grid, stripped.

use raystep_accel::{
    Aabb, Accel, AnyGrid, Axis, CellId, Grid, Hit, Interval, List, Margin, PrimId, Primitives, Ray, Want,
};

use super::{Best, Mailbox, slab, test_each};

/// The grid's own data, laid out as in `raystep-accel`.
pub(crate) struct StrippedGrid {
    lattice: Lattice,
    cells: Dense,
    margin: Margin,
    mailbox: bool,
}

struct Lattice {
    bounds: Aabb,
    resolution: [u32; 3],
    first: CellId,
}

struct Dense {
    starts: Vec<u32>,
    refs: Vec<PrimId>,
}

impl StrippedGrid {
    pub(crate) fn of(grid: &Grid, mailbox: bool, count: usize) -> StrippedGrid {
        let (mut starts, mut refs) = (vec![0], Vec::new());
        for cell in (0..grid.cell_count() as u32).map(CellId) {
            refs.extend(grid.cell_prims(cell));
            starts.push(refs.len() as u32);
        }
        let raystep_accel::Lattice { bounds, resolution, first } = grid.lattice;
        StrippedGrid {
            lattice: Lattice { bounds, resolution, first },
            cells: Dense { starts, refs },
            margin: Margin::of(&bounds, count),
            mailbox,
        }
    }

    #[inline(never)]
    pub(crate) fn intersect(&self, prims: &impl Primitives, ray: &Ray) -> Option<Hit> {
        self.walk(prims, ray, Want::Nearest)
    }

    #[inline(always)]
    fn walk(&self, prims: &impl Primitives, ray: &Ray, want: Want) -> Option<Hit> {
        if self.margin.bars(ray).is_some() {
            return List.walk(prims, ray, want, &mut ());
        }
        let mut best = Best::new(want);
        if let Some(crossing) = Crossing::begin(&self.lattice, ray) {
            let mut mailbox = Mailbox::new();
            self.cross(prims, crossing, &mut best, &mut mailbox);
        }
        best.hit
    }

    #[inline]
    fn cross(&self, prims: &impl Primitives, mut crossing: Crossing<'_>, best: &mut Best, mailbox: &mut Mailbox) {
        loop {
            let refs = self.enter(&crossing);
            test_each(refs, self.mailbox.then_some(&mut *mailbox), prims, crossing.ray, best);
            if best.answered() {
                return;
            }
            // A uniform grid has no grids within cells.
            let t_far = crossing.t_far();
            if best.t() < t_far {
                return;
            }
            if !crossing.step() {
                return;
            }
        }
    }

    #[inline]
    fn enter(&self, crossing: &Crossing<'_>) -> &[PrimId] {
        self.cells.look_up(crossing.cell())
    }
}

impl Dense {
    #[inline]
    fn look_up(&self, cell: CellId) -> &[PrimId] {
        &self.refs[self.starts[cell.index()] as usize..self.starts[cell.index() + 1] as usize]
    }
}

impl Lattice {
    #[inline]
    fn cell_at(&self, x: u32, y: u32, z: u32) -> CellId {
        let [nx, ny, _] = self.resolution;
        CellId(self.first.0 + x + nx * (y + ny * z))
    }

    #[inline]
    fn plane(&self, axis: Axis, index: u32) -> f32 {
        let (n, low, high) = (self.resolution[axis.index()], self.bounds.min[axis], self.bounds.max[axis]);
        if index == 0 {
            low
        } else if index == n {
            high
        } else {
            low + (high - low) * index as f32 / n as f32
        }
    }

    #[inline]
    fn locate(&self, axis: Axis, p: f32) -> u32 {
        let n = self.resolution[axis.index()];
        let (low, high) = (self.bounds.min[axis], self.bounds.max[axis]);
        let mut index = ((p - low) / (high - low) * n as f32) as u32;
        index = index.min(n - 1);
        while index > 0 && p < self.plane(axis, index) {
            index -= 1;
        }
        while index + 1 < n && p >= self.plane(axis, index + 1) {
            index += 1;
        }
        index
    }
}

struct Crossing<'a> {
    lattice: &'a Lattice,
    ray: &'a Ray,
    place: [u32; 3],
    t: f32,
    next: [f32; 3],
    range: Interval,
}

impl<'a> Crossing<'a> {
    #[inline]
    fn begin(lattice: &'a Lattice, ray: &'a Ray) -> Option<Crossing<'a>> {
        if lattice.bounds.is_empty() {
            return None;
        }
        let range = slab(&lattice.bounds, ray, ray.range());
        (!range.is_empty()).then(|| Crossing::over(lattice, ray, range))
    }

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

    #[inline]
    fn t_far(&self) -> f32 {
        let t = self.next[self.axis().index()];
        let t = if t < self.t { self.t } else { t };
        if t > self.range.far { self.range.far } else { t }
    }

    #[inline]
    fn step(&mut self) -> bool {
        let (axis, t) = (self.axis(), self.t_far());
        let (i, n) = (axis.index(), self.lattice.resolution[axis.index()]);
        let last = if self.ray.d[axis] > 0.0 { self.place[i] + 1 == n } else { self.place[i] == 0 };
        let inside = !last && self.next[i] <= self.range.far && self.next[i] < f32::INFINITY;
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

    #[inline]
    fn leaves(&self, axis: Axis) -> f32 {
        let (o, d, index) = (self.ray.o[axis], self.ray.d[axis], self.place[axis.index()]);
        if d == 0.0 { f32::INFINITY } else { (self.lattice.plane(axis, index + u32::from(d > 0.0)) - o) / d }
    }
}
