//! Bars below each other, on a scale of factors.

use glam::Vec2;

use crate::page::{Anchor, Figure, Look, block, line, write};
use crate::theme::{Face, Role, text_width};

/// Bars with what they are about.
#[derive(Clone, Debug, PartialEq)]
pub struct Bars {
    /// What they are about, in a few words.
    pub title: String,
    /// The lines below the title.
    pub about: Vec<String>,
    /// The bars, from above.
    pub bars: Vec<Bar>,
}

/// A bar.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    /// What it is called.
    pub name: String,
    /// A few words below the name.
    pub note: String,
    /// How long it is; none is drawn of what is not above 0.
    pub value: f64,
    /// What stands at its end.
    pub says: String,
}

impl Bars {
    /// The bars in a figure of that size. The shortest one is still to be seen; each tick is ten times the one before.
    pub fn draw(&self, size: Vec2, look: &Look) -> Figure {
        let mut figure = Figure::new(size);
        let (text, small) = (look.text, look.text * 0.78);
        let margin = text;
        let put = |figure: &mut Figure, role, at, words: &str, size, face, anchor| {
            write(figure, role, None, at, words, size, face, anchor);
        };
        let mut top = margin + text * 0.6;
        let left = Vec2::new(margin, top);
        put(&mut figure, Role::Text, left, &self.title, text * 1.25, Face::Bold, Anchor::Start);
        top += text * 1.5;
        for words in &self.about {
            put(&mut figure, Role::Quiet, Vec2::new(margin, top), words, small, Face::Regular, Anchor::Start);
            top += small * 1.4;
        }
        top += text * 0.4;
        let wide = |bar: &Bar| text_width(&bar.name, Face::Bold, text).max(text_width(&bar.note, Face::Regular, small));
        let names = self.bars.iter().map(wide).fold(0.0, f32::max);
        let drawn = || self.bars.iter().filter(|bar| bar.value > 0.0);
        let says = drawn().map(|bar| text_width(&bar.says, Face::Regular, text)).fold(0.0, f32::max);
        let from = margin + names + text;
        let room = (size.x - margin - says - text * 0.5 - from).max(1.0);
        let (low, high) =
            drawn().fold((f64::INFINITY, 0.0_f64), |(low, high), bar| (low.min(bar.value), high.max(bar.value)));
        // A whole number of factors of ten, and the shortest bar not shorter than a tenth of one.
        let first = libm::floor(libm::log10(low * 0.8));
        let last = libm::log10(high).max(first + 1e-6);
        let along = |value: f64| from + room * ((libm::log10(value) - first) / (last - first)).clamp(0.0, 1.0) as f32;
        let bottom = size.y - margin - small * 1.6;
        let row = (bottom - top) / self.bars.len().max(1) as f32;
        if high > 0.0 {
            let mut power = first;
            while power <= last {
                let value = libm::pow(10.0, power);
                let x = along(value);
                for [above, below] in self.free(x, from, along, top, row, text) {
                    figure.add(Role::Edge, None, line(Vec2::new(x, above), Vec2::new(x, below)));
                }
                let words = crate::words::number(value as f32);
                let at = Vec2::new(x, bottom + small);
                put(&mut figure, Role::Quiet, at, &words, small, Face::Regular, Anchor::Middle);
                power += 1.0;
            }
        }
        for (index, bar) in self.bars.iter().enumerate() {
            let middle = top + (index as f32 + 0.5) * row;
            let at = Vec2::new(from - text, middle - small * 0.62);
            put(&mut figure, Role::Text, at, &bar.name, text, Face::Bold, Anchor::End);
            let at = Vec2::new(from - text, middle + text * 0.62);
            put(&mut figure, Role::Quiet, at, &bar.note, small, Face::Regular, Anchor::End);
            let mut end = from;
            if bar.value > 0.0 {
                end = along(bar.value);
                let high = row * 0.56;
                figure.add(
                    Role::Filled,
                    None,
                    block(Vec2::new(from, middle - high / 2.0), Vec2::new(end - from, high), 2.0),
                );
            }
            let role = if bar.value > 0.0 { Role::Value } else { Role::Quiet };
            let at = Vec2::new(end + text * BESIDE, middle);
            put(&mut figure, role, at, &bar.says, text, Face::Regular, Anchor::Start);
        }
        figure
    }

    /// The parts of an upright line at `x` that cross no words at the ends of bars.
    fn free(&self, x: f32, from: f32, along: impl Fn(f64) -> f32, top: f32, row: f32, text: f32) -> Vec<[f32; 2]> {
        let mut parts: Vec<[f32; 2]> = Vec::new();
        for (index, bar) in self.bars.iter().enumerate() {
            let end = if bar.value > 0.0 { along(bar.value) } else { from } + text * BESIDE;
            let wide = text_width(&bar.says, Face::Regular, text);
            let (above, middle) = (top + index as f32 * row, top + (index as f32 + 0.5) * row);
            let pad = text * 0.25;
            let pieces = if (end - pad..end + wide + pad).contains(&x) {
                vec![[above, middle - text * 0.75], [middle + text * 0.75, above + row]]
            } else {
                vec![[above, above + row]]
            };
            for [above, below] in pieces {
                match parts.last_mut().filter(|last| (last[1] - above).abs() < 1e-3) {
                    Some(last) => last[1] = below,
                    None => parts.push([above, below]),
                }
            }
        }
        parts
    }
}

/// From the end of a bar to its words, in letters.
const BESIDE: f32 = 0.5;
