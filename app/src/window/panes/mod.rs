//! The panes: the lesson, space, and the figures around it, as a study page or as the presenter's.

mod abreast;
mod abreast_kept;
mod bill;
mod by_hand;
mod changes;
mod columns;
mod figure;
mod grip;
mod heat;
mod heat_kept;
mod hold;
mod inset;
mod knob;
mod lesson;
mod levels;
mod meter;
mod moving;
mod notices;
mod page;
pub(super) mod present;
mod question;
mod rival;
mod sight;
mod solid;
mod space;
pub(super) mod speaker;
mod spoken;
mod stage;
pub(super) mod study;
mod trial;
mod underway;

pub(super) use hold::Moved;
pub(super) use notices::Notices;
pub(super) use page::{Asked, Kept, Page};
