//! What somebody has changed by hand, in words, with the way back: the scene, the cuts, a cut that is only tried.

use egui::{RichText, Ui};
use raystep_accel::{ByHand, Event, Grow, HandCut};
use raystep_figure::{Face, Role, Theme, number};

use crate::shown::command::Command;
use crate::shown::state::State;
use crate::window::look::fonts::font;
use crate::window::look::formulas::Formulas;
use crate::window::look::prose::{LEADING, Prose};

/// Shows it, if there is any; says which command was asked for.
pub(super) fn show(ui: &mut Ui, state: &State, theme: &Theme, formulas: &mut Formulas) -> Option<Command> {
    let prose = Prose { theme, size: 13.5, role: Role::Value, face: Face::Regular, leading: LEADING };
    let mut asked = None;
    let mut button = |ui: &mut Ui, words: &str, command: Command| {
        let words = RichText::new(words).font(font(Face::Medium, 13.0));
        if ui.button(words).on_hover_text(command.tip()).clicked() {
            asked = Some(command);
        }
    };
    let cuts = state.rule().and_then(|rule| rule.by_hand().copied()).filter(|cuts| !cuts.is_empty());
    let cuts: Vec<String> = cuts.iter().flat_map(ByHand::cuts).map(cut_name).collect();
    if state.target().own.is_some() || !cuts.is_empty() {
        ui.add_space(6.0);
        if let Some(own) = &state.target().own {
            let does = if own.moved.len() == 1 { "lies" } else { "lie" };
            let says = format!("**Your scene:** {} {does} where you put it.", own.told());
            let says = if own.moved.len() == 1 { says } else { says.replace("put it", "put them") };
            prose.show(ui, formulas, &says);
        }
        if !cuts.is_empty() {
            prose.show(ui, formulas, &format!("**Your cuts:** {}.", cuts.join(", ")));
        }
        button(ui, "Back to the slide's scene", Command::ResetScene);
        ui.add_space(2.0);
    }
    if let Some((cut, cost, least)) = tried(state) {
        ui.add_space(6.0);
        let whose = state.playback().map_or("plane", |playback| playback.reel().volume().cut);
        let mut says = format!("**Your {whose}:** {cut} would cost {}.", number(cost));
        if let Some(least) = least {
            says.push_str(&format!(" The least so far costs {}.", number(least)));
        }
        says.push_str(" The build, and exports of it, stay as they are until you cut there.");
        prose.show(ui, formulas, &says);
        button(ui, "Cut here", Command::CutHere);
        ui.add_space(2.0);
    }
    asked
}

/// `node 0 at x = 2.09`
fn cut_name(cut: HandCut) -> String {
    format!("node {} at {} = {}", cut.node, cut.axis, number(cut.at))
}

/// The cut that is tried, what it would cost, and the least that the builder has weighed so far.
fn tried(state: &State) -> Option<(String, f32, Option<f32>)> {
    let (tried, playback) = (state.view.tried?, state.playback()?);
    let Some(Event::Build(Grow::Weigh { cost, .. })) = playback.event(tried.step) else { return None };
    let own = state.made()?;
    let of_node = |event: &Event| match event {
        Event::Build(Grow::Weigh { node, cost, .. }) if *node == tried.cut.node => Some(*cost),
        _ => None,
    };
    let weighed = (1..=tried.step).filter_map(|step| own.event(step)).filter_map(|event| of_node(&event));
    let least = weighed.filter(|cost| cost.is_finite()).reduce(f32::min);
    Some((cut_name(tried.cut), cost, least))
}
