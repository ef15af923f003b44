//! What changes of a finished structure touch: slide 44.

use raystep_accel::{Change, Grow, NodeId, PrimId};

use super::{Build, Changed, GrowMoment};

impl Build<'_> {
    /// The changes begun so far: the last of them is under way or just over.
    pub(crate) fn begun(&self, moment: &GrowMoment) -> &[Changed] {
        // One that the structure has no room for has no events of its own.
        let begins = |change: &&Changed| change.from + usize::from(change.done) <= moment.step;
        let count = self.changes.iter().take_while(begins).count();
        &self.changes[..count]
    }

    /// How many primitives come only once the structure is built.
    pub(crate) fn only_inserted(&self) -> u64 {
        let mut seen = Vec::new();
        let mut only = 0;
        for Changed { change, .. } in self.changes {
            let prim = change.prim();
            if !seen.contains(&prim) {
                seen.push(prim);
                only += u64::from(matches!(change, Change::Insert(_)));
            }
        }
        only
    }

    /// The change that a step belongs to, if the structure is built already.
    pub(crate) fn change(&self, moment: &GrowMoment) -> Option<&Changed> {
        self.begun(moment).last()
    }

    /// The nodes that a change has touched so far, in order.
    pub(crate) fn touched(&self, moment: &GrowMoment, change: &Changed) -> Vec<NodeId> {
        if !change.done {
            return Vec::new();
        }
        let next = self.changes.iter().map(|other| other.from).find(|from| *from > change.from);
        let end = moment.step.min(next.unwrap_or(usize::MAX)).min(self.events.len());
        let events = self.events.get(change.from..end).unwrap_or_default();
        let touched = events.iter().filter_map(|event| match event {
            Grow::Touch { node } => Some(*node),
            _ => None,
        });
        touched.collect()
    }

    /// Primitives that are not in the structure yet.
    pub(crate) fn coming(&self, moment: &GrowMoment) -> Vec<PrimId> {
        let rest = &self.changes[self.begun(moment).len()..];
        rest.iter()
            .filter(|change| matches!(change.change, Change::Insert(_)))
            .map(|change| change.change.prim())
            .collect()
    }

    /// Primitives that are in the structure no more.
    pub(crate) fn gone(&self, moment: &GrowMoment) -> Vec<PrimId> {
        let begun = self.begun(moment);
        // Of the change under way, once it is over.
        let over = matches!(moment.event, Some(Grow::End { .. }));
        let done = &begun[..begun.len() - usize::from(!over && !begun.is_empty())];
        done.iter()
            .filter(|change| matches!(change.change, Change::Delete(_)))
            .map(|change| change.change.prim())
            .collect()
    }
}
