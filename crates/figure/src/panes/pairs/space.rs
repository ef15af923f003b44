//! The two objects in space, and where in it the step of their test happens.

use glam::Vec3;
use raystep_accel::{Aabb, Axis, Body, Direction, Obb, Part, Probe, Ray, Shape, Step, Visit};

use super::bodies::{self, around, bounds, forms};
use super::tried::Tried;
use crate::theme::Role;
use crate::words::number;
use crate::world::{Form, Space, SpaceMark};

/// What space shows of a test.
pub(crate) fn space_of_pair(tried: &Tried<'_>) -> Space {
    let [first, second] = &tried.lies.bodies;
    let both = bounds(first).union(bounds(second));
    let mut drawing = Drawing { tried, bounds: both, marks: Vec::new(), shadows: Vec::new() };
    drawing.objects();
    drawing.step();
    drawing.marks.push(knob(first));
    // Shadows fall beside the two.
    let seen = drawing.shadows.into_iter().fold(both, Aabb::with_point);
    Space { marks: drawing.marks, bounds: seen.padded(both.extent().length() * 0.04), flat: false, notes: Vec::new() }
}

/// Where the first object is taken in the hand.
fn knob(first: &Body<'_>) -> SpaceMark {
    let role = if matches!(first, Body::Ray(_)) { Role::Ray } else { Role::Value };
    SpaceMark { form: Form::Point(first.middle()), role, place: None }
}

struct Drawing<'a> {
    tried: &'a Tried<'a>,
    bounds: Aabb,
    marks: Vec<SpaceMark>,
    /// The ends of the line on which shadows fall.
    shadows: Vec<Vec3>,
}

impl Drawing<'_> {
    fn add(&mut self, role: Role, form: Form) {
        self.marks.push(SpaceMark { form, role, place: None });
    }

    fn label(&mut self, role: Role, at: Vec3, text: String) {
        self.add(role, Form::Label { at, within: None, text });
    }

    /// The two, the second in the look of the answer once there is one.
    fn objects(&mut self) {
        let [first, second] = &self.tried.lies.bodies;
        let answer = self.tried.last().and_then(|trial| match trial.step {
            Some(Step::Probe(Probe::Met { hit: yes, .. } | Probe::Touch { touch: yes })) => Some(yes),
            _ => None,
        });
        let role = match answer {
            Some(true) => Role::Hit,
            Some(false) => Role::Missed,
            None => Role::Seen,
        };
        for form in forms(second) {
            self.add(role, form);
        }
        let own = if matches!(first, Body::Ray(_)) { Role::Ray } else { Role::Value };
        for form in forms(first) {
            self.add(own, form);
        }
        // The second one's name stands at what of it lies furthest from the first, whose name stands where it is taken.
        for (body, role, at) in [(second, role, furthest(second, first.middle())), (first, own, first.middle())] {
            let Some(kind) = body.kind() else { continue };
            self.label(role, at, kind.word().to_owned());
        }
    }

    /// What this step computes, where it lies.
    fn step(&mut self) {
        let Some(step) = self.tried.last().and_then(|trial| trial.step) else { return };
        let [first, second] = &self.tried.lies.bodies;
        match (step, first) {
            (Step::Slab(visit), Body::Ray(ray)) => self.slab(&visit, ray, second),
            (Step::Probe(probe), Body::Ray(ray)) => self.on_ray(&probe, ray, first, second),
            (Step::Probe(probe), _) => self.between(&probe, first, second),
            (Step::Slab(_), _) => {}
        }
    }

    /// A ring where the ray is at t, if that is near.
    fn ring(&mut self, role: Role, ray: &Ray, t: f32, text: String) {
        let at = ray.at(t);
        if at.is_finite() && self.bounds.padded(self.bounds.extent().length() * 0.5).contains(at) {
            self.add(role, Form::Point(at));
            self.label(role, at, text);
        }
    }

    /// The part of the ray from t to t, as far as it is drawn.
    fn live(&mut self, ray: &Ray, [near, far]: [f32; 2]) {
        let (near, far) = (near.max(0.0), far.min(bodies::SHOWN));
        if near < far {
            self.add(Role::Live, Form::Segment(ray.at(near), ray.at(far)));
        }
    }

    fn on_ray(&mut self, probe: &Probe, ray: &Ray, first: &Body<'_>, second: &Body<'_>) {
        let named = |name: &str, t: f32| format!("{name} = {}", number(t));
        match *probe {
            Probe::Cut { t, .. } => self.ring(Role::Tick, ray, t, named("t", t)),
            Probe::Quadratic { t1, t2, real: true, .. } => {
                self.ring(Role::Tick, ray, t1, named("t1", t1));
                self.ring(Role::Tick, ray, t2, named("t2", t2));
            }
            Probe::Narrow { t_near, t_far, empty, .. } => self.interval(ray, [t_near, t_far], empty),
            Probe::Met { t, hit: true } => self.ring(Role::Best, ray, t, named("t", t)),
            Probe::Areas { u, v, w, .. } => self.areas([u, v, w], second),
            Probe::Edge { edge, crossed, .. } => {
                self.rightwards(first, second);
                self.edge(edge, crossed, second);
            }
            Probe::Parity { .. } => self.rightwards(first, second),
            _ => {}
        }
    }

    /// From the point that lies in a polygon's plane to its right, with the edges crossed so far: their number decides.
    fn rightwards(&mut self, first: &Body<'_>, second: &Body<'_>) {
        let Body::Shape(Shape::Polygon(own)) = second else { return };
        let cut = self.tried.done.iter().rev().find_map(|trial| match trial.step {
            Some(Step::Probe(Probe::Cut { t, .. })) => Some(t),
            _ => None,
        });
        let point = match (first, cut) {
            (Body::Ray(ray), Some(t)) => ray.at(t),
            (Body::Ray(_), None) => return,
            _ => first.middle(),
        };
        // The polygon is flattened along the largest component of its normal; right is where the next coordinate grows.
        let normal = own.normal().as_vec3();
        let along = normal.abs().max_position();
        let (mut way, right) = (Vec3::ZERO, (along + 1) % 3);
        way[right] = 1.0;
        way[along] = -normal[right] / normal[along];
        let far = own.corners.iter().map(|corner| corner[right] - point[right]).fold(0.0, f32::max);
        self.add(Role::Tick, Form::Arrow(point, point + way * (far + 0.15 * self.bounds.extent().length())));
        self.add(Role::Tick, Form::Point(point));
        self.label(Role::Tick, point, "point".to_owned());
        for trial in self.tried.done {
            if let Some(Step::Probe(Probe::Edge { at, crossed: true, .. })) = trial.step {
                self.add(Role::Hit, Form::Point(point + way * at));
            }
        }
    }

    /// What is left of the ray.
    fn interval(&mut self, ray: &Ray, [near, far]: [f32; 2], empty: bool) {
        if !empty {
            self.live(ray, [near, far]);
        }
        self.ring(Role::Tick, ray, near, format!("near = {}", number(near)));
        self.ring(Role::Tick, ray, far, format!("far = {}", number(far)));
    }

    fn slab(&mut self, visit: &Visit, ray: &Ray, second: &Body<'_>) {
        let (Visit::Parallel { axis, .. }
        | Visit::Divide { axis, .. }
        | Visit::Order { axis, .. }
        | Visit::Narrow { axis, .. }) = *visit
        else {
            return;
        };
        let solid = match second {
            Body::Shape(Shape::Box(bounds)) => Obb::from_aabb(bounds),
            Body::Shape(Shape::Obb(solid)) => *solid,
            _ => return,
        };
        if let Some(axis) = axis_of(axis) {
            for way in [-1.0, 1.0] {
                self.add(Role::Plane, Form::Polygon(face(&solid, axis, way)));
            }
        }
        match *visit {
            Visit::Divide { t1, t2, .. } | Visit::Order { t1, t2, .. } => {
                self.ring(Role::Tick, ray, t1, format!("t1 = {}", number(t1)));
                self.ring(Role::Tick, ray, t2, format!("t2 = {}", number(t2)));
            }
            Visit::Narrow { t_near, t_far, empty, .. } => self.interval(ray, [t_near, t_far], empty),
            _ => {}
        }
    }

    /// Each edge of a triangle by the sign of the area that it makes.
    fn areas(&mut self, [u, v, w]: [f32; 3], second: &Body<'_>) {
        let Body::Shape(Shape::Triangle(own)) = second else { return };
        // The sign that most have is that of the inside.
        let more = [u, v, w].iter().filter(|area| **area >= 0.0).count() >= 2;
        for (name, area, [from, to]) in [("u", u, [own.b, own.c]), ("v", v, [own.c, own.a]), ("w", w, [own.a, own.b])] {
            let role = if (area >= 0.0) == more || area == 0.0 { Role::Here } else { Role::Wrong };
            self.add(role, Form::Segment(from, to));
            self.label(role, (from + to) * 0.5, format!("{name} = {}", number(area)));
        }
    }

    fn edge(&mut self, edge: u32, crossed: bool, second: &Body<'_>) {
        let Body::Shape(Shape::Polygon(own)) = second else { return };
        let Some([from, to]) = around(own.corners).nth(edge as usize) else { return };
        let role = if crossed { Role::Hit } else { Role::Here };
        self.add(role, Form::Segment(from, to));
        let says = if crossed { "crossed" } else { "not crossed" };
        self.label(role, (from + to) * 0.5, format!("edge {edge}: {says}"));
    }

    fn between(&mut self, probe: &Probe, first: &Body<'_>, second: &Body<'_>) {
        match *probe {
            Probe::Shadow { x, y, z, a_low, a_high, b_low, b_high, apart, .. } => {
                let from = match (first, second) {
                    // Their shadows are those of their own coordinates.
                    (Body::Shape(Shape::Box(_)), _) => Vec3::ZERO,
                    (Body::Shape(Shape::Obb(solid)), _) => solid.center,
                    _ => second.middle(),
                };
                self.shadows(from, Vec3::new(x, y, z), [a_low, a_high], [b_low, b_high], apart);
            }
            Probe::Nearest { .. } => self.nearest(first),
            Probe::Compare { of: Part::Radius, value, inside, .. } => {
                if let Body::Shape(Shape::Sphere(_)) = first {
                    self.nearest(first);
                }
                let role = if inside { Role::Hit } else { Role::Wrong };
                self.label(role, first.middle(), format!("distance² = {}", number(value)));
            }
            Probe::Compare { of, value, inside, .. } => {
                let role = if inside { Role::Hit } else { Role::Wrong };
                self.label(role, first.middle(), format!("{} = {}", of.word(), number(value)));
            }
            Probe::Areas { u, v, w, .. } => self.areas([u, v, w], second),
            Probe::Edge { edge, crossed, .. } => {
                self.rightwards(first, second);
                self.edge(edge, crossed, second);
            }
            Probe::Parity { .. } => self.rightwards(first, second),
            Probe::Side { of, distance, reach, .. } => self.side(of, [distance, reach], first, second),
            _ => {}
        }
    }

    /// The shadows of both on a direction, on a line beside them.
    fn shadows(&mut self, from: Vec3, along: Vec3, a: [f32; 2], b: [f32; 2], apart: bool) {
        let square = along.length_squared();
        if square == 0.0 || !square.is_finite() {
            return;
        }
        // Beside the two, so that they do not hide it.
        let beside = self.bounds.extent().length() * 0.34;
        let low = Vec3::NEG_Y.reject_from(along);
        let aside = if low.length() > STEEP { low } else { Vec3::NEG_X.reject_from(along) };
        let aside = aside.normalize_or_zero() * beside;
        let at = |value: f32| from + along * (value / square) + aside;
        let (low, high) = (a[0].min(b[0]), a[1].max(b[1]));
        let air = (high - low) * 0.15;
        self.shadows.extend([at(low - air), at(high + air)]);
        self.add(Role::Edge, Form::Segment(at(low - air), at(high + air)));
        let thin = aside * 0.05;
        for (role, [low, high], shift) in [(Role::Here, b, -thin), (Role::Live, a, thin)] {
            self.add(role, Form::Segment(at(low) + shift, at(high) + shift));
        }
        let gap = [a[1].min(b[1]), a[0].max(b[0])];
        if apart {
            self.add(Role::Wrong, Form::Segment(at(gap[0]), at(gap[1])));
            self.label(Role::Wrong, at((gap[0] + gap[1]) * 0.5), "a gap".to_owned());
        } else {
            self.label(Role::Edge, at(high + air), "shadows".to_owned());
        }
    }

    /// From the middle of a sphere to the nearest point of the box, as far as that is known.
    fn nearest(&mut self, first: &Body<'_>) {
        let center = first.middle();
        let mut point = center;
        for trial in self.tried.done {
            if let Some(Step::Probe(Probe::Nearest { of, nearest, .. })) = trial.step {
                match of {
                    Part::X => point.x = nearest,
                    Part::Y => point.y = nearest,
                    Part::Z => point.z = nearest,
                    _ => {}
                }
            }
        }
        self.add(Role::Here, Form::Segment(center, point));
        self.add(Role::Tick, Form::Point(point));
        self.label(Role::Tick, point, "nearest".to_owned());
    }

    /// The plane that is compared with, and how far the box reaches along its normal.
    fn side(&mut self, of: Part, [distance, reach]: [f32; 2], first: &Body<'_>, second: &Body<'_>) {
        let plane = match first {
            Body::Frustum(frustum) => {
                let index = [Part::Left, Part::Right, Part::Bottom, Part::Top, Part::Near, Part::Far];
                let Some(index) = index.iter().position(|side| *side == of) else { return };
                if let Some(corners) = bodies::side(frustum, index) {
                    self.add(Role::Plane, Form::Polygon(corners));
                }
                frustum.planes[index]
            }
            Body::Plane(plane) => *plane,
            _ => return,
        };
        let (middle, length) = (second.middle(), plane.normal.length().max(f32::MIN_POSITIVE));
        let way = plane.normal / length;
        let (distance, reach) = (distance / length, reach / length);
        self.add(Role::Here, Form::Segment(middle - way * reach, middle + way * reach));
        self.add(Role::Tick, Form::Segment(middle, middle - way * distance));
        self.label(Role::Here, middle + way * reach, format!("reach {}", number(reach)));
        self.label(Role::Tick, middle - way * distance, format!("distance {}", number(distance)));
    }
}

/// What of a body lies furthest from a point, of its corners or of its rim.
fn furthest(body: &Body<'_>, from: Vec3) -> Vec3 {
    let corners = forms(body).into_iter().flat_map(|form| match form {
        Form::Body(edges) => edges.into_iter().flatten().collect(),
        Form::Polygon(corners) => corners,
        Form::Segment(from, to) => vec![from, to],
        Form::Sphere(sphere) => vec![sphere.center + (sphere.center - from).normalize_or(Vec3::Y) * sphere.radius],
        _ => Vec::new(),
    });
    let far = |a: &Vec3, b: &Vec3| a.distance_squared(from).total_cmp(&b.distance_squared(from));
    corners.max_by(far).unwrap_or_else(|| body.middle())
}

/// The axis of a box that a slab stands across.
fn axis_of(axis: Direction) -> Option<Axis> {
    match axis {
        Direction::Along(axis) | Direction::Own(axis) => Some(axis),
        _ => None,
    }
}

/// A direction that leaves less than this of the way down is too steep for a line below the two.
const STEEP: f32 = 0.35;

/// How much larger than a box the planes of its slabs are drawn.
const LARGER: f32 = 1.25;

/// A face of a box across an axis, a little larger than it is.
fn face(solid: &Obb, axis: Axis, way: f32) -> Vec<Vec3> {
    let side = |index: usize| solid.axes[index] * solid.half[[Axis::X, Axis::Y, Axis::Z][index]];
    let index = axis.index();
    let (u, v) = (side((index + 1) % 3) * LARGER, side((index + 2) % 3) * LARGER);
    let middle = solid.center + side(index) * way;
    vec![middle + u + v, middle + u - v, middle - u - v, middle - u + v]
}
