//! What is measured here: what a structure costs the rays of a picture, in counts, which are the same everywhere.

use glam::{Vec2, Vec3};
use raystep_accel::{
    Accel, Cancelled, Cost, Each, Fill, Grow, KdLayout, Machine, Observer, Packet, PacketStep, PacketVisit, Primitives,
    Prims, Random, Ray, RayError, Structure, Want, Width, pinhole,
};
use raystep_fast::{Fast, FastKind, Settings, Work};
use raystep_scene::{Scene, Scenes, View};

use crate::Plan;

use super::table::{Lanes, Runs};
use super::{Care, Column, rows, standing};

/// Counts of one structure over the rays of one picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measured {
    /// Rays shot: one through the middle of each pixel.
    pub rays: u64,
    /// Tests of primitives, a ray.
    pub tests: f64,
    /// Nodes or cells entered, a ray.
    pub visits: f64,
    /// Volumes tested, a ray.
    pub boxes: f64,
    /// Nodes or cells that there are.
    pub nodes: u64,
    /// What the structure takes in memory.
    pub bytes: u64,
    /// Of packets, how many lanes took part in a visit; no number where single rays walk.
    pub alive: f64,
}

/// How it is walked and stored, if not by one ray after the other and as the structure stores it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct How {
    /// Rays walk in packets of so many: those of neighbouring pixels.
    pub lanes: Option<Width>,
    /// A kd-tree's nodes are laid out so, on a machine of 64 bits.
    pub layout: Option<KdLayout>,
    /// On what it runs, where it is timed.
    pub runs: Runs,
    /// With which instructions, if not with the best.
    pub isa: Option<Lanes>,
}

/// Pixels across and down the picture that is measured.
const PICTURE: [u32; 2] = [96, 72];
/// Pixels of a heat map.
const MAP: [u32; 2] = [200, 150];
/// The same for brute force: each ray tests everything, whichever ray it is.
const SMALL_PICTURE: [u32; 2] = [16, 12];

/// What one ray of a picture costs, pixel by pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Counted {
    /// Pixels across and down.
    pub size: [u32; 2],
    /// What is counted of each pixel's ray, rows from above.
    pub counts: Vec<u32>,
}

impl Counted {
    /// The ray that was shot through a pixel, where there are so many across and down.
    ///
    /// # Errors
    /// The camera sees nothing.
    pub fn ray(scene: &Scene, size: [u32; 2], at: [u32; 2]) -> Result<Ray, RayError> {
        through(&scene.close_view(), size, at)
    }

    /// The mean of all rays.
    pub fn mean(&self) -> f64 {
        self.counts.iter().map(|count| f64::from(*count)).sum::<f64>() / self.counts.len().max(1) as f64
    }

    /// The smallest and the largest count.
    pub fn range(&self) -> [u32; 2] {
        let least = self.counts.iter().copied().min().unwrap_or(0);
        [least, self.counts.iter().copied().max().unwrap_or(0)]
    }
}

impl Measured {
    /// Builds what `plan` says over a scene and shoots the rays of its close view.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub(crate) fn of(
        plan: &Plan,
        how: How,
        scene: &Scene,
        care: Care,
        watch: &mut impl Observer<Grow>,
    ) -> Result<Option<Measured>, Cancelled> {
        let Some(structure) = standing::structure(plan, scene, watch)? else { return Ok(None) };
        if let Some(width) = how.lanes {
            return Measured::of_packets(&structure, how, width, scene, care, watch).map(Some);
        }
        let all = matches!(*structure, Structure::List(_));
        let (mut cost, mut rays) = (Cost::default(), 0_u32);
        for own in shoot(&structure, scene, care.of(if all { SMALL_PICTURE } else { PICTURE }), watch)? {
            cost += own;
            rays += 1;
        }
        let each = |count: u64| count as f64 / f64::from(rays.max(1));
        let cells = structure.grid().map_or(0, |grid| grid.cell_count() as u64);
        Ok(Some(Measured {
            rays: u64::from(rays),
            tests: each(Column::Tests.count(&cost)),
            visits: each(Column::Visits.count(&cost)),
            boxes: each(Column::Boxes.count(&cost)),
            nodes: structure.node_count() as u64 + cells,
            bytes: bytes(&structure, how),
            alive: f64::NAN,
        }))
    }

    /// The same rays through a fast structure; nothing over a scene that is no mesh.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub(crate) fn of_fast(
        kind: FastKind,
        scene: &Scene,
        care: Care,
        watch: &impl Observer<Grow>,
    ) -> Result<Option<Measured>, Cancelled> {
        let Prims::Mesh(mesh) = &scene.prims else { return Ok(None) };
        let fast = kind.build(mesh, &Settings::default());
        let (view, [width, height]) = (scene.close_view(), care.of(PICTURE));
        let work = |x: u32, y: u32| {
            let mut work = Work::default();
            if let Ok(ray) = through(&view, [width, height], [x, y]) {
                fast.walk(&ray, Want::Nearest, &mut work);
            }
            work
        };
        let rows = rows::each(height, watch, |y| (0..width).map(|x| work(x, y)).collect::<Vec<_>>())?;
        let rays = u64::from(width) * u64::from(height);
        let each = |of: fn(&Work) -> u64| rows.iter().flatten().map(of).sum::<u64>() as f64 / rays.max(1) as f64;
        Ok(Some(Measured {
            rays,
            tests: each(|work| work.triangles),
            visits: each(|work| work.nodes),
            boxes: each(|work| work.boxes),
            nodes: 0,
            bytes: fast.bytes() as u64,
            alive: f64::NAN,
        }))
    }

    /// The same rays in packets, a block of pixels each.
    fn of_packets(
        structure: &Structure,
        how: How,
        width: Width,
        scene: &Scene,
        care: Care,
        watch: &mut impl Observer<Grow>,
    ) -> Result<Measured, Cancelled> {
        let [across, down] = match width {
            Width::Four => [2, 2],
            Width::Eight => [4, 2],
            Width::Sixteen => [4, 4],
        };
        let (view, size) = (scene.close_view(), care.of(PICTURE));
        let (mut fill, mut cost, mut rays) = (Fill::default(), Cost::default(), 0_u64);
        for y in (0..size[1]).step_by(down) {
            if watch.cancelled() {
                return Err(Cancelled);
            }
            for x in (0..size[0]).step_by(across) {
                let pixels = (0..down as u32).flat_map(|dy| (0..across as u32).map(move |dx| [x + dx, y + dy]));
                let block: Vec<Ray> = pixels.filter_map(|pixel| through(&view, size, pixel).ok()).collect();
                rays += block.len() as u64;
                let alone = Each(|event: PacketVisit| {
                    if let PacketStep::Lane(visit) = event.step {
                        cost.on(visit);
                    }
                });
                if let Some(packet) = Packet::of(&block) {
                    structure.walk_packet(&scene.prims, packet, Want::Nearest, &mut (&mut fill, alone));
                }
            }
        }
        let each = |count: u64| count as f64 / rays.max(1) as f64;
        Ok(Measured {
            rays,
            tests: each(cost.prim_tests),
            visits: each(fill.visits),
            boxes: each(cost.box_tests),
            nodes: structure.node_count() as u64,
            bytes: bytes(structure, how),
            alive: fill.lane_visits as f64 / fill.visits.max(1) as f64,
        })
    }
}

impl Measured {
    /// One of its counts of a ray.
    pub(crate) fn count(&self, of: Column) -> f64 {
        match of {
            Column::Visits => self.visits,
            Column::Boxes => self.boxes,
            _ => self.tests,
        }
    }

    /// The same over scenes of more and more primitives: how many those are, and what a ray costs.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub(crate) fn growth(
        plan: &Plan,
        of: Column,
        names: &[String],
        through: Option<Vec3>,
        scenes: &Scenes,
        care: Care,
        watch: &mut impl Observer<Grow>,
    ) -> Result<Vec<[f64; 2]>, Cancelled> {
        let mut dots = Vec::new();
        for scene in names.iter().filter_map(|name| scenes.named(name).ok()) {
            let each = match through {
                Some(point) => at_point(plan, of, &scene, point, watch)?,
                None => Measured::of(plan, How::default(), &scene, care, watch)?.map(|measured| measured.count(of)),
            };
            dots.extend(each.map(|each| [scene.prims.len() as f64, each]));
        }
        Ok(dots)
    }
}

/// So many rays are shot through a point.
const THROUGH: usize = 500;

/// What a ray through a point costs, over seeded rays from all around.
fn at_point(
    plan: &Plan,
    of: Column,
    scene: &Scene,
    point: Vec3,
    watch: &mut impl Observer<Grow>,
) -> Result<Option<f64>, Cancelled> {
    let Some(structure) = standing::structure(plan, scene, watch)? else { return Ok(None) };
    let mut random = Random::new(2);
    let reach = scene.bounds().extent().max_element().max(f32::MIN_POSITIVE) * 1.5;
    let from = std::iter::repeat_with(|| {
        Vec3::new(random.range(-1.0, 1.0), random.range(-1.0, 1.0), random.range(-1.0, 1.0)) * reach
    });
    let rays: Vec<Ray> = from.filter_map(|from| Ray::new(point + from, -from).ok()).take(THROUGH).collect();
    let mut cost = Cost::default();
    for ray in &rays {
        if watch.cancelled() {
            return Err(Cancelled);
        }
        structure.intersect(&scene.prims, ray, &mut cost);
    }
    Ok(Some(of.count(&cost) as f64 / THROUGH as f64))
}

impl Counted {
    /// What each ray of a scene's close view costs through a fast structure; nothing over a scene that is no mesh.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub(crate) fn of_fast(
        kind: FastKind,
        of: Column,
        scene: &Scene,
        care: Care,
        watch: &impl Observer<Grow>,
    ) -> Result<Option<Counted>, Cancelled> {
        let Prims::Mesh(mesh) = &scene.prims else { return Ok(None) };
        let (fast, view, size) = (kind.build(mesh, &Settings::default()), scene.close_view(), care.of(MAP));
        let count = |x: u32, y: u32| {
            let mut cost = Cost::default();
            if let Ok(ray) = through(&view, size, [x, y]) {
                fast.walk(&ray, Want::Nearest, &mut cost);
            }
            of.count(&cost) as u32
        };
        let rows = rows::each(size[1], watch, |y| (0..size[0]).map(|x| count(x, y)).collect::<Vec<_>>())?;
        Ok(Some(Counted { size, counts: rows.concat() }))
    }

    /// Builds what `plan` says over a scene and counts what each ray of its close view costs.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub(crate) fn of(
        plan: &Plan,
        of: Column,
        scene: &Scene,
        care: Care,
        watch: &mut impl Observer<Grow>,
    ) -> Result<Option<Counted>, Cancelled> {
        let Some(structure) = standing::structure(plan, scene, watch)? else { return Ok(None) };
        let size = care.of(MAP);
        let counts = shoot(&structure, scene, size, watch)?.map(|own| of.count(&own) as u32).collect();
        Ok(Some(Counted { size, counts }))
    }
}

/// What a structure takes in memory, its nodes laid out as asked for.
fn bytes(structure: &Structure, how: How) -> u64 {
    let own = structure.bytes() as u64;
    match (structure, how.layout) {
        (Structure::Kd(_), Some(layout)) => {
            let nodes = structure.node_count() as u64;
            let [stored, wanted] = [KdLayout::Compact, layout].map(|layout| layout.bytes(Machine::Bits64) as u64);
            own - nodes * stored + nodes * wanted
        }
        _ => own,
    }
}

/// The ray through the middle of a pixel.
pub(super) fn through(view: &View, [width, height]: [u32; 2], [x, y]: [u32; 2]) -> Result<Ray, RayError> {
    let size = Vec2::new(width as f32, height as f32);
    let at = (Vec2::new(x as f32 + 0.5, y as f32 + 0.5) / size * 2.0 - 1.0) * Vec2::new(1.0, -1.0);
    pinhole(view.eye, view.target, view.up, view.fov_degrees, at, size.x / size.y)
}

/// What each ray of a picture costs, rows from above.
fn shoot(
    structure: &Structure,
    scene: &Scene,
    [width, height]: [u32; 2],
    watch: &impl Observer<Grow>,
) -> Result<impl Iterator<Item = Cost>, Cancelled> {
    let view = scene.close_view();
    let cost = |x: u32, y: u32| {
        let mut cost = Cost::default();
        // A camera that sees nothing shoots rays that cost nothing.
        if let Ok(ray) = through(&view, [width, height], [x, y]) {
            structure.intersect(&scene.prims, &ray, &mut cost);
        }
        cost
    };
    let rows = rows::each(height, watch, |y| (0..width).map(|x| cost(x, y)).collect::<Vec<_>>())?;
    Ok(rows.into_iter().flatten())
}
