//! The speaker's window: what is on the wall, what comes next, the notes, the time, and the right answer. Only the speaker
//! sees it.

mod answer;
mod buttons;
mod desk;
mod next;
mod notes;
mod slides;
mod small;
mod time;

use desk::heading;
pub(crate) use desk::{AskedHere, Desk};
pub(crate) use slides::SHOWN;

use egui::{Id, Pos2, Rect, Stroke, StrokeKind, Ui, pos2, vec2};
use raystep_figure::Role;

use super::page::{Asked, Kept};
use super::present::{self, Marks};
use super::underway;
use crate::shown::lecture::Cover;
use crate::window::look::visuals::{fill, ink, line};

/// What the window keeps from frame to frame.
pub(crate) struct DeskKept {
    /// Of the picture of the class's page.
    pub(crate) wall: Kept,
    /// Of the picture of what comes next.
    pub(crate) next: Kept,
    /// How large the notes are.
    pub(crate) letters: f32,
}

impl Default for DeskKept {
    fn default() -> DeskKept {
        let mut wall = Kept::default();
        wall.uncovered = true;
        DeskKept { wall, next: Kept::default(), letters: 17.0 }
    }
}

/// Shows the window.
pub(crate) fn page(ui: &mut Ui, desk: &Desk<'_>, kept: &mut DeskKept, marks: &mut Marks, asked: &mut Vec<AskedHere>) {
    let theme = desk.wall.theme;
    ui.painter().rect_filled(ui.max_rect(), 0.0, fill(theme, Role::Page));
    asked.extend(underway::strip(ui, desk.wall.tasks, theme).map(|task| AskedHere::Wall(Asked::Stop(task))));
    kept.wall.notices.strip(ui, theme);
    let rect = ui.available_rect_before_wrap();
    let top = Rect::from_min_max(rect.min, pos2(rect.right(), rect.top() + 58.0));
    time::bar(ui, desk, top, asked);
    let low = (rect.height() * 0.255).clamp(150.0, 240.0);
    let below = Rect::from_min_max(pos2(rect.left(), rect.bottom() - low), rect.max);
    let middle = Rect::from_min_max(top.left_bottom(), below.right_top());
    let (left, right) = middle.split_left_right_at_fraction(0.52);
    rule(ui, desk, [middle.left_top(), middle.right_top()]);
    rule(ui, desk, [below.left_top(), below.right_top()]);
    rule(ui, desk, [right.left_top(), right.left_bottom()]);

    let left = left.shrink2(vec2(18.0, 10.0));
    let says = match desk.wall.state.lecture.cover {
        Some(Cover::Black) => "Black on the wall; below it",
        Some(Cover::White) => "White on the wall; below it",
        None if desk.wall.state.lecture.frozen => "Yours alone: the class's page is held",
        None => "On the wall now",
    };
    heading(ui, desk, left.min, says);
    let aspect = desk.class.x / desk.class.y;
    let wide = left.width().min((left.height() * 0.66) * aspect);
    let wall = Rect::from_min_size(left.min + vec2(0.0, 24.0), vec2(wide, wide / aspect));
    let mut happened = Vec::new();
    small::small(ui, Id::unique("wall"), wall, desk.class, |ui| {
        present::page(ui, desk.wall, &mut kept.wall, marks, &mut happened);
    });
    asked.extend(happened.into_iter().map(AskedHere::Wall));
    ui.painter().rect_stroke(wall.expand(1.5), 0.0, Stroke::new(1.5, ink(theme, Role::Text)), StrokeKind::Outside);
    let card = Rect::from_min_max(pos2(left.left(), wall.bottom() + 16.0), left.max);
    answer::card(ui, desk, &mut kept.wall, card);

    let right = right.shrink2(vec2(18.0, 10.0));
    let (coming, notes) = right.split_top_bottom_at_fraction(0.42);
    next::show(ui, desk, &mut kept.next, coming);
    rule(ui, desk, [coming.left_bottom(), coming.right_bottom()]);
    notes::show(ui, desk, &mut kept.wall.formulas, &mut kept.letters, notes);

    let (slides, keys) = below.split_left_right_at_x(below.right() - 300.0);
    slides::show(ui, desk, slides.shrink2(vec2(18.0, 8.0)), asked);
    buttons::show(ui, desk, keys.shrink2(vec2(14.0, 10.0)), asked);
}

fn rule(ui: &Ui, desk: &Desk<'_>, ends: [Pos2; 2]) {
    ui.painter().line_segment(ends, line(desk.wall.theme, Role::Panel));
}
