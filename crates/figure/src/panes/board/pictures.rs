//! Pictures beside each other, each with its name and what it shows.

use glam::Vec2;
use raystep_accel::Prims;

use super::known::{Known, heading, legend};
use super::{Filled, place};
use crate::page::{Anchor, Figure, Image, Ink, Look, Mark, write};
use crate::stage::{Camera, Scenery, crop, stage};
use crate::theme::{Face, Role, text_width};
use crate::world::{Form, Space, SpaceMark};

/// Pictures of a board.
#[derive(Clone, Debug, PartialEq)]
pub struct Pictures {
    /// What they are about.
    pub title: String,
    /// What stands behind the title.
    pub about: String,
    /// The pictures.
    pub pictures: Vec<Picture>,
}

/// A picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// When it comes to be seen.
    pub entry: usize,
    /// What it is called.
    pub name: String,
    /// What it shows, in numbers; nothing as long as they are not known.
    pub says: String,
    /// Words for which there is room below it from the first: as wide as those that come.
    pub room: String,
    /// Its pixels across and down, once it is made in full: the shape of its frame.
    pub size: [u32; 2],
    /// The picture itself, once there is one.
    pub image: Option<Image>,
    /// How well it and its numbers are known.
    pub known: Known,
    /// What is drawn over it, as a camera sees it that the picture was made with.
    pub over: Option<(Vec<Form>, Camera)>,
}

/// What stands in the frame of a picture that waits.
const NOT_YET: &str = "not traced yet";
/// Room below a picture for two lines of words, in letters.
const BELOW: f32 = 4.4;
/// Most that its words grow.
const LARGEST: f32 = 1.35;
/// Room between two pictures, in letters.
const GAP: f32 = 1.5;

impl Pictures {
    /// The size of the words, how many columns there are, and the width and height of a picture: as many columns as make
    /// the pictures largest, each with two lines of words below.
    fn set(&self, room: Vec2, top: f32, look: &Look) -> Option<(f32, usize, [f32; 2])> {
        let u = look.text;
        let first = self.pictures.first()?;
        let aspect = first.size[0] as f32 / first.size[1].max(1) as f32;
        let many = self.pictures.len();
        let set = |letters: f32| {
            let fitting = |columns: usize| {
                let rows = many.div_ceil(columns) as f32;
                let across = (room.x - 2.0 * look.margin() - u * GAP * (columns as f32 - 1.0)) / columns as f32;
                (across / aspect).min((room.y - top) / rows - letters * BELOW)
            };
            let each = (1..=many).map(|columns| (columns, fitting(columns)));
            each.max_by(|(_, a), (_, b)| a.total_cmp(b)).unwrap_or((1, 0.0))
        };
        // The words are larger where that makes no picture smaller.
        let grown = u * LARGEST;
        let u = if set(grown).1 >= set(u).1 { grown } else { u };
        let (columns, high) = set(u);
        let high = high.max(u * 4.0);
        Some((u, columns, [high * aspect, high]))
    }

    /// How high each of them is.
    pub(super) fn high(&self, room: Vec2, look: &Look) -> f32 {
        let top = look.heading(&mut Figure::new(Vec2::ZERO), "", "") + look.text * 0.8;
        self.set(room, top, look).map_or(0.0, |(.., [_, high])| high)
    }
}

/// Forms over a picture of this size, as far as they lie in it.
fn over(forms: &[Form], camera: &Camera, size: Vec2) -> Figure {
    let mark = |form: &Form| SpaceMark { form: form.clone(), role: Role::Here, place: None };
    let space = Space { marks: forms.iter().map(mark).collect(), flat: false, ..Space::default() };
    let mut drawn = stage(&space, &Prims::Few(Vec::new()), camera, size, Scenery::Left);
    crop(&mut drawn, 0.0);
    drawn
}

pub(super) fn draw(pictures: &Pictures, filled: Filled, room: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(room);
    let u = look.text;
    let seen = pictures.pictures.iter().filter(|picture| filled.shows(picture.entry)).map(|picture| picture.known);
    let top = heading(look, &mut figure, &pictures.title, &pictures.about, legend(seen)) + u * 0.8;
    let left = look.margin();
    let gap = u * GAP;
    let Some((u, columns, [wide, high])) = pictures.set(room, top, look) else { return figure };
    let below = u * BELOW;
    // Words may be wider than their picture: they have the room as far as the next one.
    let words = |picture: &Picture| {
        let name = text_width(&picture.name, Face::Bold, u * 1.1);
        let says = text_width(&picture.says, Face::Regular, u).max(text_width(&picture.room, Face::Regular, u));
        name.max(says)
    };
    let longest = pictures.pictures.iter().map(words).fold(wide, f32::max);
    let step = (longest + gap).min((room.x - 2.0 * left + gap) / columns as f32).max(wide + gap);
    let fitted = |words: &str, face: Face, size: f32| size * ((step - gap) / text_width(words, face, size)).min(1.0);
    for (index, picture) in pictures.pictures.iter().enumerate() {
        let (column, row) = ((index % columns) as f32, (index / columns) as f32);
        let min = Vec2::new(left + step * column, top + (high + below) * row);
        let max = min + Vec2::new(wide, high);
        let shown = filled.shows(picture.entry);
        let place = place(picture.entry).filter(|_| shown);
        // What a board begins with is looked at while its question is open; its numbers come with its step.
        if let Some(image) = picture.image.as_ref().filter(|_| shown || picture.entry == 0) {
            figure.add(Role::Scene, place, Ink::Image { min, max, image: image.clone() });
            if let Some((forms, camera)) = &picture.over {
                let drawn = over(forms, camera, max - min);
                figure.marks.extend(drawn.marks.into_iter().map(|mark| Mark { place, ..mark.moved(min) }));
            }
        }
        if shown && picture.known == Known::NotYet {
            write(&mut figure, Role::Quiet, place, (min + max) * 0.5, NOT_YET, u, Face::Regular, Anchor::Middle);
        }
        let frame = vec![min, Vec2::new(max.x, min.y), max, Vec2::new(min.x, max.y), min];
        figure.add(Role::Edge, place, Ink::Line { points: frame });
        let at = Vec2::new(min.x, max.y + u * 1.4);
        let role = if shown { Role::Text } else { Role::Quiet };
        let size = fitted(&picture.name, Face::Bold, u * 1.1);
        write(&mut figure, role, place, at, &picture.name, size, Face::Bold, Anchor::Start);
        if shown {
            let below = at + Vec2::new(0.0, u * 1.6);
            // They keep their size when a time takes the place of what stands for it.
            let size = [&picture.says, &picture.room].map(|words| fitted(words, Face::Regular, u));
            let size = size[0].min(size[1]);
            write(&mut figure, Role::Quiet, place, below, &picture.says, size, Face::Regular, Anchor::Start);
        }
    }
    figure
}
