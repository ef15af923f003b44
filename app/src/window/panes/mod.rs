//! The panes: the lesson, space, and the figures around it, as a study page or as the presenter's.

pub(super) mod columns;
pub(super) mod lesson;
pub(super) mod present;
pub(super) mod question;
mod rival;
pub(super) mod solid;
pub(super) mod space;
pub(super) mod stage;
