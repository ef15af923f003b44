//! Words in bold that are explained: a line below them, and their meaning when they are pointed at, clicked or focused.

use std::ops::Range;
use std::sync::Arc;

use egui::{Galley, Label, Rect, Response, RichText, Sense, Stroke, Ui, pos2, vec2};
use raystep_figure::{Face, Role, Theme};
use raystep_lesson::{Library, Slide, Term};

use super::fonts::font;
use super::markdown::{Run, RunLook};
use super::visuals::ink;

/// How wide a meaning is set.
const WIDTH: f32 = 280.0;

/// What explains the words of a slide's text.
pub(crate) struct Words<'a> {
    pub(crate) library: &'a Library,
    /// The slide that is read.
    pub(crate) slide: usize,
    /// The slide that was asked for.
    pub(crate) asked: Option<usize>,
}

/// A word in a line of text, by its letters.
pub(super) struct Marked<'a> {
    pub(super) term: &'a Term,
    pub(super) letters: Range<usize>,
}

impl<'a> Words<'a> {
    /// The words in bold among some runs that are explained; `letters` says how many letters a run takes.
    pub(super) fn marked(&self, runs: &[Run], letters: impl Fn(&Run) -> usize) -> Vec<Marked<'a>> {
        let mut first = 0;
        let library = self.library;
        let marked = runs.iter().filter_map(|run| {
            let letters = first..first + letters(run);
            first = letters.end;
            let term = library.term(&run.text).filter(|_| run.look == RunLook::Strong)?;
            Some(Marked { term, letters })
        });
        marked.collect()
    }

    /// Explains the words of a line that was shown.
    pub(super) fn explain(
        &mut self,
        ui: &mut Ui,
        line: &Response,
        galley: &Arc<Galley>,
        marked: &[Marked<'a>],
        theme: &Theme,
    ) {
        let corner = line.rect.min;
        for (index, word) in marked.iter().enumerate() {
            let pieces = pieces(galley, &word.letters);
            let color = ink(theme, Role::Here);
            let mut response: Option<Response> = None;
            for (part, piece) in pieces.into_iter().enumerate() {
                let rect = piece.translate(corner.to_vec2());
                let foot = rect.bottom() - 1.0;
                let dashes = egui::Shape::dashed_line(
                    &[pos2(rect.left(), foot), pos2(rect.right(), foot)],
                    Stroke::new(1.0, color),
                    2.0,
                    2.0,
                );
                ui.painter().extend(dashes);
                // What is focused is one thing, however many lines it takes.
                let sense = if part == 0 { Sense::click() } else { Sense::CLICK };
                let there = ui.interact(rect, line.id.with(("word", index, part)), sense);
                response = Some(match response {
                    Some(before) => before.union(there),
                    None => there,
                });
            }
            if let Some(response) = response {
                self.show(ui, &response, word.term, theme);
            }
        }
    }

    /// The meaning beside the word, while it is asked for.
    fn show(&mut self, ui: &Ui, response: &Response, term: &Term, theme: &Theme) {
        let says = format!("{}: {}", term.names[0], term.means);
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, &says));
        if response.has_focus() {
            let around = response.rect.expand2(vec2(2.0, 1.0));
            ui.painter().rect_stroke(around, 3.0, Stroke::new(1.5, ink(theme, Role::Here)), egui::StrokeKind::Outside);
        }
        let popup = egui::Popup::from_toggle_button_response(response);
        let open = popup.is_open();
        if response.gained_focus() && !open {
            egui::Popup::open_id(ui.ctx(), egui::Popup::default_response_id(response));
        }
        let shown = popup.close_behavior(egui::PopupCloseBehavior::CloseOnClickOutside);
        let shown = shown.show(|ui| self.meaning(ui, term, theme));
        if shown.is_none() {
            response.clone().on_hover_ui(|ui| self.meaning(ui, term, theme));
        }
    }

    fn meaning(&mut self, ui: &mut Ui, term: &Term, theme: &Theme) {
        ui.set_max_width(WIDTH);
        let text = RichText::new(&term.means).font(font(Face::Regular, 14.0)).color(ink(theme, Role::Text));
        ui.add(Label::new(text).wrap());
        let Some(slide) = self.library.slide(&term.slide) else { return };
        let index = self.library.slides.iter().position(|other| std::ptr::eq(other, slide));
        let says = taught(slide);
        if index == Some(self.slide) {
            ui.label(
                RichText::new("Taught on this slide").font(font(Face::Regular, 12.5)).color(ink(theme, Role::Quiet)),
            );
        } else if ui.link(RichText::new(says).font(font(Face::Medium, 13.0)).color(ink(theme, Role::Here))).clicked() {
            self.asked = index;
            egui::Popup::close_all(ui.ctx());
        }
    }
}

/// Where a word is taught.
fn taught(slide: &Slide) -> String {
    format!("{} · {}", slide.numbers_text(), slide.title)
}

/// Where some letters of a text stand: a rectangle for each of its lines.
fn pieces(galley: &Galley, letters: &Range<usize>) -> Vec<Rect> {
    let mut pieces = Vec::new();
    let mut first = 0;
    for placed in &galley.rows {
        let glyphs = &placed.row.glyphs;
        let within = |at: usize| at.checked_sub(first).map_or(0, |at| at.min(glyphs.len()));
        let (from, to) = (within(letters.start), within(letters.end));
        if let Some(some) = glyphs.get(from..to).filter(|some| !some.is_empty()) {
            let left = some[0].pos.x;
            let right = some.iter().map(|glyph| glyph.pos.x + glyph.advance_width).fold(left, f32::max);
            let row = Rect::from_x_y_ranges(left..=right, 0.0..=placed.row.size.y);
            pieces.push(row.translate(placed.pos.to_vec2()));
        }
        first += glyphs.len() + usize::from(placed.ends_with_newline);
    }
    pieces
}
