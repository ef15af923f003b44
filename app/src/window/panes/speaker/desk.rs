//! What the speaker's window is given, and what it asks for.

use egui::scroll_area::ScrollAreaOutput;
use egui::{Align2, Pos2, Rect, Ui, Vec2, pos2, vec2};
use raystep_figure::{Face, Role};

use crate::shown::command::Command;
use crate::shown::state::State;
use crate::shown::talk::Talk;
use crate::window::look::painter::caption;
use crate::window::look::visuals::fill;
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

/// Says at the foot of what can be scrolled that there is more, as long as there is.
pub(super) fn more_below<R>(ui: &Ui, desk: &Desk<'_>, scrolled: &ScrollAreaOutput<R>, ground: Role) {
    let seen = scrolled.inner_rect;
    if scrolled.content_size.y - scrolled.state.clamped_offset().y <= seen.height() + 1.0 {
        return;
    }
    let theme = desk.wall.theme;
    let foot = Rect::from_min_max(pos2(seen.left(), seen.bottom() - MORE), seen.max);
    ui.painter().rect_filled(foot, 0.0, fill(theme, ground));
    caption(ui.painter(), foot.center(), Align2::CENTER_CENTER, MORE_BELOW, Face::Medium, 12.5, Role::Quiet, theme);
}

/// How high the foot is that says so, in points.
const MORE: f32 = 20.0;

/// What it says.
pub(super) const MORE_BELOW: &str = "▼  more below";
