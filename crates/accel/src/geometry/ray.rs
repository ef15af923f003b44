//! A ray: where it starts, where it goes, and how much of it counts.

use std::fmt;

use glam::Vec3;

use super::Interval;

/// The points `o + t·d` with `t` in `[t_min, t_max]`. The direction need not have length one, so `t`
/// is measured in lengths of `d`. Only [`Ray::new`] makes one, so every ray can be walked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Origin, world space.
    pub o: Vec3,
    /// Direction, world space; finite and not zero.
    pub d: Vec3,
    /// Smallest t that counts.
    pub t_min: f32,
    /// Largest t that counts; may be infinite.
    pub t_max: f32,
}

/// Why a ray cannot be walked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayError {
    /// A component of the origin is NaN or infinite.
    Origin,
    /// A component of the direction is NaN or infinite.
    Direction,
    /// All three components of the direction are zero.
    NoDirection,
    /// `t_min` or `t_max` is NaN, or `t_min` is infinite.
    Range,
}

impl Ray {
    /// A ray from `o` towards `d` with `t` in `[0, ∞]`.
    ///
    /// # Errors
    /// A NaN or infinite component, or a direction of zeros.
    pub fn new(o: Vec3, d: Vec3) -> Result<Ray, RayError> {
        if !o.is_finite() {
            return Err(RayError::Origin);
        }
        if !d.is_finite() {
            return Err(RayError::Direction);
        }
        if d == Vec3::ZERO {
            return Err(RayError::NoDirection);
        }
        Ok(Ray { o, d, t_min: 0.0, t_max: f32::INFINITY })
    }

    /// The same ray with `t` in `[t_min, t_max]`. An empty range is allowed: it hits nothing.
    ///
    /// # Errors
    /// A NaN, or an infinite `t_min`.
    pub fn within(self, t_min: f32, t_max: f32) -> Result<Ray, RayError> {
        if !t_min.is_finite() || t_max.is_nan() {
            return Err(RayError::Range);
        }
        Ok(Ray { t_min, t_max, ..self })
    }

    /// The point at `t`.
    pub fn at(&self, t: f32) -> Vec3 {
        self.o + self.d * t
    }

    /// `[t_min, t_max]`.
    #[inline]
    pub fn range(&self) -> Interval {
        Interval::new(self.t_min, self.t_max)
    }
}

impl fmt::Display for RayError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            RayError::Origin => "the origin has a component that is not a finite number",
            RayError::Direction => "the direction has a component that is not a finite number",
            RayError::NoDirection => "the direction is zero: a ray needs at least one component that is not",
            RayError::Range => "t_min must be a finite number and t_max a number or inf",
        })
    }
}

impl std::error::Error for RayError {}
