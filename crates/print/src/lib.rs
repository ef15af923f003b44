//! Figures as files, without a GPU: SVG, PNG, APNG, GIF, JSON.
//!
//! A [`Figure`](raystep_figure::Figure) becomes an SVG file in which every letter is an outline from the
//! shipped fonts, so that it looks the same wherever it is opened; every other picture is that SVG file,
//! drawn in software. The same figure gives the same bytes.

mod decimal;
mod formula;
mod glyphs;
mod json;
mod letters;
mod movie;
mod pixels;
mod plate;
mod png;
mod proof;
mod prose;
mod stack;
mod svg;
mod typefaces;

pub use formula::{Extent, Unset, extent, formula};
pub use json::{Record, Told, json};
pub use letters::{Letters, Shift, letters};
pub use movie::{apng, gif};
pub use plate::{Plate, enlarge, plate, set_in};
pub use png::{PrintError, png};
pub use proof::{proof, proof_code, proof_plain};
pub use prose::prose;
pub use stack::{Layer, stack};
pub use svg::svg;
