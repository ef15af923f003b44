//! The ray, and the part of it under consideration.

use raystep_accel::{Place, Visit};

use super::{Drawing, shown};
use crate::theme::Role;
use crate::words::number;
use crate::world::Form;

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
        // Where the split plane, or the volume just tested, meets it.
        if let Some(cut) = self.moment.cut {
            self.ring(Role::Tick, Some(Place::Node(cut.node)), cut.t, Some(format!("t = {}", number(cut.t))));
        }
        if let Some(Visit::Volume { place, t_near, t_far, .. }) = self.moment.event
            && t_near <= t_far
        {
            self.ring(Role::Tick, Some(place), t_near, Some(format!("t_near = {}", number(t_near))));
            self.ring(Role::Tick, Some(place), t_far, Some(format!("t_far = {}", number(t_far))));
        }
    }
}
