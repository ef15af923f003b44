//! A beat: a heading of a slide, and the event it waits for.

use raystep_accel::Event;

use crate::{Ask, Spot, StageKind, Wait, wait};

/// The walk plays on to the next such event, and this is said there.
#[derive(Clone, Debug, PartialEq)]
pub struct Beat {
    /// Its heading.
    pub title: String,
    /// What it waits for.
    pub at: Wait,
    /// The ray it wants; none for the one before it.
    pub ray: Option<String>,
    /// What it says.
    pub paragraphs: Vec<Paragraph>,
    /// What it asks before the step.
    pub ask: Option<Ask>,
    /// Where its heading stands.
    pub(crate) spot: Spot,
    /// Where its title stands.
    pub(crate) title_spot: Spot,
    /// Where its ray is named.
    pub(crate) ray_spot: Spot,
}

/// Part of a beat's text.
#[derive(Clone, Debug, PartialEq)]
pub struct Paragraph {
    /// Markdown with `{{field}}` of the event, and formulas between `$` or `$$`.
    pub text: String,
    /// Said only if this field has this value, the `event` this name, or the `stage` is of this kind.
    pub only_if: Option<(String, String)>,
    /// Where each of its lines begins.
    pub(crate) lines: Vec<Spot>,
}

impl Beat {
    /// What the beat says at its event on a stage: Markdown, its `{{field}}` not yet filled in.
    pub fn text(&self, event: &Event, stage: StageKind) -> String {
        let said = |paragraph: &&Paragraph| match &paragraph.only_if {
            None => true,
            Some((field, name)) if field == "stage" => name == stage.name(),
            Some((field, name)) if field == "event" => wait::names(name, event.name()),
            Some((field, text)) => event.field(field).is_some_and(|value| wait::says(&value, text)),
        };
        self.paragraphs.iter().filter(said).map(|paragraph| paragraph.text.as_str()).collect::<Vec<_>>().join("\n\n")
    }
}
