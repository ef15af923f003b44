//! The fitting of a volume, and how far it has come after some of its events.

use std::collections::BTreeMap;

use glam::{DVec3, Vec3};
use raystep_accel::{Aabb, Direction, Fit, Outline, Place, Sphere};

/// What is known of a volume after some events.
#[derive(Clone, Debug)]
pub(crate) struct FitMoment {
    /// How many events have happened.
    pub(crate) step: usize,
    /// The last of them.
    pub(crate) event: Option<Fit>,
    /// The box around everything.
    pub(crate) bounds: Aabb,
    /// Points that were named, by their numbers.
    pub(crate) points: BTreeMap<u32, Vec3>,
    /// Those that decide how the volume lies, in the order in which they came.
    pub(crate) deciding: Vec<u32>,
    /// The volume so far.
    pub(crate) volume: Option<Outline>,
    /// What is tried instead.
    pub(crate) tried: Option<Outline>,
    /// The directions of an oriented box, those last tried or taken.
    pub(crate) axes: Option<[Vec3; 3]>,
    /// The middle of the sphere or of the oriented box that was last named.
    pub(crate) middle: Option<Vec3>,
    /// The planes across each direction so far: normal, and the two coordinates, seen from the middle of the box.
    pub(crate) slabs: Vec<(Direction, Vec3, [f32; 2])>,
    /// The faces of a hull by their corners.
    pub(crate) faces: BTreeMap<u32, [u32; 3]>,
    /// Those that the newest corner has removed.
    pub(crate) gone: Vec<[u32; 3]>,
    /// Those that it has made.
    pub(crate) fresh: Vec<u32>,
    planes: Vec<(Vec3, f32)>,
    /// The directions of the smallest box so far, and its middle.
    best: Option<([Vec3; 3], Vec3)>,
    round: Vec<(f32, Outline, [Vec3; 3], Vec3)>,
}

impl Default for FitMoment {
    fn default() -> FitMoment {
        FitMoment {
            step: 0,
            event: None,
            bounds: Aabb::EMPTY,
            points: BTreeMap::new(),
            deciding: Vec::new(),
            volume: None,
            tried: None,
            axes: None,
            middle: None,
            slabs: Vec::new(),
            faces: BTreeMap::new(),
            gone: Vec::new(),
            fresh: Vec::new(),
            planes: Vec::new(),
            best: None,
            round: Vec::new(),
        }
    }
}

impl FitMoment {
    /// Lets events happen until `step` have.
    pub(crate) fn advance(&mut self, events: &[Fit], step: usize) {
        for event in events.iter().take(step).skip(self.step) {
            self.on(*event);
            self.step += 1;
            self.event = Some(*event);
        }
    }

    /// The corners of a face, as far as they are known.
    pub(crate) fn corners(&self, face: [u32; 3]) -> Option<Vec<Vec3>> {
        face.iter().map(|corner| self.points.get(corner).copied()).collect()
    }

    /// The box around what a place is.
    pub(crate) fn bounds_of(&self, place: Place) -> Aabb {
        match place {
            Place::Cell(point) => self.points.get(&point.0).map_or(Aabb::EMPTY, |at| Aabb::around([*at])),
            Place::Node(face) => {
                let corners = self.faces.get(&face.0).and_then(|face| self.corners(*face));
                corners.map_or(Aabb::EMPTY, Aabb::around)
            }
            _ => self.bounds,
        }
    }

    fn name(&mut self, point: u32, at: [f32; 3]) {
        self.points.insert(point, Vec3::from(at));
    }

    fn decide(&mut self, point: u32, at: [f32; 3]) {
        self.name(point, at);
        if !self.deciding.contains(&point) {
            self.deciding.push(point);
        }
    }

    fn on(&mut self, event: Fit) {
        match event {
            Fit::Begin { bounds, .. } => self.bounds = bounds,
            Fit::Widen { bounds, .. } => {
                self.bounds = bounds;
                self.volume = Some(Outline::Box(bounds));
            }
            Fit::Far { point, x, y, z, outside: true, .. } => self.decide(point, [x, y, z]),
            Fit::Far { point, x, y, z, .. } => self.name(point, [x, y, z]),
            Fit::Try { x, y, z, radius, .. } | Fit::Shift { x, y, z, radius, .. } => {
                self.tried = Some(sphere([x, y, z], radius));
            }
            Fit::Ball { x, y, z, radius, .. } | Fit::Sphere { x, y, z, radius } => {
                (self.tried, self.volume) = (None, Some(sphere([x, y, z], radius)));
                self.middle = Some(Vec3::new(x, y, z));
            }
            Fit::Keep { point, x, y, z, .. } => self.decide(point, [x, y, z]),
            Fit::Mean { x, y, z, .. } => self.middle = Some(Vec3::new(x, y, z)),
            Fit::Frame { .. } => self.frame(&event),
            Fit::Choose { surface, taken, .. } => {
                let chosen = self.round.iter().find(|(own, ..)| *own == surface).filter(|_| taken);
                if let Some((_, outline, axes, middle)) = chosen.cloned() {
                    (self.volume, self.best) = (Some(outline), Some((axes, middle)));
                }
                // What was tried in vain is forgotten.
                if let Some((axes, middle)) = self.best {
                    (self.axes, self.middle) = (Some(axes), Some(middle));
                }
                self.tried = None;
                self.round.clear();
            }
            Fit::Push { axis, x, y, z, low, high, .. } => {
                self.slabs.retain(|(known, ..)| *known != axis);
                self.slabs.push((axis, Vec3::new(x, y, z), [low, high]));
                self.between_slabs();
            }
            Fit::Seed { point, x, y, z, .. } => self.decide(point, [x, y, z]),
            Fit::Apex { point, x, y, z, .. } => {
                self.gone.clear();
                self.fresh.clear();
                self.decide(point, [x, y, z]);
            }
            Fit::Hide { face } => self.gone.extend(self.faces.remove(&face)),
            Fit::Make { face, a, b, c, .. } => {
                self.faces.insert(face, [a, b, c]);
                self.fresh.push(face);
            }
            Fit::Enough { .. } => {
                self.gone.clear();
                self.fresh.clear();
                let corners = self.faces.values().filter_map(|face| self.corners(*face)).collect();
                self.volume = Some(Outline::Faces(corners));
            }
            Fit::Plane { x, y, z, plane, .. } => self.planes.push((Vec3::new(x, y, z), plane)),
            Fit::End { .. } => {
                self.tried = None;
                if !self.planes.is_empty() {
                    let planes = self.planes.iter().map(|(n, at)| (n.as_dvec3(), f64::from(*at)));
                    self.volume = Some(Outline::of_planes(self.bounds.center(), planes));
                    self.faces.clear();
                }
            }
            Fit::Gather { .. } | Fit::Align { .. } => {}
        }
    }

    /// Three directions that are tried, and the box along them.
    fn frame(&mut self, event: &Fit) {
        let Fit::Frame {
            x, y, z, u_x, u_y, u_z, v_x, v_y, v_z, w_x, w_y, w_z, wide_u, wide_v, wide_w, surface, ..
        } = *event
        else {
            return;
        };
        let axes = [Vec3::new(u_x, u_y, u_z), Vec3::new(v_x, v_y, v_z), Vec3::new(w_x, w_y, w_z)];
        let middle = Vec3::new(x, y, z);
        let sides = axes.iter().zip([wide_u, wide_v, wide_w]).flat_map(|(n, wide)| {
            let (n, half) = (n.as_dvec3(), f64::from(wide) * 0.5);
            [(n, half), (-n, half)]
        });
        let outline = Outline::of_planes(middle, sides);
        self.round.push((surface, outline.clone(), axes, middle));
        (self.tried, self.axes, self.middle) = (Some(outline), Some(axes), Some(middle));
    }

    /// What lies between all slabs so far: in the box, or, of an oriented box, once all three are known.
    fn between_slabs(&mut self) {
        let own = |(axis, ..): &(Direction, Vec3, [f32; 2])| matches!(axis, Direction::Own(_));
        let oriented = self.slabs.iter().any(own);
        if oriented && self.slabs.len() < 3 {
            return;
        }
        let half = (self.bounds.extent() * 0.5).as_dvec3().to_array();
        let straight = DVec3::AXES.into_iter().zip(half).flat_map(|(n, half)| [(n, half), (-n, half)]);
        let slabs = self.slabs.iter().flat_map(|(_, n, [low, high])| {
            let n = n.as_dvec3();
            [(n, f64::from(*high)), (-n, -f64::from(*low))]
        });
        let planes = straight.filter(|_| !oriented).chain(slabs);
        self.volume = Some(Outline::of_planes(self.bounds.center(), planes));
    }
}

fn sphere(center: [f32; 3], radius: f32) -> Outline {
    Outline::Sphere(Sphere { center: Vec3::from(center), radius })
}
