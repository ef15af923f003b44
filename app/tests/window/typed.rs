//! What is clicked and typed into the fields of the panel: every parameter of a structure, and a ray.

use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use raystep::shown::RayChoice;
use raystep_accel::Allowed;

use crate::window::{Window, press, settle, window};

fn click(harness: &mut Window, label: &str) {
    let text = egui::accesskit::Role::Label;
    let mut found = harness.query_all_by_label(label).filter(|node| node.accesskit_node().role() != text);
    found.next_back().unwrap_or_else(|| panic!("nothing to click is called {label}")).click();
    drop(found);
    harness.run_steps(2);
}

/// Clicks a field, types into it and presses Enter.
fn type_into(harness: &mut Window, label: &str, text: &str) {
    click(harness, label);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.run_steps(1);
    harness.event(egui::Event::Text(text.to_owned()));
    harness.run_steps(1);
    press(harness, Key::Enter);
    settle(harness);
}

#[test]
fn every_parameter_is_set_by_click_and_by_typing() {
    let mut kinds = [0; 4];
    for slide in ["3/20", "5/33", "7/56b"] {
        // Tall enough for all parameters: what is scrolled away cannot be clicked.
        let mut harness = window(slide, [1600.0, 2400.0]);
        harness.state_mut().state.predict = false;
        press(&mut harness, Key::S);
        settle(&mut harness);
        let parameters = harness.state().state.rule().unwrap().parameters();
        for parameter in parameters {
            let label = parameter.key.replace('_', " ");
            let (wanted, text) = match parameter.allowed {
                Allowed::Flag => {
                    kinds[0] += 1;
                    click(&mut harness, &label);
                    settle(&mut harness);
                    ((parameter.value != "true").to_string(), None)
                }
                Allowed::Words(words) => {
                    kinds[1] += 1;
                    let other = words.iter().find(|word| **word != parameter.value).unwrap();
                    click(&mut harness, &label);
                    click(&mut harness, other);
                    settle(&mut harness);
                    ((*other).to_owned(), None)
                }
                Allowed::Count { min, max } => {
                    kinds[2] += 1;
                    let now: u32 = parameter.value.parse().unwrap();
                    let other = if now < max { now + 1 } else { now - 1 }.max(min).to_string();
                    (other.clone(), Some(other))
                }
                // Nobody has chosen any, so they are no parameter.
                Allowed::Cuts => unreachable!("cuts are made in the picture"),
                Allowed::Real { min, max } => {
                    kinds[3] += 1;
                    let other = if parameter.value.parse::<f32>().unwrap() == min { max } else { min }.to_string();
                    (other.clone(), Some(other))
                }
            };
            if let Some(text) = text {
                type_into(&mut harness, &label, &text);
            }
            let rule = harness.state().state.rule().unwrap();
            // A word may be one that other parameters do not go with: then they are not there any more.
            let now = rule.parameters().into_iter().find(|now| now.key == parameter.key);
            assert_eq!(now.map(|now| now.value), Some(wanted), "slide {slide}, {label}");
            assert!(harness.query_by_label("Set by hand").is_some(), "the panel stays");
            assert_eq!(harness.state().state.speed, 4, "what is typed into a field is no key");
            press(&mut harness, Key::Backspace);
            settle(&mut harness);
        }
    }
    assert!(kinds.iter().all(|tried| *tried > 0), "{kinds:?}");
}

#[test]
fn a_ray_is_typed_in_numbers() {
    let mut harness = window("5/33", [1600.0, 1000.0]);
    press(&mut harness, Key::S);
    settle(&mut harness);
    type_into(&mut harness, "o.y", "2.5");
    let RayChoice::Own(ray) = harness.state().state.view.ray.clone() else { panic!("an own ray") };
    assert_eq!(ray.o.y, 2.5);
    assert!(harness.query_by_label("o.z").is_none(), "the scene is flat");
    type_into(&mut harness, "d.x", "0");
    type_into(&mut harness, "d.y", "0");
    harness.run_steps(2);
    assert!(harness.query_by_label_contains("no ray").is_some(), "a ray without a direction is refused in words");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    settle(&mut harness);
    let RayChoice::Own(ray) = harness.state().state.view.ray.clone() else { panic!("an own ray") };
    assert!(ray.d.x != 0.0, "one change, one undo");
}
