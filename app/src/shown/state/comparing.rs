//! What a beat offers, and what stands beside the walk.

use raystep_lesson::Act;

use super::State;
use crate::shown::beside::{Beside, Rivals};

impl State {
    /// Does what the beat offers, if it does.
    pub(super) fn take_up(&mut self, offer: usize) {
        let Some(act) = self.offers().get(offer).map(|offer| offer.act.clone()) else { return };
        match act {
            Act::Set(settings) => {
                // Several parameters are one change.
                self.keep();
                for (key, value) in &settings {
                    self.set(key, value);
                }
            }
            Act::Compare(kind) => self.compare(kind),
            // It stands over the page, which is no matter of what is shown.
            Act::Best => {}
            Act::Slide(id) => {
                let slide = self.library.slide(&id).map(|slide| &slide.file);
                let index = self.library.slides.iter().position(|other| Some(&other.file) == slide);
                if let Some(index) = index {
                    self.show_slide(index);
                }
            }
        }
    }

    /// Whether what a beat offers with this number is to measure all structures.
    pub fn offers_best(&self, offer: u8) -> bool {
        self.offers().get(usize::from(offer)).is_some_and(|offer| offer.act == Act::Best)
    }

    /// Another structure beside the walk.
    pub fn compare(&mut self, kind: &'static str) {
        self.compare_all(Rivals::of([kind]));
    }

    /// Other structures beside the walk: in a flat scene all of them, in a solid one the first.
    pub fn compare_all(&mut self, rivals: Rivals) {
        // A packet is compared with one structure at a time.
        let flat = self.playback.as_ref().is_none_or(|playback| {
            playback.play.scene.flat && playback.play.tape.plays() != raystep_lesson::Plays::Packet
        });
        self.beside = match rivals.kinds().next() {
            None => Beside::Nothing,
            Some(first) => {
                self.rivals = rivals;
                if rivals.count() > 1 && flat { Beside::Abreast(rivals) } else { Beside::Structure(first) }
            }
        };
    }
}
