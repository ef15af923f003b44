//! How steps become files.

use std::fmt::Write;

use clap::ValueEnum;
use raystep_accel::Grain;
use raystep_figure::Theme;
use raystep_print::{Lettering, Manner};

use super::{Piece, Size, View};
use crate::fault::Fault;

/// How many times as long a plate may be one way as the other.
const SLENDEREST: u32 = 4;

/// How steps are drawn.
#[derive(Clone, Debug)]
pub(crate) struct Order {
    /// What a picture shows.
    pub(crate) view: View,
    /// What a plate holds, if not the usual.
    pub(crate) pieces: Vec<Piece>,
    /// The kind of file.
    pub(crate) format: Format,
    /// Its width and height.
    pub(crate) size: Size,
    /// Its colours.
    pub(crate) theme: &'static Theme,
    /// How letters stand in an SVG file.
    pub(crate) lettering: Lettering,
    /// Whether margins on which nothing is drawn are cut off.
    pub(crate) crop: bool,
    /// Whether there is no ground.
    pub(crate) clear: bool,
    /// Whether the signs of space are explained, if not as usual: on plates, and not in bare views.
    pub(crate) legend: Option<bool>,
    /// Which steps films stop at, and pictures if it is said.
    pub(crate) grain: Option<Grain>,
    /// How many milliseconds a film shows a step.
    pub(crate) delay: u16,
}

/// A kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Pixels.
    Png,
    /// Outlines that stay sharp at any size.
    Svg,
    /// A page of its own with text, for papers.
    Pdf,
    /// A moving picture with all colours.
    Apng,
    /// A moving picture that opens everywhere.
    Gif,
    /// A video; it needs ffmpeg.
    Mp4,
    /// A video in a free format; it needs ffmpeg.
    Webm,
    /// The whole walk as data.
    Json,
}

impl Format {
    /// How its files' names end.
    pub(crate) fn ending(self) -> &'static str {
        match self {
            Format::Png => "png",
            Format::Svg => "svg",
            Format::Pdf => "pdf",
            Format::Apng => "apng",
            Format::Gif => "gif",
            Format::Mp4 => "mp4",
            Format::Webm => "webm",
            Format::Json => "json",
        }
    }

    /// Whether one file holds many steps.
    pub(crate) fn is_film(self) -> bool {
        matches!(self, Format::Apng | Format::Gif | Format::Mp4 | Format::Webm)
    }

    /// Whether ffmpeg writes it.
    pub(crate) fn is_video(self) -> bool {
        matches!(self, Format::Mp4 | Format::Webm)
    }

    /// Whether it stays sharp at any size.
    pub(super) fn is_sharp(self) -> bool {
        matches!(self, Format::Svg | Format::Pdf)
    }
}

/// How long a film shows a step if nobody says so.
pub(crate) const STEP_MILLIS: u16 = 900;

/// How many milliseconds a film shows a step, from 20 to 20000, as it is written.
pub(crate) fn delay(text: &str) -> Result<u16, String> {
    const ALLOWED: std::ops::RangeInclusive<u16> = 20..=20000;
    let millis = text.trim().parse().ok().filter(|millis| ALLOWED.contains(millis));
    millis.ok_or_else(|| format!("write a whole number of milliseconds from {} to {}", ALLOWED.start(), ALLOWED.end()))
}

impl Order {
    /// The usual order: outlines on a ground, nothing cut off.
    pub(crate) fn new(view: View, format: Format, size: Size, theme: &'static Theme) -> Order {
        Order {
            view,
            pieces: Vec::new(),
            format,
            size,
            theme,
            lettering: Lettering::Outlines,
            crop: false,
            clear: false,
            legend: None,
            grain: None,
            delay: STEP_MILLIS,
        }
    }

    /// A plate sets its panes side by side and below each other: in a narrow strip they have no room.
    pub(super) fn has_room(&self) -> Result<(), Fault> {
        let plate = self.view == View::Plate && self.format != Format::Json;
        if plate && self.size.slenderness() > SLENDEREST {
            return Err(Fault::new(format!(
                "--size {}: a plate has no room for its panes there, since it is at most {SLENDEREST} times as long one way \
                 as the other; a single view, as --view space, may be of any size",
                self.size
            )));
        }
        Ok(())
    }

    /// How its figures become files.
    pub(super) fn manner(&self, scale: f32) -> Manner<'static> {
        Manner { theme: self.theme, lettering: self.lettering, clear: self.clear, scale }
    }

    /// What names of files say of it: whatever is not the usual, so that no picture takes the place of another.
    pub(super) fn marks(&self) -> String {
        let mut marks = String::new();
        if !self.pieces.is_empty() {
            self.pieces.iter().for_each(|piece| marks.extend(["-", piece.name()]));
        } else if self.view != View::Plate {
            marks.extend(["-", self.view.name()]);
        }
        if *self.theme != Theme::LIGHT {
            marks.extend(["-", self.theme.name]);
        }
        if self.size != Size::USUAL {
            let _ = write!(marks, "-{}", self.size);
        }
        match self.legend {
            Some(true) => marks.push_str("-legend"),
            Some(false) => marks.push_str("-no-legend"),
            None => {}
        }
        let words = [
            (self.crop, "-cropped"),
            (self.clear, "-transparent"),
            (self.lettering == Lettering::Embedded, "-text"),
            (self.lettering == Lettering::Named, "-named-text"),
        ];
        words.into_iter().filter(|(is, _)| *is).for_each(|(_, word)| marks.push_str(word));
        if let Some(grain) = self.grain {
            marks.extend(["-", grain.word()]);
        }
        marks
    }
}
