//! The presenter's page from the last row: what a board shows is large, or has all the room that there is.

use egui_kittest::kittest::Queryable;
use glam::Vec2;
use raystep::window::{App, Remembered, Wishes};
use raystep_figure::{Anchor, Ask, Figure, Ink, Look, Pane, text_width};
use raystep_lesson::Plays;

use crate::window::{Window, library, settle, sized};

/// The smallest letters of a picture, in parts of the page's height; and the part of its room that it has in one direction
/// where they are smaller.
const LEGIBLE: f32 = 1.0 / 61.0;
/// The same where walks stand side by side, up to three of them with their trees: numbers stand in primitives and nodes,
/// which share the page.
const ABREAST: f32 = 1.0 / 105.0;
const FULL: f32 = 0.85;

/// Around a figure is room for the borders of panes.
const BORDER: f32 = 5.0;

/// The smallest letters of a figure, and the corners of what stands there.
fn measured(figure: &Figure) -> (f32, Vec2, Vec2) {
    let (mut least, mut min, mut max) = (f32::INFINITY, Vec2::INFINITY, Vec2::NEG_INFINITY);
    let mut reach = |point: Vec2| (min, max) = (min.min(point), max.max(point));
    for mark in &figure.marks {
        match &mark.ink {
            Ink::Text { at, text, size, face, anchor, .. } => {
                least = least.min(*size);
                let wide = text_width(text, *face, *size);
                let left = match anchor {
                    Anchor::Start => at.x,
                    Anchor::Middle => at.x - wide * 0.5,
                    Anchor::End => at.x - wide,
                };
                reach(Vec2::new(left, at.y - size * 0.5));
                reach(Vec2::new(left + wide, at.y + size * 0.5));
            }
            Ink::Image { min, max, .. } | Ink::Rect { min, max, .. } => {
                reach(*min);
                reach(*max);
            }
            Ink::Line { points } => points.iter().for_each(|point| reach(*point)),
            _ => {}
        }
    }
    (least, min, max)
}

#[test]
fn what_a_board_shows_is_read_from_the_last_row_or_fills_its_room() {
    let mut small = Vec::new();
    for size in [[1920.0, 1080.0], [1280.0, 720.0], [1024.0, 768.0], [3840.0, 2160.0]] {
        let mut harness: Window = sized(size).build_eframe(|context| {
            let mut app = App::wished(&context.egui_ctx, library(), Wishes::default(), Remembered::default());
            app.state.present = true;
            app
        });
        settle(&mut harness);
        let body = (size[1] / 27.0_f32).min(size[0] / 36.0);
        let scale = body / 19.0;
        let look = Look { text: 13.0 * scale, titles: true, least: 9.5 * scale };
        let slides = library().slides;
        let boards = slides.iter().enumerate().filter(|(_, slide)| matches!(slide.plays, Plays::Board | Plays::Walks));
        for (index, slide) in boards {
            harness.state_mut().state.show_slide(index);
            settle(&mut harness);
            let playback = harness.state().state.playback().expect("a board").clone();
            let reel = playback.reel();
            let mut told = String::new();
            for step in playback.play.beats.iter().flatten() {
                harness.state_mut().state.go(*step);
                harness.run_steps(2);
                let node = harness.query_by_label("Picture").expect("a picture");
                let room = node.rect().expand(BORDER);
                let instant = reel.at(*step);
                let asked = Ask::new(Vec2::new(room.width(), room.height()), look);
                let (least, min, max) = measured(&reel.still(&instant).draw(Pane::Picture, &asked));
                let filled = (max - min.max(Vec2::ZERO)) / asked.size;
                let out = (max - asked.size).max_element().max(-min.min_element());
                let what = format!("{} at {size:?}, step {step}", slide.id());
                let says = format!(
                    "1/{:.0} of the height, {:.0} x {:.0} % of {:.0} x {:.0}, {out:.0} out",
                    size[1] / least,
                    filled.x * 100.0,
                    filled.y * 100.0,
                    asked.size.x,
                    asked.size.y
                );
                if told != says {
                    println!("{what}: {says}");
                    told.clone_from(&says);
                }
                let legible = if slide.plays == Plays::Board { LEGIBLE } else { ABREAST };
                let is_large = least >= size[1] * legible;
                // Rules between walks go all across.
                let is_full = slide.plays == Plays::Board && filled.max_element() >= FULL;
                if out > 1.5 || !(is_large || is_full) {
                    small.push(format!("{what}: {says}"));
                }
            }
        }
    }
    assert!(small.is_empty(), "{}", small.join("\n"));
}
