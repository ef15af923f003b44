//! The cells of a BSP tree, and the planes that cut them: polygons in a flat scene, bodies in a solid one.

use glam::Vec3;
use raystep_accel::{ConvexCell, FreePlane};

use super::space::Form;

/// How long a normal is drawn, in diagonals of its cell.
const ARROW: f32 = 0.12;

/// What a cell looks like: its floor in a flat scene, its edges in a solid one.
pub(crate) fn cell(cell: &ConvexCell, flat: bool) -> Vec<Form> {
    if flat {
        let floor = cell.faces().next().map(|corners| corners.into_iter().map(|corner| corner.with_z(0.0)).collect());
        return floor.map(Form::Polygon).into_iter().collect();
    }
    let mut edges = Vec::new();
    for corners in cell.faces() {
        let next = corners.iter().cycle().skip(1);
        // Every edge belongs to two faces, which pass it in opposite directions.
        let once = corners.iter().zip(next).filter(|(from, to)| from.to_array() < to.to_array());
        edges.extend(once.map(|(&from, &to)| Form::Segment(from, to)));
    }
    edges
}

/// What of a plane lies in a cell: a line in a flat scene, a polygon in a solid one.
pub(crate) fn sheet(cell: &ConvexCell, plane: FreePlane, flat: bool) -> Option<Form> {
    let corners = cell.section(plane);
    if !flat {
        return (corners.len() > 2).then_some(Form::Polygon(corners));
    }
    let along = Vec3::Z.cross(plane.normal);
    let place = |p: &&Vec3| along.dot(**p);
    let first = corners.iter().min_by(|a, b| place(a).total_cmp(&place(b)))?;
    let last = corners.iter().max_by(|a, b| place(a).total_cmp(&place(b)))?;
    Some(Form::Segment(first.with_z(0.0), last.with_z(0.0)))
}

/// The normal of a plane, an arrow out of the middle of what of the plane lies in a cell.
pub(crate) fn normal(cell: &ConvexCell, plane: FreePlane, flat: bool) -> Option<Form> {
    let corners = cell.section(plane);
    if corners.is_empty() {
        return None;
    }
    let middle = corners.iter().sum::<Vec3>() / corners.len() as f32;
    let middle = if flat { middle.with_z(0.0) } else { middle };
    let length = ARROW * cell.bounds().extent().length();
    Some(Form::Arrow(middle, middle + length * plane.normal.normalize()))
}
