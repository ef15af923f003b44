//! Which structure is best? All of them over one scene and the same rays: what each costs, in a table, a chart and a
//! sentence.

mod candidate;
mod drawn;
mod measure;
mod told;

pub(crate) use candidate::Candidate;
pub(crate) use drawn::Rating;
pub(crate) use measure::{Rated, rate, rays};
pub(crate) use told::told;
