//! Flat scenes: shapes of the plane from TOML, standing in a thin slab around z = 0.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

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

/// Bytes of a file.
const MOST_BYTES: usize = 1 << 20;
/// Shapes of a scene: each is drawn by itself.
const MOST_SHAPES: usize = 10_000;
/// Corners of an outline: each is a wall that a ray is tested against.
const MOST_CORNERS: usize = 1000;

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
    disc: Option<Corner>,
    radius: Option<f32>,
    segment: Option<Vec<Corner>>,
    triangle: Option<Vec<Corner>>,
    polygon: Option<Vec<Corner>>,
    r#box: Option<Vec<Corner>>,
}

/// A point of the plane, `[x, y]`.
#[derive(Clone, Copy, Deserialize)]
#[serde(try_from = "Vec<f32>")]
struct Corner(Vec2);

impl TryFrom<Vec<f32>> for Corner {
    type Error = String;

    fn try_from(numbers: Vec<f32>) -> Result<Corner, String> {
        let &[x, y] = &numbers[..] else {
            return Err(format!("a point of the plane is [x, y]; found {} numbers", numbers.len()));
        };
        place(x, y).map(Corner)
    }
}

/// A point where a shape may lie.
pub(crate) fn place(x: f32, y: f32) -> Result<Vec2, String> {
    if x.abs() <= FURTHEST && y.abs() <= FURTHEST {
        Ok(Vec2::new(x, y))
    } else {
        Err(format!("[{x}, {y}]: coordinates are numbers from -{FURTHEST} to {FURTHEST}"))
    }
}

/// Reads a flat scene; `file` names it in errors.
pub(crate) fn parse(text: &str, file: &str) -> Result<Flat, SceneError> {
    if text.len() > MOST_BYTES {
        let message =
            format!("the file has {} KB: a scene has at most {} KB", text.len().div_ceil(1024), MOST_BYTES >> 10);
        return Err(SceneError::at_byte(file, text, 0, message));
    }
    let read: Text = toml::from_str(text).map_err(|wrong| {
        let byte = wrong.span().map_or(0, |span| span.start);
        SceneError::at_byte(file, text, byte, advise(wrong.message()))
    })?;
    if read.shapes.is_empty() {
        let byte = text.find("shapes").unwrap_or(0);
        return Err(SceneError::at_byte(file, text, byte, "`shapes` is empty; a scene needs at least one shape"));
    }
    if let Some(item) = read.shapes.get(MOST_SHAPES) {
        let message = format!("here are {} shapes: a scene has at most {MOST_SHAPES}", read.shapes.len());
        return Err(SceneError::at_byte(file, text, item.span().start, message));
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
        if self.radius.is_some() && self.disc.is_none() {
            return Err("a radius belongs to a disc: { disc = [x, y], radius = r }".to_owned());
        }
        match (self.disc, &self.segment, &self.triangle, &self.polygon, &self.r#box) {
            (Some(Corner(center)), None, None, None, None) => disc(center, self.radius),
            (None, Some(ends), None, None, None) => segment(exactly("segment", ends)?),
            (None, None, Some(corners), None, None) => outline(&exactly::<3>("triangle", corners)?),
            (None, None, None, Some(corners), None) => {
                outline(&corners.iter().map(|corner| corner.0).collect::<Vec<Vec2>>())
            }
            (None, None, None, None, Some(corners)) => rectangle(exactly("box", corners)?),
            _ => Err("a shape is exactly one of disc, segment, triangle, polygon, box".to_owned()),
        }
    }
}

fn exactly<const N: usize>(kind: &str, corners: &[Corner]) -> Result<[Vec2; N], String> {
    let corners: &[Corner; N] =
        corners.try_into().map_err(|_| format!("a {kind} is {N} points [x, y]; found {}", corners.len()))?;
    Ok(corners.map(|corner| corner.0))
}

pub(crate) fn disc(center: Vec2, radius: Option<f32>) -> Result<Shape<'static>, String> {
    let radius = radius.ok_or("a disc needs a radius: { disc = [x, y], radius = r }")?;
    if radius > 0.0 && radius <= FURTHEST {
        Ok(Shape::Sphere(Sphere { center: center.extend(0.0), radius }))
    } else {
        Err(format!("radius {radius}: a disc's radius is a number above 0, at most {FURTHEST}"))
    }
}

pub(crate) fn segment([from, to]: [Vec2; 2]) -> Result<Shape<'static>, String> {
    if from == to {
        return Err("the two ends of a segment differ".to_owned());
    }
    Ok(Shape::Wall(Wall { from, to, z: SLAB }))
}

fn rectangle([low, high]: [Vec2; 2]) -> Result<Shape<'static>, String> {
    if !low.cmplt(high).all() {
        return Err("a box is [[x_min, y_min], [x_max, y_max]], each minimum below its maximum".to_owned());
    }
    outline(&[low, Vec2::new(high.x, low.y), high, Vec2::new(low.x, high.y)])
}

/// A closed polygon of at least three corners, none of which repeats its neighbour.
pub(crate) fn outline(corners: &[Vec2]) -> Result<Shape<'static>, String> {
    if corners.len() < 3 {
        return Err(format!("a polygon has at least 3 corners; found {}", corners.len()));
    }
    if corners.len() > MOST_CORNERS {
        return Err(format!("a polygon has at most {MOST_CORNERS} corners; found {}", corners.len()));
    }
    if (0..corners.len()).any(|i| corners[i] == corners[(i + 1) % corners.len()]) {
        return Err("neighbouring corners differ; the outline closes by itself".to_owned());
    }
    Ok(Shape::Prism(Prism { outline: kept(corners), z: SLAB }))
}

/// The outline, living as long as the program so that shapes stay `Copy`: a few bytes each, and the same ones
/// however often a scene is read.
fn kept(corners: &[Vec2]) -> &'static [Vec2] {
    static KEPT: Mutex<BTreeMap<Vec<[u32; 2]>, &'static [Vec2]>> = Mutex::new(BTreeMap::new());
    let bits = corners.iter().map(|corner| corner.to_array().map(f32::to_bits)).collect();
    let mut kept = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    kept.entry(bits).or_insert_with(|| corners.to_vec().leak())
}
