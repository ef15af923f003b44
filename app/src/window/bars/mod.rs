//! The bars at the top and at the bottom.

pub(super) mod bottom;
pub(super) mod go_on;
pub(super) mod top;
