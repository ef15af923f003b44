//! Boards: tables, charts, heat maps and pictures that a slide fills row by row and point by point, printed numbers beside those that
//! follow from them and those that are measured here; and a meter, whose numbers are moved by hand.

mod camera;
mod care;
mod chart;
mod filling;
mod formula;
mod maps;
mod measure;
mod meter;
mod panel;
mod picture;
mod rendered;
mod rows;
mod smooth;
mod standing;
mod table;
mod tape;
mod telling;
mod through;
mod timing;

pub use care::Care;
pub use chart::{Chart, Drawn, Scale, Stroke};
pub use formula::Formula;
pub use maps::{Map, Maps};
pub use measure::{Counted, How, Measured};
pub use meter::{Given, Meter, Number, Numbers};
pub use panel::{Board, Entry, Panel};
pub use picture::{Picture, Pictures};
pub use rendered::Rendered;
pub use table::{Cell, Column, Lanes, Row, Runs, Table};
pub use tape::BoardTape;
pub use timing::{Stopwatch, Timed, Timing};

pub(crate) use panel::read;
