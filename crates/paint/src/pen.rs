//! Marks turned into triangles, lines and rings.

use glam::Vec3;
use raystep_accel::{Aabb, Axis, Shape, Sphere};
use raystep_figure::{Camera, Color, Dash, Stroke, Style, circles, contour, lines};

use crate::Frame;
use crate::solid::{outline, triangles};
use crate::vertex::{FaceCorner, Line, Point};

/// A form smaller than so many points gets no hatching, and finer lines.
const SMALL: f32 = 20.0;

/// A part of a curve longer than so many points is not cut into dashes.
const FAR: f32 = 4096.0;

/// A translucent triangle before it is sorted.
pub(crate) struct Triangle {
    /// From the eye, in some increasing measure.
    pub(crate) distance: f32,
    /// Whether it shows through the scene.
    pub(crate) buried: bool,
    pub(crate) corners: [FaceCorner; 3],
}

/// Turns marks into what a batch holds.
pub(crate) struct Pen<'a> {
    camera: &'a Camera,
    /// In a point of the theme's widths.
    pixels: f32,
    /// Points of the page for a length of one at distance one; without perspective, at any distance.
    scale: f32,
    pub(crate) triangles: Vec<Triangle>,
    pub(crate) lines: Vec<Line>,
    pub(crate) points: Vec<Point>,
}

impl Pen<'_> {
    pub(crate) fn new<'a>(frame: &Frame<'a>) -> Pen<'a> {
        let half_page = frame.size[1] as f32 * 0.5 / frame.pixels_per_point;
        let scale = match *frame.camera {
            Camera::Flat { half_height, .. } => half_page / half_height,
            Camera::Solid { fov_degrees, .. } => half_page / (fov_degrees.to_radians() * 0.5).tan(),
        };
        Pen {
            camera: frame.camera,
            pixels: frame.pixels_per_point,
            scale,
            triangles: Vec::new(),
            lines: Vec::new(),
            points: Vec::new(),
        }
    }

    pub(crate) fn line(&mut self, from: Vec3, to: Vec3, style: &Style, cut_off: f32) {
        let Some(stroke) = style.stroke else { return };
        let dash = match stroke.dash.pattern(stroke.width) {
            [line, gap, ..] => [line * self.pixels, gap * self.pixels],
            _ => [0.0; 2],
        };
        let width = stroke.width * self.pixels;
        self.lines.push(Line {
            from: from.to_array(),
            to: to.to_array(),
            width: [width; 2],
            dash,
            end: [0.0, cut_off],
            color: bytes(stroke.color),
        });
    }

    /// A line up to the middle of its head, and the head.
    pub(crate) fn arrow(&mut self, from: Vec3, to: Vec3, style: &Style) {
        let Some(stroke) = style.stroke else { return };
        let length = (8.0 + 2.5 * stroke.width) * self.pixels;
        self.line(from, to, style, length * 0.5);
        self.lines.push(Line {
            from: from.to_array(),
            to: to.to_array(),
            width: [length * 0.8, 0.0],
            dash: [0.0; 2],
            end: [length, 0.0],
            color: bytes(stroke.color),
        });
    }

    pub(crate) fn point(&mut self, at: Vec3, style: &Style) {
        let (width, ring) = style.stroke.map_or((0.0, [0; 4]), |stroke| (stroke.width, bytes(stroke.color)));
        self.points.push(Point {
            center: at.to_array(),
            size: [(4.5 + 0.5 * width) * self.pixels, width * self.pixels],
            ring,
            fill: style.fill.map_or(ring, bytes),
        });
    }

    pub(crate) fn prim(&mut self, shape: &Shape<'_>, style: &Style) {
        // What was hit shows through the scene, what was missed would only veil it.
        let buried = !style.hatch;
        let style = self.fine(&shape.bounds(), style);
        for triangle in triangles(shape) {
            let [a, b, c] = triangle;
            self.face(self.distance((a + b + c) / 3.0), buried, triangle, &style);
        }
        for [from, to] in outline(shape) {
            self.line(from, to, &style, 0.0);
        }
    }

    /// The style for a form of this size on the page: a small one is not drowned in its own ink.
    fn fine(&self, bounds: &Aabb, style: &Style) -> Style {
        let size = bounds.extent().max_element() * self.scale_at(bounds.center());
        // Not a number only where the eye is inside: large.
        let part = (size / SMALL).clamp(0.25, 1.0);
        if part.is_nan() || part == 1.0 {
            return *style;
        }
        let thin = |stroke: Stroke| Stroke { width: (stroke.width * part).max(0.5).min(stroke.width), ..stroke };
        // A tint as dark as the hatching it stands for.
        let tint = style.stroke.filter(|_| style.hatch).map(|stroke| Color { a: 90, ..stroke.color });
        Style { stroke: style.stroke.map(thin), fill: tint.or(style.fill), hatch: false, ..*style }
    }

    /// Six faces and twelve edges, or what remains of them where a side has no length.
    pub(crate) fn bounds(&mut self, bounds: &Aabb, style: &Style) {
        if bounds.is_empty() {
            return;
        }
        let style = &self.fine(bounds, style);
        // Two faces of a box lie over each other.
        let fill = style.fill.map(|fill| Color { a: fill.a / 2, ..fill });
        let veil = Style { fill: fill.filter(|_| bounds.extent().min_element() > 0.0).or(style.fill), ..*style };
        let e = bounds.extent();
        for axis in Axis::ALL {
            let (u, v) = others(axis);
            if e[u] <= 0.0 || e[v] <= 0.0 {
                continue;
            }
            let ends = if e[axis] > 0.0 { &[bounds.min[axis], bounds.max[axis]][..] } else { &[bounds.min[axis]][..] };
            for &at in ends {
                let corner = |on_u: f32, on_v: f32| {
                    let mut p = bounds.min;
                    p[axis] = at;
                    p[u] += e[u] * on_u;
                    p[v] += e[v] * on_v;
                    p
                };
                self.quad([corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)], &veil);
            }
        }
        self.edges(bounds, style);
    }

    fn edges(&mut self, bounds: &Aabb, style: &Style) {
        let (low, high) = (bounds.min, bounds.max);
        for axis in Axis::ALL.into_iter().filter(|&axis| low[axis] < high[axis]) {
            let (u, v) = others(axis);
            let us = if low[u] < high[u] { &[low[u], high[u]][..] } else { &[low[u]][..] };
            let vs = if low[v] < high[v] { &[low[v], high[v]][..] } else { &[low[v]][..] };
            for (&at_u, &at_v) in us.iter().flat_map(|at_u| vs.iter().map(move |at_v| (at_u, at_v))) {
                let (mut from, mut to) = (low, high);
                (from[u], to[u]) = (at_u, at_u);
                (from[v], to[v]) = (at_v, at_v);
                self.line(from, to, style, 0.0);
            }
        }
    }

    /// A circle on a page; in space, what the eye sees as its outline, and two circles around it in a style of theirs.
    pub(crate) fn sphere(&mut self, sphere: &Sphere, style: &Style, around: &Style) {
        let circles = circles(sphere);
        match *self.camera {
            Camera::Flat { .. } => {
                let distance = self.distance(sphere.center);
                for pair in circles[0].windows(2) {
                    self.face(distance, false, [sphere.center, pair[0], pair[1]], style);
                }
                self.curve(&circles[0], style);
            }
            Camera::Solid { eye, .. } => {
                for circle in &circles {
                    self.curve(circle, around);
                }
                if let Some(contour) = contour(sphere, eye) {
                    self.curve(&contour, style);
                }
            }
        }
    }

    /// A body: what the eye sees as its outline, and its other edges in a style of theirs.
    pub(crate) fn body(&mut self, edges: &[[Vec3; 2]], style: &Style, around: &Style) {
        let eye = match *self.camera {
            Camera::Flat { center, .. } => center.extend(0.0),
            Camera::Solid { eye, .. } => eye,
        };
        let (rim, faint) = lines(edges, eye);
        for [from, to] in faint {
            self.line(from, to, around, 0.0);
        }
        for path in rim {
            self.curve(&path, style);
        }
    }

    /// A line around many corners, whose dashes run on from one to the next.
    fn curve(&mut self, corners: &[Vec3], style: &Style) {
        let Some(stroke) = style.stroke else { return };
        let solid = Style { stroke: Some(Stroke { dash: Dash::Solid, ..stroke }), ..*style };
        let &[dash, gap, ..] = stroke.dash.pattern(stroke.width) else {
            for pair in corners.windows(2) {
                self.line(pair[0], pair[1], &solid, 0.0);
            }
            return;
        };
        // How much of the current dash and gap is drawn, in points.
        let mut done = 0.0;
        for pair in corners.windows(2) {
            let (from, to) = (pair[0], pair[1]);
            let length = (to - from).length() * self.scale_at((from + to) * 0.5);
            if length > FAR {
                self.line(from, to, &solid, 0.0);
                continue;
            }
            let mut at = 0.0;
            while at < length {
                let end = if done < dash { dash } else { dash + gap };
                let step = (end - done).min(length - at);
                if done < dash {
                    self.line(from.lerp(to, at / length), from.lerp(to, (at + step) / length), &solid, 0.0);
                }
                // Too small a step would never end.
                at += step.max(0.01);
                done = if done + step >= dash + gap - 0.01 { 0.0 } else { done + step.max(0.01) };
            }
        }
    }

    /// How many points of the page a length of one has at a point.
    fn scale_at(&self, at: Vec3) -> f32 {
        match *self.camera {
            Camera::Flat { .. } => self.scale,
            Camera::Solid { eye, .. } => self.scale / (at - eye).length(),
        }
    }

    /// A flat convex polygon.
    pub(crate) fn polygon(&mut self, corners: &[Vec3], style: &Style) {
        let distance = self.distance(corners.iter().copied().sum::<Vec3>() / corners.len() as f32);
        for pair in corners.windows(2).skip(1) {
            self.face(distance, false, [corners[0], pair[0], pair[1]], style);
        }
        for (&from, &to) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            self.line(from, to, style, 0.0);
        }
    }

    fn quad(&mut self, [a, b, c, d]: [Vec3; 4], style: &Style) {
        let distance = self.distance((a + c) * 0.5);
        self.face(distance, false, [a, b, c], style);
        self.face(distance, false, [a, c, d], style);
    }

    fn face(&mut self, distance: f32, buried: bool, triangle: [Vec3; 3], style: &Style) {
        let hatch = style.stroke.filter(|_| style.hatch).map_or([0; 4], |stroke| bytes(stroke.color));
        let fill = style.fill.map_or([0; 4], bytes);
        if fill[3] > 0 || hatch[3] > 0 {
            let corner = |p: Vec3| FaceCorner { position: p.to_array(), fill, hatch };
            self.triangles.push(Triangle { distance, buried, corners: triangle.map(corner) });
        }
    }

    /// How far away, in some increasing measure.
    fn distance(&self, p: Vec3) -> f32 {
        match *self.camera {
            Camera::Flat { .. } => -p.z,
            Camera::Solid { eye, .. } => (p - eye).length_squared(),
        }
    }
}

fn others(axis: Axis) -> (Axis, Axis) {
    match axis {
        Axis::X => (Axis::Y, Axis::Z),
        Axis::Y => (Axis::Z, Axis::X),
        Axis::Z => (Axis::X, Axis::Y),
    }
}

fn bytes(color: Color) -> [u8; 4] {
    [color.r, color.g, color.b, color.a]
}
