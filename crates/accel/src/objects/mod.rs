//! Two objects and whether they meet, slide 19: one file a pair, each test observed step by step; the objects
//! themselves stand in `shapes`.
//!
//! These are the tests that structures use: a walk meets triangles by [`ray_triangle`] and boxes by
//! [`ray_aabb`], a builder prunes by [`triangle_aabb`]. Unwatched they tell nothing and cost nothing.

mod aabb_aabb;
mod body;
mod example;
mod frustum_aabb;
mod inside;
mod obb_obb;
mod pairs;
mod plane_aabb;
mod point_aabb;
mod point_cone;
mod point_cylinder;
mod point_frustum;
mod point_obb;
mod point_plane;
mod point_polygon;
mod point_sphere;
mod point_triangle;
mod probe;
mod quadratic;
mod ray_aabb;
mod ray_cone;
mod ray_cylinder;
mod ray_obb;
mod ray_plane;
mod ray_polygon;
mod ray_sphere;
mod ray_triangle;
mod shapes;
mod sphere_aabb;
mod step;
mod trial;
mod triangle_aabb;

pub use body::{Body, Kind};
pub use pairs::{PAIRS, Pair};
pub use probe::{Cover, Part, Probe};
pub(crate) use shapes::clipped;
pub use shapes::{Cone, Corner, Cylinder, Disc, Frustum, Plane, Polygon, Prism, Shape, Sphere, Triangle, Wall};
pub use step::{Step, Steps, Watch};
pub use trial::{Arrangement, Trial};

use glam::DVec3;

/// The index of the component with the largest absolute value.
fn largest(d: DVec3) -> usize {
    let d = d.abs();
    if d.x >= d.y && d.x >= d.z {
        0
    } else if d.y >= d.z {
        1
    } else {
        2
    }
}
