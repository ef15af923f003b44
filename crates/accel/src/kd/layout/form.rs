//! What the four forms of a node have in common.

use super::{Addresses, NodeField};
use crate::bsp::Kind;
use crate::kd::Upright;

/// A way to write down what a node says.
pub(super) trait Form: Sized {
    /// Its fields, in order.
    const FIELDS: &'static [NodeField];

    /// Writes a node down.
    fn pack(kind: Kind<Upright>, addresses: &Addresses) -> Self;

    /// Says what is written.
    fn unpack(self, addresses: &Addresses) -> Kind<Upright>;

    /// What stands in its fields.
    fn words(self) -> impl Iterator<Item = u32>;

    /// The form with these words in its fields, `next` after `next`.
    fn read(next: impl FnMut() -> u32) -> Self;
}
