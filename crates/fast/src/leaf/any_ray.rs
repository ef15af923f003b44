//! Any ray and all triangles, with the textbook's own test.

use raystep_accel::{Hit, Ray, Want};

use super::Four;
use crate::judge::{Count, Nearest, careful};

/// Brute force, for rays that a structure cannot be trusted with.
pub(crate) fn any_ray(leaves: &[Four], ray: &Ray, want: Want, count: &mut impl Count) -> Option<Hit> {
    let mut best = Nearest::before(ray.t_max);
    for four in leaves {
        count.triangles(four.count());
        for lane in 0..four.count() as usize {
            careful(four.triangle(lane), four.prim(lane), ray, &mut best);
        }
        if want == Want::Any && best.is_some() {
            break;
        }
    }
    best.hit()
}
