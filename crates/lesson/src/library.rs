//! All slides and listings.

use crate::{Listing, Problem, Slide};

/// The lessons, sorted as they are taught.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Library {
    /// The slides that could be read, in order.
    pub slides: Vec<Slide>,
    /// The listings.
    pub listings: Vec<Listing>,
    /// What could not be read.
    pub problems: Vec<Problem>,
}

impl Library {
    /// The listing of that name.
    pub fn listing(&self, name: &str) -> Option<&Listing> {
        self.listings.iter().find(|listing| listing.name == name)
    }

    /// The slide called `"5/33"`, `"05-kd-tree/33-which-child-first"` or `"33-which-child-first"`.
    pub fn slide(&self, id: &str) -> Option<&Slide> {
        self.slides.iter().find(|slide| {
            slide.id() == id || slide.name == id || id.split_once('/') == Some((&slide.section, &slide.name))
        })
    }
}
