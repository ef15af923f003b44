//! The lecture with lessons of somebody's own beside it.

use crate::{Library, Problem, Spot};

/// What is said of what the lecture has already.
const ADVICE: &str = "or leave the lecture out with --only";

impl Library {
    /// These lessons with others beside them: slides stand where their paths say. A slide whose number these have
    /// already, a listing or a word that says something else here, is left out and told among the problems.
    #[must_use]
    pub fn and(mut self, own: Library) -> Library {
        let (slides, mut problems) = self.fresh_slides(&own);
        for listing in &own.listings {
            match self.listing(&listing.name) {
                None => self.listings.push(listing.clone()),
                Some(known) if known.lines == listing.lines => {}
                Some(_) => {
                    let name = &listing.name;
                    let message = format!(
                        "the lecture's listing `{name}` says something else: give the file another name, {ADVICE}"
                    );
                    problems.push(Problem::new(&listing.file, Spot::START, message));
                }
            }
        }
        for term in &own.terms {
            match term.names.iter().find_map(|name| Some((name, self.term(name)?))) {
                None => self.terms.push(term.clone()),
                Some((_, known)) if known.means == term.means => {}
                Some((name, _)) => {
                    let message = format!("the lecture explains `{name}` otherwise: leave the line out, {ADVICE}");
                    problems.push(Problem::new(crate::term::FILE, term.spot, message));
                }
            }
        }
        self.slides.extend(slides);
        self.slides.sort_by(|a, b| a.file.cmp(&b.file));
        self.problems.extend(own.problems);
        self.problems.extend(problems);
        // Whoever names a scene of the lecture finds no other: own ones have other names.
        self.know(own.scenes);
        self
    }

    /// The slides that these lessons do not have, and what is said of the others.
    fn fresh_slides(&self, own: &Library) -> (Vec<crate::Slide>, Vec<Problem>) {
        let (mut fresh, mut problems) = (Vec::new(), Vec::new());
        for slide in &own.slides {
            let same = |other: &&crate::Slide| other.file == slide.file || slide.shares(other).is_some();
            if let Some(other) = self.slides.iter().find(same) {
                let what = match slide.shares(other) {
                    Some(number) => {
                        format!("slide {number} is the lecture's {} already: give it another number", other.file)
                    }
                    None => "the lecture has a slide of this name: give the file another one".to_owned(),
                };
                problems.push(Problem::new(
                    &slide.file,
                    slide.numbers_spot,
                    format!("{what}, {ADVICE}; it is left out"),
                ));
                continue;
            }
            let mut slide = slide.clone();
            // A section of the lecture keeps its title, unless the own lessons name it.
            let title =
                self.slides.iter().find(|other| other.section == slide.section).map(|other| &other.section_title);
            if let Some(title) = title.filter(|_| slide.section_title == crate::slide::untitled(&slide.section)) {
                slide.section_title.clone_from(title);
            }
            fresh.push(slide);
        }
        (fresh, problems)
    }
}
