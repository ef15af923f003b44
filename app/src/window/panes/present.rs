//! The presenter's page: title, space, the ruler, the question or what is said, what changed, and the stack in words.

use egui::{Align2, Rect, Sense, Ui, pos2, vec2};
use raystep_accel::Place;
use raystep_figure::{Face, Look, Role, changed_height, stack_height};

use super::columns::bytes;
use super::figure::figure;
use super::page::{Asked, Kept, Page};
use super::speech::{Column, Fitted, Speech};
use super::stage;
use crate::shown::command::Command;
use crate::shown::pictures::{Pane, Pictures};
use crate::window::look::painter::caption;
use crate::window::look::visuals::fill;

/// Shows the page in the whole window; says which place the pointer is on.
pub(crate) fn page(ui: &mut Ui, page: Page<'_>, kept: &mut Kept, asked: &mut Vec<Asked>) -> Option<Place> {
    ui.painter().rect_filled(ui.max_rect(), 0.0, fill(page.theme, Role::Page));
    kept.notices.strip(ui, page.theme);
    let rect = ui.available_rect_before_wrap();
    // Everything follows from the height: body text is a twenty-eighth of it or larger.
    let body = (rect.height() / 27.0).clamp(16.0, 64.0).min(rect.width() / 44.0);
    let margin = body * 1.4;
    let inner = rect.shrink2(vec2(margin, margin * 0.7));
    let title_height = body * 2.0;
    heading(ui, page, Rect::from_min_size(inner.min, vec2(inner.width(), title_height)), body);

    let foot = body * 1.5;
    let look = Look { text: body * 0.78, titles: false };
    let bytes = bytes(page.state);
    let ruler = match &kept.pictures {
        _ if bytes => body * 11.0,
        Some(pictures) => pictures.ruler_line_height(&look),
        None => 0.0,
    };
    let top = inner.top() + title_height;
    let bottom = inner.bottom() - foot - ruler;
    let wide = |column: Column| (inner.width() * column.part).max(body * 11.0);
    let floor = |column: Column| if column.tall { inner.bottom() - foot } else { bottom };
    let room = |column: Column| vec2(wide(column), floor(column) - top - body * 0.5);
    let fitted = Fitted::of(kept.column.take(), ui, page.state, &mut kept.formulas, page.theme, room, body);
    let column = fitted.as_ref().map_or(Column::USUAL, |fitted| fitted.column);
    kept.column = fitted;
    let side = wide(column);
    let space = Rect::from_min_max(pos2(inner.left(), top), pos2(inner.right() - side - body, bottom));
    let words = pos2(inner.right() - side, top + body * 0.4);
    let words = Rect::from_min_max(words, pos2(inner.right(), floor(column)));
    let right = if column.tall { space.right() } else { inner.right() };
    let line = Rect::from_min_max(pos2(inner.left(), bottom), pos2(right, bottom + ruler));

    let mut under = stage::stage(ui, page, kept, space, false, body / 19.0, asked);
    if ruler > 0.0 {
        let pane = if bytes { Pane::Bytes } else { Pane::RulerLine };
        under = figure(ui, page, kept, pane, line, &look, asked).or(under);
    }
    under = side_page(ui, page, kept, words, body, column, asked).or(under);
    let foot = Rect::from_min_max(pos2(inner.left(), inner.bottom() - foot), inner.max);
    if let Some(pictures) = &kept.pictures
        && footer(ui, page, pictures, foot, body)
    {
        asked.push(Asked::Command(Command::Present));
    }
    under
}

fn heading(ui: &Ui, page: Page<'_>, rect: Rect, body: f32) {
    let Some(slide) = page.state.slide() else { return };
    let at = rect.left_center();
    caption(ui.painter(), at, Align2::LEFT_CENTER, &slide.title, Face::Bold, body * 1.35, Role::Text, page.theme);
    let section = format!("{} · {}", slide.section_title(), slide.numbers_text());
    caption(
        ui.painter(),
        rect.right_center(),
        Align2::RIGHT_CENTER,
        &section,
        Face::Regular,
        body * 0.68,
        Role::Quiet,
        page.theme,
    );
}

/// Shows what has been done so far, and the way back; says whether that was taken.
fn footer(ui: &mut Ui, page: Page<'_>, pictures: &Pictures, rect: Rect, body: f32) -> bool {
    let (playback, step) = (&pictures.playback, page.state.view.step);
    let tally = pictures.tally();
    let says = format!("step {step} of {} · {tally}", playback.steps().last());
    caption(
        ui.painter(),
        rect.left_center(),
        Align2::LEFT_CENTER,
        &says,
        Face::Regular,
        body * 0.68,
        Role::Quiet,
        page.theme,
    );
    let back = ui.allocate_rect(Rect::from_min_max(rect.right_top() - vec2(body * 9.0, 0.0), rect.max), Sense::click());
    back.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, "Back to the study page"));
    let role = if back.hovered() { Role::Here } else { Role::Quiet };
    caption(
        ui.painter(),
        rect.right_center(),
        Align2::RIGHT_CENTER,
        "F5 back to study",
        Face::Regular,
        body * 0.55,
        role,
        page.theme,
    );
    back.clicked()
}

/// The question or what the beat says, then what changed, then the stack.
fn side_page(
    ui: &mut Ui,
    page: Page<'_>,
    kept: &mut Kept,
    rect: Rect,
    body: f32,
    column: Column,
    asked: &mut Vec<Asked>,
) -> Option<Place> {
    let mut child = ui.new_child(egui::UiBuilder::new().max_rect(rect));
    child.set_clip_rect(rect.expand(4.0));
    let speech = Speech::of(page.state);
    let words = egui::ScrollArea::vertical()
        .id_salt("presented")
        .show(&mut child, |ui| speech.show(ui, &mut kept.formulas, &column.set(page.theme, body)));
    asked.extend(words.inner.map(Asked::Command));
    let look = Look { text: body * 0.62, titles: true };
    let rest = rect.height() - words.content_size.y - body * 0.6;
    let [stack, changed] = shares(kept.pictures.as_ref()?, &look, rest);
    let bottom = rect.bottom();
    let mut under = None;
    if stack > 0.0 {
        let rect = Rect::from_min_max(pos2(rect.left(), bottom - stack), pos2(rect.right(), bottom));
        let look = Look { titles: false, ..look };
        under = figure(ui, page, kept, Pane::StackHere, rect, &look, asked);
    }
    if changed > 0.0 {
        let bottom = if stack > 0.0 { bottom - stack - body * 0.3 } else { bottom };
        let rect = Rect::from_min_max(pos2(rect.left(), bottom - changed), pos2(rect.right(), bottom));
        under = figure(ui, page, kept, Pane::Changed, rect, &look, asked).or(under);
    }
    under
}

/// The heights of the stack and of what changed in the room that the words leave; 0 of what has none. The stack has four
/// rows where there is room for both, else those that it needs.
fn shares(pictures: &Pictures, look: &Look, rest: f32) -> [f32; 2] {
    let bare = Look { titles: false, ..*look };
    let (least, most) = (changed_height(2, look), changed_height(6, look));
    let changes = pictures.has(Pane::Changed);
    if !pictures.has(Pane::StackHere) {
        let changed = if changes && rest >= least { rest.min(most) } else { 0.0 };
        return [0.0, changed];
    }
    let gap = look.text * 0.5;
    let four = stack_height(4, &bare);
    let needed = stack_height(pictures.stacked().clamp(1, 4), &bare);
    let stack = match () {
        () if changes && rest >= four + gap + least => four,
        () if changes && rest >= needed + gap + least => needed,
        () if rest >= stack_height(1, &bare) => rest.min(four),
        () => 0.0,
    };
    let left = rest - stack - gap;
    [stack, if changes && left >= least { left.min(most) } else { 0.0 }]
}
