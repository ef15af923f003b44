//! The scale of heat maps: one colour a count, equal factors equally far apart, and what stands beside it.

use std::sync::{Arc, OnceLock};

use glam::Vec2;

use super::map::Map;
use crate::page::{Anchor, Figure, Image, Ink, Look, block, line, write};
use crate::theme::{Face, Role, text_width};
use crate::words::number;

/// Bars of a histogram.
pub(super) const BARS: usize = 24;

/// Colours of the bar beside a map.
const STEPS: u32 = 64;

/// How far up the scale a count lies: 0 for 1, 1 for the most. The scale is one of factors.
pub(super) fn part(count: f64, most: u32) -> f64 {
    libm::log2(count.max(1.0)) / libm::log2(f64::from(most))
}

/// The colour at a part of the scale.
fn colour(part: f64) -> [u8; 4] {
    let colorous::Color { r, g, b } = colorous::VIRIDIS.eval_continuous(part);
    [r, g, b, 255]
}

/// The picture of counts. Rays that cost nothing have no colour: the page is seen there.
pub(super) fn image(map: &Map, most: u32) -> Image {
    // Counts come again and again: each has its colour looked up once.
    let few = (0..=most.min(4096)).map(|count| colour(part(f64::from(count), most))).collect::<Vec<_>>();
    let of = |count: &u32| match few.get(*count as usize) {
        _ if *count == 0 => [0; 4],
        Some(colour) => *colour,
        None => colour(part(f64::from(*count), most)),
    };
    let rgba: Arc<[u8]> = map.counts.iter().flat_map(of).collect();
    Image { width: map.size[0], height: map.size[1], rgba }
}

/// The share of rays in each part of the scale, from its lower end.
pub(super) fn shares(map: &Map, most: u32) -> Vec<f32> {
    let mut shares = vec![0.0; BARS];
    for count in map.counts.iter().filter(|count| **count > 0) {
        let bar = (part(f64::from(*count), most) * BARS as f64) as usize;
        shares[bar.min(BARS - 1)] += 1.0 / map.counts.len() as f32;
    }
    shares
}

/// All colours of the scale, the largest count's on top; made once.
fn bar_image() -> Image {
    static RGBA: OnceLock<Arc<[u8]>> = OnceLock::new();
    let all = || (0..STEPS).flat_map(|step| colour(1.0 - (f64::from(step) + 0.5) / f64::from(STEPS))).collect();
    Image { width: 1, height: STEPS, rgba: RGBA.get_or_init(all).clone() }
}

/// Where the bar of colours stands whose legend begins at a corner: its upper left corner and its size.
pub(super) fn bar(corner: Vec2, high: f32, u: f32) -> (Vec2, Vec2) {
    (corner + Vec2::new(0.0, u * 0.6), Vec2::new(u * 0.9, high - u * 2.6))
}

/// The corner of the swatch of rays that cost nothing.
fn zero(top: Vec2, bar: Vec2, u: f32) -> Vec2 {
    top + Vec2::new(0.0, bar.y + u * 0.6)
}

/// How high on the page a count lies.
pub(super) fn height(count: u32, most: u32, corner: Vec2, high: f32, u: f32) -> f32 {
    let (top, bar) = bar(corner, high, u);
    match count {
        0 => zero(top, bar, u).y + bar.x * 0.5,
        count => top.y + bar.y * (1.0 - part(f64::from(count), most) as f32),
    }
}

/// What stands beside a map.
pub(super) struct Legend<'a> {
    /// What is counted: `"tests"`.
    pub(super) of: &'a str,
    /// The upper end of the scale.
    pub(super) most: u32,
    /// Whether some rays cost nothing.
    pub(super) zero: bool,
    /// The share of rays in each part of the scale, from its lower end.
    pub(super) shares: &'a [f32],
}

/// The scale of colours in numbers, beside it how many rays cost as much.
pub(super) fn legend(figure: &mut Figure, legend: &Legend<'_>, corner: Vec2, high: f32, look: &Look) {
    let Legend { of, most, zero: nothing, shares } = *legend;
    let (u, small) = (look.text, look.small());
    let (top, bar) = bar(corner, high, u);
    figure.add(Role::Scene, None, Ink::Image { min: top, max: top + bar, image: bar_image() });
    figure.add(Role::Edge, None, outline(top, top + bar));
    // Rays that cost nothing have a swatch of their own.
    if nothing {
        let corner = zero(top, bar, u);
        // As empty as in the map.
        figure.add(Role::Edge, None, outline(corner, corner + Vec2::splat(bar.x)));
        let at = corner + Vec2::new(bar.x + u * 0.5, bar.x * 0.5);
        write(figure, Role::Quiet, None, at, "0", small, Face::Regular, Anchor::Start);
    }
    let at = |count: f64| top.y + bar.y * (1.0 - part(count, most) as f32);
    let mut last = f32::INFINITY;
    let round = (0..8).flat_map(|power| [1.0, 2.0, 5.0].map(|digit| digit * libm::pow(10.0, f64::from(power))));
    let marks = round.filter(|count| *count < f64::from(most) / 1.4).chain([f64::from(most)]);
    let widest = text_width(&most.to_string(), Face::Regular, small);
    for count in marks {
        let y = at(count);
        if last - y < u * 1.1 && count < f64::from(most) {
            continue;
        }
        last = y;
        let tick = Vec2::new(top.x + bar.x, y);
        figure.add(Role::Edge, None, line(tick, tick + Vec2::new(u * 0.25, 0.0)));
        let words = tick + Vec2::new(u * 0.5, 0.0);
        write(figure, Role::Quiet, None, words, &number(count as f32), small, Face::Regular, Anchor::Start);
    }
    let largest = shares.iter().copied().fold(0.0, f32::max).max(1e-6);
    let left = top.x + bar.x + u * 1.0 + widest;
    let room = u * 3.4;
    let step = bar.y / BARS as f32;
    for (index, share) in shares.iter().enumerate().filter(|(_, share)| **share > 0.0) {
        let y = top.y + bar.y - step * (index as f32 + 1.0);
        let size = Vec2::new((room * share / largest).max(1.0), step * 0.8);
        figure.add(Role::Scene, None, block(Vec2::new(left, y), size, 0.0));
    }
    // The next map begins beside it: long words take two lines.
    let says = format!("{of} per ray");
    let fits = text_width(&says, Face::Regular, small) <= left + room - top.x;
    let words = if fits { vec![says.as_str()] } else { vec![of, "per ray"] };
    for (row, says) in words.into_iter().chain(["bars: share of rays"]).enumerate() {
        let at = Vec2::new(top.x, corner.y + high + u * (0.9 + 1.3 * row as f32));
        write(figure, Role::Quiet, None, at, says, small, Face::Regular, Anchor::Start);
    }
}

/// A closed line.
pub(super) fn outline(min: Vec2, max: Vec2) -> Ink {
    Ink::Line { points: vec![min, Vec2::new(max.x, min.y), max, Vec2::new(min.x, max.y), min] }
}
