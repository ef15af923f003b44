//! Figures as files, without a GPU: SVG, PDF, PNG, APNG, GIF, JSON.
//!
//! A [`Figure`](raystep_figure::Figure) becomes an SVG file in which every letter is an outline from the
//! shipped fonts, so that it looks the same wherever it is opened; every picture of pixels is that SVG file,
//! drawn in software. Letters as text are asked for, and stand in PDF files. The same figure gives the same bytes.

mod bounds;
mod decimal;
mod escaped;
mod film;
mod formula;
mod formula_svg;
mod glyphs;
mod json;
mod label;
mod leaf;
mod letters;
mod pdf;
mod pixels;
mod plate;
mod png;
mod proof;
mod prose;
mod stack;
mod svg;
mod typefaces;
mod webfont;

pub use bounds::{around, drawn, part};
pub use film::{Apng, Frame, Gif, Palette, Tally, frame};
pub use formula::{Extent, Unset, extent};
pub use formula_svg::formula;
pub use glyphs::Lettering;
pub use json::{Record, Told, json};
pub use leaf::{Leaf, Passage, Reading};
pub use letters::{Letters, Shift, letters};
pub use pdf::{pdf, pdf_pages};
pub use plate::{Part, Plate, enlarge, plate, set_in};
pub use png::{PrintError, png};
pub use proof::{proof, proof_code, proof_plain};
pub use prose::prose;
pub use stack::{Layer, stack};
pub use svg::{Manner, drawing, svg};
