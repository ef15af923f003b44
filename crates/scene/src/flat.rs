//! Flat scenes: shapes of the plane from TOML, standing in a thin slab around z = 0.

use glam::Vec2;
use raystep_accel::{Prism, Shape, Sphere, Wall};
use serde::Deserialize;
use toml::Spanned;

use crate::SceneError;
use crate::error::nearest;

/// Foot and head of everything upright: the thin slab in which a flat scene lives.
const SLAB: [f32; 2] = [-0.25, 0.25];

/// Coordinates further out would overflow when multiplied.
const FURTHEST: f32 = 1e6;

/// What a file says.
pub(crate) struct Flat {
    pub(crate) title: String,
    pub(crate) note: String,
    pub(crate) shapes: Vec<Shape<'static>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Text {
    title: String,
    #[serde(default)]
    note: String,
    shapes: Vec<Spanned<Item>>,
}

/// One entry of `shapes`: exactly one of the kinds.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Item {
    disc: Option<Vec2Text>,
    radius: Option<f32>,
    segment: Option<[Vec2Text; 2]>,
    triangle: Option<[Vec2Text; 3]>,
    polygon: Option<Vec<Vec2Text>>,
    r#box: Option<[Vec2Text; 2]>,
}

type Vec2Text = [f32; 2];

/// Reads a flat scene; `file` names it in errors.
pub(crate) fn parse(text: &str, file: &str) -> Result<Flat, SceneError> {
    let read: Text = toml::from_str(text).map_err(|wrong| {
        let byte = wrong.span().map_or(0, |span| span.start);
        SceneError::at_byte(file, text, byte, advise(wrong.message()))
    })?;
    if read.shapes.is_empty() {
        let byte = text.find("shapes").unwrap_or(0);
        return Err(SceneError::at_byte(file, text, byte, "`shapes` is empty; a scene needs at least one shape"));
    }
    let mut shapes = Vec::new();
    for item in &read.shapes {
        let shape = item.get_ref().shape();
        shapes.push(shape.map_err(|message| SceneError::at_byte(file, text, item.span().start, message))?);
    }
    Ok(Flat { title: read.title, note: read.note, shapes })
}

/// Adds the nearest allowed key to what toml says of an unknown one.
fn advise(message: &str) -> String {
    let mut quoted = message.split('`').skip(1).step_by(2);
    if message.starts_with("unknown field")
        && let Some(found) = quoted.next()
        && let Some(near) = nearest(found, quoted)
    {
        return format!("{message}; did you mean `{near}`?");
    }
    message.to_owned()
}

impl Item {
    fn shape(&self) -> Result<Shape<'static>, String> {
        let kinds = [
            ("disc", self.disc.is_some()),
            ("segment", self.segment.is_some()),
            ("triangle", self.triangle.is_some()),
            ("polygon", self.polygon.is_some()),
            ("box", self.r#box.is_some()),
        ];
        let found: Vec<&str> = kinds.iter().filter(|kind| kind.1).map(|kind| kind.0).collect();
        if found.len() != 1 {
            let found = if found.is_empty() { "none".to_owned() } else { found.join(" and ") };
            return Err(format!("a shape is one of disc, segment, triangle, polygon, box; found {found}"));
        }
        if self.radius.is_some() && self.disc.is_none() {
            return Err("only a disc has a radius".to_owned());
        }
        if let Some(center) = self.disc {
            let radius = self.radius.ok_or("a disc needs a radius: { disc = [x, y], radius = r }")?;
            if !(radius > 0.0 && radius <= FURTHEST) {
                return Err(format!("radius {radius}: a disc's radius is a number above 0, at most {FURTHEST}"));
            }
            return Ok(Shape::Sphere(Sphere { center: point(center)?.extend(0.0), radius }));
        }
        if let Some([from, to]) = self.segment {
            let (from, to) = (point(from)?, point(to)?);
            if from == to {
                return Err("the two ends of a segment differ".to_owned());
            }
            return Ok(Shape::Wall(Wall { from, to, z: SLAB }));
        }
        if let Some([low, high]) = self.r#box {
            let (low, high) = (point(low)?, point(high)?);
            if !low.cmplt(high).all() {
                return Err("a box is [[x_min, y_min], [x_max, y_max]], each minimum below its maximum".to_owned());
            }
            return Ok(prism(vec![low, Vec2::new(high.x, low.y), high, Vec2::new(low.x, high.y)]));
        }
        let corners = self.triangle.as_ref().map(|corners| &corners[..]).or(self.polygon.as_deref()).unwrap_or(&[]);
        outline(corners)
    }
}

/// A closed polygon of at least three corners, none of which repeats its neighbour.
fn outline(corners: &[Vec2Text]) -> Result<Shape<'static>, String> {
    let corners = corners.iter().copied().map(point).collect::<Result<Vec<Vec2>, String>>()?;
    if corners.len() < 3 {
        return Err(format!("a polygon has at least 3 corners; found {}", corners.len()));
    }
    if (0..corners.len()).any(|i| corners[i] == corners[(i + 1) % corners.len()]) {
        return Err("neighbouring corners differ; the outline closes by itself".to_owned());
    }
    Ok(prism(corners))
}

/// An outline lives as long as the program, a few bytes each, so that shapes stay `Copy`.
fn prism(outline: Vec<Vec2>) -> Shape<'static> {
    Shape::Prism(Prism { outline: outline.leak(), z: SLAB })
}

fn point(p: Vec2Text) -> Result<Vec2, String> {
    let p = Vec2::from(p);
    if p.abs().max_element() <= FURTHEST && p.is_finite() {
        Ok(p)
    } else {
        Err(format!("[{}, {}]: coordinates are numbers from -{FURTHEST} to {FURTHEST}", p.x, p.y))
    }
}
