//! Heat maps beside each other: one colour a count, one scale for all, a histogram for each.

use glam::Vec2;

use super::heat_scale::{Legend, image, legend, outline, shares};
use super::known::{Known, heading, legend as signs};
use super::map::Map;
use super::{Filled, place};
use crate::page::{Anchor, Figure, Image, Ink, Look, write};
use crate::theme::{Face, Role};
use crate::words::{ROUGH, number};

/// Heat maps of a board. Their colours are made once, when the maps are.
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
    /// The largest count of all maps: the upper end of their scale.
    most: u32,
    /// The shape of their frames: so many across for so many down; that of their pixels if nobody says.
    frame: Option<[u32; 2]>,
    inked: Vec<Inked>,
}

/// What follows from the counts of a map.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Inked {
    pub(super) image: Image,
    /// The share of its rays in each part of the scale, from its lower end.
    pub(super) shares: Vec<f32>,
    mean: f64,
    /// The smallest and the largest count.
    range: [u32; 2],
}

/// A pixel of a heat map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pixel {
    /// When its map comes to be seen.
    pub entry: usize,
    /// How many pixels lie left of it and above it.
    pub at: [u32; 2],
    /// Pixels of the map, across and down.
    pub size: [u32; 2],
    /// What its ray costs.
    pub count: u32,
}

/// What stands in the frame of a map that waits.
const NOT_YET: &str = "not counted yet";

/// Room right of a map, for its scale and histogram, in letters.
const SCALE: f32 = 9.0;
/// Room below a map, for its name and numbers, in letters.
const BELOW: f32 = 4.2;

impl Maps {
    /// Maps on one scale; `of` is what is counted.
    pub fn new(title: String, about: String, of: String, maps: Vec<Map>) -> Maps {
        let most = maps.iter().flat_map(|map| map.counts.iter().copied()).max().unwrap_or(1).max(2);
        let inked = maps.iter().map(|map| Inked {
            image: image(map, most),
            shares: shares(map, most),
            mean: map.counts.iter().map(|count| f64::from(*count)).sum::<f64>() / map.counts.len().max(1) as f64,
            range: [map.counts.iter().min(), map.counts.iter().max()].map(|count| count.copied().unwrap_or(0)),
        });
        let inked = inked.collect();
        Maps { title, about, of, maps, most, frame: None, inked }
    }

    /// The same maps in frames of this shape, however coarse they are.
    #[must_use]
    pub fn framed(self, frame: [u32; 2]) -> Maps {
        Maps { frame: Some(frame), ..self }
    }

    /// The largest count of all maps, at least 2.
    pub(super) fn most(&self) -> u32 {
        self.most
    }

    /// The pixels of a map as they are drawn.
    pub fn image(&self, map: usize) -> Option<&Image> {
        self.inked.get(map).map(|inked| &inked.image)
    }

    /// The largest picture of each of so many maps in a room of this size.
    pub fn picture(room: Vec2, count: usize, look: &Look) -> Vec2 {
        let share = (room.x - 2.0 * look.margin()) / count.max(1) as f32;
        let high = room.y - top(count, look) - look.text * BELOW;
        Vec2::new(share - look.text * (SCALE + 1.0), high).max(Vec2::splat(look.text * 4.0))
    }

    /// The room that so many maps of this size need.
    pub fn room(picture: Vec2, count: usize, look: &Look) -> Vec2 {
        let across = (picture.x + look.text * (SCALE + 1.0)) * count.max(1) as f32 + 2.0 * look.margin();
        Vec2::new(across, picture.y + top(count, look) + look.text * BELOW)
    }

    /// Where the maps lie: the upper left corner of each and the lower right one.
    pub(super) fn corners(&self, room: Vec2, look: &Look) -> Vec<[Vec2; 2]> {
        let most = Maps::picture(room, self.maps.len(), look);
        let [width, height] = self.frame.or(self.maps.first().map(|map| map.size)).unwrap_or([4, 3]);
        let aspect = width as f32 / height as f32;
        let high = (most.x / aspect).min(most.y);
        let size = Vec2::new(high * aspect, high);
        let corner = |index: usize| {
            let along = (size.x + look.text * (SCALE + 1.0)) * index as f32;
            Vec2::new(look.margin() + along, top(self.maps.len(), look))
        };
        (0..self.maps.len()).map(corner).map(|min| [min, min + size]).collect()
    }

    /// How high each of them is.
    pub(super) fn high(&self, room: Vec2, look: &Look) -> f32 {
        self.corners(room, look).first().map_or(0.0, |[min, max]| max.y - min.y)
    }

    /// The pixel at a point, of those maps that are `shown`.
    pub(super) fn pixel_at(
        &self,
        room: Vec2,
        look: &Look,
        point: Vec2,
        shown: &dyn Fn(usize) -> bool,
    ) -> Option<Pixel> {
        let corners = self.corners(room, look);
        let mut maps = self.maps.iter().zip(corners).filter(|(map, _)| shown(map.entry));
        let (map, [min, max]) = maps.find(|(_, [min, max])| point.cmpge(*min).all() && point.cmplt(*max).all())?;
        let [width, height] = map.size;
        let part = (point - min) / (max - min);
        let along = |part: f32, of: u32| ((part * of as f32) as u32).min(of.saturating_sub(1));
        let at = [along(part.x, width), along(part.y, height)];
        Some(Pixel { entry: map.entry, at, size: map.size, count: map.count(at)? })
    }
}

impl Map {
    /// What the ray of a pixel costs.
    pub(super) fn count(&self, [x, y]: [u32; 2]) -> Option<u32> {
        self.counts.get(y as usize * self.size[0] as usize + x as usize).copied()
    }
}

/// Where maps begin below their title. A single one stands on whole points: so a picture of as many pixels stays sharp.
fn top(count: usize, look: &Look) -> f32 {
    let top = look.heading(&mut Figure::new(Vec2::ZERO), "", "") + look.text * 0.8;
    if count == 1 { top.ceil() } else { top }
}

pub(super) fn draw(maps: &Maps, filled: Filled, room: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(room);
    let u = look.text;
    let seen = maps.maps.iter().filter(|map| filled.shows(map.entry)).map(|map| map.known);
    heading(look, &mut figure, &maps.title, &maps.about, signs(seen));
    for ((map, inked), [min, max]) in maps.maps.iter().zip(&maps.inked).zip(maps.corners(room, look)) {
        let shown = filled.shows(map.entry);
        let place = place(map.entry).filter(|_| shown);
        let counted = shown && map.known != Known::NotYet;
        if counted {
            figure.add(Role::Scene, place, Ink::Image { min, max, image: inked.image.clone() });
        }
        figure.add(Role::Edge, place, outline(min, max));
        if shown && !counted {
            write(&mut figure, Role::Quiet, place, (min + max) * 0.5, NOT_YET, u, Face::Regular, Anchor::Middle);
        }
        if filled.is_asked(map.entry) {
            write(&mut figure, Role::Guess, None, (min + max) * 0.5, "?", u * 2.0, Face::Bold, Anchor::Middle);
        }
        let name = Vec2::new(min.x, max.y + u * 1.4);
        let role = if shown { Role::Text } else { Role::Quiet };
        write(&mut figure, role, place, name, &map.name, u * 1.05, Face::Bold, Anchor::Start);
        if counted {
            let [least, most] = inked.range;
            let rough = map.known == Known::Roughly;
            let (sign, role) = if rough { (ROUGH, Role::Quiet) } else { ("", Role::Missed) };
            let says = format!("mean {sign}{}, {least} to {most}", number(inked.mean as f32));
            let at = name + Vec2::new(0.0, u * 1.5);
            write(&mut figure, role, place, at, &says, u, Face::Regular, Anchor::Start);
            let (of, most, zero) = (maps.of.as_str(), maps.most, map.counts.contains(&0));
            let beside = Legend { of, most, zero, shares: &inked.shares };
            legend(&mut figure, &beside, Vec2::new(max.x + u * 0.8, min.y), max.y - min.y, look);
        }
    }
    figure
}
