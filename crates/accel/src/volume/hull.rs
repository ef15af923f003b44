//! The convex hull, slide 52: the tightest of the convex volumes, and the dearest to test.

use glam::{DVec3, Vec3};

use super::quickhull::quickhull;
use super::{Outline, Spans, Volume, corners, slack, spans};
use crate::common::bars_projection;
use crate::slab::{earlier, later};
use crate::{Aabb, Axes, Cancelled, Corner, Direction, Fit, Interval, Observer, Place, PrimId, Primitives, Ray, Visit};

/// All points behind some planes.
#[derive(Clone, Debug, PartialEq)]
pub struct Hull {
    /// The box around it.
    pub bounds: Aabb,
    /// Each plane's normal, outward and of length one, and how far along it the plane lies, seen from the middle
    /// of the box.
    pub planes: Vec<(Vec3, f32)>,
    /// The corners of the primitives that are its own.
    pub corners: Vec<Vec3>,
}

/// More corners than this are not sought: planes cost time in each test.
const MOST_CORNERS: usize = 48;

impl Volume for Hull {
    type Draft = Spans;

    #[inline]
    fn bars(ray: &Ray) -> Option<Visit> {
        bars_projection(ray)
    }

    fn fit<P: Primitives>(
        prims: &P,
        ids: impl Iterator<Item = PrimId>,
        bounds: &Aabb,
        _: Axes,
        watch: &mut impl Observer<Fit>,
    ) -> Result<Hull, Cancelled> {
        let corners = corners(prims, ids, watch)?;
        let center = bounds.center();
        let seen = |corner: &Corner| corner.at.as_dvec3() - center.as_dvec3();
        let mut points: Vec<DVec3> = corners.iter().filter(|corner| corner.radius == 0.0).map(seen).collect();
        let sharp = points.len();
        for round in corners.iter().filter(|corner| corner.radius > 0.0) {
            points.extend(directions().map(|n| seen(round) + n * f64::from(round.radius)));
        }
        let found = quickhull(&points, center.as_dvec3(), MOST_CORNERS, watch)?;
        // Whatever the search left out or rounding moved: each plane goes out as far as the furthest corner.
        let normals: Vec<Vec3> = found.faces.iter().map(|face| face.n.as_vec3()).collect();
        let along: Vec<DVec3> = normals.iter().map(|n| n.as_dvec3()).collect();
        let far = spans(&corners, center, &along, watch)?;
        let offsets = far.into_iter().map(|[_, high]| (high as f32).next_up());
        let planes: Vec<(Vec3, f32)> = normals.into_iter().zip(offsets).collect();
        for (face, &(Vec3 { x, y, z }, plane)) in found.faces.iter().zip(&planes) {
            watch.on(Fit::Plane { face: face.id, x, y, z, plane });
        }
        let kept = found.corners.into_iter().filter(|&i| i < sharp);
        Ok(Hull { bounds: *bounds, planes, corners: kept.map(|i| (points[i] + center.as_dvec3()).as_vec3()).collect() })
    }

    /// Clips the ray against one plane after the other (Cyrus and Beck 1978).
    fn meet(&self, ray: &Ray, within: Interval, place: Place, watch: &mut impl Observer<Visit>) -> Interval {
        let f = ray.o - self.bounds.center();
        let slack = slack(ray, f, self.bounds.extent().length() * 0.5);
        let Interval { near: mut t_near, far: mut t_far } = within;
        for (face, &(n, offset)) in (0..).zip(&self.planes) {
            let (o, d, plane) = (n.dot(f), n.dot(ray.d), offset + slack);
            // Against the normal the ray comes in, along it the ray goes out; parallel it is in or out for ever.
            let (t, entering) = if d == 0.0 {
                (if o > plane { f32::NEG_INFINITY } else { f32::INFINITY }, false)
            } else {
                ((plane - o) / d, d < 0.0)
            };
            if entering {
                t_near = t_near.max(earlier(t));
            } else {
                t_far = t_far.min(later(t));
            }
            let empty = t_near > t_far;
            watch.on(Visit::Clip {
                place,
                face,
                axis: Direction::of(n),
                o,
                d,
                plane,
                t,
                entering,
                t_near,
                t_far,
                empty,
            });
            if empty {
                break;
            }
        }
        Interval::new(t_near, t_far)
    }

    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn planes(&self) -> u32 {
        self.planes.len() as u32
    }

    fn outline(&self) -> Outline {
        let planes = self.planes.iter().map(|&(n, offset)| (n.as_dvec3(), f64::from(offset)));
        Outline::of_planes(self.bounds.center(), planes)
    }

    fn bytes(&self) -> usize {
        size_of::<Hull>() + size_of_val(&*self.planes) + size_of_val(&*self.corners)
    }
}

/// Twenty-six directions, as evenly as corners, edges and faces of a cube give them.
fn directions() -> impl Iterator<Item = DVec3> {
    let all = (0..27).map(|i| DVec3::new(f64::from(i % 3) - 1.0, f64::from(i / 3 % 3) - 1.0, f64::from(i / 9) - 1.0));
    all.filter_map(DVec3::try_normalize)
}
