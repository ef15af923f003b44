//! The slides that come, to be clicked, and all steps of this one.

use egui::{Align2, Id, Rect, Sense, Stroke, StrokeKind, Ui, pos2, vec2};
use raystep_figure::fonts::elided;
use raystep_figure::{Face, Role, text_width};

use super::desk::{AskedHere, Desk, heading};
use super::small::small;
use crate::shown::talk::minutes;
use crate::window::look::painter::{caption, paint_figure};
use crate::window::look::visuals::{fill, ink};

/// How many slides are shown.
pub(crate) const SHOWN: usize = 4;

/// The letters of titles.
const LETTERS: f32 = 12.5;

/// A title in one line or two; what does not fit into them ends with dots.
fn lines(title: &str, wide: f32) -> Vec<String> {
    if text_width(title, Face::Regular, LETTERS) <= wide {
        return vec![title.to_owned()];
    }
    let mut blanks = title.match_indices(' ').map(|(at, _)| at);
    let fits = blanks.rfind(|at| text_width(&title[..*at], Face::Regular, LETTERS) <= wide);
    let (first, rest) = title.split_at(fits.unwrap_or(0));
    let rest = elided(rest.trim(), Face::Regular, LETTERS, wide);
    [first.to_owned(), rest].into_iter().filter(|line| !line.is_empty()).collect()
}

pub(super) fn show(ui: &mut Ui, desk: &Desk<'_>, rect: Rect, asked: &mut Vec<AskedHere>) {
    let theme = desk.wall.theme;
    heading(ui, desk, rect.min, "Next slides");
    let room = Rect::from_min_max(rect.min + vec2(0.0, 22.0), rect.max - vec2(0.0, 30.0));
    let gap = 14.0;
    let high = (room.height() - 54.0).max(30.0);
    let wide = ((room.width() - gap * (SHOWN - 1) as f32) / SHOWN as f32).min(high * 1.6);
    let slides = &desk.wall.state.library.slides;
    for index in 0..SHOWN {
        let place = desk.wall.state.view.slide + 1 + index;
        let Some(slide) = slides.get(place) else { break };
        let corner = pos2(room.left() + index as f32 * (wide + gap), room.top());
        let picture = Rect::from_min_size(corner, vec2(wide, high));
        let whole = Rect::from_min_max(picture.min, pos2(picture.right(), room.bottom()));
        let response = ui.interact(whole, ui.scope_id().with(("slide", place)), Sense::click());
        response
            .widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, format!("To slide {}", slide.id())));
        if response.clicked() {
            asked.push(AskedHere::Slide(place));
        }
        let role = if response.hovered() || response.has_focus() { Role::Here } else { Role::Edge };
        ui.painter().rect_filled(picture, 0.0, fill(theme, Role::Panel));
        if let Some(figure) = desk.thumbs.of(place, desk.wall.state.view.stage, theme) {
            let size = vec2(figure.size.x, figure.size.y);
            small(ui, Id::unique(("thumb", place)), picture, size, |ui| {
                paint_figure(ui.painter(), ui.max_rect().min, figure, theme, None);
            });
        }
        ui.painter().rect_stroke(picture, 0.0, Stroke::new(1.5, ink(theme, role)), StrokeKind::Inside);
        let below = |y: f32| pos2(picture.left(), picture.bottom() + y);
        caption(ui.painter(), below(11.0), Align2::LEFT_CENTER, &slide.id(), Face::Bold, 13.0, role, theme);
        let says = format!("{:.0} min", minutes(slide));
        let at = pos2(picture.right(), picture.bottom() + 11.0);
        caption(ui.painter(), at, Align2::RIGHT_CENTER, &says, Face::Regular, 12.5, Role::Quiet, theme);
        // A long title has two lines.
        for (row, line) in lines(&slide.title, wide).into_iter().enumerate() {
            let at = below(27.0 + 15.0 * row as f32);
            caption(ui.painter(), at, Align2::LEFT_CENTER, &line, Face::Regular, LETTERS, Role::Text, theme);
        }
    }
    let Some(playback) = desk.wall.state.playback() else { return };
    let (mut step, last) = (desk.wall.state.view.step, playback.steps().last());
    let foot = Rect::from_min_max(pos2(rect.left(), rect.bottom() - 22.0), rect.max);
    let says = format!("step {step} of {last}");
    caption(ui.painter(), foot.left_center(), Align2::LEFT_CENTER, &says, Face::Medium, 14.0, Role::Text, theme);
    let track = Rect::from_min_max(pos2(foot.left() + 130.0, foot.top()), foot.max - vec2(10.0, 0.0));
    let response = ui.interact(track, ui.scope_id().with("steps"), Sense::click_and_drag());
    response.widget_info(|| egui::WidgetInfo::slider(true, step as f64, "Step"));
    let y = track.center().y;
    let share = step as f32 / last.max(1) as f32;
    let knob = pos2(track.left() + share * track.width(), y);
    ui.painter().hline(track.x_range(), y, Stroke::new(4.0, ink(theme, Role::Edge).gamma_multiply(0.4)));
    ui.painter().hline(track.left()..=knob.x, y, Stroke::new(4.0, ink(theme, Role::Here)));
    ui.painter().circle(knob, 8.0, fill(theme, Role::Page), Stroke::new(2.5, ink(theme, Role::Here)));
    if let Some(at) = response.interact_pointer_pos() {
        step = (((at.x - track.left()) / track.width()).clamp(0.0, 1.0) * last as f32).round() as usize;
        asked.push(AskedHere::Step(step));
    }
}
