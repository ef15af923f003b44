//! The colours of a GIF: at most 256, the same for all its pictures, so that a role keeps its hue.

use std::collections::{BTreeSet, HashMap};

use quantizr::{Histogram, Image, Options, QuantizeResult};
use raystep_figure::{Color, Role, Theme};

use super::Frame;
use crate::PrintError;

/// Red, green, blue.
type Rgb = [u8; 3];

/// Counts the colours of a film's pictures.
pub struct Tally {
    histogram: Histogram,
    /// What the theme draws with.
    roles: BTreeSet<Rgb>,
    /// Those that occur.
    met: BTreeSet<Rgb>,
    clear: bool,
}

/// Most colours of a GIF.
const MOST: usize = 256;

/// The colours that the theme draws with, where they cover, and its tints on a panel.
fn of_theme(theme: &Theme) -> BTreeSet<Rgb> {
    let panel = theme.style(Role::Panel).fill;
    let of_role = |role: Role| {
        let (style, label) = (theme.style(role), theme.label(role));
        [style.stroke.map(|stroke| stroke.color), style.fill, Some(style.text), label.fill]
    };
    let colors = Role::ALL.into_iter().flat_map(of_role).flatten();
    let covers = |color: Color| panel.map_or(color, |panel| color.over(panel));
    colors.map(covers).map(|color| [color.r, color.g, color.b]).collect()
}

impl Tally {
    /// None yet.
    pub fn new(theme: &Theme) -> Tally {
        Tally { histogram: Histogram::new(), roles: of_theme(theme), met: BTreeSet::new(), clear: false }
    }

    /// Counts those of a picture.
    ///
    /// # Errors
    /// When the picture lacks pixels.
    pub fn add(&mut self, frame: &Frame) -> Result<(), PrintError> {
        let mut opaque = frame.rgba.clone();
        let mut before = [0; 4];
        for pixel in opaque.chunks_exact_mut(4) {
            // A pixel is clear or it is not.
            self.clear |= pixel[3] < HALF;
            pixel[3] = 255;
            if pixel != before {
                before.copy_from_slice(pixel);
                let color = [pixel[0], pixel[1], pixel[2]];
                if self.roles.contains(&color) {
                    self.met.insert(color);
                }
            }
        }
        let image = Image::new(&opaque, frame.width as usize, frame.height as usize);
        self.histogram.add_image(&image.map_err(|error| PrintError::Pack(error.to_string()))?);
        Ok(())
    }

    /// The colours that stand for all.
    ///
    /// # Errors
    /// When none was counted.
    pub fn palette(self) -> Result<Palette, PrintError> {
        // The colours of roles as they are, and the best for whatever lies between.
        let mut colors: Vec<Rgb> = self.met.into_iter().collect();
        let room = MOST - colors.len() - usize::from(self.clear);
        let mut options = Options::default();
        options.set_max_colors(room as i32).map_err(|error| PrintError::Pack(error.to_string()))?;
        let found = QuantizeResult::quantize_histogram(&self.histogram, &options);
        let found = found.get_palette();
        let entries = found.entries.iter().take(found.count as usize);
        colors.extend(entries.map(|color| [color.r, color.g, color.b]));
        Ok(Palette { colors, clear: self.clear, known: HashMap::new() })
    }
}

/// Below this alpha a pixel is clear.
const HALF: u8 = 128;

/// The colours of a film.
#[derive(Clone, Debug)]
pub struct Palette {
    colors: Vec<Rgb>,
    clear: bool,
    known: HashMap<Rgb, u8>,
}

impl Palette {
    /// As a GIF writes it; what is clear comes last.
    pub(super) fn bytes(&self) -> Vec<u8> {
        let clear = self.clear.then_some([0; 3]);
        self.colors.iter().copied().chain(clear).flatten().collect()
    }

    /// The entry that is clear, if pixels are.
    pub(super) fn clear(&self) -> Option<u8> {
        self.clear.then_some(self.colors.len() as u8)
    }

    /// The entry of each pixel.
    pub(super) fn indices(&mut self, frame: &Frame) -> Vec<u8> {
        let clear = self.clear();
        let index = |pixel: &[u8]| match clear {
            Some(clear) if pixel[3] < HALF => clear,
            _ => self.nearest([pixel[0], pixel[1], pixel[2]]),
        };
        frame.rgba.chunks_exact(4).map(index).collect()
    }

    fn nearest(&mut self, color: Rgb) -> u8 {
        let colors = &self.colors;
        *self.known.entry(color).or_insert_with(|| {
            // The eye sees green best, and blue least.
            let far = |other: &Rgb| {
                let [r, g, b] = [0, 1, 2].map(|at| i32::from(color[at]) - i32::from(other[at])).map(|d| d * d);
                2 * r + 4 * g + b
            };
            let nearest = colors.iter().enumerate().min_by_key(|(_, other)| far(other));
            nearest.map_or(0, |(index, _)| index as u8)
        })
    }
}
