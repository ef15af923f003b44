//! The panes: the lesson, space, and the figures around it, as a study page or as the presenter's.

mod by_hand;
mod columns;
mod figure;
mod inset;
mod lesson;
mod levels;
mod notices;
mod page;
pub(super) mod present;
mod question;
mod rival;
mod sight;
mod solid;
mod space;
mod speech;
mod stage;
pub(super) mod study;

pub(super) use page::{Asked, Kept, Page};
