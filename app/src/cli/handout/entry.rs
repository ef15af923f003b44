//! A beat on paper: its picture with what is said of it, or the question that comes before.

use glam::Vec2;
use raystep_figure::{Anchor, Face, Figure, Ink, Role, Theme, crop};
use raystep_lesson::{Show, Slide};
use raystep_print::{Passage, Reading, enlarge, prose, set_in};

use super::sheet::{INNER, Piece, Sheet};
use crate::cli::page::plain;
use crate::export::{Asked, Session, Telling, View};
use crate::fault::Fault;

/// A beat.
pub(super) struct Entry {
    telling: Telling,
    /// The picture in words.
    shows: String,
    /// Whether it has pictures; the same one may stand above.
    pictured: bool,
    /// Its pictures, beside each other, once they are drawn.
    pictures: Vec<Figure>,
    /// The number of its question, from 1.
    pub(super) number: usize,
}

/// Size of the letters.
const SIZE: f32 = 17.0;
/// Between pictures beside each other, and above and below them.
const GAP: f32 = 14.0;
/// How high pictures may be; those that stand alone are higher. On one slide all are as high.
const HIGH: [f32; 6] = [520.0, 480.0, 440.0, 400.0, 360.0, 320.0];
const ALONE: f32 = 1.2;

/// The beats of a slide as far as they are reached, on as few sheets as may be, their pictures as high as they can be on
/// these. `about` says of which slide they are.
pub(super) fn entries(slide: &Slide, about: &str, sessions: &[Session<'_>]) -> Result<Vec<Entry>, Fault> {
    let beside = beside(slide);
    let mut entries = Vec::new();
    let mut drawn = Vec::new();
    // What the picture above shows: a beat's question is often asked where the beat before it stands.
    let mut above = None;
    for beat in 0..slide.beats.len() {
        let Some(session) = sessions.iter().find(|session| session.is_told_here(beat)) else { continue };
        let (Some(at), Some(telling)) = (session.step_of(beat), session.telling(beat)) else { continue };
        let step = telling.asked.as_ref().map_or(at, |asked| asked.before);
        let here = Some((session.file_stem().to_owned(), step));
        let telling_asks = telling.asked.is_some();
        let pictured = above != here;
        above = here;
        entries.push(Entry { telling, shows: session.shows(step), pictured, pictures: Vec::new(), number: 0 });
        let asked = telling_asks.then_some(beat);
        drawn.push((session, step, asked));
    }
    let height = |high: f32| if beside.is_some() { high } else { high * ALONE };
    let sheets = |high: f32| {
        let mut sheet = Sheet::new(&slide.title, about);
        for entry in &entries {
            sheet.add(entry.piece_with(height(high)));
        }
        sheet.finish().len()
    };
    let fewest = HIGH.map(sheets).into_iter().zip(HIGH).min_by_key(|(sheets, _)| *sheets);
    let high = fewest.map_or(HIGH[0], |(_, high)| height(high));
    for (entry, (session, step, asked)) in entries.iter_mut().zip(drawn).filter(|(entry, _)| entry.pictured) {
        entry.pictures = pictures(beside, high, session, step, asked)?;
    }
    Ok(entries)
}

/// What stands beside space: the bytes of a slide that is about these, or the tree, if it shows one.
fn beside(slide: &Slide) -> Option<View> {
    match slide.show.first() {
        Some(Show::Bytes) => Some(View::Bytes),
        _ => slide.show.contains(&Show::Tree).then_some(View::Tree),
    }
}

/// Space, or what stands in its place, and what stands beside it, so high. While the question of a beat is `asked`
/// nothing in them answers it.
fn pictures(
    beside: Option<View>,
    high: f32,
    session: &Session<'_>,
    step: usize,
    asked: Option<usize>,
) -> Result<Vec<Figure>, Fault> {
    let views = match beside {
        Some(View::Bytes) => vec![(INNER * 0.45 - GAP, View::Space), (INNER * 0.55, View::Bytes)],
        Some(view) => vec![(INNER * 0.6 - GAP, View::Space), (INNER * 0.4, view)],
        None => vec![(INNER, View::Space)],
    };
    let draw = |(width, view): (f32, View)| {
        let size = Vec2::new(width, high);
        let figure = session.figure_on(view, step, asked, size, SHARP, &Theme::PRINT)?;
        Ok(framed(figure, size))
    };
    views.into_iter().map(draw).collect()
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
    pub(super) fn piece(&self) -> Piece {
        self.piece_with(self.pictures.iter().map(|picture| picture.size.y).fold(0.0, f32::max))
    }

    /// The same; its pictures, drawn or not, are so high.
    fn piece_with(&self, high: f32) -> Piece {
        let mut pile = Pile::default();
        let mut x = 0.0;
        for picture in &self.pictures {
            set_in(&mut pile.figure, picture.clone(), Vec2::new(x, 0.0));
            x += picture.size.x + GAP;
        }
        if self.pictured {
            pile.y = high + GAP * 0.7;
            pile.read(Reading::Picture, format!("Picture: {}", plain(&self.shows)));
        }
        match &self.telling.asked {
            Some(asked) => self.question(asked, &mut pile),
            None => {
                pile.words(&format!("**{}**", self.telling.heading), SIZE * 1.1, Face::Bold, Role::Text, 0.0);
                pile.words(&self.telling.text, SIZE, Face::Regular, Role::Text, 0.0);
            }
        }
        pile.read(Reading::Words, self.says());
        Piece { asks: self.asks(), ..pile.done() }
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

    /// What it says or asks.
    fn says(&self) -> String {
        match &self.telling.asked {
            Some(asked) => {
                let answers = ('A'..='Z').zip(&asked.answers);
                let answers: Vec<String> =
                    answers.map(|(letter, a)| format!("{letter}: {}", plain(&a.label))).collect();
                let question = plain(&asked.question);
                format!("Question {}: {question} {}.", self.number, answers.join("; "))
            }
            None => {
                let (heading, text) = (plain(&self.telling.heading), plain(&self.telling.text));
                format!("{heading}. {text}")
            }
        }
    }
}

/// The answer to an entry's question; `about` says of which slide it is.
pub(super) fn answers(entry: &Entry, about: &str) -> Piece {
    let mut pile = Pile::default();
    let Some(asked) = &entry.telling.asked else { return pile.done() };
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
    pile.read(Reading::Words, said.join(" "));
    pile.done()
}

/// Words one below the other.
#[derive(Default)]
struct Pile {
    figure: Figure,
    y: f32,
    passages: Vec<Passage>,
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

    /// All that was added since the last time is read so.
    fn read(&mut self, kind: Reading, says: String) {
        let before = self.passages.last().map_or(0, |last| last.marks.end);
        self.passages.push(Passage { marks: before..self.figure.marks.len(), kind, says });
    }

    fn done(mut self) -> Piece {
        self.figure.size = Vec2::new(INNER, self.y);
        Piece { figure: self.figure, passages: self.passages, asks: false }
    }
}
