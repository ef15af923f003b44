//! What is filled in, and what it asks for.

use std::path::PathBuf;
use std::sync::Arc;

use clap::ValueEnum;
use raystep_accel::Grain;
use raystep_figure::Theme;
use raystep_print::Lettering;

use crate::export::{Format, Order, Piece, STEP_MILLIS, Size, There, View, Which as Steps, delay, has_ffmpeg, span};
use crate::fault::Fault;
use crate::shown::playback::Playback;
use crate::shown::state::State;
use crate::window::work::exporting::Wish;

/// What is filled in.
pub(super) struct Form {
    pub(super) which: Which,
    pub(super) steps: String,
    pub(super) format: Format,
    pub(super) page: Page,
    /// What stands on a plate of one's own choice.
    pub(super) pieces: Vec<Piece>,
    pub(super) legend: Option<bool>,
    pub(super) lettering: Lettering,
    pub(super) size: String,
    pub(super) crop: bool,
    pub(super) clear: bool,
    pub(super) grain: Option<Grain>,
    pub(super) delay: String,
    pub(super) theme: &'static Theme,
    pub(super) folder: String,
    /// Whether videos can be written on this machine.
    pub(super) videos: bool,
    /// What there is to draw of what is shown.
    there: Vec<Lacking>,
    of: Option<Arc<Playback>>,
}

/// The steps to write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Which {
    /// The step that is shown.
    This,
    /// Those of the slide's beats; of a film, all.
    Beats,
    /// Those that are named.
    Steps,
}

/// What a picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Page {
    /// A view.
    View(View),
    /// A plate of one's own choice.
    Own,
}

/// What is typed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Field {
    /// The first and the last step.
    Steps,
    /// How large a picture is.
    Size,
    /// How long each step of a film stays.
    Delay,
    /// Where files are written to.
    Folder,
}

impl Field {
    /// All of them, from above.
    pub(super) const ALL: [Field; 4] = [Field::Steps, Field::Size, Field::Delay, Field::Folder];
}

/// Why a view is not there, alone and among others on a plate.
struct Lacking {
    view: View,
    alone: Option<&'static str>,
    on_plates: Option<&'static str>,
}

impl Form {
    /// The usual choices.
    pub(super) fn new(theme: &'static Theme) -> Form {
        Form {
            which: Which::This,
            steps: String::new(),
            format: Format::Png,
            page: Page::View(View::Plate),
            pieces: vec![Piece::Title, Piece::Text, Piece::View(View::Space)],
            legend: None,
            lettering: Lettering::Outlines,
            size: Size::USUAL.to_string(),
            crop: false,
            clear: false,
            grain: None,
            delay: STEP_MILLIS.to_string(),
            theme,
            folder: usual_folder(),
            videos: false,
            there: Vec::new(),
            of: None,
        }
    }

    /// The same, where something else may be shown by now.
    pub(super) fn fitting(mut self, state: &State) -> Form {
        self.videos = has_ffmpeg();
        if self.format.is_video() && !self.videos {
            self.format = Format::Gif;
        }
        self.keep_to(state);
        self
    }

    /// Keeps to what there is in what is shown.
    pub(super) fn keep_to(&mut self, state: &State) {
        let made = state.made();
        if self.of.as_ref().map(Arc::as_ptr) == made.map(Arc::as_ptr) && !self.there.is_empty() {
            return;
        }
        self.of = made.cloned();
        self.steps = made.map_or_else(String::new, |made| format!("0..{}", made.steps().last()));
        let Some(made) = made else { return };
        let listing = state.slide().and_then(|slide| state.library.listing(&slide.listing));
        let reel = made.reel();
        let there = There { reel: &reel, play: &made.play, listing };
        let lacking =
            |view: &View| Lacking { view: *view, alone: there.lacks(*view), on_plates: there.lacks_on_plates(*view) };
        self.there = View::value_variants().iter().map(lacking).collect();
        if let Page::View(view) = self.page
            && self.lacks(view).is_some()
        {
            self.page = Page::View(View::Plate);
        }
        let pieces = std::mem::take(&mut self.pieces);
        self.pieces = pieces.into_iter().filter(|piece| self.lacks_piece(*piece).is_none()).collect();
    }

    /// Why there is no such view.
    pub(super) fn lacks(&self, view: View) -> Option<&'static str> {
        self.there.iter().find(|there| there.view == view)?.alone
    }

    /// Why it cannot stand on a plate.
    pub(super) fn lacks_piece(&self, piece: Piece) -> Option<&'static str> {
        let Piece::View(view) = piece else { return None };
        self.there.iter().find(|there| there.view == view)?.on_plates
    }

    /// The last step of what is shown.
    pub(super) fn last(&self) -> usize {
        self.of.as_ref().map_or(0, |made| made.steps().last())
    }

    /// What is wrong with what is typed in a field. What is greyed says nothing.
    pub(super) fn wrong(&self, field: Field) -> Option<String> {
        let named = |name: &str, wrong: String| format!("{name}: {wrong}.");
        match field {
            Field::Steps if self.chosen() == Which::Steps => match span(&self.steps) {
                Ok(steps) if *steps.start() > self.last() => {
                    Some(named("Steps", format!("the last one is {}", self.last())))
                }
                steps => steps.err().map(|wrong| named("Steps", wrong)),
            },
            Field::Size if self.draws().is_none() => {
                self.size.trim().parse::<Size>().err().map(|wrong| named("Size", wrong))
            }
            Field::Delay if self.moves().is_none() => delay(&self.delay).err().map(|wrong| named("Each step", wrong)),
            Field::Folder if self.folder.trim().is_empty() => {
                Some("Write the folder that the files shall go to.".to_owned())
            }
            Field::Steps | Field::Size | Field::Delay | Field::Folder => None,
        }
    }

    /// What the form says, at this step. What is greyed says nothing.
    pub(super) fn wish(&self, step: usize) -> Result<Wish, Fault> {
        if let Some(wrong) = Field::ALL.into_iter().find_map(|field| self.wrong(field)) {
            return Err(Fault::new(wrong));
        }
        let which = match self.chosen() {
            Which::This => Steps::Steps(step..=step),
            Which::Beats => Steps::Beats,
            Which::Steps => Steps::Steps(span(&self.steps).map_err(Fault::new)?),
        };
        let pieces = match self.page {
            Page::Own if self.draws().is_none() => self.pieces.clone(),
            _ => Vec::new(),
        };
        if self.page == Page::Own && self.draws().is_none() && pieces.is_empty() {
            return Err(Fault::new("Choose what stands on the plate."));
        }
        let view = match self.page {
            Page::View(view) => view,
            Page::Own => View::Plate,
        };
        let size = match self.draws() {
            None => self.size.trim().parse::<Size>().map_err(Fault::new)?,
            Some(_) => Size::USUAL,
        };
        let delay = match self.moves() {
            None => delay(&self.delay).map_err(Fault::new)?,
            Some(_) => STEP_MILLIS,
        };
        let order = Order {
            pieces,
            lettering: if self.spells().is_none() { self.lettering } else { Lettering::Outlines },
            crop: self.crop && self.draws().is_none(),
            clear: self.clear && self.bares().is_none(),
            legend: self.legend.filter(|_| self.explains().is_none()),
            grain: self.grain.filter(|_| self.leaves_out().is_none()),
            delay,
            ..Order::new(view, self.format, size, self.theme)
        };
        // A JSON file is of the ray that is shown.
        let all_rays = self.chosen() == Which::Beats && self.draws().is_none();
        let folder = PathBuf::from(self.folder.trim());
        Ok(Wish { order, which, all_rays, folder })
    }
}

/// The folder that is offered.
fn usual_folder() -> String {
    let home = std::env::var_os("HOME").map(PathBuf::from).unwrap_or_default();
    home.join("raystep").to_string_lossy().into_owned()
}
