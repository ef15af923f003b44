//! What the speaker's window is given, and what it asks for.

use egui::{Align2, Pos2, Ui, Vec2, vec2};
use raystep_figure::{Face, Role};

use crate::shown::command::Command;
use crate::shown::state::State;
use crate::shown::talk::Talk;
use crate::window::look::painter::caption;
use crate::window::panes::page::{Asked, Page};
use crate::window::work::thumbs::Thumbs;

/// What the speaker's window shows.
pub(crate) struct Desk<'a> {
    /// What the class sees, unless its page is held.
    pub(crate) wall: Page<'a>,
    /// The beat that comes next; none after the last slide.
    pub(crate) next: Option<&'a State>,
    /// The size of the class's page, in points.
    pub(crate) class: Vec2,
    pub(crate) talk: &'a Talk,
    /// Seconds on the talk's clock, and the time of the day.
    pub(crate) now: f64,
    pub(crate) clock: &'a str,
    pub(crate) thumbs: &'a Thumbs,
}

/// What was asked for.
#[derive(Debug)]
pub(crate) enum AskedHere {
    /// Something in the picture of the class's page.
    Wall(Asked),
    /// A command.
    Command(Command),
    /// A slide, by its place.
    Slide(usize),
    /// A step.
    Step(usize),
    /// A longer talk, or a shorter one.
    Lengthen(bool),
    /// The talk has so many minutes.
    Length(f32),
    /// The time begins anew.
    Restart,
}

/// The name of a part of the window.
pub(super) fn heading(ui: &Ui, desk: &Desk<'_>, at: Pos2, says: &str) {
    caption(
        ui.painter(),
        at + vec2(0.0, 10.0),
        Align2::LEFT_CENTER,
        says,
        Face::Bold,
        13.5,
        Role::Quiet,
        desk.wall.theme,
    );
}
