//! What comes next: its picture, its words, and the names of the beats behind it.

use egui::{Align2, Id, Rect, ScrollArea, StrokeKind, Ui, UiBuilder, pos2, vec2};
use raystep_figure::{Face, Role};
use raystep_lesson::Medium;

use super::desk::{Desk, heading, more_below};
use super::small::small;
use crate::shown::reel::said;
use crate::window::look::painter::caption;
use crate::window::look::prose::Prose;
use crate::window::look::visuals::{fill, line};
use crate::window::panes::page::{Kept, Page};
use crate::window::panes::stage;

/// The width that space is laid out on, in points.
const SPACE: f32 = 560.0;

pub(super) fn show(ui: &mut Ui, desk: &Desk<'_>, kept: &mut Kept, rect: Rect) {
    let theme = desk.wall.theme;
    heading(ui, desk, rect.min, "Next beat");
    let at = pos2(rect.right(), rect.top() + 10.0);
    let state = desk.wall.state;
    let says = match state.question() {
        Some(_) => "→ shows the answer",
        None if state.question_waits() => "→ asks the question",
        None => "→ goes on",
    };
    caption(ui.painter(), at, Align2::RIGHT_CENTER, says, Face::Regular, 12.5, Role::Quiet, theme);
    let rect = Rect::from_min_max(rect.min + vec2(0.0, 26.0), rect.max - vec2(0.0, 8.0));
    let Some(next) = desk.next else {
        let title =
            desk.wall.state.library.slides.get(desk.wall.state.view.slide + 1).map(|slide| slide.title.as_str());
        let says = title.map_or("This is the last slide.".to_owned(), |title| format!("The next slide: {title}"));
        caption(
            ui.painter(),
            rect.left_top() + vec2(0.0, 16.0),
            Align2::LEFT_CENTER,
            &says,
            Face::Medium,
            16.0,
            Role::Text,
            theme,
        );
        return;
    };
    let picture = Rect::from_min_size(rect.min, vec2(rect.width() * 0.47, rect.height()));
    ui.painter().rect_filled(picture, 0.0, fill(theme, Role::Page));
    let page = Page { state: next, beside: None, heat: None, counting: false, lit: None, ..desk.wall };
    let size = picture.size() * (SPACE / picture.width());
    small(ui, Id::unique("next"), picture, size, |ui| {
        let room = ui.max_rect().shrink(8.0);
        stage::stage(ui, page, kept, room, false, 1.0, &mut Vec::new())
    });
    ui.painter().rect_stroke(picture, 0.0, line(theme, Role::Panel), StrokeKind::Inside);
    let words = Rect::from_min_max(pos2(picture.right() + 16.0, rect.top()), rect.max);
    let bottom = words.bottom();
    let mut child = ui.new_child(UiBuilder::new().max_rect(words));
    child.set_clip_rect(words);
    let scrolled = ScrollArea::vertical().id_salt("next words").auto_shrink(false).show(&mut child, |ui| {
        ui.set_width(ui.available_width());
        let prose = Prose { theme, size: 14.0, role: Role::Text, face: Face::Regular, leading: 1.35 };
        if let (Some((beat, step)), Some(playback)) = (next.beat(), next.playback()) {
            Prose { face: Face::Bold, size: 16.5, ..prose }.show(ui, &mut kept.formulas, &beat.title);
            prose.show(ui, &mut kept.formulas, &said(beat, &playback.play, step, Medium::Wall));
        }
        let then = after(desk, next);
        if !then.is_empty() {
            Prose { role: Role::Quiet, face: Face::Bold, size: 13.0, ..prose }.show(ui, &mut kept.formulas, "then");
            // As many as there is room for: none is cut.
            for title in then {
                if ui.cursor().top() + prose.height(ui, &mut kept.formulas, &title, ui.available_width()) > bottom {
                    break;
                }
                prose.show(ui, &mut kept.formulas, &title);
            }
        }
    });
    more_below(&child, desk, &scrolled, Role::Page);
}

/// The titles of up to four beats that come after the next one, those with questions marked.
fn after(desk: &Desk<'_>, next: &crate::shown::state::State) -> Vec<String> {
    let (Some(slide), Some(playback)) = (next.slide(), next.made()) else { return Vec::new() };
    let mut beats: Vec<(usize, usize)> =
        playback.play.beats.iter().enumerate().filter_map(|(beat, at)| Some(((*at)?, beat))).collect();
    beats.sort_unstable();
    let later = beats.into_iter().filter(|(step, _)| *step > next.view.step).take(4);
    let asks = |beat: usize| desk.wall.state.predict && playback.posed.iter().any(|posed| posed.beat == beat);
    let title = |(_, beat): (usize, usize)| {
        let title = slide.beats.get(beat)?.title.clone();
        Some(if asks(beat) { format!("{title} · **question**") } else { title })
    };
    later.filter_map(title).collect()
}
