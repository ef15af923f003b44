//! A step's marks as the faces, lines and points that the GPU draws.

use raystep_accel::Primitives;
use raystep_figure::{Form, Role};

use crate::Frame;
use crate::pen::Pen;
use crate::vertex::{FaceCorner, Line, Point};

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
