//! How well something on a board is known: what is measured comes late, and from few rays first.

use crate::page::{Figure, Look};
use crate::words::ROUGH;

/// How well something on a board is known.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Known {
    /// It is still to be measured: its room waits.
    NotYet,
    /// Few rays have told it: nobody should quote it.
    Roughly,
    /// It does not change any more.
    #[default]
    Fully,
}

/// What stands for a number that is still to be measured.
pub(super) const WAITS: &str = "\u{2026}";

/// What the signs mean, once for a panel: those of what is seen of it.
pub(super) fn legend(known: impl Iterator<Item = Known>) -> Option<String> {
    let mut said = known.filter(|known| *known != Known::Fully).collect::<Vec<_>>();
    said.sort_by_key(|known| *known != Known::Roughly);
    match said.first()? {
        Known::Roughly => Some(format!("{ROUGH} from few rays so far")),
        _ => Some(format!("{WAITS} not measured yet")),
    }
}

/// The heading of a panel, with what the signs mean behind what it is about; where both have no room, instead of it.
pub(super) fn heading(look: &Look, figure: &mut Figure, title: &str, about: &str, legend: Option<String>) -> f32 {
    match legend {
        None => look.heading(figure, title, about),
        Some(legend) if about.is_empty() => look.heading(figure, title, &legend),
        Some(legend) => {
            let both = format!("{legend} · {about}");
            let fits = look.has_room(figure, title, &both);
            look.heading(figure, title, if fits { &both } else { &legend })
        }
    }
}
