//! A tape: what a student steps through.

use super::Observer;

/// A tape of at most `limit` events that counts what it could not keep.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace<E> {
    /// The events, oldest first.
    pub events: Vec<E>,
    /// How many events came after the tape was full.
    pub lost: u64,
    limit: usize,
}

impl<E> Trace<E> {
    /// An empty tape for `limit` events.
    pub fn new(limit: usize) -> Trace<E> {
        Trace { events: Vec::new(), lost: 0, limit }
    }
}

impl<E> Observer<E> for Trace<E> {
    fn on(&mut self, event: E) {
        if self.events.len() < self.limit {
            self.events.push(event);
        } else {
            self.lost += 1;
        }
    }
}
