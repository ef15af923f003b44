//! For each mistake a small flat scene and a ray on which it shows.

use glam::{Vec2, Vec3};

use super::Mistake;
use crate::{BvhRule, GridRule, KdRule, KdSplit, Ray, Rule, Shape, Sphere, Wall};

/// A flat scene, the structure to build over it, and a ray.
#[derive(Clone, Debug, PartialEq)]
pub struct Example {
    /// The primitives.
    pub shapes: Vec<Shape<'static>>,
    /// The structure.
    pub rule: Rule,
    /// The ray.
    pub ray: Ray,
    /// The rays that walk with it, if a packet makes the mistake.
    pub others: Vec<Ray>,
}

impl Mistake {
    /// Where the mistake shows: in the verdict, in the answer or in what the walk costs.
    pub fn example(self) -> Example {
        let (shapes, rule, ray) = match self {
            // The box [1, 3] × [2, 6] from the lower right: x = 3 comes before x = 1.
            Mistake::SlabNoSwap => (vec![wall([1.0, 2.0], [3.0, 6.0])], Rule::Slab, ray([5.0, 1.0], [-1.0, 1.0])),
            // A wall along y: its box begins and ends at x = 2.
            Mistake::SlabStrict => (vec![wall([2.0, 0.0], [2.0, 4.0])], Rule::Slab, ray([0.0, 2.0], [1.0, 0.0])),
            // The first box again, from the same place, looking away.
            Mistake::SlabBehind => (vec![wall([1.0, 2.0], [3.0, 6.0])], Rule::Slab, ray([5.0, 1.0], [1.0, -1.0])),
            // The wall is hit in the second cell at t = 2.62, the disc in the third at t = 2.15.
            Mistake::GridStopsEarly => {
                let mut shapes = in_a_box([0.0, 0.0], [4.0, 1.0], vec![wall([1.2, 0.2], [3.8, 0.75])]);
                shapes.push(disc([2.3, 0.5], 0.15));
                (shapes, four_cells(), ray([0.0, 0.5], [1.0, 0.0]))
            }
            // The same wall, and no disc.
            Mistake::GridForgets => {
                let shapes = in_a_box([0.0, 0.0], [4.0, 1.0], vec![wall([1.2, 0.2], [3.8, 0.75])]);
                (shapes, four_cells(), ray([0.0, 0.5], [1.0, 0.0]))
            }
            // The plane x = 4 from the right: the wall across it is hit at t = 6.33, the disc at t = 4.8.
            Mistake::KdLeftFirst => {
                let shapes = vec![wall([3.0, 0.2], [7.0, 1.4]), disc([6.9, 1.0], 0.3)];
                (in_a_box([0.0, 0.0], [8.0, 2.0], shapes), one_plane(), ray([12.0, 1.0], [-1.0, 0.0]))
            }
            // The plane x = 8: the wall across it is hit at t = 9, the disc behind it at t = 8.5.
            Mistake::KdAnyHit => {
                let shapes = vec![wall([6.0, 0.4], [12.0, 1.6]), disc([8.8, 1.0], 0.3)];
                (in_a_box([2.0, 0.0], [14.0, 2.0], shapes), one_plane(), ray([0.0, 1.0], [1.0, 0.0]))
            }
            // The left box begins at t = 3 and is hit at 6; the right one begins at 1 and is hit at 2.
            Mistake::BvhUnordered | Mistake::BvhNoCut => {
                let shapes = vec![wall([7.0, 0.0], [1.0, 2.0]), wall([9.0, 0.0], [7.0, 2.0])];
                let rule = Rule::Bvh(BvhRule { leaf_size: 1, ..BvhRule::default() });
                (shapes, rule, ray([10.0, 1.0], [-1.0, 0.0]))
            }
            // The plane x = 4: three rays rise right of it and miss, the first one left of it, where a disc is hit.
            Mistake::KdPacketMajority => {
                let shapes = vec![disc([2.0, 2.0], 0.5)];
                (in_a_box([0.0, 0.0], [8.0, 4.0], shapes), one_plane(), ray([2.0, -1.0], [0.0, 1.0]))
            }
        };
        let others = if self.is_of_packets() { [5.0, 6.0, 7.0].map(ray_up).to_vec() } else { Vec::new() };
        Example { shapes, rule: rule.flat(), ray, others }
    }
}

fn wall(from: [f32; 2], to: [f32; 2]) -> Shape<'static> {
    Shape::Wall(Wall { from: Vec2::from(from), to: Vec2::from(to), z: [-0.5, 0.5] })
}

fn disc([x, y]: [f32; 2], radius: f32) -> Shape<'static> {
    Shape::Sphere(Sphere { center: Vec3::new(x, y, 0.0), radius })
}

fn ray([x, y]: [f32; 2], [dx, dy]: [f32; 2]) -> Ray {
    Ray::new(Vec3::new(x, y, 0.0), Vec3::new(dx, dy, 0.0)).expect("the examples' rays are finite")
}

fn ray_up(x: f32) -> Ray {
    ray([x, -1.0], [0.0, 1.0])
}

/// Two short walls, in the lower left and the upper right corner, make the box of the scene a round one.
fn in_a_box(min: [f32; 2], max: [f32; 2], mut shapes: Vec<Shape<'static>>) -> Vec<Shape<'static>> {
    shapes.push(wall(min, [min[0], min[1] + 0.1]));
    shapes.push(wall([max[0], max[1] - 0.1], max));
    shapes
}

/// A row of four cells.
fn four_cells() -> Rule {
    Rule::Grid(GridRule { cells: [4, 1, 1], ..GridRule::default() })
}

/// A kd-tree with one plane, through the middle.
fn one_plane() -> Rule {
    Rule::Kd(KdRule { split: KdSplit::Middle, max_depth: 1, min_objects: 1, ..KdRule::default() })
}
