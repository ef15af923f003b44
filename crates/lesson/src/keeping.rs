//! Lessons that are read again while somebody reads them: what cannot be read now stays as it was.

use crate::{Library, Slide, Stage};

impl Library {
    /// These lessons with what is missing in them as it was `before`: slides of which nothing can be played now,
    /// since their files are half-written or wrong, and the slide that is `open`, should its file be gone. The
    /// problems are still told.
    pub fn keeping(mut self, before: &Library, open: Option<&Slide>) -> Library {
        for old in &before.slides {
            let now = self.slides.iter().position(|slide| slide.file == old.file);
            let wrong = self.problems.iter().any(|problem| problem.file == old.file);
            match now {
                Some(now) if wrong && !plays(&self.slides[now]) => self.slides[now] = old.clone(),
                None if wrong || open.is_some_and(|open| open.file == old.file && self.of_number(open).is_none()) => {
                    let place = self.slides.partition_point(|slide| slide.file < old.file);
                    self.slides.insert(place, old.clone());
                }
                _ => {}
            }
        }
        if self.terms.is_empty() {
            self.terms.clone_from(&before.terms);
        }
        let wrong = |file: &str| self.problems.iter().any(|problem| problem.file == file);
        let scenes = self.scenes.keeping(&before.scenes, wrong);
        self.know(scenes);
        // A listing is as good as gone while its file is empty or not there.
        for listing in &before.listings {
            let now = self.listings.iter().position(|own| own.name == listing.name);
            let used = || self.slides.iter().any(|slide| slide.listing == listing.name);
            match now {
                Some(now) if self.listings[now].lines.is_empty() => self.listings[now] = listing.clone(),
                None if used() => self.listings.push(listing.clone()),
                _ => {}
            }
        }
        self
    }

    /// Where a slide stands in these lessons: it, or one of its number, or else what stands in its place.
    pub fn place_of(&self, slide: &Slide, place: usize) -> usize {
        let same = self.slides.iter().position(|other| other.file == slide.file);
        let same = same.or_else(|| self.of_number(slide));
        same.unwrap_or_else(|| place.min(self.slides.len().saturating_sub(1)))
    }

    /// The slide of the same section and number, whatever its file is called now.
    fn of_number(&self, slide: &Slide) -> Option<usize> {
        self.slides.iter().position(|other| other.id() == slide.id())
    }
}

/// Whether there is anything to be shown of a slide.
fn plays(slide: &Slide) -> bool {
    let built = |stage: &Stage| stage.plan.wrong().is_empty();
    !slide.stages.is_empty() && !slide.beats.is_empty() && slide.stages.iter().all(built)
}
