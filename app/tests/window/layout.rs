//! Where things stand in the window: nothing is cut, covered or moved, and borders can be dragged.

use egui::{Key, Modifiers, Pos2, Rect, pos2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use raystep::shown::{RayChoice, command::Command};
use raystep_accel::Grain;
use raystep_figure::{Face, text_width};
use raystep_lesson::{Facts, Plays, Slide};

use crate::window::{Window, library, settle, window};

/// Where the control of this name stands.
fn rect(harness: &Window, name: &str) -> Option<Rect> {
    let text = egui::accesskit::Role::Label;
    let mut found = harness.query_all_by_label(name).filter(|node| node.accesskit_node().role() != text);
    found.next().map(|node| node.rect())
}

fn at(harness: &Window, name: &str) -> Rect {
    rect(harness, name).unwrap_or_else(|| panic!("nothing is called {name}"))
}

/// Where the middle of the page is: space, or what a kind draws in its place.
fn stage(harness: &Window) -> Rect {
    rect(harness, "Picture").unwrap_or_else(|| at(harness, "Space"))
}

fn drag(harness: &mut Window, from: Pos2, to: Pos2) {
    harness.hover_at(from);
    harness.run_steps(2);
    harness.drag_at(from);
    harness.run_steps(2);
    for part in [0.3, 0.6, 1.0] {
        harness.hover_at(from + (to - from) * part);
        harness.run_steps(1);
    }
    harness.drop_at(to);
    harness.run_steps(3);
}

fn click(harness: &mut Window, at: Pos2, modifiers: Modifiers) {
    harness.event(egui::Event::PointerMoved(at));
    harness.run_steps(2);
    for pressed in [true, false] {
        let button = egui::PointerButton::Primary;
        harness.event_modifiers(egui::Event::PointerButton { pos: at, button, pressed, modifiers }, modifiers);
        harness.run_steps(1);
    }
    harness.run_steps(1);
}

fn ids() -> Vec<String> {
    library().slides.iter().map(Slide::id).collect()
}

#[test]
fn the_borders_between_rows_of_panes_are_dragged_on_both_sides() {
    for (pane, size) in [
        ("Tree", [1600.0, 1000.0]),
        ("t along the ray", [1600.0, 1000.0]),
        ("Work", [1600.0, 1000.0]),
        ("Stack", [1600.0, 1000.0]),
        ("Changed", [1600.0, 1000.0]),
        ("Tree", [1280.0, 800.0]),
    ] {
        for off in [-3.0, 3.0] {
            let mut harness = window("5/33", size);
            let before = at(&harness, pane);
            let from = pos2(before.center().x, before.top() + off);
            // The pane's own ground ends a little before its border.
            drag(&mut harness, from - vec2(0.0, 5.0), from - vec2(0.0, 35.0));
            let after = at(&harness, pane);
            let moved = before.top() - after.top();
            assert!((20.0..40.0).contains(&moved), "{pane} at {size:?}, {off} beside its border: moved by {moved}");
        }
    }
}

#[test]
fn the_tree_and_the_code_stand_side_by_side_on_a_laptop() {
    for size in [[1600.0, 1000.0], [1280.0, 800.0], [1024.0, 768.0]] {
        for (slide, best) in [("5/33", "Tree"), ("3/20", "Cells"), ("7/56b", "Tree"), ("2/13b", "Slabs")] {
            let harness = window(slide, size);
            let (tree, code) = (at(&harness, best), at(&harness, "Walk"));
            for pane in [tree, code] {
                assert!(pane.height() > 90.0 && pane.bottom() <= size[1], "{slide} at {size:?}: {pane:?}");
            }
            assert!(!tree.intersects(code), "{slide} at {size:?}: {tree:?} and {code:?}");
        }
    }
}

#[test]
fn nothing_in_the_top_bar_is_cut_or_covers_another() {
    for size in [[1600.0, 1000.0], [1500.0, 900.0], [1440.0, 900.0], [1280.0, 800.0], [1024.0, 768.0], [900.0, 600.0]] {
        let mut harness = window("1/1", size);
        for index in 0..ids().len() {
            harness.state_mut().state.show_slide(index);
            settle(&mut harness);
            let slide = harness.state().state.slide().unwrap().clone();
            let outline = at(&harness, "Outline of slides");
            let next = at(&harness, "Next slide");
            let title = text_width(&slide.title, Face::Medium, 13.5) + 34.0;
            // The smallest window may cut what is long; the others cut nothing.
            if size[0] > 1000.0 {
                assert!(title <= outline.width() + 0.5, "{} at {size:?} is cut", slide.title);
            }
            assert!(outline.right() <= next.left() + 0.5, "{outline:?} covers {next:?}");
            let rays = harness.state().state.stage().unwrap().rays.len();
            for ray in 0..rays {
                harness.state_mut().state.show_ray(RayChoice::Named(ray), false);
                settle(&mut harness);
                let name = harness.state().state.stage().unwrap().rays[ray].name.clone();
                let shown = at(&harness, &format!("Ray: {name}"));
                let needed = text_width(&name, Face::Medium, 13.5) + 34.0;
                assert!(shown.width() >= needed - 0.5 || size[0] < 1000.0, "{} {name} at {size:?} is cut", slide.id());
                assert!(next.right() <= shown.left() + 0.5, "{} at {size:?}: {shown:?} covers {next:?}", slide.id());
                assert!(shown.right() <= at(&harness, "Flat").left() + 0.5);
            }
        }
    }
}

#[test]
fn the_list_of_slides_opens_at_ones_own_and_is_as_long_as_the_window() {
    for (slide, size) in [("5/33", [1600.0, 1000.0]), ("8/66", [1024.0, 768.0]), ("1/1", [900.0, 600.0])] {
        let mut harness = window(slide, size);
        let row = |slide: &Slide| format!("{}   {}", slide.title, slide.numbers_text());
        let own = row(harness.state().state.slide().unwrap());
        let list = at(&harness, "Outline of slides");
        harness.hover_at(list.center());
        harness.drag_at(list.center());
        harness.drop_at(list.center());
        harness.run_steps(8);
        let room = list.bottom()..size[1];
        let seen = |harness: &Window, row: &str| {
            let rect = rect(harness, row);
            rect.filter(|rect| room.contains(&rect.top()) && room.contains(&rect.bottom()))
        };
        assert!(seen(&harness, &own).is_some(), "{slide} at {size:?}: {own} is not seen");
        let rows: Vec<String> = harness.state().state.library.slides.iter().map(row).collect();
        let shown: f32 = rows.iter().filter_map(|row| Some(seen(&harness, row)?.height())).sum();
        assert!(shown > size[1] * 0.5, "{slide} at {size:?}: rows of {shown} points are seen");
    }
}

/// The button that shows the structure, whatever its name.
fn structure(harness: &Window) -> Rect {
    harness.get_by_label_contains("Structure: ").rect()
}

#[test]
fn the_buttons_stand_still_from_slide_to_slide() {
    for size in [[1600.0, 1000.0], [1440.0, 900.0], [1390.0, 800.0], [1280.0, 800.0], [1024.0, 768.0], [900.0, 600.0]] {
        let mut harness = window("5/33", size);
        let names = ["Predict", "Present", "Compare", "Flat", "Solid", "More", "Next slide", "Previous slide"];
        let first: Vec<(&str, Rect)> =
            names.into_iter().filter_map(|name| Some((name, rect(&harness, name)?))).collect();
        assert!(first.len() + 1 >= names.len(), "only Present may stand in the menu");
        let shown = structure(&harness);
        let check = |harness: &Window, what: &str| {
            // Boards and pairs have neither stages nor a structure to choose, what is fitted has stages alone; all else stands where it always does.
            let board = matches!(harness.state().state.slide().unwrap().plays, Plays::Board | Plays::Pairs);
            for (name, first) in &first {
                if board && ["Flat", "Solid"].contains(name) {
                    assert_eq!(rect(harness, name), None, "{what} at {size:?}");
                    continue;
                }
                let moved = (at(harness, name).min - first.min).length();
                assert!(moved < 0.5, "{what} at {size:?}: {name} moves by {moved}");
            }
            if board || harness.state().state.slide().unwrap().plays == Plays::Fit {
                return;
            }
            let now = structure(harness);
            let moved = (now.min - shown.min).length() + (now.max - shown.max).length();
            assert!(moved < 0.5, "{what} at {size:?}: the structure goes from {shown:?} to {now:?}");
            // The list of rays begins with the longest name that has room, and ends at the structure.
            if let Some(rays) = harness.query_all_by_label_contains("Ray: ").map(|node| node.rect()).next() {
                assert!((shown.left() - rays.right() - 6.0).abs() < 0.6, "{what} at {size:?}: {rays:?}, {shown:?}");
            }
        };
        for index in 0..ids().len() {
            harness.state_mut().state.show_slide(index);
            settle(&mut harness);
            check(&harness, &format!("slide {index}"));
        }
        // Nor when a parameter is changed, where there is one of that name.
        for (slide, key, value) in [("5/33", "max_depth", "3"), ("3/20", "prune", "false")] {
            let index = ids().iter().position(|id| id == slide).expect("a slide");
            harness.state_mut().state.show_slide(index);
            harness.state_mut().state.set(key, value);
            settle(&mut harness);
            check(&harness, &format!("{slide} with {key} = {value}"));
        }
    }
}

#[test]
fn the_picture_stands_still_from_step_to_step() {
    for size in [[1600.0, 1000.0], [1280.0, 800.0], [900.0, 600.0]] {
        for slide in ["2/13b", "3/20", "5/30", "5/33", "7/56b"] {
            let mut harness = window(slide, size);
            let first = stage(&harness);
            harness.state_mut().state.grain = Grain::Visit;
            harness.state_mut().state.apply(Command::First);
            let last = harness.state().state.playback().unwrap().steps().last();
            while harness.state().state.view.step < last {
                harness.state_mut().state.apply(Command::Next);
                harness.run_steps(1);
                let now = stage(&harness);
                let moved = (now.min - first.min).length().max((now.max - first.max).length());
                assert!(moved < 1.0, "{slide} at {size:?}: from {first:?} to {now:?}");
            }
        }
    }
}

#[test]
fn a_question_and_why_an_answer_is_wrong_are_seen_or_said_to_be_below() {
    for size in [[1280.0, 800.0], [1024.0, 768.0], [900.0, 600.0]] {
        for slide in ["5/30", "5/33", "3/20", "2/15", "7/56"] {
            let mut harness = window(slide, size);
            let playback = harness.state().state.playback().unwrap().clone();
            let posed = playback.posed.first().expect("a question").clone();
            harness.state_mut().state.go(posed.before);
            harness.run_steps(3);
            if harness.state().state.question().is_none() {
                harness.key_press(Key::ArrowRight);
            }
            harness.run_steps(40);
            let foot = size[1] - 80.0;
            let seen = |harness: &Window, rect: Rect| {
                rect.bottom() <= foot + 0.5 || harness.query_by_label("▼  more below").is_some()
            };
            let letter = char::from(b'A' + posed.choices.len() as u8 - 1);
            let answer = |node: &egui_kittest::Node<'_>| node.rect();
            let button = harness.query_by_label_contains(&format!("Answer {letter}: ")).map(|node| answer(&node));
            assert!(seen(&harness, button.expect("answers")), "{slide} at {size:?}: {button:?}");
            let wrong = posed.choices.iter().position(|choice| !choice.right).unwrap();
            harness.state_mut().state.apply(Command::Answer(wrong as u8));
            harness.run_steps(40);
            let not = harness.get_by_label("Not this").rect();
            assert!(not.bottom() <= foot + 0.5, "{slide} at {size:?}: the reason begins at {not:?}");
        }
    }
}

#[derive(Debug)]
struct Notes;

impl egui::DroppedFile for Notes {
    fn path(&self) -> &std::path::Path {
        std::path::Path::new("notes.txt")
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        Ok(Vec::new())
    }
}

#[test]
fn a_notice_covers_no_pane() {
    for size in [[1600.0, 1000.0], [900.0, 600.0]] {
        let mut harness = window("5/33", size);
        harness.input_mut().dropped_files.push(std::sync::Arc::new(Notes));
        harness.run_steps(4);
        let notice = harness.get_by_label_contains("a mesh is a file in OBJ").rect();
        for pane in ["Space", "t along the ray", "Walk", "Timeline"] {
            assert!(!notice.intersects(at(&harness, pane)), "{pane} at {size:?}");
        }
        assert!(notice.bottom() <= size[1] - 80.0 && notice.left() >= 0.0);
    }
}

#[test]
fn a_click_on_a_line_runs_to_its_next_time_and_with_shift_back() {
    for (slide, event) in [("5/33", "plane"), ("3/20", "step"), ("5/30", "weigh")] {
        let mut harness = window(slide, [1600.0, 1000.0]);
        harness.state_mut().state.predict = false;
        let state = &harness.state().state;
        let playback = state.playback().unwrap().clone();
        let listing = state.library.listing(&state.slide().unwrap().listing).unwrap().clone();
        let line = listing.line_named(event).unwrap();
        let line_of = |step: usize| Facts::at(&playback.play, step).and_then(|facts| listing.line_of(&facts));
        let shows = |step: usize| line_of(step) == Some(line);
        let steps: Vec<usize> = (1..=playback.steps().last()).filter(|step| shows(*step)).collect();
        assert!(steps.len() > 1, "{slide}");
        let state = &mut harness.state_mut().state;
        state.go(0);
        state.run_to_line(line, false);
        assert_eq!(state.view.step, steps[0], "{slide}");
        state.run_to_line(line, false);
        assert_eq!(state.view.step, steps[1], "{slide}");
        state.run_to_line(line, true);
        assert_eq!(state.view.step, steps[0], "{slide}");
        state.run_to_line(line, true);
        assert_eq!(state.view.step, *steps.last().unwrap(), "{slide}: around the beginning");

        // The same by the mouse: the marked line is clicked.
        state.go(steps[0]);
        harness.run_steps(2);
        let pane = at(&harness, "Walk");
        let row = 22.0;
        let y = pane.top() - 5.0 + 31.0 + row * (line as f32 + 0.5);
        click(&mut harness, pos2(pane.center().x, y), Modifiers::NONE);
        assert_eq!(harness.state().state.view.step, steps[1], "{slide}");
        click(&mut harness, pos2(pane.center().x, y), Modifiers::SHIFT);
        assert_eq!(harness.state().state.view.step, steps[0], "{slide}");
    }
}

#[test]
fn a_click_on_a_sign_under_the_timeline_runs_to_its_next_time() {
    let mut harness = window("5/33", [1600.0, 1000.0]);
    harness.state_mut().state.predict = false;
    harness.state_mut().state.go(0);
    harness.run_steps(2);
    let timeline = at(&harness, "Timeline");
    // The first name stands under the left end of the track: the slabs.
    let name = timeline.left_center() + vec2(10.0 + 13.5 * 13.0 + 20.0, 1.5 * 13.0);
    let mut stood = Vec::new();
    for modifiers in [Modifiers::NONE, Modifiers::NONE, Modifiers::SHIFT] {
        click(&mut harness, name, modifiers);
        let state = &harness.state().state;
        stood.push(state.view.step);
        let event = state.playback().unwrap().event(state.view.step).expect("a step");
        assert_eq!(event.name(), "slab.divide");
    }
    assert!(stood[0] < stood[1] && stood[2] == stood[0], "{stood:?}");
}

#[test]
fn undo_takes_back_a_whole_drag_also_while_walks_still_arrive() {
    let mut harness = window("5/33", [1600.0, 1000.0]);
    let ray = harness.state().state.playback().unwrap().play.tape.ray().unwrap();
    let moved = |y: f32| {
        let mut own = ray;
        own.o.y += y;
        RayChoice::Own(own)
    };
    // One drag whose last ray has not arrived when the next one begins.
    let state = &mut harness.state_mut().state;
    state.keep();
    state.show_ray(moved(0.1), true);
    settle(&mut harness);
    let state = &mut harness.state_mut().state;
    state.show_ray(moved(0.2), true);
    state.keep();
    state.show_ray(moved(0.3), true);
    settle(&mut harness);
    harness.state_mut().state.apply(Command::Undo);
    settle(&mut harness);
    assert_eq!(harness.state().state.view.ray, moved(0.2), "the end of the first drag");
    harness.state_mut().state.apply(Command::Undo);
    settle(&mut harness);
    assert_eq!(harness.state().state.view.ray, RayChoice::Named(0));
}

#[test]
fn undo_takes_back_a_whole_drag_of_a_number() {
    let mut harness = window("5/33", [1600.0, 2000.0]);
    harness.state_mut().state.predict = false;
    harness.key_press(Key::S);
    harness.run_steps(3);
    let own = harness.state().state.view.clone();
    let field = at(&harness, "max depth").center();
    drag(&mut harness, field, field + vec2(120.0, 0.0));
    settle(&mut harness);
    assert!(!harness.state().state.view.same_walk(&own), "the drag has set the number");
    harness.state_mut().state.apply(Command::Undo);
    settle(&mut harness);
    assert!(harness.state().state.view.same_walk(&own), "one drag, one undo");
}
