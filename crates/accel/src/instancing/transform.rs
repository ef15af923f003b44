//! The way from one space into another and back.

use std::fmt;

use glam::{Mat3, Vec3};

use crate::{Aabb, Ray};

/// `p ↦ matrix · p + shift`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// Turns, stretches and mirrors.
    pub matrix: Mat3,
    /// Moves.
    pub shift: Vec3,
}

/// Why a model cannot be placed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TransformError {
    /// A component is NaN or infinite.
    NotFinite,
    /// The transform flattens space, or nearly: it cannot be undone.
    Flat,
    /// There is no such model.
    Model {
        /// The model that was asked for.
        model: u32,
    },
}

impl Transform {
    /// Leaves everything where it is.
    pub const IDENTITY: Transform = Transform { matrix: Mat3::IDENTITY, shift: Vec3::ZERO };

    /// A transform that stretches one way this much more than another cannot be undone in single precision.
    const WORST: f32 = 1e4;

    /// Moves by `shift`.
    pub fn moved(shift: Vec3) -> Transform {
        Transform { shift, ..Transform::IDENTITY }
    }

    /// Where a point goes.
    #[inline]
    pub fn point(&self, p: Vec3) -> Vec3 {
        self.vector(p) + self.shift
    }

    /// Where a direction goes: it is not moved, and keeps the length it gets.
    #[inline]
    pub fn vector(&self, v: Vec3) -> Vec3 {
        self.matrix.x_axis * v.x + self.matrix.y_axis * v.y + self.matrix.z_axis * v.z
    }

    /// The same ray in the other space: the same `t` is the same point.
    ///
    /// Nothing if a component becomes too large or all of the direction too small for a number.
    #[inline]
    pub fn ray(&self, ray: &Ray) -> Option<Ray> {
        let moved = Ray::new(self.point(ray.o), self.vector(ray.d)).ok()?;
        moved.within(ray.t_min, ray.t_max).ok()
    }

    /// The box around a transformed box: each entry of the matrix takes the lower or the upper bound.
    /// (Arvo 1990, "Transforming axis-aligned bounding boxes", Graphics Gems.)
    pub fn bounds(&self, bounds: &Aabb) -> Aabb {
        if bounds.is_empty() {
            return Aabb::EMPTY;
        }
        let mut image = Aabb { min: self.shift, max: self.shift };
        for (column, low, high) in [
            (self.matrix.x_axis, bounds.min.x, bounds.max.x),
            (self.matrix.y_axis, bounds.min.y, bounds.max.y),
            (self.matrix.z_axis, bounds.min.z, bounds.max.z),
        ] {
            image.min += (column * low).min(column * high);
            image.max += (column * low).max(column * high);
        }
        image
    }

    /// The way back.
    ///
    /// # Errors
    /// There is none.
    pub fn inverse(&self) -> Result<Transform, TransformError> {
        if !(self.matrix.is_finite() && self.shift.is_finite()) {
            return Err(TransformError::NotFinite);
        }
        let matrix = self.matrix.inverse();
        let back = Transform { matrix, shift: Vec3::ZERO };
        let back = Transform { shift: -back.vector(self.shift), ..back };
        let fits = matrix.is_finite() && back.shift.is_finite() && self.condition() <= Self::WORST;
        if fits { Ok(back) } else { Err(TransformError::Flat) }
    }

    /// How much more it stretches one way than another, at most: 1 for turns and even scales.
    pub fn condition(&self) -> f32 {
        let norm =
            |m: &Mat3| (m.x_axis.length_squared() + m.y_axis.length_squared() + m.z_axis.length_squared()).sqrt();
        (norm(&self.matrix) * norm(&self.matrix.inverse()) / 3.0).max(1.0)
    }
}

impl fmt::Display for TransformError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            TransformError::NotFinite => f.write_str("the transform has a component that is not a finite number"),
            TransformError::Flat => f.write_str("the transform flattens space, so no ray can be moved back"),
            TransformError::Model { model } => write!(f, "there is no model {model}"),
        }
    }
}

impl std::error::Error for TransformError {}
