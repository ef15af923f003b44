//! Heat maps beside each other: one colour a count, one scale for all, a histogram for each.

use std::sync::Arc;

use glam::Vec2;

use super::{Filled, place};
use crate::page::{Anchor, Figure, Image, Ink, Look, block, line, write};
use crate::theme::{Face, Role, text_width};
use crate::words::number;

/// Heat maps of a board.
#[derive(Clone, Debug, PartialEq)]
pub struct Maps {
    /// What they are about.
    pub title: String,
    /// What stands behind the title.
    pub about: String,
    /// What is counted: `"tests"`.
    pub of: String,
    /// The maps.
    pub maps: Vec<Map>,
}

/// A heat map.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// When it comes to be seen.
    pub entry: usize,
    /// What it is called.
    pub name: String,
    /// Pixels across and down.
    pub size: [u32; 2],
    /// What was counted for each pixel's ray, rows from above.
    pub counts: Vec<u32>,
}

/// Bars of a histogram.
const BARS: usize = 24;

impl Maps {
    /// The largest count of all maps: the upper end of their scale.
    fn most(&self) -> u32 {
        self.maps.iter().flat_map(|map| map.counts.iter().copied()).max().unwrap_or(1).max(2)
    }
}

/// How far up the scale a count lies: 0 for 1, 1 for the most. The scale is one of factors.
fn part(count: f64, most: u32) -> f64 {
    libm::log2(count.max(1.0)) / libm::log2(f64::from(most))
}

impl Map {
    /// Its picture. Nothing is white: rays that cost nothing.
    fn image(&self, most: u32) -> Image {
        let colour = |count: &u32| {
            if *count == 0 {
                return [255, 255, 255, 255];
            }
            let colorous::Color { r, g, b } = colorous::VIRIDIS.eval_continuous(part(f64::from(*count), most));
            [r, g, b, 255]
        };
        let rgba: Arc<[u8]> = self.counts.iter().flat_map(colour).collect();
        Image { width: self.size[0], height: self.size[1], rgba }
    }

    /// The share of its rays in each part of the scale, from its lower end.
    fn shares(&self, most: u32) -> Vec<f32> {
        let mut shares = vec![0.0; BARS];
        for count in self.counts.iter().filter(|count| **count > 0) {
            let bar = (part(f64::from(*count), most) * BARS as f64) as usize;
            shares[bar.min(BARS - 1)] += 1.0 / self.counts.len() as f32;
        }
        shares
    }

    fn mean(&self) -> f64 {
        self.counts.iter().map(|count| f64::from(*count)).sum::<f64>() / self.counts.len().max(1) as f64
    }
}

pub(super) fn draw(maps: &Maps, filled: Filled, room: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(room);
    let u = look.text;
    let top = look.heading(&mut figure, &maps.title, &maps.about) + u * 0.8;
    let most = maps.most();
    let (left, below) = (look.margin(), u * 4.2);
    // A scale with the histogram of its map stands right of each.
    let scale = u * 9.0;
    let share = (room.x - 2.0 * left) / maps.maps.len().max(1) as f32;
    let [width, height] = maps.maps.first().map_or([4, 3], |map| map.size);
    let aspect = width as f32 / height as f32;
    let high = ((share - scale - u) / aspect).min(room.y - top - below).max(u * 4.0);
    let wide = high * aspect;
    for (index, map) in maps.maps.iter().enumerate() {
        let min = Vec2::new(left + (wide + scale + u) * index as f32, top);
        let max = min + Vec2::new(wide, high);
        let shown = filled.shows(map.entry);
        let place = place(map.entry).filter(|_| shown);
        if shown {
            figure.add(Role::Scene, place, Ink::Image { min, max, image: map.image(most) });
        }
        figure.add(Role::Edge, place, outline(min, max));
        if filled.is_asked(map.entry) {
            write(&mut figure, Role::Guess, None, (min + max) * 0.5, "?", u * 2.0, Face::Bold, Anchor::Middle);
        }
        let name = Vec2::new(min.x, max.y + u * 1.4);
        let role = if shown { Role::Text } else { Role::Quiet };
        write(&mut figure, role, place, name, &map.name, u * 1.05, Face::Bold, Anchor::Start);
        if shown {
            let says = format!("mean {}, most {}", number(map.mean() as f32), map.counts.iter().max().unwrap_or(&0));
            let at = name + Vec2::new(0.0, u * 1.5);
            write(&mut figure, Role::Missed, place, at, &says, u, Face::Regular, Anchor::Start);
            legend(&mut figure, maps, map, most, Vec2::new(max.x + u * 0.8, min.y), high, look);
        }
    }
    figure
}

/// A closed line.
fn outline(min: Vec2, max: Vec2) -> Ink {
    Ink::Line { points: vec![min, Vec2::new(max.x, min.y), max, Vec2::new(min.x, max.y), min] }
}

/// The scale of colours in numbers, beside it how many rays cost as much.
fn legend(figure: &mut Figure, maps: &Maps, map: &Map, most: u32, corner: Vec2, high: f32, look: &Look) {
    let (u, small) = (look.text, look.small());
    let bar = Vec2::new(u * 0.9, high - u * 2.6);
    let top = corner + Vec2::new(0.0, u * 0.6);
    let steps = 64;
    let rgba: Arc<[u8]> = (0..steps)
        .flat_map(|step| {
            let along = 1.0 - (f64::from(step) + 0.5) / f64::from(steps);
            let colorous::Color { r, g, b } = colorous::VIRIDIS.eval_continuous(along);
            [r, g, b, 255]
        })
        .collect();
    let image = Image { width: 1, height: steps, rgba };
    figure.add(Role::Scene, None, Ink::Image { min: top, max: top + bar, image });
    figure.add(Role::Edge, None, outline(top, top + bar));
    // Rays that cost nothing have a swatch of their own.
    let nothing = map.counts.contains(&0);
    if nothing {
        let corner = top + Vec2::new(0.0, bar.y + u * 0.6);
        figure.add(Role::Edge, None, outline(corner, corner + Vec2::splat(bar.x)));
        let at = corner + Vec2::new(bar.x + u * 0.5, bar.x * 0.5);
        write(figure, Role::Quiet, None, at, "0", small, Face::Regular, Anchor::Start);
    }
    let at = |count: f64| top.y + bar.y * (1.0 - part(count, most) as f32);
    let mut last = f32::INFINITY;
    let round = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0, 5000.0, 10_000.0];
    let marks = round.into_iter().filter(|count| *count < f64::from(most) / 1.4).chain([f64::from(most)]);
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
    let shares = map.shares(most);
    let largest = shares.iter().copied().fold(0.0, f32::max).max(1e-6);
    let left = top.x + bar.x + u * 1.0 + widest;
    let room = u * 3.4;
    let step = bar.y / BARS as f32;
    for (index, share) in shares.iter().enumerate().filter(|(_, share)| **share > 0.0) {
        let y = top.y + bar.y - step * (index as f32 + 1.0);
        let size = Vec2::new((room * share / largest).max(1.0), step * 0.8);
        figure.add(Role::Scene, None, block(Vec2::new(left, y), size, 0.0));
    }
    let under = Vec2::new(top.x, corner.y + high + u * 0.9);
    let says = format!("{} per ray", maps.of);
    write(figure, Role::Quiet, None, under, &says, small, Face::Regular, Anchor::Start);
    let bars = Vec2::new(top.x, under.y + u * 1.3);
    write(figure, Role::Quiet, None, bars, "bars: share of rays", small, Face::Regular, Anchor::Start);
}
