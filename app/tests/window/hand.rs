//! What is taken in the hand: shapes, planes and the cut that is weighed follow it, and so does all that is said.

use egui::{Event, Key, Modifiers, Pos2, Vec2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use raystep::shown::View;
use raystep::window::{App, Remembered, Wishes};
use raystep_accel::{
    Accel, Axis, CellId, Event as Happened, Grow, HandCut, NodeId, Place, PrimId, Primitives, Structure,
};
use raystep_lesson::Tape;

use crate::window::{self, Window, library, press, settle, sized};

fn window(slide: &str, size: [f32; 2]) -> Window {
    let mut harness = window::window(slide, size);
    harness.state_mut().state.predict = false;
    harness
}

/// Where something lies that can be taken: its middle.
fn place(harness: &Window, name: &str) -> Pos2 {
    harness.get_by_label(name).rect().center()
}

/// Whether something is said, however its words are kept together.
fn says(harness: &Window, words: &str) -> bool {
    let first = words.split(' ').next().unwrap_or_default();
    let mut found = harness.query_all_by_label_contains(first);
    found.any(|node| {
        let node = node.accesskit_node();
        let text = node.label().or_else(|| node.value()).unwrap_or_default();
        text.replace('\u{a0}', " ").contains(words)
    })
}

/// Takes what lies at a point and moves it, in a few frames; does not let go.
fn drag(harness: &mut Window, from: Pos2, by: Vec2) {
    harness.hover_at(from);
    harness.run_steps(1);
    harness.drag_at(from);
    harness.run_steps(1);
    for share in [0.3, 0.6, 1.0] {
        harness.hover_at(from + by * share);
        harness.run_steps(2);
    }
}

fn drop(harness: &mut Window, at: Pos2) {
    harness.drop_at(at);
    settle(harness);
}

fn view(harness: &Window) -> View {
    harness.state().state.view.clone()
}

/// What happens on a walk, as it is shown.
fn shown(harness: &Window) -> String {
    let playback = harness.state().state.playback().unwrap();
    format!("{:?}", playback.play.tape.events().collect::<Vec<_>>())
}

/// What happens if everything is built and walked anew.
fn retraced(harness: &Window) -> String {
    let playback = harness.state().state.playback().unwrap();
    let (scene, mut events) = (&playback.play.scene, Vec::new());
    let structure = Structure::build(&scene.prims, &playback.rule, &mut ()).unwrap();
    structure.intersect(&scene.prims, &playback.play.tape.ray().unwrap(), &mut events);
    format!("{:?}", events.into_iter().map(Happened::Walk).collect::<Vec<_>>())
}

#[test]
fn what_is_dragged_takes_the_walk_along_and_one_undo_brings_it_back() {
    let check = |slide: &str, what: &str, from: Vec2, by: Vec2| {
        let mut harness = window(slide, [1600.0, 1000.0]);
        let (before, walk) = (view(&harness), shown(&harness));
        let from = place(&harness, what) + from;
        drag(&mut harness, from, by);
        assert!(says(&harness, "Your"), "{slide} {what}: it is said");
        drop(&mut harness, from + by);
        let after = view(&harness);
        assert!(!after.same_walk(&before), "{slide} {what} moves");
        assert_eq!(shown(&harness), retraced(&harness), "{slide} {what}");
        assert!(shown(&harness) != walk, "{slide} {what}: another walk");
        // One drag, one undo.
        harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        settle(&mut harness);
        assert!(view(&harness).same_page(&before), "{slide} {what}: undone");
        assert_eq!(shown(&harness), walk);
        harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
        settle(&mut harness);
        assert!(view(&harness).same_walk(&after), "{slide} {what}: done again");
        // One key brings the slide's scene back.
        harness.key_press_modifiers(Modifiers::SHIFT, Key::R);
        settle(&mut harness);
        assert!(view(&harness).same_walk(&before), "{slide} {what}: as the slide has it");
        // Escape takes back what is still held.
        drag(&mut harness, from, by);
        assert!(!view(&harness).same_walk(&before));
        press(&mut harness, Key::Escape);
        settle(&mut harness);
        assert!(view(&harness).same_page(&before), "{slide} {what}: taken back");
        harness.hover_at(from + by * 2.0);
        drop(&mut harness, from + by * 2.0);
        assert!(view(&harness).same_page(&before), "{slide} {what}: nothing is held any more");
    };
    // A box, a side of it; discs; a plane.
    check("2/15", "Polygon 0", Vec2::ZERO, vec2(300.0, 0.0));
    check("2/15", "Polygon 0, side 2", Vec2::ZERO, vec2(-500.0, 0.0));
    check("5/33", "Disc 6", Vec2::ZERO, vec2(0.0, -140.0));
    check("5/33", "Plane of node 0, across x", Vec2::ZERO, vec2(130.0, 20.0));
}

#[test]
fn the_step_stays_at_the_same_decision() {
    let mut harness = window("5/33", [1600.0, 1000.0]);
    press(&mut harness, Key::End);
    let from = place(&harness, "Disc 11");
    drag(&mut harness, from, vec2(60.0, 40.0));
    let playback = harness.state().state.playback().unwrap().clone();
    assert_eq!(view(&harness).step, playback.steps().last(), "the end stays the end");
    drop(&mut harness, from + vec2(60.0, 40.0));
}

#[test]
fn everything_is_moved_by_keyboard_too() {
    let mut harness = window("2/15", [1600.0, 1000.0]);
    let before = view(&harness);
    let corner = |harness: &Window| harness.state().state.playback().unwrap().play.scene.prims.bounds(PrimId(0)).max;
    let at = corner(&harness);
    harness.get_by_label("Polygon 0, corner 3").focus();
    harness.run_steps(2);
    press(&mut harness, Key::ArrowRight);
    settle(&mut harness);
    let step = corner(&harness).x - at.x;
    assert!(step > 0.0 && corner(&harness).y == at.y, "an arrow moves it");
    harness.key_press_modifiers(Modifiers::SHIFT, Key::ArrowRight);
    settle(&mut harness);
    let fine = corner(&harness).x - at.x - step;
    assert!(fine > 0.0 && fine < step * 0.2, "with Shift finely: {step}, then {fine}");
    assert_eq!(view(&harness).step, before.step, "an arrow that moves something is no step");
    press(&mut harness, Key::Escape);
    for _ in 0..2 {
        harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        settle(&mut harness);
    }
    assert!(view(&harness).same_page(&before), "two presses, two undos");
}

/// The cut that is weighed at the shown step, and what it costs.
fn weighed(harness: &Window) -> (HandCut, f32) {
    let state = &harness.state().state;
    match state.playback().unwrap().event(state.view.step) {
        Some(Happened::Build(Grow::Weigh { node, axis, plane, cost, .. })) => {
            (HandCut { node, axis: axis.axis().unwrap(), at: plane }, cost)
        }
        other => panic!("no cut is weighed: {other:?}"),
    }
}

#[test]
fn the_cut_that_is_weighed_is_tried_without_changing_the_build() {
    for (slide, by) in [("5/30", 150.0), ("7/53", -120.0)] {
        let mut harness = window(slide, [1600.0, 1000.0]);
        let before = view(&harness);
        let built = harness.state().state.made().unwrap().clone();
        let (own, cost) = weighed(&harness);
        let name = format!("Cut of node {} across {}", own.node, own.axis);
        let from = place(&harness, &name);
        assert_eq!(own.axis, Axis::X, "{slide}");
        drag(&mut harness, from, vec2(by, 0.0));
        let (tried, other) = weighed(&harness);
        assert!(tried.at != own.at && other != cost, "{slide}: it follows");
        // The builder's own word.
        let (prims, rule) = (&built.play.scene.prims, &built.rule);
        let Some(Grow::Weigh { cost: told, p_below, p_above, .. }) = Structure::weigh(prims, rule, tried) else {
            panic!("{slide}: it is weighed")
        };
        assert_eq!(told, other, "{slide}");
        assert!(p_below > 0.0 && p_above > 0.0, "{slide}");
        let said = raystep_figure::number(told);
        assert!(says(&harness, &format!("would cost {said}.")), "{slide}: {said} is said");
        assert!(std::sync::Arc::ptr_eq(harness.state().state.made().unwrap(), &built), "{slide}: the build stays");
        press(&mut harness, Key::Escape);
        assert_eq!(weighed(&harness), (own, cost), "{slide}: taken back");
        harness.drop_at(from);
        harness.run_steps(2);

        // Let go, it stays until one goes on; one undo takes it away.
        drag(&mut harness, from, vec2(by, 0.0));
        drop(&mut harness, from + vec2(by, 0.0));
        assert_eq!(weighed(&harness), (tried, other), "{slide}");
        harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        settle(&mut harness);
        assert_eq!(weighed(&harness), (own, cost), "{slide}");
        assert!(view(&harness).same_page(&before), "{slide}");
        harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
        settle(&mut harness);
        assert_eq!(weighed(&harness), (tried, other), "{slide}: tried again");
        press(&mut harness, Key::ArrowRight);
        press(&mut harness, Key::ArrowLeft);
        assert_eq!(weighed(&harness), (own, cost), "{slide}: whoever goes on leaves it");

        // By keyboard; and then the node is cut there.
        harness.get_by_label(&name).focus();
        harness.run_steps(2);
        press(&mut harness, Key::ArrowRight);
        let (tried, _) = weighed(&harness);
        assert!(tried.at > own.at, "{slide}: the arrow moves it");
        harness.get_by_label("Cut here").click();
        settle(&mut harness);
        let state = &harness.state().state;
        let Some(Happened::Build(Grow::Split { node, axis, plane, .. })) =
            state.playback().unwrap().event(state.view.step)
        else {
            panic!("{slide}: the node is divided now")
        };
        assert_eq!((node, axis, plane), (NodeId(0), tried.axis.into(), tried.at), "{slide}");
        assert!(says(&harness, "Your cuts: node 0 at x"), "{slide}");
        press(&mut harness, Key::Backspace);
        settle(&mut harness);
        assert!(view(&harness).same_walk(&before), "{slide}: the slide's own build");
    }
}

#[test]
fn an_open_question_is_not_answered_by_dragging() {
    let mut harness = window("5/30", [1600.0, 1000.0]);
    harness.state_mut().state.predict = true;
    let posed = harness.state().state.playback().unwrap().posed[0].clone();
    harness.state_mut().state.go(posed.before);
    harness.run_steps(2);
    while harness.state().state.question().is_none() {
        press(&mut harness, Key::ArrowRight);
    }
    let (own, _) = weighed(&harness);
    assert!(harness.query_by_label(&format!("Cut of node {} across {}", own.node, own.axis)).is_none());
    harness.state_mut().state.try_cut(HandCut { at: own.at * 0.9, ..own });
    assert_eq!(weighed(&harness).0, own);
}

#[test]
fn a_step_moves_and_any_key_ends_the_motion() {
    let mut moving = Remembered::default();
    moving.motion = Some(true);
    let wishes = Wishes { slide: Some("5/33".to_owned()), ..Wishes::default() };
    let mut harness = sized([1600.0, 1000.0])
        .with_step_dt(0.02)
        .build_eframe(|context| App::wished(&context.egui_ctx, library(), wishes, moving));
    settle(&mut harness);
    harness.state_mut().state.predict = false;
    harness.run_steps(20);
    let still = |harness: &mut Window| {
        harness.run_steps(1);
        let shapes = &harness.output().shapes;
        shapes.iter().map(|clipped| clipped.shape.visual_bounding_rect()).collect::<Vec<_>>()
    };
    let (before, again) = (still(&mut harness), still(&mut harness));
    assert_eq!(before, again, "nothing moves by itself");
    let step = view(&harness).step;
    harness.key_press(Key::ArrowRight);
    let first = still(&mut harness);
    assert!(view(&harness).step > step, "the step is there at once");
    let second = still(&mut harness);
    assert!(first != second, "the picture is on its way");
    harness.run_steps(20);
    let end = still(&mut harness);
    assert!(end != second && end == still(&mut harness), "and arrives");
    // Back and forth again; a key in between ends it.
    harness.key_press(Key::ArrowLeft);
    harness.run_steps(30);
    harness.key_press(Key::ArrowRight);
    harness.run_steps(2);
    harness.event(Event::Key {
        key: Key::F24,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: Modifiers::NONE,
    });
    assert_eq!(still(&mut harness), end, "any key ends it at once");
    // A jump is no step: nothing moves.
    press(&mut harness, Key::Home);
    let there = still(&mut harness);
    assert_eq!(there, still(&mut harness));
}

/// A number of the meter that is shown, and what the meter's last row makes of all of them.
fn metered(harness: &Window, name: &str) -> (f64, String) {
    let playback = harness.state().state.playback().unwrap();
    let Tape::Board(board) = &playback.play.tape else { panic!("a board") };
    // The row by the meter is the sixth of slide 8.
    (board.numbers.get(name).unwrap(), format!("{:?}", board.events[5]))
}

#[test]
fn a_number_of_a_meter_is_dragged_moved_by_arrows_and_typed() {
    let mut harness = window("1/8", [1600.0, 1000.0]);
    press(&mut harness, Key::Home);
    for _ in 0..6 {
        settle(&mut harness);
        assert!(harness.query_by_label("Nx: 1000").is_none(), "it waits for the row that follows it");
        press(&mut harness, Key::ArrowRight);
    }
    settle(&mut harness);
    let (before, (own, tests)) = (view(&harness), metered(&harness, "Nx"));
    assert_eq!(own, 1000.0);
    let from = place(&harness, "Nx: 1000");
    drag(&mut harness, from, vec2(60.0, 0.0));
    let (held, more) = metered(&harness, "Nx");
    assert!(held > own && more != tests, "it follows: {held}");
    assert_eq!(metered(&harness, "Ny").0, 1000.0, "the others stay");
    press(&mut harness, Key::Escape);
    settle(&mut harness);
    assert!(view(&harness).same_page(&before), "taken back");
    harness.drop_at(from);
    harness.run_steps(2);

    drag(&mut harness, from, vec2(60.0, 0.0));
    drop(&mut harness, from + vec2(60.0, 0.0));
    assert_eq!(metered(&harness, "Nx"), (held, more));
    assert_eq!(view(&harness).step, before.step, "the step stays");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    settle(&mut harness);
    assert!(view(&harness).same_page(&before), "one drag, one undo");
    assert_eq!(metered(&harness, "Nx"), (own, tests.clone()));

    // By keyboard.
    harness.get_by_label("Nx: 1000").focus();
    harness.run_steps(2);
    press(&mut harness, Key::ArrowRight);
    settle(&mut harness);
    let (moved, _) = metered(&harness, "Nx");
    assert!(moved > own, "an arrow moves it");
    assert_eq!(view(&harness).step, before.step, "and is no step");
    // A whole number moves at least by one.
    harness.key_press_modifiers(Modifiers::SHIFT, Key::ArrowLeft);
    settle(&mut harness);
    let (fine, _) = metered(&harness, "Nx");
    assert!(fine < moved && moved - fine < moved - own, "{fine}");
    assert!(says(&harness, &format!("{} · 1000 · 1000", raystep_figure::number(fine as f32))), "it is said");

    // Typed.
    harness.get_by_label("Nx, typed").click();
    harness.run_steps(2);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.event(Event::Text("2,500".to_owned()));
    harness.run_steps(2);
    press(&mut harness, Key::Enter);
    settle(&mut harness);
    assert_eq!(metered(&harness, "Nx").0, 2500.0);
    // The slide's own numbers.
    press(&mut harness, Key::Backspace);
    settle(&mut harness);
    assert_eq!(metered(&harness, "Nx"), (own, tests));
}

/// The pair and the arrangement that are shown.
fn laid_out(harness: &Window) -> (u32, u32) {
    match harness.state().state.playback().unwrap().event(view(harness).step) {
        Some(Happened::Pair(trial)) => (trial.pair, trial.case),
        other => panic!("no pair lies there: {other:?}"),
    }
}

/// What the tests of all pairs answer.
fn answers(harness: &Window) -> Vec<&'static str> {
    let tape = &harness.state().state.playback().unwrap().play.tape;
    let answer = |event: Happened| {
        let name = event.name();
        (name.starts_with("met") || name.starts_with("touch")).then_some(name)
    };
    tape.events().filter_map(answer).collect()
}

#[test]
fn the_first_object_of_a_pair_is_dragged_and_its_test_runs_again() {
    let mut harness = window("3/19", [1600.0, 1000.0]);
    let (before, own) = (view(&harness), answers(&harness));
    assert_eq!((laid_out(&harness), own[0]), ((0, 1), "met.hit"));
    // Above the plane, and rising.
    let from = place(&harness, "The ray that can be moved");
    drag(&mut harness, from, vec2(0.0, -150.0));
    drop(&mut harness, from + vec2(0.0, -150.0));
    let moved = answers(&harness);
    assert_eq!((moved[0], &moved[1..]), ("met.miss", &own[1..]), "this test alone answers otherwise");
    assert_eq!(laid_out(&harness), (0, 1), "it is still the same pair");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    settle(&mut harness);
    assert!(view(&harness).same_page(&before) && answers(&harness) == own, "one drag, one undo");
    // By keyboard.
    harness.get_by_label("The ray that can be moved").focus();
    harness.run_steps(2);
    press(&mut harness, Key::ArrowUp);
    settle(&mut harness);
    assert!(!view(&harness).same_walk(&before) && view(&harness).step == before.step);
    press(&mut harness, Key::Escape);

    // A click on a cell lays its pair out, another one its other arrangement; so it goes forth and back.
    for (cell, shown) in [(3, (3, 1)), (3, (3, 2)), (3, (3, 1)), (0, (0, 1)), (22, (22, 1))] {
        harness.state_mut().state.pick(Some(Place::Cell(CellId(cell))), false);
        settle(&mut harness);
        assert_eq!(laid_out(&harness), shown);
        assert_eq!(harness.state().state.picked, None, "nothing stays lit");
    }
}
