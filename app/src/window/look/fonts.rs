//! The shipped faces as egui's font families, the same as in exported files.

use std::sync::Arc;

use egui::{FontData, FontDefinitions, FontFamily, FontId};
use raystep_figure::{Face, fonts};

/// The family that sets a face.
pub(crate) fn family(face: Face) -> FontFamily {
    match face {
        Face::Regular => FontFamily::Proportional,
        Face::Mono => FontFamily::Monospace,
        other => FontFamily::Name(name(other).into()),
    }
}

/// A face at a size in points.
pub(crate) fn font(face: Face, size: f32) -> FontId {
    FontId::new(size, family(face))
}

/// Every face, each followed by the others in case it lacks a sign.
pub(crate) fn definitions() -> FontDefinitions {
    let mut definitions = FontDefinitions::empty();
    for face in Face::ALL {
        definitions.font_data.insert(name(face).to_owned(), Arc::new(FontData::from_static(fonts::bytes(face))));
        let fallbacks = [Face::Regular, Face::Mono].into_iter().filter(|&other| other != face);
        let faces = std::iter::once(face).chain(fallbacks).map(|face| name(face).to_owned()).collect();
        definitions.families.insert(family(face), faces);
    }
    definitions
}

fn name(face: Face) -> &'static str {
    match face {
        Face::Regular => "regular",
        Face::Medium => "medium",
        Face::Bold => "bold",
        Face::Italic => "italic",
        Face::Mono => "mono",
        Face::MonoMedium => "mono-medium",
    }
}
