//! From where the rays are shot.

use std::fmt;
use std::str::FromStr;

use glam::Vec3;
use raystep_figure::Camera;
use raystep_scene::{Scene, View};

use crate::export::Size;
use crate::shown::camera::of_scene;

/// A camera, as it is written on the command line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::cli) enum Look {
    /// As near as the whole object stays in the picture.
    Close,
    /// The scene's own view.
    Scene,
    /// An eye, what it looks at, and an angle in degrees.
    Free {
        /// Where the eye is.
        eye: Vec3,
        /// What it looks at.
        target: Vec3,
        /// The vertical angle of view.
        fov_degrees: f32,
    },
}

impl FromStr for Look {
    type Err = String;

    fn from_str(text: &str) -> Result<Look, String> {
        let numbers: Option<Vec<f32>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
        let numbers = numbers.filter(|numbers| numbers.iter().all(|number| number.is_finite()));
        match (text, numbers.as_deref()) {
            ("close", _) => Ok(Look::Close),
            ("scene", _) => Ok(Look::Scene),
            (_, Some(&[ex, ey, ez, tx, ty, tz, ref angle @ ..])) if angle.len() < 2 => {
                let fov_degrees = angle.first().copied().unwrap_or(30.0);
                let (eye, target) = (Vec3::new(ex, ey, ez), Vec3::new(tx, ty, tz));
                if eye == target || !(1.0..=170.0).contains(&fov_degrees) {
                    return Err("the eye must not lie at the target, and the angle must be from 1 to 170".to_owned());
                }
                Ok(Look::Free { eye, target, fov_degrees })
            }
            _ => Err("write close, scene, or six numbers for eye and target and perhaps a seventh for the angle in \
                      degrees, as in 2,-9,5,0,0,1.5,30"
                .to_owned()),
        }
    }
}

impl fmt::Display for Look {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Look::Close => f.write_str("close"),
            Look::Scene => f.write_str("scene"),
            Look::Free { eye: e, target: t, fov_degrees } => {
                write!(f, "{},{},{},{},{},{},{fov_degrees}", e.x, e.y, e.z, t.x, t.y, t.z)
            }
        }
    }
}

/// What is shot: a picture from a camera, perhaps with a light.
pub(in crate::cli) struct Shot {
    pub(in crate::cli) camera: Camera,
    pub(in crate::cli) size: Size,
    pub(in crate::cli) light: Option<Vec3>,
}

impl Shot {
    pub(in crate::cli) fn of(scene: &Scene, look: Look, size: Size, shadows: bool) -> Shot {
        let pixels: glam::Vec2 = size.into();
        let camera = match look {
            Look::Free { eye, target, fov_degrees } => Camera::Solid { eye, target, up: scene.view.up, fov_degrees },
            Look::Close if !scene.flat => {
                let View { eye, target, up, fov_degrees } = scene.close_view();
                Camera::Solid { eye, target, up, fov_degrees }
            }
            Look::Close | Look::Scene => of_scene(scene, pixels),
        };
        // Above, to the left and in front, two diagonals away.
        let bounds = scene.bounds();
        let light = shadows.then(|| bounds.center() + Vec3::new(-0.6, -0.8, 1.7) * bounds.extent().length());
        Shot { camera, size, light }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cameras_are_read() {
        assert_eq!("close".parse(), Ok(Look::Close));
        let free = Look::Free { eye: Vec3::new(1.0, -2.0, 3.0), target: Vec3::ZERO, fov_degrees: 30.0 };
        assert_eq!("1,-2,3,0,0,0".parse(), Ok(free));
        assert_eq!("1,-2,3,0,0,0,30".parse(), Ok(free));
        for wrong in ["", "far", "1,2,3", "0,0,0,0,0,0", "1,2,3,0,0,0,0", "1,2,3,0,0,0,30,1", "1,2,nan,0,0,0"] {
            assert!(wrong.parse::<Look>().is_err(), "{wrong}");
        }
    }
}
