//! The words of the presenter's page: what is said and asked at a step, as large as all that a slide says fits.

use egui::{RichText, Ui, Vec2, vec2};
use raystep_figure::{Face, Role};
use raystep_lesson::Medium;

use super::answer;
use crate::shown::command::Command;
use crate::shown::reel::{beginning, said};
use crate::shown::state::State;
use crate::shown::words::{label, question_text, reason};
use crate::window::look::fonts::font;
use crate::window::look::formulas::Formulas;
use crate::window::look::markdown::plain;
use crate::window::look::prose::Prose;
use crate::window::look::visuals::ink;

/// Something that stands in the column of words.
#[derive(Clone, Debug, PartialEq)]
enum Part {
    /// A text in Markdown.
    Text { text: String, role: Role, face: Face, size: f32 },
    /// A question's answers, and which of them was wrong; once it is answered, which is right.
    Answers { names: Vec<String>, wrong: Option<usize>, right: Option<usize> },
    /// What there is to do.
    Offers(Vec<String>),
}

/// What is said at a step, from above.
#[derive(Clone)]
pub(crate) struct Speech(Vec<Part>);

impl Speech {
    /// What is said at the step that the state shows.
    pub(crate) fn of(state: &State) -> Speech {
        let plain_text = |text: String| Part::Text { text, role: Role::Text, face: Face::Regular, size: 1.0 };
        let strong = |text: String| Part::Text { text, role: Role::Text, face: Face::Medium, size: 1.1 };
        let mut parts = Vec::new();
        // An answered question stays, until one goes on.
        let open = state.question().map(|posed| (posed, None));
        let settled = state.settled().filter(|_| state.is_settled());
        let settled = settled.map(|(posed, answered)| (posed, Some(answered.choice)));
        if let Some((posed, right)) = open.or(settled) {
            parts.push(strong(question_text(state, posed)));
            let answered = state.answered.filter(|answered| answered.beat == posed.beat);
            let wrong = answered.and_then(|answered| answered.wrong());
            let names = posed.choices.iter().map(|choice| plain(&label(choice))).collect();
            parts.push(Part::Answers { names, wrong, right });
            if let Some(wrong) = wrong {
                let text = reason(state, posed, &posed.choices[wrong]);
                parts.push(Part::Text { text, role: Role::Wrong, face: Face::Regular, size: 1.0 });
            }
            return Speech(parts);
        }
        if let Some(mistake) = state.view.example {
            parts.push(strong(escaped(mistake.title())));
            parts.push(plain_text(escaped(mistake.consequence())));
        }
        let playback = state.playback();
        match state.beat().filter(|(_, step)| *step == state.view.step).zip(playback) {
            Some(((beat, step), playback)) => {
                parts.push(strong(escaped(&beat.title)));
                let text = said(beat, &playback.play, step, Medium::Wall);
                if !text.trim().is_empty() {
                    parts.push(plain_text(text));
                }
                let offers: Vec<String> = state.offers().iter().map(|offer| offer.words.clone()).collect();
                if !offers.is_empty() {
                    parts.push(Part::Offers(offers));
                }
            }
            None => {
                let says = playback.and_then(|playback| {
                    Some(playback.reel().sentence(state.view.step, &playback.event(state.view.step)?))
                });
                // Before a class the picture that a slide opens with speaks for itself.
                let opening = state.slide().filter(|_| !state.present).map(|slide| beginning(slide.plays).to_owned());
                parts.extend(says.or(opening).map(plain_text));
            }
        }
        Speech(parts)
    }

    /// All that beats say on this walk or build, their questions, and why answers are wrong.
    pub(crate) fn all(state: &State) -> Vec<Speech> {
        let Some(playback) = state.playback() else { return Vec::new() };
        let mut at = state.clone();
        let mut all = Vec::new();
        for step in playback.play.beats.iter().flatten() {
            at.go(*step);
            all.push(Speech::of(&at));
        }
        for posed in playback.posed.iter().filter(|_| state.predict) {
            at.go(posed.before);
            if at.question().is_none() {
                at.apply(Command::Next);
            }
            all.push(Speech::of(&at));
            for choice in (0..posed.choices.len()).filter(|choice| !posed.choices[*choice].right) {
                at.apply(Command::Answer(choice as u8));
                all.push(Speech::of(&at));
            }
        }
        all
    }

    /// The same in pages of this size: what does not fit below the rest stands on the next one.
    pub(crate) fn pages(self, ui: &Ui, formulas: &mut Formulas, prose: &Prose<'_>, room: Vec2) -> Vec<Speech> {
        if self.height(ui, formulas, prose, room.x) <= room.y + 1.0 {
            return vec![self];
        }
        let pieces: Vec<Part> = self.0.into_iter().flat_map(Part::pieces).collect();
        let highs: Vec<f32> = pieces.iter().map(|piece| piece.height(ui, formulas, prose, room.x)).collect();
        // The page's number stands at its foot.
        let most = room.y - prose.size;
        let fewest = turned(&highs, gap(prose.size), most);
        let count = |turns: &[bool]| turns.iter().filter(|turns| **turns).count();
        // As full as each other, as far as they can be: no line is left over for a page of its own.
        let lower = (1..EVEN).map(|part| turned(&highs, gap(prose.size), most * part as f32 / EVEN as f32));
        let even = lower.into_iter().find(|turns| count(turns) == count(&fewest)).unwrap_or(fewest);
        let mut pages = vec![Speech(Vec::new())];
        for (piece, turns) in pieces.into_iter().zip(even) {
            if turns {
                pages.push(Speech(Vec::new()));
            }
            pages.last_mut().expect("there is a page").0.push(piece);
        }
        pages
    }

    /// How high it is.
    pub(crate) fn height(&self, ui: &Ui, formulas: &mut Formulas, prose: &Prose<'_>, width: f32) -> f32 {
        let heights = self.0.iter().map(|part| part.height(ui, formulas, prose, width));
        heights.sum::<f32>() + gap(prose.size) * self.0.len().saturating_sub(1) as f32
    }

    /// Shows it; says which command was asked for. What there is to do stands there only if it `offers` that: else its
    /// room stays empty.
    pub(crate) fn show(
        &self,
        ui: &mut Ui,
        formulas: &mut Formulas,
        prose: &Prose<'_>,
        offers: bool,
    ) -> Option<Command> {
        let mut asked = None;
        ui.spacing_mut().item_spacing.y = gap(prose.size);
        for part in &self.0 {
            if matches!(part, Part::Offers(_)) && !offers {
                let width = ui.available_width();
                ui.allocate_space(vec2(width, part.height(ui, formulas, prose, width)));
                continue;
            }
            ui.scope(|ui| asked = part.show(ui, formulas, prose).or(asked));
        }
        asked
    }
}

/// In so many steps pages are tried less full.
const EVEN: usize = 24;

/// Before which pieces of these heights a page is turned that is filled so high at most.
fn turned(highs: &[f32], gap: f32, most: f32) -> Vec<bool> {
    let mut full = 0.0;
    let turns = highs.iter().map(|high| {
        let above = if full > 0.0 { full + gap } else { 0.0 };
        let turns = full > 0.0 && above + high > most;
        full = if turns { *high } else { above + high };
        turns
    });
    turns.collect()
}

/// Between two parts, and between two buttons.
fn gap(body: f32) -> f32 {
    body * 0.55
}

/// How large what stands on the buttons of offers is.
const OFFER: f32 = 0.8;

impl Part {
    /// The same in pieces that can stand on different pages: a text by its paragraphs.
    fn pieces(self) -> Vec<Part> {
        match self {
            Part::Text { text, role, face, size } => {
                let piece = |text: &str| Part::Text { text: text.to_owned(), role, face, size };
                text.split("\n\n").filter(|text| !text.trim().is_empty()).map(piece).collect()
            }
            other => vec![other],
        }
    }

    fn height(&self, ui: &Ui, formulas: &mut Formulas, prose: &Prose<'_>, width: f32) -> f32 {
        let Prose { theme, size: body, .. } = *prose;
        let stacked =
            |heights: Vec<f32>| heights.iter().sum::<f32>() + gap(body) * heights.len().saturating_sub(1) as f32;
        match self {
            Part::Text { text, role, face, size } => {
                Prose { size: body * size, role: *role, face: *face, ..*prose }.height(ui, formulas, text, width)
            }
            Part::Answers { names, .. } => {
                let across = answer::across(ui, names, theme, body, width);
                let wide = answer::share(width, across, gap(body));
                let high = |names: &[String]| {
                    names.iter().map(|name| answer::height(ui, name, theme, body, wide)).fold(0.0, f32::max)
                };
                stacked(names.chunks(across).map(high).collect())
            }
            Part::Offers(words) => {
                let padding = ui.spacing().button_padding;
                let high = |text: &String| {
                    let (letters, wide) = (font(Face::Medium, body * OFFER), width - 2.0 * padding.x);
                    let galley = ui.painter().layout(text.clone(), letters, ink(theme, Role::Text), wide);
                    (galley.size().y + 2.0 * padding.y).max(ui.spacing().interact_size.y)
                };
                stacked(words.iter().map(high).collect())
            }
        }
    }

    fn show(&self, ui: &mut Ui, formulas: &mut Formulas, prose: &Prose<'_>) -> Option<Command> {
        let Prose { theme, size: body, .. } = *prose;
        let mut asked = None;
        match self {
            Part::Text { text, role, face, size } => {
                Prose { size: body * size, role: *role, face: *face, ..*prose }.show(ui, formulas, text);
            }
            Part::Answers { names, wrong, right } => {
                let width = ui.available_width();
                let across = answer::across(ui, names, theme, body, width);
                let wide = answer::share(width, across, gap(body));
                let mark = |index: usize| match () {
                    () if *right == Some(index) => answer::Mark::Right,
                    () if *wrong == Some(index) => answer::Mark::Wrong,
                    () if right.is_some() => answer::Mark::Closed,
                    () => answer::Mark::Open,
                };
                for (row, beside) in names.chunks(across).enumerate() {
                    ui.horizontal_top(|ui| {
                        ui.spacing_mut().item_spacing.x = gap(body);
                        for (index, name) in (row * across..).zip(beside) {
                            if answer::show(ui, index, name, mark(index), theme, body, wide) {
                                asked = Some(Command::Answer(index as u8));
                            }
                        }
                    });
                }
            }
            Part::Offers(words) => {
                for (index, words) in words.iter().enumerate() {
                    let text = RichText::new(words).font(font(Face::Medium, body * OFFER));
                    if ui.button(text).clicked() {
                        asked = Some(Command::Offer(index as u8));
                    }
                }
            }
        }
        asked
    }
}

/// A title, which is shown word for word, as Markdown.
fn escaped(title: &str) -> String {
    title.chars().flat_map(|letter| letter.is_ascii_punctuation().then_some('\\').into_iter().chain([letter])).collect()
}
