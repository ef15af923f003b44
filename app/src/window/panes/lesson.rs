//! The column at the left: what the slide says at this step, and its question.

use egui::{Button, Frame, Margin, Panel, RichText, ScrollArea, Ui, UiBuilder};
use raystep_figure::{Face, Role, Theme, counted, veiled};
use raystep_lesson::Medium;

use super::page::Asked;
use super::{changes, question};
use crate::shown::command::Command;
use crate::shown::reel::{beginning, said as said_by};
use crate::shown::state::State;
use crate::window::look::fonts::font;
use crate::window::look::formulas::Formulas;
use crate::window::look::markdown::together;
use crate::window::look::prose::{LEADING, Prose};
use crate::window::look::visuals::ink;
use crate::window::look::words::Words;

/// How high the sign is that says that there is more.
const SIGN: f32 = 28.0;

/// What the column keeps from frame to frame.
#[derive(Clone, Copy, Default)]
struct Scroll {
    /// Whether the text is longer than the column.
    long: bool,
    /// Whether its end is in sight.
    at_end: bool,
    /// Where to scroll to.
    to: Option<f32>,
    /// What is said, as far as it decides where one reads on.
    stamp: Stamp,
}

/// The slide, the step, whether a question is open, and the answer given.
type Stamp = (usize, usize, bool, Option<usize>);

fn stamp(state: &State) -> Stamp {
    let answered = state.answered.filter(|answered| !answered.right).map(|answered| answered.choice);
    (state.view.slide, state.view.step, state.question().is_some(), answered)
}

/// How wide the border below the last words is, in points.
const FOOT: i8 = 18;

/// Shows the lesson. What does not fit is scrolled, and a sign at the foot says so.
pub(super) fn pane(ui: &mut Ui, state: &State, theme: &Theme, formulas: &mut Formulas, asked: &mut Vec<Asked>) {
    let id = ui.scope_id().with("lesson scroll");
    let mut scroll: Scroll = ui.data(|data| data.get_temp(id)).unwrap_or_default();
    let room = ui.available_height();
    let fresh = scroll.stamp != stamp(state);
    scroll.stamp = stamp(state);
    if fresh && scroll.stamp.3.is_none() {
        scroll.to = Some(0.0);
    }
    if scroll.long && sign(ui, theme, scroll.at_end) {
        scroll.to = Some(if scroll.at_end { 0.0 } else { f32::INFINITY });
    }
    // What is too wide for the column does not widen it.
    let rect = ui.available_rect_before_wrap();
    let parent = ui;
    let ui = &mut parent.new_child(UiBuilder::new().max_rect(rect));
    ui.shrink_clip_rect(rect);
    let mut area = ScrollArea::vertical().id_salt("lesson").auto_shrink(false);
    if let Some(to) = scroll.to.take() {
        area = area.vertical_scroll_offset(to.min(1e6));
    }
    let shown = area.show(ui, |ui| {
        Frame::new().inner_margin(Margin { left: 22, right: 20, top: 18, bottom: FOOT }).show(ui, |ui| {
            ui.set_width(ui.available_width());
            content(ui, state, theme, formulas, fresh, asked);
        });
    });
    let seen = shown.state.clamped_offset().y + shown.inner_rect.height();
    // The border below the last words may lie out of sight.
    let words = shown.content_size.y - f32::from(FOOT);
    let long = words > room;
    let at_end = seen >= words;
    if (long, at_end) != (scroll.long, scroll.at_end) {
        ui.ctx().request_repaint();
    }
    (scroll.long, scroll.at_end) = (long, at_end);
    ui.data_mut(|data| data.insert_temp(id, scroll));
    parent.advance_cursor_after_rect(rect);
}

/// The sign that there is more than is seen; says whether it was clicked.
fn sign(ui: &mut Ui, theme: &Theme, at_end: bool) -> bool {
    let panel = Panel::bottom("lesson sign").exact_size(SIGN).resizable(false).frame(Frame::new());
    let says = if at_end { "▲  back to the top" } else { "▼  more below" };
    panel
        .show(ui, |ui| {
            let text = RichText::new(says).font(font(Face::Medium, 13.0)).color(ink(theme, Role::Here));
            ui.add_sized(ui.available_size(), Button::new(text).frame(false)).clicked()
        })
        .inner
}

fn content(ui: &mut Ui, state: &State, theme: &Theme, formulas: &mut Formulas, fresh: bool, asked: &mut Vec<Asked>) {
    let Some(slide) = state.slide() else {
        ui.label("There are no slides.");
        return;
    };
    ui.label(RichText::new(&slide.title).font(font(Face::Bold, 22.0)));
    let prose = Prose { theme, size: 14.5, role: Role::Text, face: Face::Regular, leading: LEADING };
    if let Some(mesh) = &state.view.mesh {
        prose.show(
            ui,
            formulas,
            &format!("Your own mesh: {}, {}.", mesh.title, counted(prims(mesh) as u64, "triangle", "triangles")),
        );
        let quiet = Prose { role: Role::Quiet, size: 13.0, ..prose };
        // A line each.
        mesh.note.lines().for_each(|note| quiet.show(ui, formulas, note));
    }
    if let Some(mistake) = state.view.example {
        prose.show(
            ui,
            formulas,
            &format!("No ray of this slide shows the mistake. Here is one that does: **{}**", mistake.title()),
        );
        let quiet = Prose { role: Role::Quiet, size: 13.0, ..prose };
        quiet.show(ui, formulas, mistake.consequence());
        quiet.show(ui, formulas, "Backspace goes back to the slide.");
    }

    let changed = changes::show(ui, state, theme, formulas);

    let event = state.playback().and_then(|playback| playback.event(state.view.step));
    // While a question is open nothing says what the numbers come to.
    let event = event.map(|event| if state.question().is_some() { veiled(&event) } else { event });
    let says = state.playback().zip(event).map(|(playback, event)| playback.reel().sentence(state.view.step, &event));
    match state.beat() {
        Some((beat, step)) => {
            let later = state.view.step > step;
            if beat.title != slide.title {
                ui.add_space(2.0);
                ui.horizontal_wrapped(|ui| {
                    ui.label(RichText::new(&beat.title).font(font(Face::Medium, 15.5)).color(ink(theme, Role::Here)));
                    // The text below stays while the walk goes on: it speaks of its own step.
                    if later {
                        said(ui, theme, &format!("at\u{a0}step\u{a0}{step}"));
                    }
                });
            }
            if let Some(playback) = state.playback() {
                let words = Words { library: &state.library, slide: state.view.slide, asked: None };
                let text = said_by(beat, &playback.play, step, Medium::Window);
                let words = prose.explain(ui, formulas, &text, words);
                asked.extend(words.asked.map(Asked::Slide));
            }
            asked.extend(offers(ui, state, 14.5).map(Asked::Command));
            // Later events say what they do themselves.
            if later && let Some(says) = says {
                said(ui, theme, &says);
            }
        }
        None => match says {
            Some(says) => said(ui, theme, &says),
            None => said(ui, theme, beginning(slide.plays)),
        },
    }
    ui.add_space(8.0);
    let top = ui.cursor().top();
    asked.extend(question::show(ui, state, theme, formulas).or(changed).map(Asked::Command));
    if fresh && state.question().is_some() {
        // A question that has just opened is seen whole, and why an answer is wrong.
        let foot = egui::Rect::from_x_y_ranges(ui.max_rect().x_range(), top..=ui.min_rect().bottom() + 14.0);
        let seen = ui.clip_rect();
        // One that is higher than the column stays where it begins in sight, below the slide's title.
        if foot.height() <= seen.height() || foot.top() > seen.center().y {
            ui.scroll_to_rect(foot, None);
        }
    }
}

/// A button for each thing that the beat offers to do.
pub(super) fn offers(ui: &mut Ui, state: &State, size: f32) -> Option<Command> {
    let mut asked = None;
    for (index, offer) in state.offers().into_iter().enumerate() {
        let words = RichText::new(&offer.words).font(font(Face::Medium, size));
        if ui.button(words).clicked() {
            asked = Some(Command::Offer(index as u8));
        }
    }
    asked
}

/// The sentence of an event that no beat speaks of.
fn said(ui: &mut Ui, theme: &Theme, sentence: &str) {
    let sentence = together(sentence);
    ui.label(RichText::new(sentence).font(font(Face::Regular, 14.5)).color(ink(theme, Role::Quiet)));
}

fn prims(scene: &raystep_scene::Scene) -> usize {
    raystep_accel::Primitives::len(&scene.prims)
}
