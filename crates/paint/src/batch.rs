//! A step's marks as the faces, lines and points that the GPU draws.

use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use raystep_accel::{Aabb, Axis, Primitives, Shape};
use raystep_figure::{Camera, Color, Form, Style};

use crate::Frame;
use crate::solid::{outline, triangles};

/// A corner of a translucent triangle; the layout in `face.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Pod, Zeroable)]
pub(crate) struct FaceCorner {
    position: [f32; 3],
    fill: [u8; 4],
    /// The colour of the hatching; nothing where transparent.
    hatch: [u8; 4],
}

/// A line or an arrow head, widths and lengths in pixels; the layout in `line.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Pod, Zeroable)]
pub(crate) struct Line {
    from: [f32; 3],
    to: [f32; 3],
    /// At its beginning and at its end; a head tapers.
    width: [f32; 2],
    /// Lengths of line and gap; no gap, no dashes.
    dash: [f32; 2],
    /// How much of its end to keep (all where 0), and how much of it to cut off.
    end: [f32; 2],
    color: [u8; 4],
}

/// A ring around a point, in pixels; the layout in `point.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Pod, Zeroable)]
pub(crate) struct Point {
    center: [f32; 3],
    /// Radius, and width of the ring.
    size: [f32; 2],
    ring: [u8; 4],
    fill: [u8; 4],
}

/// Everything that one step draws over its scene.
#[derive(PartialEq)]
pub(crate) struct Batch {
    /// Three to a triangle, the farthest first.
    pub(crate) faces: Vec<FaceCorner>,
    pub(crate) lines: Vec<Line>,
    pub(crate) points: Vec<Point>,
}

impl Batch {
    pub(crate) fn new(frame: &Frame<'_>) -> Batch {
        let pixels = frame.pixels_per_point;
        let mut pen = Pen { frame, pixels, triangles: Vec::new(), lines: Vec::new(), points: Vec::new() };
        for mark in &frame.space.marks {
            let style = frame.theme.style(mark.role);
            match &mark.form {
                Form::Box(bounds) | Form::Sheet(bounds) => pen.bounds(bounds, &style),
                Form::Segment(from, to) => pen.line(*from, *to, &style, 0.0),
                Form::Arrow(from, to) => pen.arrow(*from, *to, &style),
                Form::Point(at) => pen.point(*at, &style),
                Form::Prim(prim) if prim.index() < frame.prims.len() => pen.prim(&frame.prims.shape(*prim), &style),
                // Text is the caller's.
                Form::Prim(_) | Form::Label { .. } => {}
            }
        }
        // Translucent faces lie over those behind them.
        pen.triangles.sort_by(|a, b| b.0.total_cmp(&a.0));
        let faces = pen.triangles.iter().flat_map(|(_, corners)| corners).copied().collect();
        Batch { faces, lines: pen.lines, points: pen.points }
    }
}

/// Turns marks into what a batch holds.
struct Pen<'a> {
    frame: &'a Frame<'a>,
    /// In a point of the theme's widths.
    pixels: f32,
    /// With their distances, not yet sorted.
    triangles: Vec<(f32, [FaceCorner; 3])>,
    lines: Vec<Line>,
    points: Vec<Point>,
}

impl Pen<'_> {
    fn line(&mut self, from: Vec3, to: Vec3, style: &Style, cut_off: f32) {
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
    fn arrow(&mut self, from: Vec3, to: Vec3, style: &Style) {
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

    fn point(&mut self, at: Vec3, style: &Style) {
        let (width, ring) = style.stroke.map_or((0.0, [0; 4]), |stroke| (stroke.width, bytes(stroke.color)));
        self.points.push(Point {
            center: at.to_array(),
            size: [(4.5 + 0.5 * width) * self.pixels, width * self.pixels],
            ring,
            fill: style.fill.map_or(ring, bytes),
        });
    }

    fn prim(&mut self, shape: &Shape<'_>, style: &Style) {
        for triangle in triangles(shape) {
            self.face(triangle, style);
        }
        for [from, to] in outline(shape) {
            self.line(from, to, style, 0.0);
        }
    }

    /// Six faces and twelve edges, or what remains of them where a side has no length.
    fn bounds(&mut self, bounds: &Aabb, style: &Style) {
        if bounds.is_empty() {
            return;
        }
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

    fn quad(&mut self, [a, b, c, d]: [Vec3; 4], style: &Style) {
        let depth = self.depth((a + c) * 0.5);
        self.face_at(depth, [a, b, c], style);
        self.face_at(depth, [a, c, d], style);
    }

    fn face(&mut self, triangle: [Vec3; 3], style: &Style) {
        let [a, b, c] = triangle;
        self.face_at(self.depth((a + b + c) / 3.0), triangle, style);
    }

    fn face_at(&mut self, depth: f32, triangle: [Vec3; 3], style: &Style) {
        let hatch = style.stroke.filter(|_| style.hatch).map_or([0; 4], |stroke| bytes(stroke.color));
        let fill = style.fill.map_or([0; 4], bytes);
        if fill[3] > 0 || hatch[3] > 0 {
            let corner = |p: Vec3| FaceCorner { position: p.to_array(), fill, hatch };
            self.triangles.push((depth, triangle.map(corner)));
        }
    }

    /// How far away, in some increasing measure.
    fn depth(&self, p: Vec3) -> f32 {
        match *self.frame.camera {
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
