//! Lesson text on a page: Markdown with formulas, in the theme's faces.

use egui::text::{LayoutJob, TextFormat};
use egui::{Align, Frame, Label, Margin, Ui, Widget};
use raystep_figure::{Face, Role, Theme};

use super::fonts::font;
use super::formulas::Formulas;
use super::markdown::{Block, Run, RunLook, blocks, together};
use super::tex::{self, Shift};
use super::visuals::{fill, ink, line};
use super::words::Words;

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
    /// From line to line, in parts of the size.
    pub(crate) leading: f32,
}

/// From line to line where there is room.
pub(crate) const LEADING: f32 = 1.45;

/// Around a formula that stands by itself, at its sides and above and below it.
const FORMULA: [i8; 2] = [14, 10];

/// What stands before an item of a list.
fn dot() -> [Run; 1] {
    [Run { text: "·".to_owned(), look: RunLook::Strong }]
}

impl Prose<'_> {
    /// Shows Markdown, as wide as there is room.
    pub(crate) fn show(&self, ui: &mut Ui, formulas: &mut Formulas, markdown: &str) {
        self.blocks(ui, formulas, markdown, &mut None);
    }

    /// The same, and explains the words in bold that are in the glossary.
    pub(crate) fn explain<'a>(
        &self,
        ui: &mut Ui,
        formulas: &mut Formulas,
        markdown: &str,
        words: Words<'a>,
    ) -> Words<'a> {
        let mut explained = Some(words);
        self.blocks(ui, formulas, markdown, &mut explained);
        explained.expect("they are only looked at")
    }

    fn blocks(&self, ui: &mut Ui, formulas: &mut Formulas, markdown: &str, words: &mut Option<Words<'_>>) {
        ui.spacing_mut().item_spacing.y = self.gap();
        for block in blocks(markdown) {
            match block {
                Block::Paragraph(runs) => self.line(ui, &runs, words),
                Block::Item(runs) => {
                    ui.horizontal_top(|ui| {
                        ui.label(self.job(&dot(), ui));
                        ui.vertical(|ui| self.line(ui, &runs, words));
                    });
                }
                Block::Formula(tex) => self.formula(ui, formulas, &tex),
                Block::Code(lines) => {
                    ui.label(egui::RichText::new(lines).font(font(Face::Mono, self.size * 0.92)));
                }
            }
        }
    }

    fn line(&self, ui: &mut Ui, runs: &[Run], words: &mut Option<Words<'_>>) {
        let job = self.job(runs, ui);
        let response = Label::new(job.clone()).wrap().ui(ui);
        let Some(words) = words else { return };
        let marked = words.marked(runs, |run| self.letters(run));
        if !marked.is_empty() {
            let galley = ui.painter().layout_job(job);
            words.explain(ui, &response, &galley, &marked, self.theme);
        }
    }

    /// How high Markdown is when it is shown in this width.
    pub(crate) fn height(&self, ui: &Ui, formulas: &mut Formulas, markdown: &str, width: f32) -> f32 {
        let text = |runs: &[Run], width: f32| {
            let mut job = self.job(runs, ui);
            job.wrap.max_width = width;
            ui.painter().layout_job(job).size().y
        };
        let gap = ui.spacing().item_spacing.x;
        let heights = blocks(markdown).into_iter().map(|block| match block {
            Block::Paragraph(runs) => text(&runs, width),
            Block::Item(runs) => {
                let dot = ui.painter().layout_job(self.job(&dot(), ui)).size().x;
                text(&runs, width - dot - gap)
            }
            Block::Formula(tex) => {
                let [across, along] = FORMULA.map(|margin| 2.0 * f32::from(margin));
                formulas.height(&tex, self.size * 1.12, width - across) + along
            }
            Block::Code(lines) => {
                let letters = font(Face::Mono, self.size * 0.92);
                ui.painter().layout(lines, letters, ink(self.theme, self.role), width).size().y
            }
        });
        let heights: Vec<f32> = heights.collect();
        heights.iter().sum::<f32>() + self.gap() * heights.len().saturating_sub(1) as f32
    }

    /// Between two paragraphs.
    fn gap(&self) -> f32 {
        self.size * (self.leading - 0.75)
    }

    /// How many letters a run takes.
    fn letters(&self, run: &Run) -> usize {
        match run.look {
            RunLook::Formula => tex::parts(&run.text).iter().map(|part| part.text.chars().count()).sum(),
            _ => run.text.chars().count(),
        }
    }

    /// A formula in a box of its own, as large as fits.
    fn formula(&self, ui: &mut Ui, formulas: &mut Formulas, tex: &str) {
        let frame = Frame::new()
            .fill(fill(self.theme, Role::Panel))
            .stroke(line(self.theme, Role::Panel))
            .corner_radius(6.0)
            .inner_margin(Margin::symmetric(FORMULA[0], FORMULA[1]));
        frame.show(ui, |ui| {
            ui.set_width(ui.available_width());
            formulas.show(ui, tex, self.size * 1.12, self.theme.style(self.role).text);
        });
    }

    /// The runs as one text.
    fn job(&self, runs: &[Run], ui: &Ui) -> LayoutJob {
        let mut job = LayoutJob::default();
        let color = ink(self.theme, self.role);
        let line_height = Some(self.size * self.leading);
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
            let line_height = (part.shift == Shift::Line).then_some(self.size * self.leading);
            let color = ink(self.theme, self.role);
            job.append(
                &part.text,
                0.0,
                TextFormat { font_id: font(face, size), color, line_height, valign, ..TextFormat::default() },
            );
        }
    }
}
