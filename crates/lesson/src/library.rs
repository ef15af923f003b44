//! All slides, listings and words.

use std::sync::LazyLock;

use include_dir::{Dir, include_dir};
use raystep_scene::Scenes;

use crate::problem::misspelt;
use crate::reading::Reading;
use crate::{Listing, Problem, Slide, Spot, Term, limits, term};

/// The lessons as they were when the program was built.
static LESSONS: Dir<'static> = include_dir!("$CARGO_MANIFEST_DIR/../../lessons");

/// The lessons, sorted as they are taught.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Library {
    /// The slides that could be read, in order.
    pub slides: Vec<Slide>,
    /// The listings.
    pub listings: Vec<Listing>,
    /// The words that are explained.
    pub terms: Vec<Term>,
    /// The scenes beside the slides.
    pub scenes: Scenes,
    /// What could not be read.
    pub problems: Vec<Problem>,
}

impl Library {
    /// The lessons in the program itself.
    pub fn embedded() -> Library {
        static READ: LazyLock<Library> = LazyLock::new(|| {
            let mut files = Vec::new();
            collect(&LESSONS, &mut files);
            Library::from_files(files)
        });
        READ.clone()
    }

    /// The lessons in these files: paths from the folder of lessons on, and texts.
    pub fn from_files(files: impl IntoIterator<Item = (String, String)>) -> Library {
        let mut files: Vec<(String, String)> = files.into_iter().collect();
        files.sort();
        let mut library = Library::default();
        for (path, text) in &files {
            library.add(path, text);
        }
        let sections = files.iter().filter_map(|(path, _)| path.strip_suffix(".md")?.rsplit_once('/'));
        let mut sections: Vec<&str> = sections.map(|(section, _)| section).collect();
        sections.dedup();
        for (path, text) in files.iter().filter(|(path, _)| path == "sections.txt") {
            library.name_sections(path, text, &sections);
        }
        library.tell_twins();
        library
    }

    /// The same lessons with the scenes in these files: names from the folder of lessons on, and bytes. A scene that is
    /// among `known` is not read again.
    #[must_use]
    pub fn with_scenes(mut self, files: impl IntoIterator<Item = (String, Vec<u8>)>, known: &Scenes) -> Library {
        let (scenes, wrong) = Scenes::read(files, known);
        let spot = |wrong: usize| u32::try_from(wrong).unwrap_or(u32::MAX);
        let problems = wrong.iter().map(|wrong| {
            let spot = Spot { line: spot(wrong.line), column: spot(wrong.column) };
            Problem::new(&wrong.file, spot, wrong.sentence())
        });
        self.problems.extend(problems);
        self.know(scenes);
        self
    }

    /// Looks up scenes among these first.
    pub(crate) fn know(&mut self, scenes: Scenes) {
        self.slides.iter_mut().flat_map(|slide| &mut slide.stages).for_each(|stage| stage.know(&scenes));
        self.scenes = scenes;
    }

    /// Says so where two slides of a section have the same number.
    fn tell_twins(&mut self) {
        let mut wrong = Vec::new();
        for (place, slide) in self.slides.iter().enumerate() {
            if let Some((number, other)) =
                self.slides[..place].iter().find_map(|other| Some((slide.shares(other)?, other)))
            {
                let message = format!("slide {number} is {} already: another number is needed", other.file);
                wrong.push(Problem::new(&slide.file, slide.numbers_spot, message));
            }
        }
        self.problems.extend(wrong);
    }

    /// Adds what one file holds: `section/slide.md`, `listings/name.txt` or `terms.txt`.
    fn add(&mut self, path: &str, text: &str) {
        let (folder, file) = path.rsplit_once('/').unwrap_or(("", path));
        let problems = if let Some(name) = file.strip_suffix(".txt").filter(|_| folder == "listings") {
            let (listing, problems) = Listing::read(name, path, text);
            self.listings.push(listing);
            problems
        } else if let Some(name) = file.strip_suffix(".md").filter(|_| !folder.is_empty()) {
            let (slide, problems) = Slide::read(folder, name, path, text);
            self.slides.extend(slide);
            problems
        } else if path == term::FILE {
            let (terms, problems) = Term::read_all(path, text);
            self.terms = terms;
            problems
        } else {
            Vec::new()
        };
        self.problems.extend(problems);
    }

    /// Names the sections by lines of `folder : title`.
    fn name_sections(&mut self, path: &str, text: &str, sections: &[&str]) {
        let mut reading = Reading::new(path, text);
        if !reading.is_too_large() {
            for (at, line) in reading.lines().filter(|(_, line)| !line.trim().is_empty()) {
                self.name_section(at, line, sections, &mut reading);
            }
        }
        self.problems.extend(reading.finish());
    }

    fn name_section(&mut self, at: usize, line: &str, sections: &[&str], reading: &mut Reading<'_>) {
        let Some((folder, title)) = line.split_once(" : ") else {
            reading.problem(at, "a line that names a section is `folder : title`");
            return;
        };
        let (folder, title) = (folder.trim(), title.trim());
        if !sections.contains(&folder) {
            reading.problem(at, misspelt("folder with a slide in it", folder, sections));
        }
        if title.is_empty() || title.chars().count() > limits::TITLE {
            reading.problem(at, format!("a section's title has from 1 to {} letters", limits::TITLE));
            return;
        }
        for slide in self.slides.iter_mut().filter(|slide| slide.section == folder) {
            title.clone_into(&mut slide.section_title);
        }
    }

    /// The listing of that name.
    pub fn listing(&self, name: &str) -> Option<&Listing> {
        self.listings.iter().find(|listing| listing.name == name)
    }

    /// What a word means, if that is explained.
    pub fn term(&self, word: &str) -> Option<&Term> {
        self.terms.iter().find(|term| term.is(word))
    }

    /// The slide called `"5/33"`, `"05-kd-tree/33-which-child-first"`, `"33-which-child-first"` or, by its number alone,
    /// `"33"`.
    pub fn slide(&self, id: &str) -> Option<&Slide> {
        let called = |slide: &&Slide| {
            slide.id() == id || slide.name == id || id.split_once('/') == Some((&slide.section, &slide.name))
        };
        self.slides.iter().find(called).or_else(|| self.slides.get(self.numbered(id)?))
    }

    /// The place of a slide by the number it has in the lecture, `"33"`, or with its section, `"5/33"`. A number between
    /// those that a slide stands for, `"35"` of 33 to 38, finds it, too.
    pub fn numbered(&self, typed: &str) -> Option<usize> {
        let (section, number) =
            typed.split_once('/').map_or((None, typed), |(section, number)| (Some(section), number));
        let digits = |text: &&str| text.bytes().all(|byte| byte.is_ascii_digit());
        let value = |text: &str| {
            let text = Some(text.trim_end_matches(|letter: char| letter.is_ascii_alphabetic()));
            text.filter(digits)?.parse::<u32>().ok()
        };
        let here = |slide: &Slide| section.is_none_or(|section| slide.id().split('/').next() == Some(section));
        let exact = |slide: &Slide| slide.numbers.iter().any(|known| known == number);
        let between = |slide: &Slide| {
            let (first, last) = (value(slide.numbers.first()?)?, value(slide.numbers.last()?)?);
            (first..=last).contains(&value(number)?).then_some(())
        };
        let place = |found: &dyn Fn(&Slide) -> bool| self.slides.iter().position(|slide| here(slide) && found(slide));
        place(&exact).or_else(|| place(&|slide| between(slide).is_some()))
    }
}

/// Whether a file of the lessons' folder may be a slide or a listing.
pub(crate) fn wanted(path: &std::path::Path) -> bool {
    path.extension().is_some_and(|ending| ending == "md" || ending == "txt")
}

/// The texts in a folder of the program.
fn collect(folder: &Dir<'static>, files: &mut Vec<(String, String)>) {
    for file in folder.files().filter(|file| wanted(file.path())) {
        if let Some(text) = file.contents_utf8() {
            files.push((file.path().to_string_lossy().replace('\\', "/"), text.to_owned()));
        }
    }
    folder.dirs().for_each(|folder| collect(folder, files));
}
