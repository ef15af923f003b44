//! How far the reading is, and whether it shall go on.

use super::ObjError;

/// So many bytes, or corners, between two reports.
const BETWEEN: usize = 1 << 18;

/// So many steps between two questions where nobody knows how many there will be.
const PATIENCE: u32 = 1 << 12;

/// Tells the part done, from 0 to 1, and asks whether to go on.
pub(super) struct Progress<'a> {
    tell: &'a mut dyn FnMut(f32) -> bool,
    /// The parts of the whole between which the present work lies.
    from: f32,
    to: f32,
    part: f32,
    /// What has to be done before the next report.
    next: usize,
    steps: u32,
}

impl Progress<'_> {
    pub(super) fn new(tell: &mut dyn FnMut(f32) -> bool) -> Progress<'_> {
        Progress { tell, from: 0.0, to: 0.0, part: 0.0, next: 0, steps: 0 }
    }

    /// The next work ends where this part of the whole is done.
    pub(super) fn until(&mut self, to: f32) -> &mut Self {
        (self.from, self.to, self.next) = (self.to, to, 0);
        self
    }

    /// So many of so many are done.
    pub(super) fn reach(&mut self, done: usize, of: usize) -> Result<(), ObjError> {
        if done < self.next {
            return Ok(());
        }
        self.next = done + BETWEEN;
        self.part = self.part.max(self.from + (self.to - self.from) * (done as f32 / of.max(1) as f32).min(1.0));
        self.ask()
    }

    /// One more of nobody knows how many.
    #[inline]
    pub(super) fn step(&mut self) -> Result<(), ObjError> {
        self.steps += 1;
        if self.steps < PATIENCE {
            return Ok(());
        }
        self.steps = 0;
        self.ask()
    }

    fn ask(&mut self) -> Result<(), ObjError> {
        if (self.tell)(self.part) { Ok(()) } else { Err(ObjError::Cancelled) }
    }
}
