//! While a question is open the page shows what led to it, and nothing that it asks for.

use std::collections::BTreeSet;
use std::sync::Arc;

use glam::Vec2;
use raystep_accel::{Axis, Event, Place, Value};
use raystep_figure::{Figure, Form, Ink, Look, Role, TreeView, sentence, veiled};
use raystep_lesson::Library;

use super::State;
use crate::shown::all_nodes::AllNodes;
use crate::shown::pictures::{Pane, Pictures};
use crate::shown::playback::{Built, Playback, Posed};
use crate::shown::view::{RayChoice, View};
use crate::shown::words::label;

/// What a page shows: the texts of each pane, and the roles in which it draws a place.
struct Shown {
    texts: Vec<(&'static str, BTreeSet<String>)>,
    roles: Vec<(&'static str, Option<Place>, Role)>,
}

const PANES: [Pane; 14] = [
    Pane::Picture,
    Pane::Ruler,
    Pane::RulerLine,
    Pane::Tree,
    Pane::Cells,
    Pane::Matrix,
    Pane::Slabs,
    Pane::Bytes,
    Pane::Listing,
    Pane::Changed,
    Pane::Stack,
    Pane::Bin,
    Pane::Work,
    Pane::Timeline,
];

/// Everything that the page of a state says and marks.
fn shown(state: &State) -> Shown {
    let mut pictures = Pictures::of(None, state).expect("a walk");
    let code = state.slide().and_then(|slide| state.library.listing(&slide.listing)).cloned();
    let mut shown = Shown { texts: Vec::new(), roles: Vec::new() };
    for pane in PANES {
        let figure =
            pictures.pane(pane, Vec2::new(900.0, 500.0), &Look::WINDOW, code.as_ref(), &TreeView::default(), None);
        shown.texts.push((pane.name(), texts(&figure)));
        shown.roles.extend(figure.marks.iter().map(|mark| (pane.name(), mark.place, mark.role)));
    }
    let marks = pictures.space.as_ref().map_or(&[][..], |space| &space.marks);
    let labels = marks.iter().filter_map(|mark| match &mark.form {
        Form::Label { text, .. } if mark.role != Role::Guess => Some(text.clone()),
        _ => None,
    });
    shown.texts.push(("Space", labels.collect()));
    let marks = marks.iter().filter(|mark| mark.role != Role::Guess);
    shown.roles.extend(marks.map(|mark| ("Space", mark.place, mark.role)));
    let event = state.playback().and_then(|playback| playback.event(state.view.step));
    let event = event.map(|event| if state.question().is_some() { veiled(&event) } else { event });
    let says = state.playback().zip(event).map(|(playback, event)| sentence(&event, playback.reel().volume()));
    shown.texts.push(("sentence", says.into_iter().collect()));
    shown
}

fn texts(figure: &Figure) -> BTreeSet<String> {
    let texts = figure.marks.iter().filter_map(|mark| match &mark.ink {
        Ink::Text { text, .. } => Some(text.clone()),
        _ => None,
    });
    texts.collect()
}

/// Words of the page itself: how large a node is, which step it is and was compared with, which of two arrangements,
/// what a sign means.
const SETTING: [&str; 7] = [" bytes", "64 bit: ", "step ", "arrangement ", "so many ", " nodes drawn", "level "];

/// The words that would give an answer away.
fn words(value: &Value, label: &str) -> Vec<String> {
    let words: &[&str] = match value {
        Value::Word("hit", _) => &["hit", "hits"],
        Value::Word("miss", _) => &["missed", "misses", "empty"],
        Value::Word("cut", _) => &["too far"],
        Value::Word(word, _) => &[word],
        Value::Axis(Axis::X | Axis::Y | Axis::Z) | Value::Place(_) | Value::Flag(_) | Value::Count(_) => &[],
        _ => return vec![label.to_owned()],
    };
    words.iter().map(|word| (*word).to_owned()).collect()
}

/// Whether a text holds these words, not as a part of other words or numbers.
fn holds(text: &str, words: &str) -> bool {
    let part = |c: char| c.is_alphanumeric() || c == '−';
    text.match_indices(words).any(|(at, _)| {
        let before = text[..at].trim_end_matches('.').chars().next_back();
        let after = text[at + words.len()..].trim_start_matches('.').chars().next();
        !before.is_some_and(part) && !after.is_some_and(char::is_alphanumeric)
    })
}

/// What the open question's page gives away that the page of the step before did not.
/// What the step itself tells, `now`, has happened, and may be said and marked.
fn given_away(posed: &Posed, now: Option<&Event>, asked: &Shown, before: &Shown) -> Vec<String> {
    let mut found = Vec::new();
    let (right, wrong): (Vec<_>, Vec<_>) = posed.choices.iter().partition(|choice| choice.right);
    let Some(right) = right.first() else { return found };
    // Who takes part is told with every event of a packet.
    let told = now.is_some_and(|event| {
        event.fields().iter().chain(&["lanes"]).any(|field| event.field(field) == Some(right.value))
    });
    for ((pane, now), (_, then)) in asked.texts.iter().zip(&before.texts) {
        let fresh = now.difference(then).filter(|text| !SETTING.iter().any(|words| text.contains(words)));
        let fresh: Vec<&String> = fresh.collect();
        let says = |words: &[String]| fresh.iter().find(|text| words.iter().any(|word| holds(text, word)));
        let others = wrong.iter().any(|choice| says(&words(&choice.value, &label(choice))).is_some());
        if let Some(text) = says(&words(&right.value, &label(right))).filter(|_| !others && !told) {
            found.push(format!("{pane} says {text:?}"));
        }
    }
    // Of places that may be the answer none is marked as no other is.
    let Some(place) = right.place.filter(|place| now.is_none_or(|event| event.place() != *place)) else { return found };
    let roles = |shown: &Shown, place: Place| -> BTreeSet<(&str, Role)> {
        let here = shown.roles.iter().filter(|(_, at, _)| *at == Some(place));
        here.map(|(pane, _, role)| (*pane, *role))
            .filter(|(_, role)| !matches!(role, Role::Text | Role::Quiet))
            .collect()
    };
    let fresh = |place| roles(asked, place).difference(&roles(before, place)).copied().collect::<BTreeSet<_>>();
    let own = fresh(place);
    for other in wrong.iter().filter_map(|choice| choice.place) {
        found.extend(own.difference(&fresh(other)).map(|(pane, role)| format!("{pane} marks the answer as {role:?}")));
    }
    found
}

#[test]
fn an_open_question_gives_nothing_away() {
    let library = Arc::new(Library::embedded());
    let (mut found, mut asked) = (Vec::new(), 0);
    for (index, slide) in library.slides.iter().enumerate() {
        for stage in &slide.stages {
            let built = stage.draft(slide.plays).expect("a shipped stage");
            let rule = stage.plan.rule(built.scene.flat).expect("a shipped rule");
            let nodes = Arc::new(AllNodes::of(&built.structure, built.told.as_ref()));
            let raystep_lesson::Built { scene, structure, told } = built;
            let built = Built { scene, rule, structure, nodes, told, seconds: 0.0 };
            let rays = if !slide.plays.has_rays() { 1 } else { stage.rays.len() };
            for ray in 0..rays {
                let view = View { ray: RayChoice::Named(ray), ..View::of_slide(index, stage.kind) };
                let own = stage.rays.get(ray).map(|ray| ray.ray);
                let playback = Playback::new(view.clone(), built.clone(), own, slide, stage).expect("a walk");
                let mut state = State::new(library.clone(), index);
                state.wanted = Some(view);
                assert!(state.arrive(Arc::new(playback)));
                let playback = state.playback().expect("a walk").clone();
                for posed in playback.posed.clone() {
                    let Some(earlier) = posed.before.checked_sub(1) else { continue };
                    state.predict = false;
                    state.go(earlier);
                    let before = shown(&state);
                    state.predict = true;
                    state.go(posed.before);
                    state.asking = true;
                    assert_eq!(state.question(), Some(&posed));
                    asked += 1;
                    let which = || format!("{} {:?} ray {ray} step {}", slide.id(), stage.kind, posed.before);
                    let away = given_away(&posed, playback.event(posed.before).as_ref(), &shown(&state), &before);
                    found.extend(away.into_iter().map(|what| format!("{}: {what}", which())));
                }
            }
        }
    }
    assert!(asked > 80, "{asked} questions");
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn the_test_would_have_found_it() {
    let page = |says: &str| Shown { texts: vec![("Slabs", [says.to_owned()].into())], roles: Vec::new() };
    let word = |word| Value::Word(word, &["hit", "miss", "cut"]);
    let choice = |value, right| raystep_lesson::Choice {
        label: None,
        value,
        place: None,
        right,
        reason: None,
        own: None,
        of_list: false,
    };
    let verdict =
        Posed { beat: 0, before: 1, step: 2, choices: vec![choice(word("hit"), false), choice(word("miss"), true)] };
    let before = page("so far [0, 3]");
    assert_eq!(given_away(&verdict, None, &page("Empty: 3 > 2. The box is missed."), &before).len(), 1);
    assert_eq!(given_away(&verdict, None, &page("so far [3, 2]"), &before).len(), 0);
    let number =
        Posed { choices: vec![choice(Value::Number(8.0), true), choice(Value::Number(9.0), false)], ..verdict };
    assert_eq!(given_away(&number, None, &page("8"), &before).len(), 1);
    assert_eq!(given_away(&number, None, &page("18 and 8.5"), &before).len(), 0);
    let tested = raystep_accel::Visit::Test { prim: raystep_accel::PrimId(0), t: 8.0, hit: true };
    assert_eq!(given_away(&number, Some(&Event::Walk(tested)), &page("t = 8"), &before).len(), 0);
}
