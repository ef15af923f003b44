//! The presenter's page: title, space, what is said or asked, and below space the panes that the slide is about. Nothing
//! is cut off, nothing tells of keys.

mod heading;
mod marks;
mod notes;
mod strip;

use egui::{Align2, Color32, Rect, Ui, pos2, vec2};
use raystep_accel::Place;
use raystep_figure::{Face, Look, Role, changed_height};

use super::figure::figure;
use super::page::{Asked, Kept, Page};
use super::space::glam_size;
use super::spoken::{Column, Fitted, Room, Speech};
use super::stage;
use crate::shown::awaited::awaited;
use crate::shown::lecture::Cover;
use crate::shown::pictures::Pane;
use crate::window::look::painter::caption;
use crate::window::look::visuals::fill;
pub(crate) use marks::Marks;
use strip::Strip;

/// The size of the page's letters: a twenty-seventh of its height, where it is not very narrow.
fn letters(rect: Rect) -> f32 {
    (rect.height() / 27.0).min(rect.width() / 36.0)
}

/// Room above and below a picture, in letters.
const INSET: f32 = 0.2;

/// The least part of the page's height that space keeps beside two rows of panes.
const SPACE: f32 = 0.38;

/// Shows the page in all the room there is; says which place the pointer is on.
pub(crate) fn page(
    ui: &mut Ui,
    page: Page<'_>,
    kept: &mut Kept,
    marks: &mut Marks,
    asked: &mut Vec<Asked>,
) -> Option<Place> {
    let rect = ui.available_rect_before_wrap();
    if let Some(cover) = page.state.lecture.cover.filter(|_| !kept.uncovered) {
        let color = if cover == Cover::Black { Color32::BLACK } else { Color32::WHITE };
        ui.painter().rect_filled(rect, 0.0, color);
        return None;
    }
    ui.painter().rect_filled(rect, 0.0, fill(page.theme, Role::Page));
    let body = letters(rect);
    let inner = rect.shrink2(vec2(body * 1.4, body));
    let (top, foot) = (inner.top() + body * 2.0, inner.bottom() - body * 1.3);
    heading::show(ui, page, Rect::from_min_max(inner.min, pos2(inner.right(), top)), body);

    let strip = Strip::of(page.state, kept.pictures.as_ref(), inner.size(), body);
    let bottom = foot - strip.height();
    let share = |column: Column| top + (bottom - top) * column.above;
    let wide = |column: Column| inner.width() * column.part;
    let floor = |column: Column| if column.tall { foot } else { bottom };
    let words = |column: Column| vec2(wide(column), floor(column) - share(column) - body * 0.8);
    // A picture stands beside what is said of it, or above: as it is seen best.
    let picture = |column: Column| {
        let (right, low) = match column.above > 0.0 {
            true => (inner.right(), share(column)),
            false => (inner.right() - wide(column) - body, bottom),
        };
        Rect::from_min_max(pos2(inner.left(), top), pos2(right, low)).shrink2(vec2(0.0, body * INSET))
    };
    let look = stage::look_of_picture(true, picture(Column::USUAL).height(), body / 19.0);
    let worth =
        |column: Column| kept.pictures.as_ref().and_then(|shown| shown.worth(glam_size(picture(column)), &look));
    let room = Room { body, words: &words, worth: &worth };
    let fitted = Fitted::of(kept.column.take(), ui, page.state, &mut kept.formulas, page.theme, &room);
    let column = fitted.as_ref().map_or(Column::USUAL, |fitted| fitted.column);
    kept.column = fitted;
    let side = wide(column);
    let strip = if column.tall {
        strip.stacked(inner.width() - side - body, foot - top, inner.height() * SPACE)
    } else {
        strip
    };
    let bottom = foot - strip.height();
    let under_it = column.above > 0.0;
    let left = if under_it { inner.right() } else { inner.right() - side - body };
    let space = Rect::from_min_max(pos2(inner.left(), top), pos2(left, if under_it { share(column) } else { bottom }));
    let corner = if under_it { pos2(inner.left(), share(column)) } else { pos2(left + body, top) };
    let words = Rect::from_min_max(corner + vec2(0.0, body * 0.4), pos2(inner.right(), floor(column)));
    let below =
        Rect::from_min_max(pos2(inner.left(), bottom), pos2(if column.tall { left } else { inner.right() }, foot));

    let mut under = stage::stage(ui, page, kept, space.shrink2(vec2(0.0, body * INSET)), false, body / 19.0, asked);
    under = strip.show(ui, page, kept, below, body, asked).or(under);
    under = side_page(ui, page, kept, words, body, column, asked).or(under);
    says_so_far(ui, page, kept, Rect::from_min_max(pos2(inner.left(), foot), inner.max), body);
    heading::way_back(ui, page, rect, body, asked);
    if page.state.lecture.notes {
        notes::over(ui, page, kept, rect, body);
    }
    marks.show(ui, page, rect, body);
    under
}

/// A picture that comes within so many seconds is not announced.
const WAITS: f32 = 0.6;

/// What has been done so far.
fn says_so_far(ui: &Ui, page: Page<'_>, kept: &Kept, rect: Rect, body: f32) {
    let Some(pictures) = &kept.pictures else { return };
    let (playback, step) = (&pictures.playback, page.state.view.step);
    // What would answer a question is left out, and nothing says so.
    let tally = Some(pictures.tally()).filter(|tally| page.state.question().is_none() && !tally.is_empty());
    let tally = tally.map_or_else(String::new, |tally| format!(" · {tally}"));
    // What is on its way for longer than a moment is waited for; nobody in a class need wonder why nothing moves.
    let waits = ui.ctx().animate_bool_with_time(ui.scope_id().with("waits"), page.making, WAITS) >= 1.0;
    let awaited = match page.state.wanted() {
        Some(_) => Some("the next picture is being made …"),
        None => awaited(playback, step),
    };
    let says = match awaited.filter(|_| waits && page.making) {
        Some(awaited) => awaited.to_owned(),
        None => format!("step {step} of {}{tally}", playback.steps().last()),
    };
    let at = rect.left_center() + vec2(0.0, body * 0.3);
    caption(ui.painter(), at, Align2::LEFT_CENTER, &says, Face::Regular, body * 0.68, Role::Quiet, page.theme);
}

/// What is said or asked, and in the room that is left below it what changed.
fn side_page(
    ui: &mut Ui,
    page: Page<'_>,
    kept: &mut Kept,
    rect: Rect,
    body: f32,
    column: Column,
    asked: &mut Vec<Asked>,
) -> Option<Place> {
    let prose = column.set(page.theme, body);
    let pages = Speech::of(page.state).pages(ui, &mut kept.formulas, &prose, rect.size());
    let at = kept.pages.at(page.state, pages.len());
    let mut child = ui.new_child(egui::UiBuilder::new().max_rect(rect));
    let speech = pages.get(at)?;
    // Nobody in a class presses a button: they are there for the hand that moves the mouse.
    let offers = kept.uncovered || ui.input(|input| input.pointer.has_pointer());
    asked.extend(speech.show(&mut child, &mut kept.formulas, &prose, offers).map(Asked::Command));
    let end = child.min_rect().bottom();
    if pages.len() > 1 {
        let says = format!("{} of {}", at + 1, pages.len());
        let at = rect.right_bottom();
        caption(ui.painter(), at, Align2::RIGHT_BOTTOM, &says, Face::Medium, body * 0.68, Role::Quiet, page.theme);
        return None;
    }
    let look = Look { text: body * 0.62, titles: true, least: 0.0 };
    let pictures = kept.pictures.as_ref()?;
    let rest = (rect.bottom() - end - body * 0.6).min(changed_height(6, &look));
    let changed = pictures.has(Pane::Changed) && pictures.changes();
    // A question is thought about by itself.
    let asks = page.state.question().is_some() || page.state.is_settled();
    let shows = changed && rest >= changed_height(2, &look) && !asks;
    let below = Rect::from_min_max(pos2(rect.left(), rect.bottom() - rest), rect.max);
    shows.then(|| figure(ui, page, kept, Pane::Changed, below, &look, asked)).flatten()
}
