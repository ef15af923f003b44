//! What the speaker is to say.

use egui::{Align2, Button, Rect, RichText, ScrollArea, Ui, UiBuilder, Vec2, pos2, vec2};
use raystep_figure::{Face, Role};

use super::desk::{Desk, MORE_BELOW, heading};
use crate::shown::talk::minutes;
use crate::window::look::fonts::font;
use crate::window::look::formulas::Formulas;
use crate::window::look::painter::caption;
use crate::window::look::prose::{LEADING, Prose};

/// The smallest and the largest letters, and from one size to the next.
const SIZES: [f32; 3] = [12.0, 34.0, 2.0];

pub(super) fn show(ui: &mut Ui, desk: &Desk<'_>, formulas: &mut Formulas, letters: &mut f32, rect: Rect) {
    let theme = desk.wall.theme;
    let rect = Rect::from_min_max(rect.min + vec2(0.0, 8.0), rect.max);
    heading(ui, desk, rect.min, "Notes");
    let Some(slide) = desk.wall.state.slide() else { return };
    let says = format!("{:.0} min", minutes(slide));
    let at = pos2(rect.right() - 92.0, rect.top() + 10.0);
    caption(ui.painter(), at, Align2::RIGHT_CENTER, &says, Face::Regular, 13.0, Role::Quiet, theme);
    let buttons = Rect::from_min_size(pos2(rect.right() - 80.0, rect.top()), vec2(80.0, 22.0));
    ui.new_child(UiBuilder::new().max_rect(buttons)).horizontal(|ui| {
        let [least, most, step] = SIZES;
        for (text, name, by) in [("A−", "Smaller notes", -step), ("A+", "Larger notes", step)] {
            let button = Button::new(RichText::new(text).font(font(Face::Medium, 13.0))).min_size(vec2(34.0, 20.0));
            let response = ui.add(button);
            response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, name));
            if response.clicked() {
                *letters = (*letters + by).clamp(least, most);
            }
        }
    });
    let words = Rect::from_min_max(rect.min + vec2(0.0, 32.0), rect.max);
    let mut child = ui.new_child(UiBuilder::new().max_rect(words));
    child.set_clip_rect(words);
    let notes = if slide.notes.is_empty() { "This slide has no notes." } else { &slide.notes };
    let set = |size: f32| Prose { theme, size, role: Role::Text, face: Face::Regular, leading: LEADING };
    // A little smaller than is wished for, where all of it then has room.
    let wide = words.width() - 8.0;
    let tried = (0..4).map(|less| *letters - less as f32).filter(|size| *size >= SIZES[0]);
    let fits = tried.into_iter().find(|size| set(*size).height(ui, formulas, notes, wide) <= words.height());
    let prose = set(fits.unwrap_or(*letters));
    // Else whole lines are seen, and a sign that there are more.
    if fits.is_none() {
        let foot = prose.size * LEADING;
        let high = whole_lines(ui, formulas, &prose, notes, vec2(wide, words.height() - foot));
        let seen = Rect::from_min_size(words.min, vec2(words.width(), high));
        child = ui.new_child(UiBuilder::new().max_rect(seen));
        child.set_clip_rect(seen);
        let at = pos2(words.center().x, words.bottom() - foot * 0.5);
        caption(ui.painter(), at, Align2::CENTER_CENTER, MORE_BELOW, Face::Medium, 12.5, Role::Quiet, theme);
    }
    ScrollArea::vertical().id_salt(("notes", desk.wall.state.view.slide)).auto_shrink(false).show(&mut child, |ui| {
        ui.set_width(ui.available_width() - 8.0);
        prose.show(ui, formulas, notes);
    });
}

/// How high those lines are that fit as a whole.
fn whole_lines(ui: &Ui, formulas: &mut Formulas, prose: &Prose<'_>, notes: &str, room: Vec2) -> f32 {
    let line = prose.size * prose.leading;
    // Where each paragraph begins: notes have one a line.
    let ends = notes.match_indices('\n').map(|(at, _)| at + 1);
    let begins =
        ends.map(|end| prose.height(ui, formulas, &notes[..end], room.x) + prose.size * (prose.leading - 0.75));
    let tops: Vec<f32> = std::iter::once(0.0).chain(begins).take_while(|top| top + line <= room.y).collect();
    tops.last().map_or(room.y, |top| top + ((room.y - top) / line).floor() * line)
}
