//! Which part of the ray a ruler shows, and how it is stretched and shifted.

use std::cmp::Ordering;

use raystep_accel::Interval;

/// A ruler is never stretched further than so many times: single precision has no more to show.
const MOST: f32 = 1e4;

/// The scale of a ruler.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RulerScale {
    /// All that there is to show.
    pub whole: Interval,
    /// What is shown of it.
    pub shown: Interval,
    /// Where that begins and ends in the pane, in points.
    pub left: f32,
    /// Its other end.
    pub right: f32,
}

impl RulerScale {
    /// The t at a place of the pane.
    pub fn t_at(&self, x: f32) -> f32 {
        let part = ((x - self.left) / (self.right - self.left)).clamp(0.0, 1.0);
        self.shown.near + (self.shown.far - self.shown.near) * part
    }

    /// Stretched by a factor, what lies at a place of the pane staying there; nothing when that shows all there is.
    pub fn stretched(&self, factor: f32, x: f32) -> Option<Interval> {
        let (all, t) = (self.whole.far - self.whole.near, self.t_at(x));
        let length = self.shown.far - self.shown.near;
        let factor = if factor.is_finite() { factor.clamp(0.05, 20.0) } else { 1.0 };
        let factor = if length / factor < all / MOST { 1.0 } else { factor };
        let near = t - (t - self.shown.near) / factor;
        self.within(near, length / factor)
    }

    /// Shifted by so many points, as what lies under the pointer follows it.
    pub fn shifted(&self, by: f32) -> Option<Interval> {
        let length = self.shown.far - self.shown.near;
        self.within(self.shown.near - by / (self.right - self.left) * length, length)
    }

    /// A part of this length, moved so that it does not reach out of all there is.
    fn within(&self, near: f32, length: f32) -> Option<Interval> {
        let all = self.whole.far - self.whole.near;
        if length.partial_cmp(&(all * 0.999)) != Some(Ordering::Less) {
            return None;
        }
        let near = near.max(self.whole.near).min(self.whole.far - length);
        Some(Interval::new(near, near + length))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scale(near: f32, far: f32) -> RulerScale {
        RulerScale { whole: Interval::new(0.0, 20.0), shown: Interval::new(near, far), left: 100.0, right: 500.0 }
    }

    #[test]
    fn what_lies_under_the_pointer_stays_there() {
        let now = scale(0.0, 20.0);
        let part = now.stretched(4.0, 300.0).expect("a part");
        assert_eq!(part, Interval::new(7.5, 12.5));
        let then = RulerScale { shown: part, ..now };
        assert_eq!((now.t_at(300.0), then.t_at(300.0)), (10.0, 10.0));
        // Back again, all of it.
        assert_eq!(then.stretched(0.25, 300.0), None);
    }

    #[test]
    fn a_part_never_reaches_out_of_the_whole() {
        let now = scale(1.0, 3.0);
        assert_eq!(now.shifted(400.0), Some(Interval::new(0.0, 2.0)));
        assert_eq!(now.shifted(-40_000.0), Some(Interval::new(18.0, 20.0)));
        assert_eq!(now.stretched(0.5, 100.0), Some(Interval::new(1.0, 5.0)));
        // A pane without width, and a factor that is no number.
        assert_eq!(scale(0.0, 20.0).stretched(f32::NAN, 100.0), None);
    }

    #[test]
    fn nothing_is_stretched_without_end() {
        let mut now = scale(0.0, 20.0);
        for _ in 0..200 {
            now.shown = now.stretched(3.0, 250.0).unwrap_or(now.shown);
        }
        assert!(now.shown.far - now.shown.near > 1e-3, "{now:?}");
    }
}
