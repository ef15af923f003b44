//! A beat on paper: its picture with what is said of it, or the question that comes before.

use glam::Vec2;
use raystep_figure::{Anchor, Face, Figure, Ink, Role, Theme, crop};
use raystep_lesson::{Show, Slide};
use raystep_print::{enlarge, prose, set_in};

use super::sheet::INNER;
use crate::cli::page::plain;
use crate::export::{Asked, Session, Telling, View};
use crate::fault::Fault;

/// A beat.
pub(super) struct Entry {
    telling: Telling,
    /// The picture in words.
    shows: String,
    /// Its pictures, beside each other; none where the same one stands above.
    pictures: Vec<Figure>,
    /// The number of its question, from 1.
    pub(super) number: usize,
}

/// Size of the letters.
const SIZE: f32 = 17.0;
/// Between pictures beside each other, and above and below them.
const GAP: f32 = 14.0;
/// How high a picture is.
const HIGH: f32 = 400.0;

/// The beats of a slide as far as they are reached.
pub(super) fn entries(slide: &Slide, sessions: &[Session<'_>]) -> Result<Vec<Entry>, Fault> {
    let mut entries = Vec::new();
    // What the picture above shows: a beat's question is often asked where the beat before it stands.
    let mut above = None;
    for beat in 0..slide.beats.len() {
        let Some(session) = sessions.iter().find(|session| session.is_told_here(beat)) else { continue };
        let (Some(at), Some(telling)) = (session.step_of(beat), session.telling(beat)) else { continue };
        let step = telling.asked.as_ref().map_or(at, |asked| asked.before);
        let here = Some((session.file_stem().to_owned(), step));
        let pictures = if above == here { Vec::new() } else { pictures(slide, session, step)? };
        above = here;
        entries.push(Entry { telling, shows: session.shows(step), pictures, number: 0 });
    }
    Ok(entries)
}

/// Space, or what stands in its place, and the tree if the slide shows one.
fn pictures(slide: &Slide, session: &Session<'_>, step: usize) -> Result<Vec<Figure>, Fault> {
    let tree = slide.show.contains(&Show::Tree);
    let widths = if tree { vec![INNER * 0.6 - GAP, INNER * 0.4] } else { vec![INNER] };
    let views = [View::Space, View::Tree];
    let draw = |(width, view): (f32, View)| {
        let size = Vec2::new(width, if tree { HIGH } else { HIGH * 1.2 });
        let (figure, _) = session.figure(view, step, None, size * SHARP, &Theme::PRINT)?;
        Ok(framed(figure, size))
    };
    widths.into_iter().zip(views).map(draw).collect()
}

/// Pixels of a solid scene to a point of the page.
const SHARP: f32 = 1.5;

/// A picture at this size, with nothing beyond its edge, and a line around it.
fn framed(mut picture: Figure, size: Vec2) -> Figure {
    let by = size.x / picture.size.x.max(1.0);
    enlarge(&mut picture, by);
    picture.size = size;
    crop(&mut picture, 0.0);
    let points = vec![Vec2::ZERO, Vec2::new(size.x, 0.0), size, Vec2::new(0.0, size.y), Vec2::ZERO];
    picture.add(Role::Edge, None, Ink::Line { points });
    picture
}

impl Entry {
    /// Whether it asks something.
    pub(super) fn asks(&self) -> bool {
        self.telling.asked.is_some()
    }

    /// It on paper; of a beat that asks nothing is told that answers.
    pub(super) fn figure(&self) -> Figure {
        let mut pile = Pile::default();
        let mut x = 0.0;
        let high = self.pictures.iter().map(|picture| picture.size.y).fold(0.0, f32::max);
        for picture in &self.pictures {
            set_in(&mut pile.figure, picture.clone(), Vec2::new(x, 0.0));
            x += picture.size.x + GAP;
        }
        if high > 0.0 {
            pile.y = high + GAP * 0.7;
        }
        match &self.telling.asked {
            Some(asked) => self.question(asked, &mut pile),
            None => {
                pile.words(&format!("**{}**", self.telling.heading), SIZE * 1.1, Face::Bold, Role::Text, 0.0);
                pile.words(&self.telling.text, SIZE, Face::Regular, Role::Text, 0.0);
            }
        }
        pile.done()
    }

    fn question(&self, asked: &Asked, pile: &mut Pile) {
        let text = format!("**Question {}.** {}", self.number, asked.question);
        pile.words(&text, SIZE, Face::Medium, Role::Text, 0.0);
        for (letter, answer) in ('A'..='Z').zip(&asked.answers) {
            let at = Vec2::new(16.0, pile.y + SIZE * 0.75);
            let half = SIZE * 0.46;
            pile.figure.add(
                Role::Edge,
                None,
                Ink::Rect { min: at - Vec2::new(half, half), max: at + Vec2::new(half, half), round: 3.0 },
            );
            let (text, size, face, anchor) = (letter.to_string(), SIZE, Face::Bold, Anchor::Start);
            let at = Vec2::new(34.0, at.y);
            pile.figure.add(Role::Text, None, Ink::Text { at, text, size, face, anchor, boxed: false });
            pile.words(&answer.label, SIZE, Face::Regular, Role::Text, 60.0);
        }
    }

    /// The same in words.
    pub(super) fn says(&self) -> String {
        let shows = plain(&self.shows);
        match &self.telling.asked {
            Some(asked) => {
                let answers = ('A'..='Z').zip(&asked.answers);
                let answers: Vec<String> =
                    answers.map(|(letter, a)| format!("{letter}: {}", plain(&a.label))).collect();
                let question = plain(&asked.question);
                format!("Picture: {shows} Question {}: {question} {}.", self.number, answers.join("; "))
            }
            None => {
                let (heading, text) = (plain(&self.telling.heading), plain(&self.telling.text));
                format!("{heading}. Picture: {shows} {text}")
            }
        }
    }
}

/// The answer to an entry's question, on paper and in words; `about` says of which slide it is.
pub(super) fn answers(entry: &Entry, about: &str) -> (Figure, String) {
    let mut pile = Pile::default();
    let Some(asked) = &entry.telling.asked else { return (pile.done(), String::new()) };
    let right = ('A'..='Z').zip(&asked.answers).find(|(_, answer)| answer.right);
    let right = right.map_or_else(String::new, |(letter, answer)| format!("{letter}: {}", answer.label));
    pile.words(&format!("Question {} · {about}", entry.number), SIZE * 0.85, Face::Regular, Role::Quiet, 0.0);
    pile.words(&format!("**{right}**"), SIZE, Face::Bold, Role::Text, 0.0);
    let mut said = vec![format!("Question {}, {about}: {}.", entry.number, plain(&right))];
    for (letter, answer) in ('A'..='Z').zip(&asked.answers) {
        if let Some(reason) = answer.reason.as_ref().filter(|_| !answer.right) {
            let text = format!("Not {letter}, {}: {reason}", answer.label);
            pile.words(&text, SIZE * 0.92, Face::Regular, Role::Quiet, 18.0);
            said.push(plain(&text));
        }
    }
    pile.words(&entry.telling.text, SIZE * 0.92, Face::Regular, Role::Text, 18.0);
    said.push(plain(&entry.telling.text));
    (pile.done(), said.join(" "))
}

/// Words one below the other.
#[derive(Default)]
struct Pile {
    figure: Figure,
    y: f32,
}

impl Pile {
    fn words(&mut self, markdown: &str, size: f32, face: Face, role: Role, indent: f32) {
        if markdown.trim().is_empty() {
            return;
        }
        let part = prose(markdown, INNER - indent, size, face, role);
        let height = part.size.y;
        set_in(&mut self.figure, part, Vec2::new(indent, self.y));
        self.y += height + size * 0.35;
    }

    fn done(mut self) -> Figure {
        self.figure.size = Vec2::new(INNER, self.y);
        self.figure
    }
}
