//! Who watches an algorithm: nobody, a counter, a tape, or several at once.

use std::cmp::Ordering;

/// Receives what an algorithm does, in the order it does it.
pub trait Observer<E> {
    /// The next event.
    fn on(&mut self, event: E);

    /// Whether a builder should give up. Asked about once per node, and now and then where a node holds many
    /// primitives, but never for each of them.
    fn cancelled(&self) -> bool {
        false
    }
}

/// So many items are handed on between two questions.
pub(crate) const BETWEEN_LOOKS: usize = 256;

/// Hands on items, and asks now and then whether to give up: no long list makes a builder deaf. Short ones ask
/// nothing, as builders ask once per node anyway.
pub(crate) fn patiently<E, T>(
    items: impl IntoIterator<Item = T>,
    watch: &impl Observer<E>,
) -> impl Iterator<Item = Result<T, Cancelled>> {
    let look = |(i, item)| if (i + 1) % BETWEEN_LOOKS == 0 && watch.cancelled() { Err(Cancelled) } else { Ok(item) };
    items.into_iter().enumerate().map(look)
}

/// Sorts pieces of a list, then ever longer ones, and asks before each whether to give up. Equal items stay as they
/// were. A stable sort finds what is in order already, so longer pieces are only merged.
pub(crate) fn sort_patiently<E, T>(
    items: &mut [T],
    watch: &impl Observer<E>,
    order: impl Fn(&T, &T) -> Ordering,
) -> Result<(), Cancelled> {
    let mut length = 1 << 14;
    loop {
        for piece in items.chunks_mut(length) {
            if watch.cancelled() {
                return Err(Cancelled);
            }
            piece.sort_by(&order);
        }
        if length >= items.len() {
            return Ok(());
        }
        length *= 2;
    }
}

/// The builder was told to give up by its observer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cancelled;

impl std::fmt::Display for Cancelled {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("cancelled")
    }
}

impl std::error::Error for Cancelled {}

/// Nobody: compiles to nothing.
impl<E> Observer<E> for () {
    #[inline(always)]
    fn on(&mut self, _: E) {}
}

/// A plain tape without a limit.
impl<E> Observer<E> for Vec<E> {
    fn on(&mut self, event: E) {
        self.push(event);
    }
}

/// Pass on.
impl<E, O: Observer<E> + ?Sized> Observer<E> for &mut O {
    fn on(&mut self, event: E) {
        (**self).on(event);
    }

    fn cancelled(&self) -> bool {
        (**self).cancelled()
    }
}

/// Both.
impl<E: Copy, A: Observer<E>, B: Observer<E>> Observer<E> for (A, B) {
    fn on(&mut self, event: E) {
        self.0.on(event);
        self.1.on(event);
    }

    fn cancelled(&self) -> bool {
        self.0.cancelled() || self.1.cancelled()
    }
}

/// Calls a closure with each event.
pub struct Each<F>(pub F);

impl<E, F: FnMut(E)> Observer<E> for Each<F> {
    fn on(&mut self, event: E) {
        (self.0)(event);
    }
}
