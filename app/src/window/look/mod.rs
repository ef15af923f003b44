//! How the window looks: colours, letters, formulas, figures and controls, and what of that is remembered.

pub(super) mod controls;
mod desktop;
pub(super) mod fonts;
pub(super) mod formulas;
pub(super) mod icons;
mod images;
pub(super) mod markdown;
pub(super) mod outline;
pub(super) mod painter;
pub(super) mod prose;
pub(super) mod remembered;
pub(super) mod tex;
pub(super) mod typed;
pub(super) mod visuals;
pub(super) mod words;
