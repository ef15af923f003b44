//! How many rays a second: rounds over the same rays, as long as there is time.

use raystep_accel::Ray;

/// What is timed, and for how long.
pub struct Pace<'a> {
    /// Seconds since any moment.
    pub clock: &'a dyn Fn() -> f64,
    /// Whether to go on.
    pub go_on: &'a (dyn Fn() -> bool + Sync),
    /// For so many seconds, or a little longer.
    pub seconds: f64,
}

/// At least so many rounds are timed, and at most.
const ROUNDS: usize = 5;
const MOST_ROUNDS: usize = 99;
/// So many rays, from all over the picture, say how long the others will take.
const TRIES: usize = 64;
/// Rays that stand together are taken together, so that those who profit from it can.
const TILE: usize = 64;

impl Pace<'_> {
    /// As many of the rays, from all over the picture, as can be shot in each of some rounds; nothing if it shall not go
    /// on.
    pub fn some(&self, rays: &[Ray], mut shoot: impl FnMut(&[Ray])) -> Option<Vec<Ray>> {
        let share = self.seconds / (ROUNDS + 1) as f64;
        let begun = (self.clock)();
        let mut tried = 0;
        for ray in &spread(rays, 1, TRIES) {
            if !(self.go_on)() {
                return None;
            }
            shoot(std::slice::from_ref(ray));
            tried += 1;
            if (self.clock)() - begun > share {
                break;
            }
        }
        let each = ((self.clock)() - begun).max(1e-9) / tried.max(1) as f64;
        // More than any machine shoots are never asked for.
        let most = (share / each).clamp(2.0, 1e9) as usize;
        Some(match most {
            most if most >= rays.len() => rays.to_vec(),
            most if most >= TRIES * TILE => spread(rays, TILE, most),
            most => spread(rays, 1, most),
        })
    }

    /// The median of the rounds' rays a second, the least and the most, and how many rounds there were; nothing if it shall
    /// not go on.
    pub fn rounds(&self, rays: usize, mut round: impl FnMut()) -> Option<([f64; 3], usize)> {
        let begun = (self.clock)();
        let mut speeds = Vec::new();
        while speeds.len() < ROUNDS || ((self.clock)() - begun < self.seconds && speeds.len() < MOST_ROUNDS) {
            if !(self.go_on)() {
                return None;
            }
            let from = (self.clock)();
            round();
            speeds.push(rays as f64 / ((self.clock)() - from).max(1e-9));
        }
        speeds.sort_by(f64::total_cmp);
        Some(([speeds[speeds.len() / 2], speeds[0], speeds[speeds.len() - 1]], speeds.len()))
    }
}

/// No more than `most` of the rays, in runs of `run`, evenly from all of them.
fn spread(rays: &[Ray], run: usize, most: usize) -> Vec<Ray> {
    let (runs, wanted) = (rays.len().div_ceil(run), (most / run).max(1));
    let every = runs.div_ceil(wanted).max(1);
    // From the middle of each stretch, so that it is not the picture's corner that is always there.
    rays.chunks(run).skip(every / 2).step_by(every).flatten().copied().collect()
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use glam::Vec3;

    use super::*;

    /// A machine that takes so many seconds for each ray: how many rays a round has, and the speed that is told.
    fn check(each: f64, rays: usize) -> (usize, [f64; 3], usize) {
        let now = Cell::new(0.0);
        let shot = |n: usize| now.set(now.get() + each * n as f64);
        let clock = || now.get();
        let pace = Pace { clock: &clock, go_on: &|| true, seconds: 0.5 };
        let all = vec![Ray::new(Vec3::ZERO, Vec3::X).unwrap(); rays];
        let some = pace.some(&all, |rays| shot(rays.len())).unwrap().len();
        let (speeds, rounds) = pace.rounds(some, || shot(some)).unwrap();
        (some, speeds, rounds)
    }

    #[test]
    fn time_is_bounded_and_speed_is_told_as_it_is() {
        for each in [1e-8, 1e-6, 1e-4, 1e-2] {
            let (some, speeds, rounds) = check(each, 1 << 14);
            assert!(speeds.iter().all(|speed| (speed * each - 1.0).abs() < 1e-6), "{each}: {speeds:?}");
            assert!((ROUNDS..=MOST_ROUNDS).contains(&rounds), "{each}: {rounds} rounds");
            let took = each * (some * rounds) as f64;
            assert!(took < 0.7, "{each}: {some} rays in {rounds} rounds take {took} s");
        }
        assert_eq!(check(1e-8, 1 << 14).0, 1 << 14, "who is fast shoots all of them");
        assert_eq!(check(3.0, 100).0, 2, "who is slow shoots two in a round");
    }

    #[test]
    fn who_says_stop_is_heard() {
        let pace = Pace { clock: &|| 0.0, go_on: &|| false, seconds: 0.5 };
        assert!(pace.rounds(1, || ()).is_none());
        assert!(pace.some(&[Ray::new(Vec3::ZERO, Vec3::X).unwrap()], |_| ()).is_none());
    }
}
