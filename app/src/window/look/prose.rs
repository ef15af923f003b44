//! Lesson text on a page: Markdown with formulas, in the theme's faces.

use egui::text::{LayoutJob, TextFormat};
use egui::{Align, Frame, Label, Margin, Ui, Widget};
use raystep_figure::{Face, Role, Theme};

use super::fonts::font;
use super::formulas::Formulas;
use super::markdown::{Block, Run, RunLook, blocks, together};
use super::tex::{self, Shift};
use super::visuals::{fill, ink, line};

/// How text is set.
#[derive(Clone, Copy)]
pub(crate) struct Prose<'a> {
    pub(crate) theme: &'a Theme,
    /// Size of the letters in points.
    pub(crate) size: f32,
    /// What the words mean.
    pub(crate) role: Role,
    /// The face of plain words.
    pub(crate) face: Face,
}

impl Prose<'_> {
    /// Shows Markdown, as wide as there is room.
    pub(crate) fn show(&self, ui: &mut Ui, formulas: &mut Formulas, markdown: &str) {
        ui.spacing_mut().item_spacing.y = self.size * 0.7;
        for block in blocks(markdown) {
            match block {
                Block::Paragraph(runs) => self.line(ui, &runs),
                Block::Item(runs) => {
                    ui.horizontal_top(|ui| {
                        ui.label(self.job(&[Run { text: "·".to_owned(), look: RunLook::Strong }], ui));
                        ui.vertical(|ui| self.line(ui, &runs));
                    });
                }
                Block::Formula(tex) => self.formula(ui, formulas, &tex),
                Block::Code(lines) => {
                    ui.label(egui::RichText::new(lines).font(font(Face::Mono, self.size * 0.92)));
                }
            }
        }
    }

    fn line(&self, ui: &mut Ui, runs: &[Run]) {
        let job = self.job(runs, ui);
        Label::new(job).wrap().ui(ui);
    }

    /// A formula in a box of its own, as large as fits.
    fn formula(&self, ui: &mut Ui, formulas: &mut Formulas, tex: &str) {
        let frame = Frame::new()
            .fill(fill(self.theme, Role::Panel))
            .stroke(line(self.theme, Role::Panel))
            .corner_radius(6.0)
            .inner_margin(Margin::symmetric(14, 10));
        frame.show(ui, |ui| {
            ui.set_width(ui.available_width());
            formulas.show(ui, tex, self.size * 1.12, self.theme.style(self.role).text);
        });
    }

    /// The runs as one text.
    fn job(&self, runs: &[Run], ui: &Ui) -> LayoutJob {
        let mut job = LayoutJob::default();
        let color = ink(self.theme, self.role);
        let line_height = Some(self.size * 1.45);
        for run in runs {
            let face = match run.look {
                RunLook::Plain => self.face,
                RunLook::Strong => Face::Bold,
                RunLook::Emphasis => Face::Italic,
                RunLook::Code => Face::Mono,
                RunLook::Formula => {
                    self.short_formula(&mut job, &run.text);
                    continue;
                }
            };
            let size = if run.look == RunLook::Code { self.size * 0.92 } else { self.size };
            let format = TextFormat { font_id: font(face, size), color, line_height, ..TextFormat::default() };
            let text = if run.look == RunLook::Code { run.text.clone() } else { together(&run.text) };
            job.append(&text, 0.0, format);
        }
        job.wrap.max_width = ui.available_width();
        job
    }

    fn short_formula(&self, job: &mut LayoutJob, tex: &str) {
        for part in tex::parts(tex) {
            let (size, valign) = match part.shift {
                Shift::Line => (self.size, Align::BOTTOM),
                Shift::Below => (self.size * 0.72, Align::BOTTOM),
                Shift::Above => (self.size * 0.72, Align::TOP),
            };
            let face = if part.italic { Face::Italic } else { self.face };
            let line_height = (part.shift == Shift::Line).then_some(self.size * 1.45);
            let color = ink(self.theme, self.role);
            job.append(
                &part.text,
                0.0,
                TextFormat { font_id: font(face, size), color, line_height, valign, ..TextFormat::default() },
            );
        }
    }
}
