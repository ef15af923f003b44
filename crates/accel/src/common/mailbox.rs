//! Mailboxes: how a ray knows that it tested a primitive already, though several cells refer to it.

use crate::{Best, Observer, PrimId, Primitives, Ray, Visit, test};

/// The lecture's mailbox sits at the primitive and holds the last ray's number, so that no two rays can
/// walk at once. This one is turned around (Shevtsov, Soupikov, Kapustin 2007): it sits on the walk's own
/// stack and holds primitives. It may forget one, which costs a second test and changes no answer.
pub(crate) struct Mailbox {
    slots: [u32; Mailbox::SLOTS],
}

impl Mailbox {
    const SLOTS: usize = 64;

    /// Nothing tested yet.
    #[inline]
    pub(crate) fn new() -> Mailbox {
        Mailbox { slots: [u32::MAX; Mailbox::SLOTS] }
    }

    /// Whether `prim` is known to have been tested.
    #[inline]
    pub(crate) fn holds(&self, prim: PrimId) -> bool {
        self.slots[prim.index() % Mailbox::SLOTS] == prim.0
    }

    /// Notes that `prim` was tested.
    #[inline]
    pub(crate) fn put(&mut self, prim: PrimId) {
        self.slots[prim.index() % Mailbox::SLOTS] = prim.0;
    }
}

/// Tests what a leaf refers to, one after the other, but not what the mailbox holds; stops as soon as a
/// shadow ray has its answer.
#[inline(always)]
pub(crate) fn test_each(
    refs: &[PrimId],
    mut mailbox: Option<&mut Mailbox>,
    prims: &impl Primitives,
    ray: &Ray,
    best: &mut Best,
    watch: &mut impl Observer<Visit>,
) {
    for &prim in refs {
        if let Some(mailbox) = &mut mailbox {
            if mailbox.holds(prim) {
                watch.on(Visit::Skip { prim });
                continue;
            }
            mailbox.put(prim);
        }
        test(prims, prim, ray, best, watch);
        if best.answered() {
            return;
        }
    }
}
