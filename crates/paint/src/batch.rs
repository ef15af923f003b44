//! A step's marks as the faces, lines and points that the GPU draws.

use bytemuck::{Pod, Zeroable};
use raystep_accel::Primitives;
use raystep_figure::{Form, Role};

use crate::Frame;
use crate::pen::Pen;

/// A corner of a translucent triangle; the layout in `face.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Pod, Zeroable)]
pub(crate) struct FaceCorner {
    pub(crate) position: [f32; 3],
    pub(crate) fill: [u8; 4],
    /// The colour of the hatching; nothing where transparent.
    pub(crate) hatch: [u8; 4],
}

/// A line or an arrow head, widths and lengths in pixels; the layout in `line.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Pod, Zeroable)]
pub(crate) struct Line {
    pub(crate) from: [f32; 3],
    pub(crate) to: [f32; 3],
    /// At its beginning and at its end; a head tapers.
    pub(crate) width: [f32; 2],
    /// Lengths of line and gap; no gap, no dashes.
    pub(crate) dash: [f32; 2],
    /// How much of its end to keep (all where 0), and how much of it to cut off.
    pub(crate) end: [f32; 2],
    pub(crate) color: [u8; 4],
}

/// A ring around a point, in pixels; the layout in `point.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Pod, Zeroable)]
pub(crate) struct Point {
    pub(crate) center: [f32; 3],
    /// Radius, and width of the ring.
    pub(crate) size: [f32; 2],
    pub(crate) ring: [u8; 4],
    pub(crate) fill: [u8; 4],
}

/// Everything that one step draws over its scene.
#[derive(PartialEq)]
pub(crate) struct Batch {
    /// Three to a triangle, the farthest first.
    pub(crate) faces: Vec<FaceCorner>,
    /// Those that show through the scene.
    pub(crate) buried: Vec<FaceCorner>,
    pub(crate) lines: Vec<Line>,
    pub(crate) points: Vec<Point>,
}

impl Batch {
    pub(crate) fn new(frame: &Frame<'_>) -> Batch {
        let mut pen = Pen::new(frame);
        for mark in &frame.space.marks {
            let style = frame.theme.style(mark.role);
            match &mark.form {
                Form::Box(bounds) | Form::Sheet(bounds) => pen.bounds(bounds, &style),
                Form::Sphere(sphere) => pen.sphere(sphere, &style, &frame.theme.style(Role::Hidden)),
                Form::Body(edges) => pen.body(edges, &style, &frame.theme.style(Role::Hidden)),
                Form::Polygon(corners) => pen.polygon(corners, &style),
                Form::Segment(from, to) => pen.line(*from, *to, &style, 0.0),
                Form::Arrow(from, to) => pen.arrow(*from, *to, &style),
                Form::Point(at) => pen.point(*at, &style),
                Form::Prim(prim) if prim.index() < frame.prims.len() => pen.prim(&frame.prims.shape(*prim), &style),
                // Text and the axes of flat scenes are the caller's.
                Form::Prim(_) | Form::Label { .. } | Form::Number { .. } | Form::Axes(_) => {}
            }
        }
        // Translucent faces lie over those behind them.
        pen.triangles.sort_by(|a, b| b.distance.total_cmp(&a.distance));
        let corners = |only_buried: bool| {
            let triangles = pen.triangles.iter().filter(|triangle| triangle.buried || !only_buried);
            triangles.flat_map(|triangle| triangle.corners).collect()
        };
        Batch { faces: corners(false), buried: corners(true), lines: pen.lines, points: pen.points }
    }
}
