//! The two planes of a slab that is being cut.

use raystep_accel::{Aabb, Axis, Visit};

use super::{Drawing, Form};
use crate::moment::{SlabCut, SlabTest};
use crate::{Role, number};

impl Drawing<'_> {
    pub(super) fn slab(&mut self) {
        let Some(slab) = self.moment.slab.as_ref() else { return };
        if matches!(self.moment.event, Some(Visit::Volume { .. })) {
            return;
        }
        for cut in &slab.cuts {
            let drawn = cut.axis == slab.axis || (self.walk.flat && cut.axis < slab.axis);
            if drawn && !(self.walk.flat && cut.axis == Axis::Z.into()) {
                self.planes(slab, cut);
            }
        }
    }

    /// The planes of a slab across an axis; of other slabs only where the ray meets them.
    fn planes(&mut self, slab: &SlabTest, cut: &SlabCut) {
        let role = if cut.axis == slab.axis { Role::Plane } else { Role::Edge };
        if let Some(axis) = cut.axis.axis() {
            let room = self.room(slab);
            for at in [cut.low, cut.high] {
                let mut sheet = room;
                sheet.min[axis] = at;
                sheet.max[axis] = at;
                self.add(role, Some(slab.place), Form::Sheet(sheet));
            }
        }
        if let (Some(ts), true) = (cut.t, cut.axis == slab.axis) {
            for (name, t) in ["t1", "t2"].into_iter().zip(ts) {
                self.ring(Role::Tick, Some(slab.place), t, Some(format!("{name} = {}", number(t))));
            }
        }
    }

    /// A plane has no end: in a flat scene it runs through the picture, in a solid one beyond the box.
    fn room(&self, slab: &SlabTest) -> Aabb {
        if self.walk.flat {
            return self.bounds;
        }
        let bounds = self.walk.bounds(slab.place);
        bounds.padded(0.15 * bounds.extent().max_element())
    }
}
