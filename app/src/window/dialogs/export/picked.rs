//! What makes no sense for what is chosen, with the sentence why: it is greyed.

use super::form::{Form, Page, Which};
use crate::export::{Format, View};

impl Form {
    /// The steps that are written: a film of one step is none.
    pub(super) fn chosen(&self) -> Which {
        match self.which {
            _ if self.format == Format::Json => Which::Beats,
            Which::This if self.format.is_film() => Which::Beats,
            which => which,
        }
    }

    /// Why no steps are chosen.
    pub(super) fn steps_matter(&self) -> Option<&'static str> {
        (self.format == Format::Json).then_some("A JSON file holds all steps.")
    }

    /// Why it cannot be the step that is shown.
    pub(super) fn one_step(&self) -> Option<&'static str> {
        self.steps_matter().or(self.format.is_film().then_some("A film holds many steps."))
    }

    /// Why nothing is drawn.
    pub(super) fn draws(&self) -> Option<&'static str> {
        (self.format == Format::Json).then_some("A JSON file holds the walk, no picture.")
    }

    /// Why such files are not written here.
    pub(super) fn writes(&self, format: Format) -> Option<&'static str> {
        let missing = "Videos are written by ffmpeg, which was not found on this machine: install it, or choose GIF.";
        (format.is_video() && !self.videos).then_some(missing)
    }

    /// Why the signs are not explained.
    pub(super) fn explains(&self) -> Option<&'static str> {
        let has = matches!(self.page, Page::Own | Page::View(View::Plate | View::Space));
        self.draws().or((!has).then_some("Plates and space have a legend, other views have none."))
    }

    /// Why letters are what they are.
    pub(super) fn spells(&self) -> Option<&'static str> {
        match self.format {
            Format::Svg => None,
            Format::Pdf => Some("A PDF file has text anyhow."),
            _ => Some("Only an SVG file has letters as text."),
        }
    }

    /// Why the ground stays.
    pub(super) fn bares(&self) -> Option<&'static str> {
        self.draws().or(self.format.is_video().then_some("A video has a ground."))
    }

    /// Why no steps are left out.
    pub(super) fn leaves_out(&self) -> Option<&'static str> {
        let many = self.format.is_film() || self.chosen() == Which::Steps;
        self.steps_matter().or((!many).then_some("Steps are left out of films, and of steps that are named."))
    }

    /// Why nothing moves.
    pub(super) fn moves(&self) -> Option<&'static str> {
        (!self.format.is_film()).then_some("Only a film shows one step after the other.")
    }
}
