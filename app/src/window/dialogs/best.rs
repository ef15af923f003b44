//! Which structure is best? The table, the chart and a sentence for each, filled as they are measured.

use egui::{Rect, RichText, ScrollArea, Sense, Ui, vec2};
use glam::Vec2;
use raystep_figure::{Ask, Face, Look, Pane, Role, Theme};

use crate::rating::told;
use crate::window::look::controls;
use crate::window::look::fonts::font;
use crate::window::look::painter::paint_figure;
use crate::window::look::visuals::ink;
use crate::window::work::judging::Judging;

/// The widest and the highest that the page becomes.
const MOST: egui::Vec2 = vec2(1500.0, 920.0);

/// Shows the page; says whether it shall close.
pub(super) fn page(ui: &Ui, judging: &Judging, theme: &Theme) -> bool {
    let Some(judged) = judging.shown() else { return true };
    let modal = controls::modal(ui, "which is best").show(ui.ctx(), |ui| {
        let room = (ui.ctx().content_rect().size() - vec2(70.0, 70.0)).min(MOST);
        ui.set_width(room.x);
        let high = room.y - 46.0;
        let wide = room.x > 1000.0;
        let size = if wide { vec2(room.x * 0.68, high) } else { vec2(room.x, high * 0.66) };
        let words = |ui: &mut Ui, size: egui::Vec2| {
            let area = ScrollArea::vertical().max_height(size.y).min_scrolled_height(size.y).auto_shrink(false);
            area.show(ui, |ui| {
                ui.set_width(size.x - 14.0);
                ui.label(RichText::new("What each is good at").font(font(Face::Bold, 15.0)));
                ui.add_space(4.0);
                let mut small = "Less is better in every column. A step is a node, a cell or a box.".to_owned();
                if judged.rated.iter().any(|rated| rated.what.is_fast()) {
                    small += " \u{201c}Fast\u{201d} are those of the last chapter at full speed; they are compared with each other.";
                }
                ui.label(RichText::new(small).small().color(ink(theme, Role::Quiet)));
                for sentence in told(&judged.rated, true) {
                    ui.add_space(6.0);
                    let (name, rest) = sentence.split_once(':').unwrap_or(("", &sentence));
                    ui.label(RichText::new(name).font(font(Face::Bold, 13.5)));
                    ui.label(RichText::new(capital(rest.trim())).font(font(Face::Regular, 13.5)));
                }
            });
        };
        if wide {
            ui.horizontal_top(|ui| {
                figure(ui, judging, size, theme);
                ui.add_space(10.0);
                let left = vec2(ui.available_width(), high);
                ui.vertical(|ui| words(ui, left));
            });
        } else {
            figure(ui, judging, size, theme);
            words(ui, vec2(room.x, high * 0.34 - 8.0));
        }
        ui.add_space(6.0);
        ui.horizontal(|ui| {
            let close = ui.button("Close").clicked();
            if let Some(what) = judging.underway() {
                ui.spinner();
                ui.label(format!("Building and measuring: {}", what.name()));
            }
            close
        })
        .inner
    });
    modal.should_close() || modal.inner
}

/// The table over the chart.
fn figure(ui: &mut Ui, judging: &Judging, size: egui::Vec2, theme: &Theme) {
    let Some(judged) = judging.shown() else { return };
    let (rect, response): (Rect, _) = ui.allocate_exact_size(size, Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "All structures"));
    let reel = judged.rating.reel();
    let instant = reel.at(reel.len());
    // Once all are there, none is new.
    let hide = judging.underway().is_none();
    let ask = Ask { hide, ..Ask::new(Vec2::new(size.x, size.y), Look::WINDOW) };
    let figure = reel.still(&instant).draw(Pane::Picture, &ask);
    paint_figure(&ui.painter_at(rect), rect.min, &figure, theme, None);
}

fn capital(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
