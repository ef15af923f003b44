//! The ray, and the part of it under consideration.

use raystep_accel::Place;

use super::{Drawing, line, shown};
use crate::theme::Role;
use crate::words::number;
use crate::world::{Form, SpaceMark};

impl Drawing<'_> {
    pub(super) fn ray(&mut self) {
        let ray = self.walk.ray;
        let part = shown(self.walk, &self.bounds);
        if part.is_empty() {
            return;
        }
        // The whole of it, dashed, and the live part over it.
        self.add(Role::Ray, None, Form::Arrow(ray.at(part.near), ray.at(part.far)));
        let live = self.moment.live;
        let (near, far) = (live.near.max(part.near), live.far.min(part.far));
        if near < far {
            self.add(Role::Live, self.moment.here, Form::Segment(ray.at(near), ray.at(far)));
        }
        if self.bounds.contains(ray.o) {
            self.add(Role::Ray, None, Form::Point(ray.o));
        }
        // Where the split plane meets it.
        if let Some(cut) = self.moment.cut {
            self.ring(Role::Tick, Some(Place::Node(cut.node)), cut.t, Some(format!("t = {}", number(cut.t))));
        }
    }

    /// The line that the ray lies on, where it is no ray: behind its origin and after its end. It is drawn where
    /// something lies there.
    pub(super) fn line(&mut self) {
        let ray = self.walk.ray;
        let line = line(self.walk, &self.bounds);
        if self.is_one_test() || self.back < 0.0 {
            let rest = [(line.near, line.far.min(0.0)), (line.near.max(ray.t_max), line.far)];
            let rest = rest.into_iter().filter(|(from, to)| from < to).map(|(from, to)| {
                let form = Form::Segment(ray.at(from), ray.at(to));
                SpaceMark { form, role: Role::Line, place: None }
            });
            // Below the ray and its rings, over all boxes.
            let below = self.marks.iter().position(|mark| mark.role == Role::Ray).unwrap_or(self.marks.len());
            self.marks.splice(below..below, rest);
        }
    }
}
