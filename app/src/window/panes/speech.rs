//! The words of the presenter's page: what is said and asked at a step, as large as all that a slide says fits.

use std::sync::Arc;

use egui::{Button, RichText, Stroke, Ui, vec2};
use raystep_figure::{Face, Role, Theme};
use raystep_lesson::Medium;

use crate::shown::command::Command;
use crate::shown::playback::Playback;
use crate::shown::reel::{beginning, said};
use crate::shown::state::State;
use crate::shown::words::{label, question_text, reason};
use crate::window::look::fonts::font;
use crate::window::look::formulas::Formulas;
use crate::window::look::markdown::plain;
use crate::window::look::prose::{LEADING, Prose};
use crate::window::look::visuals::{fill, ink};

/// Something that stands in the column of words.
#[derive(Clone, Debug, PartialEq)]
enum Part {
    /// A text in Markdown.
    Text { text: String, role: Role, face: Face, size: f32 },
    /// A question's answers, and which of them was wrong.
    Answers { names: Vec<String>, wrong: Option<usize> },
    /// What there is to do.
    Offers(Vec<String>),
}

/// What is said at a step, from above.
pub(super) struct Speech(Vec<Part>);

/// How wide the column of words is, and how large they are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Column {
    /// Its part of the page's width.
    pub(super) part: f32,
    /// The size of its letters in parts of the page's.
    pub(super) size: f32,
    /// From line to line, in parts of that size.
    pub(super) leading: f32,
    /// Whether it reaches down beside the ruler, which then is as narrow as space.
    pub(super) tall: bool,
}

impl Column {
    /// The one that is tried first.
    pub(super) const USUAL: Column = COLUMNS[0];

    /// How its words are set, where letters of the page have this size.
    pub(super) fn set(self, theme: &Theme, body: f32) -> Prose<'_> {
        Prose { theme, size: body * self.size, role: Role::Text, face: Face::Regular, leading: self.leading }
    }
}

/// What is tried, the best first: letters of less than a thirty-fourth of the page's height are never tried.
const COLUMNS: [Column; 9] = [
    Column { part: 0.30, size: 1.0, leading: LEADING, tall: false },
    Column { part: 0.30, size: 0.92, leading: LEADING, tall: false },
    Column { part: 0.34, size: 0.92, leading: LEADING, tall: false },
    Column { part: 0.34, size: 0.86, leading: 1.4, tall: false },
    Column { part: 0.34, size: 0.86, leading: 1.4, tall: true },
    Column { part: 0.38, size: 0.86, leading: 1.4, tall: true },
    Column { part: 0.38, size: 0.8, leading: 1.35, tall: true },
    Column { part: 0.43, size: 0.8, leading: 1.35, tall: true },
    Column { part: 0.48, size: 0.8, leading: 1.28, tall: true },
];

/// A column with what it was fitted to.
#[derive(Clone, Debug)]
pub(super) struct Fitted {
    /// The walk or the build.
    playback: Arc<Playback>,
    /// Whether questions are asked.
    predict: bool,
    /// The room of the widest column, and the size of letters.
    room: [u32; 3],
    /// What it came to.
    pub(super) column: Column,
}

impl Fitted {
    /// The best column in which all fits that is said on this walk or build: it stays while that is shown. `room` is
    /// what a column has, and `body` the size of letters.
    pub(super) fn of(
        kept: Option<Fitted>,
        ui: &Ui,
        state: &State,
        formulas: &mut Formulas,
        theme: &Theme,
        room: impl Fn(Column) -> egui::Vec2,
        body: f32,
    ) -> Option<Fitted> {
        let playback = state.playback()?.clone();
        let predict = state.predict;
        let last = COLUMNS[COLUMNS.len() - 1];
        let key = [room(last).x, room(last).y, body * 16.0].map(|side| side as u32);
        let same =
            |kept: &Fitted| Arc::ptr_eq(&kept.playback, &playback) && (kept.predict, kept.room) == (predict, key);
        if let Some(kept) = kept.filter(same) {
            return Some(kept);
        }
        let all = Speech::all(state);
        let mut fits = |column: &&Column| {
            let room = room(**column);
            all.iter().all(|speech| speech.height(ui, formulas, &column.set(theme, body), room.x) <= room.y)
        };
        let column = *COLUMNS.iter().find(&mut fits).unwrap_or(&last);
        Some(Fitted { playback, predict, room: key, column })
    }
}

impl Speech {
    /// What is said at the step that the state shows.
    pub(super) fn of(state: &State) -> Speech {
        let plain_text = |text: String| Part::Text { text, role: Role::Text, face: Face::Regular, size: 1.0 };
        let strong = |text: String| Part::Text { text, role: Role::Text, face: Face::Medium, size: 1.1 };
        let mut parts = Vec::new();
        if let Some(posed) = state.question() {
            parts.push(strong(question_text(state, posed)));
            let wrong = state.answered.filter(|answered| answered.beat == posed.beat && !answered.right);
            let names = posed.choices.iter().map(|choice| plain(&label(choice))).collect();
            parts.push(Part::Answers { names, wrong: wrong.map(|answered| answered.choice) });
            if let Some(answered) = wrong {
                let text = reason(state, posed, &posed.choices[answered.choice]);
                parts.push(Part::Text { text, role: Role::Wrong, face: Face::Regular, size: 1.0 });
            }
            return Speech(parts);
        }
        if let Some((posed, answered)) = state.settled() {
            let text = format!("**{}**", label(&posed.choices[answered.choice]));
            parts.push(Part::Text { text, role: Role::Hit, face: Face::Regular, size: 1.1 });
        }
        let playback = state.playback();
        match state.beat().filter(|(_, step)| *step == state.view.step).zip(playback) {
            Some(((beat, step), playback)) => {
                parts.push(strong(escaped(&beat.title)));
                let text = said(beat, &playback.play, step, Medium::Window);
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
                let opening = || state.slide().map_or("", |slide| beginning(slide.plays)).to_owned();
                parts.push(plain_text(says.unwrap_or_else(opening)));
            }
        }
        Speech(parts)
    }

    /// All that beats say on this walk or build, their questions, and why answers are wrong.
    pub(super) fn all(state: &State) -> Vec<Speech> {
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

    /// How high it is.
    fn height(&self, ui: &Ui, formulas: &mut Formulas, prose: &Prose<'_>, width: f32) -> f32 {
        let heights = self.0.iter().map(|part| part.height(ui, formulas, prose, width));
        heights.sum::<f32>() + gap(prose.size) * self.0.len().saturating_sub(1) as f32
    }

    /// Shows it; says which command was asked for.
    pub(super) fn show(&self, ui: &mut Ui, formulas: &mut Formulas, prose: &Prose<'_>) -> Option<Command> {
        let mut asked = None;
        ui.spacing_mut().item_spacing.y = gap(prose.size);
        for part in &self.0 {
            ui.scope(|ui| asked = part.show(ui, formulas, prose).or(asked));
        }
        asked
    }
}

/// Between two parts, and between two buttons.
fn gap(body: f32) -> f32 {
    body * 0.55
}

/// How large what stands on the buttons of offers is.
const OFFER: f32 = 0.8;

impl Part {
    fn height(&self, ui: &Ui, formulas: &mut Formulas, prose: &Prose<'_>, width: f32) -> f32 {
        let Prose { theme, size: body, .. } = *prose;
        let button = |text: &str, size: f32, least: f32| {
            let padding = ui.spacing().button_padding;
            let wide = width - 2.0 * padding.x;
            let galley = ui.painter().layout(text.to_owned(), font(Face::Medium, size), ink(theme, Role::Text), wide);
            (galley.size().y + 2.0 * padding.y).max(least)
        };
        let buttons = |texts: &[String], size: f32, least: f32| {
            let heights = texts.iter().map(|text| button(text, size, least));
            heights.sum::<f32>() + gap(body) * texts.len().saturating_sub(1) as f32
        };
        match self {
            Part::Text { text, role, face, size } => {
                Prose { size: body * size, role: *role, face: *face, ..*prose }.height(ui, formulas, text, width)
            }
            Part::Answers { names, .. } => {
                let names: Vec<String> = names.iter().enumerate().map(|(at, name)| answer(at, name)).collect();
                buttons(&names, body, body * LEAST)
            }
            Part::Offers(words) => buttons(words, body * OFFER, ui.spacing().interact_size.y),
        }
    }

    fn show(&self, ui: &mut Ui, formulas: &mut Formulas, prose: &Prose<'_>) -> Option<Command> {
        let Prose { theme, size: body, .. } = *prose;
        let mut asked = None;
        match self {
            Part::Text { text, role, face, size } => {
                Prose { size: body * size, role: *role, face: *face, ..*prose }.show(ui, formulas, text);
            }
            Part::Answers { names, wrong } => {
                for (index, name) in names.iter().enumerate() {
                    let role = if *wrong == Some(index) { Role::Wrong } else { Role::Here };
                    let text = RichText::new(answer(index, name)).font(font(Face::Medium, body));
                    let button = Button::new(text.color(ink(theme, Role::Text)))
                        .fill(fill(theme, Role::Panel))
                        .stroke(Stroke::new(2.0, ink(theme, role)))
                        .corner_radius(body * 0.3)
                        .min_size(vec2(ui.available_width(), body * LEAST));
                    if ui.add(button).clicked() {
                        asked = Some(Command::Answer(index as u8));
                    }
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

/// The least height of an answer's button, in letters.
const LEAST: f32 = 1.65;

/// What stands on an answer's button.
fn answer(index: usize, name: &str) -> String {
    let letter = char::from(b'A' + index.min(25) as u8);
    format!("{letter}   {name}")
}

/// A title, which is shown word for word, as Markdown.
fn escaped(title: &str) -> String {
    title.chars().flat_map(|letter| letter.is_ascii_punctuation().then_some('\\').into_iter().chain([letter])).collect()
}
