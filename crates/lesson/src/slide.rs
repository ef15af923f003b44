//! A slide: the same beats on a flat and a solid stage.

use raystep_accel::KdLayout;

use crate::minutes::minutes;
use crate::reading::Reading;
use crate::{Beat, NamedRay, Plays, Problem, Spot, Stage, StageKind, body, head};

/// One slide of the lecture, as its file says it.
#[derive(Clone, Debug, PartialEq)]
pub struct Slide {
    /// Its file without folder and ending: `"33-which-child-first"`; unique in its section.
    pub name: String,
    /// The folder it lies in: `"05-kd-tree"`.
    pub section: String,
    /// What the section is called.
    pub(crate) section_title: String,
    /// The numbers of the lecture's slides that it stands for: `"33"`, `"13a"`.
    pub numbers: Vec<String>,
    /// What it is called.
    pub title: String,
    /// A walk, a packet, a build or a board.
    pub plays: Plays,
    /// The name of its listing.
    pub listing: String,
    /// The panes that it is about, most important first.
    pub show: Vec<Show>,
    /// Of the bytes of a kd-tree's node, the last layout that is shown.
    pub layout: KdLayout,
    /// Where it plays: flat first if it has both.
    pub stages: Vec<Stage>,
    /// The stage that it opens on, if it says so.
    pub opens: Option<StageKind>,
    /// What it says, in the order of what it plays.
    pub beats: Vec<Beat>,
    /// What is for the lecturer alone: Markdown.
    pub notes: String,
    /// The file it was read from.
    pub file: String,
    /// Where in the file its numbers stand.
    pub(crate) numbers_spot: Spot,
    /// Where its title stands.
    pub(crate) title_spot: Spot,
    /// Where its listing is named.
    pub(crate) listing_spot: Spot,
}

/// The heading of what is for the lecturer alone.
const NOTES: &str = "# Notes";

impl Slide {
    /// `"5/33"`: how the command line calls it.
    pub fn id(&self) -> String {
        let number = self.numbers.first().map_or(self.name.as_str(), String::as_str);
        format!("{}/{number}", self.section_number())
    }

    /// The first number, with the section's, that both slides have.
    pub(crate) fn shares(&self, other: &Slide) -> Option<String> {
        let number = self.numbers.iter().find(|number| other.numbers.contains(number))?;
        let id = |slide: &Slide| format!("{}/{number}", slide.section_number());
        (id(self) == id(other)).then(|| id(self))
    }

    /// `"5"`: the number before the section's name.
    fn section_number(&self) -> &str {
        self.section.split('-').next().unwrap_or_default().trim_start_matches('0')
    }

    /// What the section is called: `"kd-trees"`.
    pub fn section_title(&self) -> &str {
        &self.section_title
    }

    /// `"slides 33-38"`, `"slide 12"`.
    pub fn numbers_text(&self) -> String {
        match self.numbers.as_slice() {
            [] => String::new(),
            [only] => format!("slide {only}"),
            [first, .., last] => format!("slides {first}\u{2013}{last}"),
        }
    }

    /// Reads a slide's file; none if it has no head.
    pub(crate) fn read(section: &str, name: &str, file: &str, text: &str) -> (Option<Slide>, Vec<Problem>) {
        let mut reading = Reading::new(file, text);
        let slide = Slide::parts(section, name, file, text, &mut reading);
        (slide, reading.finish())
    }

    fn parts(section: &str, name: &str, file: &str, text: &str, reading: &mut Reading<'_>) -> Option<Slide> {
        if reading.is_too_large() {
            return None;
        }
        let lines: Vec<(usize, &str)> = reading.lines().collect();
        let fence = |line: &&(usize, &str)| line.1.trim_end() == "+++";
        if !lines.first().as_ref().is_some_and(fence) {
            reading.problem(0, "a slide begins with its head: a line `+++`, TOML, and a line `+++`");
            return None;
        }
        let Some(end) = lines.iter().skip(1).position(|line| fence(&line)).map(|end| end + 1) else {
            reading.problem(0, "the head is not closed: a second line `+++` is missing");
            return None;
        };
        // What the lecturer alone reads stands below everything else.
        let notes_at = lines.iter().position(|(_, line)| line.trim_end() == NOTES).filter(|at| *at > end);
        let (lines, below) = lines.split_at(notes_at.unwrap_or(lines.len()));
        let notes: Vec<&str> = below.iter().skip(1).map(|(_, line)| line.trim_end()).collect();
        let notes = notes.join("\n").trim().to_owned();
        if let Some((at, _)) = below.first().filter(|_| notes.is_empty()) {
            reading.problem(*at, format!("`{NOTES}` is followed by what the lecturer is to say"));
        }
        // Blanks in place of the first fence: a byte of the head is the same byte of the file.
        let head = head::read(&format!("   {}", &text[3..lines[end].0]), reading);
        let before = reading.count();
        // Without a head nobody knows what is played, nor which events there are.
        let beats = if head.is_some() { body::read(&lines[end + 1..], reading) } else { Vec::new() };
        let readable = head.is_some();
        let head = head.unwrap_or_default();
        // What could not be read may have been a beat or a question.
        let complete = readable && reading.count() == before;
        if complete && beats.is_empty() {
            reading.problem(lines[end].0, "a slide has a beat or more: `## Title {at=event}`");
        } else if complete && beats.iter().all(|beat| beat.ask.is_none()) {
            reading.problem(lines[end].0, "a slide asks a question or more: `> ask {field=near}: question`");
        }
        Some(Slide {
            name: name.to_owned(),
            section: section.to_owned(),
            section_title: untitled(section),
            numbers: head.numbers,
            title: head.title,
            plays: reading.plays,
            listing: head.listing,
            show: head.show,
            layout: head.layout.unwrap_or(KdLayout::Compact),
            stages: head.stages,
            opens: head.opens,
            beats,
            notes,
            file: file.to_owned(),
            numbers_spot: head.numbers_spot,
            title_spot: head.title_spot,
            listing_spot: head.listing_spot,
        })
    }

    /// How many minutes it takes, if its notes say so.
    pub fn minutes(&self) -> Option<f32> {
        minutes(&self.notes)
    }

    /// The stage of that kind, if the slide offers it.
    pub fn stage(&self, kind: StageKind) -> Option<&Stage> {
        self.stages.iter().find(|stage| stage.kind == kind)
    }

    /// The stage that it opens on for someone who wishes to see this kind: the one it says, else that one if it
    /// has it, else its first.
    pub fn opening_stage(&self, wished: StageKind) -> Option<&Stage> {
        let kind = self.opens.unwrap_or(wished);
        self.stage(kind).or(self.stages.first())
    }

    /// The ray that a beat is played on: the one it names, else the one of the beats before it, else
    /// the stage's first.
    pub fn ray_of<'a>(&self, stage: &'a Stage, beat: usize) -> Option<&'a NamedRay> {
        let named = self.beats.get(..=beat)?.iter().rev().find_map(|beat| beat.ray.as_deref());
        named.and_then(|name| stage.ray(name)).or(stage.rays.first())
    }
}

/// What a section is called that nobody names: `"kd tree"`.
pub(crate) fn untitled(section: &str) -> String {
    section.split('-').skip(1).collect::<Vec<_>>().join(" ")
}

/// A pane that a slide is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Show {
    /// The scene with the walk in it.
    Space,
    /// The tree of nodes.
    Tree,
    /// The table of cells and of the three next t.
    Cells,
    /// The matrix of pairs.
    Matrix,
    /// The three slab intervals.
    Slabs,
    /// The bytes of a kd-tree's node, or the table of a hashed grid.
    Bytes,
    /// The ruler of t.
    Ruler,
    /// The stack.
    Stack,
    /// The listing with this step's values.
    Listing,
    /// The work so far.
    Work,
}

impl Show {
    /// All panes with the names that slides give them.
    pub const NAMES: [(&'static str, Show); 10] = [
        ("space", Show::Space),
        ("tree", Show::Tree),
        ("cells", Show::Cells),
        ("matrix", Show::Matrix),
        ("slabs", Show::Slabs),
        ("bytes", Show::Bytes),
        ("t", Show::Ruler),
        ("stack", Show::Stack),
        ("listing", Show::Listing),
        ("work", Show::Work),
    ];
}
