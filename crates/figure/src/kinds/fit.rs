//! The fitting of a volume around a set.

use raystep_accel::{Aabb, BvhVolume, Fit, Place, Primitives, Prims};

use super::{Instant, Kind};
use crate::moments::FitMoment;
use crate::page::Figure;
use crate::panes::{Ask, Pane, listing, space_of_fit, steps};
use crate::theme::Role;
use crate::words::{Fact, VolumeName, whole};
use crate::world::{Depth, Form, Space, forms_of_volume};

/// The fitting of one volume around everything, step by step.
#[derive(Clone, Copy, Debug)]
pub struct Fitting<'a> {
    /// What it is fitted around.
    pub prims: &'a Prims,
    /// What happens.
    pub events: &'a [Fit],
    /// Which volume it is.
    pub volume: BvhVolume,
    /// Whether the scene is flat.
    pub flat: bool,
}

/// Of the steps so far, so many are told in words: there is never room for more.
const TOLD: usize = 24;

/// What the marks of space mean.
const SIGNS: &[(Role, &str)] = &[
    (Role::Scene, "primitive"),
    (Role::Edge, "box around everything"),
    (Role::Here, "volume so far, what is new"),
    (Role::Seen, "what stays of it"),
    (Role::Candidate, "tried"),
    (Role::Dropped, "goes"),
    (Role::Live, "direction"),
    (Role::Plane, "distance, or plane pushed out"),
    (Role::Tick, "point of this step"),
    (Role::Best, "decides"),
];

impl Fitting<'_> {
    fn is_seen(&self, event: &Fit) -> bool {
        !(self.flat && event.concerns_z())
    }
}

impl Kind for Fitting<'_> {
    fn len(&self) -> usize {
        self.events.len()
    }

    fn start(&self) -> Instant {
        Instant::new(FitMoment::default())
    }

    fn advance(&self, at: &mut Instant, step: usize) {
        at.state_mut::<FitMoment>().advance(self.events, step);
    }

    fn panes(&self) -> Vec<Pane> {
        vec![Pane::Listing, Pane::Work]
    }

    fn draw(&self, at: &Instant, pane: Pane, ask: &Ask<'_>) -> Option<Figure> {
        let moment: &FitMoment = at.state();
        let Ask { size, ref look, .. } = *ask;
        Some(match pane {
            Pane::Listing => listing("Fit", ask.lines, self.fact(moment.step), self.flat, size, look),
            Pane::Work => {
                let done: Vec<(usize, &dyn Fact)> = (1..)
                    .zip(&self.events[..moment.step.min(self.events.len())])
                    .filter(|(_, event)| self.is_seen(event))
                    .map(|(step, event)| -> (usize, &dyn Fact) { (step, event) })
                    .collect();
                let first = done.len().saturating_sub(TOLD);
                steps("The fitting so far", &done[first..], size, look)
            }
            _ => return None,
        })
    }

    fn fact(&self, step: usize) -> Option<&dyn Fact> {
        let event = self.events.get(step.checked_sub(1)?)?;
        Some(event)
    }

    fn space(&self, at: &Instant, _: Depth) -> Option<Space> {
        Some(space_of_fit(self.events, at.state(), self.flat))
    }

    fn outline(&self, at: &Instant, place: Place) -> Vec<Form> {
        let moment: &FitMoment = at.state();
        match place {
            Place::Prim(prim) if prim.index() < self.prims.len() => vec![Form::Prim(prim)],
            Place::Cell(point) => moment.points.get(&point.0).map(|at| Form::Point(*at)).into_iter().collect(),
            Place::Node(face) => {
                let corners = moment.faces.get(&face.0).and_then(|face| moment.corners(*face));
                corners.filter(|_| !self.flat).map(Form::Polygon).into_iter().collect()
            }
            Place::World => moment.volume.iter().flat_map(|volume| forms_of_volume(volume, self.flat)).collect(),
            Place::Prim(_) => Vec::new(),
        }
    }

    fn prims(&self) -> &Prims {
        self.prims
    }

    fn flat(&self) -> bool {
        self.flat
    }

    fn volume(&self) -> VolumeName {
        VolumeName::named(self.volume)
    }

    fn signs(&self) -> &'static [(Role, &'static str)] {
        SIGNS
    }

    fn here(&self, at: &Instant) -> Option<Place> {
        at.state::<FitMoment>().event.map(|event| event.place()).filter(|place| *place != Place::World)
    }

    fn bounds(&self, at: &Instant, place: Place) -> Aabb {
        match place {
            Place::Prim(prim) => self.prims.bounds(prim),
            place => at.state::<FitMoment>().bounds_of(place),
        }
    }

    fn tally(&self, at: &Instant) -> String {
        let moment: &FitMoment = at.state();
        let deciding = moment.deciding.len() as u64;
        let points = if deciding == 1 { "point decides" } else { "points decide" };
        let one = VolumeName::named(self.volume).one;
        if deciding == 0 { one.to_owned() } else { format!("{one} · {} {points}", whole(deciding)) }
    }
}
