//! What somebody tries instead of what the builder weighed.

use raystep_accel::Grow;

use super::{Build, GrowMoment, Weighed};

impl Build<'_> {
    /// What the builder has weighed at its node, and what somebody tries instead of the last of it.
    pub(crate) fn weighed(&self, moment: &GrowMoment) -> (Vec<Weighed>, Option<Weighed>) {
        let mut weighed = moment.weighed.clone();
        let own = match self.instead {
            Some(Grow::Weigh { axis, plane, below, above, cost, .. }) if axis.axis().is_some() => {
                Weighed { axis, plane, below, above, cost, free: None }
            }
            _ => return (weighed, None),
        };
        let tried = weighed.pop();
        weighed.extend(tried.and(Some(own)));
        (weighed, tried)
    }
}
