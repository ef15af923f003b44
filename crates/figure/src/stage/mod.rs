//! A space as a camera sees it: a figure.

mod axes;
mod beside;
mod camera;
mod controls;
mod crop;
mod entry;
mod inset;
mod labels;
mod lens;
mod named;
mod numbers;
mod obstacles;
mod rulers;
mod shaded;
mod shapes;
mod spot;

use glam::{Vec2, Vec3};
use raystep_accel::{Aabb, Place, PrimId, Primitives, Prims};

use lens::Lens;

use crate::page::{Anchor, Figure, Ink, Mark};
use crate::theme::fonts::broken;
use crate::theme::{Face, Role};
use crate::world::{Form, Space, SpaceMark};

pub use axes::axes;
pub use camera::Camera;
pub use crop::crop;
pub use inset::{inset_at, inset_size, is_nearer, set_inset};
pub use labels::pointed_at;
pub use shaded::{Shaded, shaded};
pub(crate) use spot::covers;

/// What a picture shows of the primitives to which nothing has happened.
#[derive(Clone, Copy, Debug)]
pub enum Scenery<'a> {
    /// Their outlines, pale and thin.
    Drawn,
    /// Nothing: they are painted below the figure.
    Left,
    /// An image of them; lines behind their surfaces are faint.
    Shaded(&'a Shaded),
}

/// The space as `camera` sees it in a picture of this size in points, with labels; and the axes of a solid scene,
/// unless its primitives are painted elsewhere.
pub fn stage(space: &Space, prims: &Prims, camera: &Camera, size: Vec2, scenery: Scenery<'_>) -> Figure {
    stage_around(None, space, prims, camera, size, scenery)
}

/// The same with labels that keep off a rectangle, given by its corners, where something else will stand.
pub fn stage_around(
    kept: Option<[Vec2; 2]>,
    space: &Space,
    prims: &Prims,
    camera: &Camera,
    size: Vec2,
    scenery: Scenery<'_>,
) -> Figure {
    let mut figure = drawn(kept, space, prims, camera, size, scenery, &space.notes);
    if !matches!(scenery, Scenery::Left) {
        figure.marks.extend(axes(camera, size).marks);
    }
    figure
}

/// The same without axes and notes, for a small picture with a title at its foot, which names where the step is.
pub fn close_up(space: &Space, prims: &Prims, camera: &Camera, size: Vec2, scenery: Scenery<'_>) -> Figure {
    let foot = [Vec2::new(0.0, size.y - inset::FOOT), size];
    let named = |mark: &&SpaceMark| mark.role == Role::Here && matches!(mark.form, Form::Label { .. });
    let marks = space.marks.iter().filter(|mark| !named(mark)).cloned().collect();
    let space = Space { marks, bounds: space.bounds, flat: space.flat, notes: Vec::new() };
    let mut figure = drawn(Some(foot), &space, prims, camera, size, scenery, &[]);
    // What has no room for all of its words says none.
    figure.marks.retain(|mark| labels::is_whole(&mark.ink, size));
    figure
}

fn drawn(
    kept: Option<[Vec2; 2]>,
    space: &Space,
    prims: &Prims,
    camera: &Camera,
    size: Vec2,
    scenery: Scenery<'_>,
    notes: &[String],
) -> Figure {
    let depth = match scenery {
        Scenery::Shaded(shaded) => Some(shaded),
        _ => None,
    };
    let mut stage = Stage { lens: Lens::new(camera, size), flat: space.flat, depth, figure: Figure::new(size) };
    // Primitives lie on the tint of what refers to them, and its outline runs over them.
    let ground = |mark: &&SpaceMark| space.flat && mark.role == Role::Filled;
    for mark in space.marks.iter().filter(ground) {
        stage.form(&mark.form, Role::Filled, mark.place, prims);
    }
    match scenery {
        Scenery::Drawn => stage.scenery(space, prims),
        Scenery::Left => {}
        Scenery::Shaded(shaded) => {
            let image = shaded.image.clone();
            stage.figure.add(Role::Scene, None, Ink::Image { min: Vec2::ZERO, max: size, image });
        }
    }
    for mark in &space.marks {
        let role = if ground(&mark) { Role::Edge } else { mark.role };
        stage.form(&mark.form, role, mark.place, prims);
    }
    crop::crop_far(&mut stage.figure);
    stage.notes(notes);
    let mut obstacles = labels::place(kept, space, &stage.lens, &mut stage.figure);
    entry::set(space, &stage.lens, &mut stage.figure, &mut obstacles);
    numbers::set(space, prims, &stage.lens, &mut stage.figure, &mut obstacles);
    rulers::draw(space, &stage.lens, &mut stage.figure);
    stage.figure
}

/// Only the labels of a space, where [`stage`] would put them: for a picture whose marks are painted elsewhere.
pub fn labels(space: &Space, prims: &Prims, camera: &Camera, size: Vec2) -> Figure {
    let mut figure = stage(space, prims, camera, size, Scenery::Left);
    figure.marks.retain(is_label);
    figure
}

/// Whether a mark of a picture is a text, or the line from one to what it labels.
pub fn is_label(mark: &Mark) -> bool {
    matches!((&mark.ink, mark.role), (Ink::Text { .. }, _) | (Ink::Line { .. }, Role::Quiet))
}

/// A picture being drawn.
struct Stage<'a> {
    lens: Lens,
    flat: bool,
    depth: Option<&'a Shaded>,
    figure: Figure,
}

/// Radius of a ring, in points.
const RING: f32 = 6.0;

/// Length of an arrow's head, in points.
const HEAD: f32 = 13.0;

impl Stage<'_> {
    /// The primitives that no mark of the space draws.
    fn scenery(&mut self, space: &Space, prims: &Prims) {
        let marked: std::collections::BTreeSet<PrimId> = space
            .marks
            .iter()
            .filter_map(|mark| if let Form::Prim(prim) = mark.form { Some(prim) } else { None })
            .collect();
        for prim in (0..prims.len() as u32).map(PrimId).filter(|prim| !marked.contains(prim)) {
            self.prim(prims, prim, Role::Scene);
        }
    }

    /// What of much is drawn, in the lower right corner.
    fn notes(&mut self, notes: &[String]) {
        let page = self.figure.size;
        let size = (spot::letters(page) * 0.92).min(13.0);
        // One that is wider than the picture, or than what the axes leave of it, takes two lines; where it took more it
        // would cover the scene.
        let axes = if self.flat { 0.0 } else { axes::room(page)[1].x };
        let notes = notes.iter().map(|note| broken(note, Face::Regular, size, page.x - 28.0 - axes));
        let lines: Vec<String> = notes.filter(|lines| lines.len() <= 2).flatten().collect();
        for (row, text) in lines.into_iter().rev().enumerate() {
            let at = page - Vec2::new(14.0, 16.0 + row as f32 * size * 1.5);
            let ink = Ink::Text { at, text, size, face: Face::Regular, anchor: Anchor::End, boxed: false };
            self.figure.add(Role::Quiet, None, ink);
        }
    }

    fn form(&mut self, form: &Form, role: Role, place: Option<Place>, prims: &Prims) {
        match form {
            Form::Box(bounds) => self.bounds(bounds, role, place),
            Form::Sheet(bounds) => self.sheet(bounds, role, place),
            Form::Sphere(sphere) if self.flat => self.disc(sphere, role, place),
            Form::Sphere(sphere) => self.globe(sphere, role, place),
            Form::Body(edges) => self.body(edges, role, place),
            // A plane is tinted as a sheet is, also where something stands before it.
            Form::Polygon(corners) if is_cut(role) => self.tint(corners, role, place),
            Form::Polygon(corners) => self.area(corners, role, place),
            Form::Segment(from, to) => self.line(*from, *to, role, place),
            Form::Arrow(from, to) => self.arrow(*from, *to, role, place),
            Form::Point(at) => {
                if let Some((center, _)) = self.lens.point(*at) {
                    // The ray's origin is a dot, not a dashed ring.
                    let (role, radius) = if role == Role::Ray { (Role::Live, RING * 0.5) } else { (role, RING) };
                    self.figure.add(role, place, Ink::Circle { center, radius });
                    // On a solid fill, a ring needs a hole.
                    if role == Role::Best {
                        self.figure.add(Role::Page, place, Ink::Circle { center, radius: RING * 0.5 });
                    }
                }
            }
            Form::Prim(prim) if prim.index() < prims.len() => self.prim(prims, *prim, role),
            // What is written comes last.
            Form::Prim(_) | Form::Label { .. } | Form::Number { .. } | Form::Axes(_) => {}
        }
    }

    /// A rectangle of the plane, or the twelve edges of a box in space.
    fn bounds(&mut self, bounds: &Aabb, role: Role, place: Option<Place>) {
        let corners = bounds.corners();
        if self.flat {
            let seen: Vec<Vec2> = corners.iter().filter_map(|&corner| Some(self.lens.point(corner)?.0)).collect();
            let min = seen.iter().copied().fold(Vec2::INFINITY, Vec2::min);
            let max = seen.iter().copied().fold(Vec2::NEG_INFINITY, Vec2::max);
            self.figure.add(role, place, Ink::Rect { min, max, round: 0.0 });
            return;
        }
        for (index, &from) in corners.iter().enumerate() {
            for axis in [1, 2, 4] {
                if index & axis == 0 {
                    self.line(from, corners[index | axis], role, place);
                }
            }
        }
    }

    /// A line of the plane, or a rectangle in space.
    fn sheet(&mut self, bounds: &Aabb, role: Role, place: Option<Place>) {
        if self.flat {
            self.line(bounds.min.with_z(0.0), bounds.max.with_z(0.0), role, place);
            return;
        }
        // Of the eight corners, the four that differ along the two axes with a length.
        let corners = bounds.corners();
        let extent = bounds.extent();
        let around: &[usize] = if extent.x == 0.0 {
            &[0, 2, 6, 4]
        } else if extent.y == 0.0 {
            &[0, 1, 5, 4]
        } else {
            &[0, 1, 3, 2]
        };
        let around: Vec<Vec3> = around.iter().map(|&index| corners[index]).collect();
        self.tint(&around, role, place);
    }

    fn arrow(&mut self, from: Vec3, to: Vec3, role: Role, place: Option<Place>) {
        self.line(from, to, role, place);
        if let (Some([(tail, _), _]), Some((tip, _))) = (self.lens.segment(from, to), self.lens.point(to)) {
            let along = (tip - tail).normalize_or_zero();
            if along != Vec2::ZERO {
                self.figure.add(role, place, Ink::Arrowhead { tip, along, length: HEAD });
            }
        }
    }

    fn line(&mut self, from: Vec3, to: Vec3, role: Role, place: Option<Place>) {
        self.path(&[from, to], role, place);
    }

    /// A line around corners; what lies behind a surface is faint.
    fn path(&mut self, corners: &[Vec3], role: Role, place: Option<Place>) {
        let mut paths: Vec<(Vec<Vec2>, bool)> = Vec::new();
        for pair in corners.windows(2) {
            let Some([from, to]) = self.lens.segment(pair[0], pair[1]) else { continue };
            for (start, end, hidden) in self.runs(from, to) {
                match paths.last_mut() {
                    Some((points, same)) if *same == hidden && points.last().is_some_and(|p| joined(*p, start)) => {
                        points.push(end);
                    }
                    _ => paths.push((vec![start, end], hidden)),
                }
            }
        }
        for (points, hidden) in paths {
            let role = if hidden { behind(role) } else { role };
            self.figure.add(role, place, Ink::Line { points });
        }
    }

    /// A straight line on the page with its depths, parted where it goes behind a surface or comes out.
    fn runs(&self, from: (Vec2, f32), to: (Vec2, f32)) -> Vec<(Vec2, Vec2, bool)> {
        let Some(shaded) = self.depth else { return vec![(from.0, to.0, false)] };
        // Depth is linear along a projected line.
        let pieces = ((to.0 - from.0).length() / 2.0).ceil().clamp(1.0, 4096.0) as usize;
        let at = |piece: usize| {
            let share = piece as f32 / pieces as f32;
            (from.0 + (to.0 - from.0) * share, from.1 + (to.1 - from.1) * share)
        };
        let hides = |piece: usize| {
            let ((a, near), (b, far)) = (at(piece), at(piece + 1));
            shaded.hides((a + b) * 0.5, (near + far) * 0.5, self.figure.size)
        };
        let mut start = 0;
        let mut runs = Vec::new();
        for piece in 0..pieces {
            if piece + 1 == pieces || hides(piece) != hides(piece + 1) {
                runs.push((at(start).0, at(piece + 1).0, hides(piece)));
                start = piece + 1;
            }
        }
        runs
    }
}

/// Whether a role is that of planes that cut.
fn is_cut(role: Role) -> bool {
    matches!(role, Role::Plane | Role::Candidate)
}

/// How a line looks where a surface lies before it.
fn behind(role: Role) -> Role {
    match role {
        Role::Live => Role::LiveBehind,
        Role::Ray => Role::Ray,
        Role::Here | Role::Seen => Role::Seen,
        Role::Waiting | Role::Best | Role::Hit | Role::Lane => role,
        Role::Thread1 | Role::Strand1 => Role::Thread1,
        Role::Thread2 | Role::Strand2 => Role::Thread2,
        Role::Thread3 | Role::Strand3 => Role::Thread3,
        Role::Thread4 | Role::Strand4 => Role::Thread4,
        _ => Role::Hidden,
    }
}

/// Whether two points of the page are the same but for rounding.
fn joined(a: Vec2, b: Vec2) -> bool {
    (a - b).length_squared() < 1e-4
}
