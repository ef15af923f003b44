//! A beat: a heading of a slide, and the event it waits for.

use crate::{Ask, Condition, Facts, Offer, Spot, Wait, template};

/// The walk plays on to the next such event, and this is said there.
#[derive(Clone, Debug, PartialEq)]
pub struct Beat {
    /// Its heading.
    pub title: String,
    /// What it waits for.
    pub at: Wait,
    /// What it waits for on the solid stage, if that is another one of the same events.
    pub at_solid: Option<Wait>,
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
    /// Markdown with `{{fact}}`, and formulas between `$` or `$$`.
    pub text: String,
    /// Said only if this holds.
    pub only_if: Option<Condition>,
    /// Said only here.
    pub only_in: Option<Medium>,
    /// What it offers to do, in the window.
    pub offers: Vec<Offer>,
    /// Where it begins.
    pub(crate) spot: Spot,
    /// Where each of its lines begins.
    pub(crate) lines: Vec<Spot>,
}

/// Where a text is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Medium {
    /// In a window, where something can be done about it.
    Window,
    /// On the wall before a class: what is for a window is not said, since nobody there has a mouse.
    Wall,
    /// On paper, which shows what it has to show.
    Paper,
}

impl Beat {
    /// What it waits for in a flat scene, or in a solid one.
    pub fn wait(&self, flat: bool) -> &Wait {
        self.at_solid.as_ref().filter(|_| !flat).unwrap_or(&self.at)
    }

    /// What the beat says at its event: Markdown, its `{{fact}}` not yet filled in.
    pub fn text(&self, facts: &Facts<'_>, medium: Medium) -> String {
        let said = self.said(facts, medium).map(|paragraph| paragraph.text.as_str()).filter(|text| !text.is_empty());
        said.collect::<Vec<_>>().join("\n\n")
    }

    /// What the beat offers to do at its event, in the window.
    pub fn offers(&self, facts: &Facts<'_>) -> impl Iterator<Item = &Offer> {
        self.said(facts, Medium::Window).flat_map(|paragraph| &paragraph.offers)
    }

    fn said(&self, facts: &Facts<'_>, medium: Medium) -> impl Iterator<Item = &Paragraph> {
        self.paragraphs
            .iter()
            .filter(move |paragraph| paragraph.is_for(medium))
            .filter(|paragraph| paragraph.is_said(facts))
    }
}

impl Paragraph {
    /// Whether it is for those who read there.
    fn is_for(&self, medium: Medium) -> bool {
        match (self.only_in, medium) {
            (None, _) => true,
            (Some(only), here) => only == here,
        }
    }

    /// Whether it is said: its condition holds, and all that it names has happened.
    fn is_said(&self, facts: &Facts<'_>) -> bool {
        self.is_asked_for(facts) && self.is_known(facts)
    }

    /// Whether its condition holds.
    pub(crate) fn is_asked_for(&self, facts: &Facts<'_>) -> bool {
        self.only_if.as_ref().is_none_or(|condition| condition.holds(facts))
    }

    /// Whether all that it names has happened.
    pub(crate) fn is_known(&self, facts: &Facts<'_>) -> bool {
        self.is_known_but(facts, &|_| false)
    }

    /// Whether all that it names has happened, but for what may come later.
    pub(crate) fn is_known_but(&self, facts: &Facts<'_>, later: &dyn Fn(&str) -> bool) -> bool {
        template::named(&self.text).all(|name| facts.field(name).is_some() || later(name))
    }
}
