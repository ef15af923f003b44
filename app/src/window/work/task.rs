//! Something that takes a while: how far it is, and whether it should give up.

use raystep_figure::whole;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};

/// Work under way beside the UI thread.
#[derive(Debug)]
pub(crate) struct Task {
    name: String,
    /// What is counted; `"%"` stands alone.
    unit: &'static str,
    /// How many there are in all; 0 when nobody knows.
    of: AtomicU32,
    done: AtomicU32,
    stopped: AtomicBool,
    over: AtomicBool,
}

impl Task {
    /// Work that counts what it has done in this unit.
    pub(crate) fn new(name: impl Into<String>, unit: &'static str) -> Arc<Task> {
        let (of, done, stopped, over) = Default::default();
        Arc::new(Task { name: name.into(), unit, of, done, stopped, over })
    }

    /// So many there are in all.
    pub(crate) fn expect(&self, of: usize) {
        self.of.store(of as u32, Ordering::Relaxed);
    }

    /// One more is done.
    pub(crate) fn count(&self) {
        self.done.fetch_add(1, Ordering::Relaxed);
    }

    /// So many are done.
    pub(crate) fn reach(&self, done: usize) {
        self.done.store(done as u32, Ordering::Relaxed);
    }

    /// Asks the work to give up.
    pub(crate) fn stop(&self) {
        self.stopped.store(true, Ordering::Relaxed);
    }

    /// Whether it should give up.
    pub(crate) fn is_stopped(&self) -> bool {
        self.stopped.load(Ordering::Relaxed)
    }

    /// There is nothing left to do.
    pub(crate) fn finish(&self) {
        self.over.store(true, Ordering::Relaxed);
    }

    /// Whether somebody still waits for it.
    pub(crate) fn is_underway(&self) -> bool {
        !self.is_stopped() && !self.over.load(Ordering::Relaxed)
    }

    /// Which part of it is done, if that is known.
    pub(crate) fn part(&self) -> Option<f32> {
        let of = if self.unit == "%" { 100 } else { self.of.load(Ordering::Relaxed) };
        (of > 0).then(|| self.done.load(Ordering::Relaxed) as f32 / of as f32)
    }

    /// What it does and how far it is.
    pub(crate) fn says(&self) -> String {
        let (name, unit) = (&self.name, self.unit);
        match (self.done.load(Ordering::Relaxed), self.of.load(Ordering::Relaxed)) {
            (0, 0) => name.clone(),
            // Nobody asks how many of what.
            (_, 0) if unit.is_empty() => name.clone(),
            (done, 0) => format!("{name}: {} {unit}", whole(u64::from(done))),
            (done, of) => format!("{name}: {} of {of} {unit}", done.min(of)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_task_says_how_far_it_is() {
        let task = Task::new("Writing", "pictures");
        assert_eq!(task.says(), "Writing");
        let uncounted = Task::new("Measuring", "");
        uncounted.reach(3);
        assert_eq!(uncounted.says(), "Measuring");
        task.reach(3);
        assert_eq!((task.says().as_str(), task.part()), ("Writing: 3 pictures", None));
        task.reach(1_203_004);
        assert_eq!(task.says(), "Writing: 1,203,004 pictures");
        task.reach(3);
        task.expect(7);
        assert_eq!(task.says(), "Writing: 3 of 7 pictures");
        assert!(task.is_underway());
        task.stop();
        assert!(!task.is_underway());
    }
}
