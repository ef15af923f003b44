//! The state of a reel at one step, of whatever kind.

use std::any::Any;
use std::fmt::Debug;

/// The state of a reel after some of its steps.
#[derive(Clone, Debug)]
pub struct Instant {
    step: usize,
    state: Box<dyn State>,
}

/// What a kind keeps of an instant.
trait State: Any + Debug + Send + Sync {
    fn copied(&self) -> Box<dyn State>;
}

impl<S: Any + Clone + Debug + Send + Sync> State for S {
    fn copied(&self) -> Box<dyn State> {
        Box::new(self.clone())
    }
}

impl Clone for Box<dyn State> {
    fn clone(&self) -> Self {
        (**self).copied()
    }
}

impl Instant {
    /// A state before the first step.
    pub fn new(state: impl Any + Clone + Debug + Send + Sync) -> Instant {
        Instant { step: 0, state: Box::new(state) }
    }

    /// How many steps have happened.
    pub fn step(&self) -> usize {
        self.step
    }

    /// So many steps have happened; steps already taken are not taken back.
    pub(super) fn reach(&mut self, step: usize) {
        self.step = self.step.max(step);
    }

    /// What the kind keeps of it.
    ///
    /// # Panics
    /// If the instant is of another kind: it belongs to the reel that made it.
    pub fn state<S: Any>(&self) -> &S {
        let state: &dyn Any = &*self.state;
        state.downcast_ref().expect("an instant belongs to the reel that made it")
    }

    /// The same, to be changed.
    ///
    /// # Panics
    /// As [`state`](Instant::state) does.
    pub fn state_mut<S: Any>(&mut self) -> &mut S {
        let state: &mut dyn Any = &mut *self.state;
        state.downcast_mut().expect("an instant belongs to the reel that made it")
    }
}
