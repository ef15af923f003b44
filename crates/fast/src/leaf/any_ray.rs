//! Any ray and all triangles, with the textbook's own test.

use raystep_accel::{Hit, Ray, Want};

use super::Four;
use crate::judge::{Count, Nearest, careful};

/// Brute force, for rays that a structure cannot be trusted with. A triangle that lies in many leaves is tested once.
pub(crate) fn any_ray(leaves: &[Four], ray: &Ray, want: Want, count: &mut impl Count) -> Option<Hit> {
    let (mut best, mut seen) = (Nearest::before(ray.t_max), Seen::default());
    for four in leaves {
        for lane in 0..four.count() as usize {
            let prim = four.prim(lane);
            if seen.is_new(prim) {
                count.triangles(1);
                careful(four.triangle(lane), prim, ray, &mut best);
            }
        }
        if want == Want::Any && best.is_some() {
            break;
        }
    }
    best.hit()
}

/// Which triangles were tested, a bit each.
#[derive(Default)]
struct Seen(Vec<u64>);

impl Seen {
    /// Whether a triangle was not seen before; now it is.
    fn is_new(&mut self, prim: u32) -> bool {
        let (word, bit) = (prim as usize / 64, 1 << (prim % 64));
        if word >= self.0.len() {
            self.0.resize(word + 1, 0);
        }
        let new = self.0[word] & bit == 0;
        self.0[word] |= bit;
        new
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_is_new_once() {
        let mut seen = Seen::default();
        let new: Vec<bool> = [5, 64, 5, 1000, 63, 64, 0, 1000].into_iter().map(|prim| seen.is_new(prim)).collect();
        assert_eq!(new, [true, true, false, true, true, false, true, false]);
    }
}
