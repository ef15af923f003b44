//! The column at the left: what the slide says at this step, and its question.

use egui::{Frame, Margin, RichText, ScrollArea, Ui};
use raystep_figure::{Face, Role, Theme, sentence, told};

use super::command::Command;
use super::fonts::font;
use super::formulas::Formulas;
use super::prose::Prose;
use super::question;
use super::state::State;
use super::visuals::ink;
use crate::reel::beginning;

/// Shows the lesson; says which command was asked for.
pub(super) fn pane(ui: &mut Ui, state: &State, theme: &Theme, formulas: &mut Formulas) -> Option<Command> {
    let mut asked = None;
    ScrollArea::vertical().id_salt("lesson").auto_shrink(false).show(ui, |ui| {
        Frame::new().inner_margin(Margin { left: 22, right: 20, top: 18, bottom: 18 }).show(ui, |ui| {
            ui.set_width(ui.available_width());
            asked = content(ui, state, theme, formulas);
        });
    });
    asked
}

fn content(ui: &mut Ui, state: &State, theme: &Theme, formulas: &mut Formulas) -> Option<Command> {
    let Some(slide) = state.slide() else {
        ui.label("There are no slides.");
        return None;
    };
    ui.label(RichText::new(&slide.title).font(font(Face::Bold, 22.0)));
    let prose = Prose { theme, size: 14.5, role: Role::Text, face: Face::Regular };
    if let Some(mesh) = &state.view.mesh {
        prose.show(ui, formulas, &format!("Your own mesh: {}, {} triangles.", mesh.title, prims(mesh)));
        let quiet = Prose { role: Role::Quiet, size: 13.0, ..prose };
        quiet.show(ui, formulas, &mesh.note);
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

    let event = state.playback().and_then(|playback| playback.event(state.view.step));
    let says = state.playback().zip(event).map(|(playback, event)| sentence(&event, playback.reel().volume()));
    match state.beat() {
        Some((beat, step)) => {
            let at = state.playback().and_then(|playback| playback.event(step));
            let later = state.view.step > step;
            if beat.title != slide.title {
                ui.add_space(2.0);
                ui.horizontal_wrapped(|ui| {
                    ui.label(RichText::new(&beat.title).font(font(Face::Medium, 15.5)).color(ink(theme, Role::Here)));
                    // The text below stays while the walk goes on: it speaks of its own step.
                    if later {
                        said(ui, theme, &format!("at step {step}"));
                    }
                });
            }
            if let Some(at) = at {
                prose.show(ui, formulas, &told(&beat.text(&at, state.view.stage), &at));
            }
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
    question::show(ui, state, theme, formulas)
}

/// The sentence of an event that no beat speaks of.
fn said(ui: &mut Ui, theme: &Theme, sentence: &str) {
    ui.label(RichText::new(sentence).font(font(Face::Regular, 14.5)).color(ink(theme, Role::Quiet)));
}

fn prims(scene: &raystep_scene::Scene) -> usize {
    raystep_accel::Primitives::len(&scene.prims)
}
