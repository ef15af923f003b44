//! Steps as one moving picture.

use rayon::prelude::*;
use raystep_print::{Apng, Frame, Gif, PrintError, Tally};

use super::ground::cancelled;
use super::{Format, Order};
use crate::fault::Fault;

/// The pictures of a film.
pub(super) struct Film<'a> {
    /// Steps with the beat that stands there.
    pub(super) steps: &'a [(usize, Option<usize>)],
    /// The picture of the step with this place, as SVG, and how many pixels a point has.
    pub(super) draw: &'a (dyn Fn(usize) -> Result<(String, f32), Fault> + Sync),
    /// Whether somebody still waits for it.
    pub(super) go_on: &'a (dyn Fn() -> bool + Sync),
}

/// How many times longer a film stays on a beat, and on its last picture.
const ON_BEAT: u16 = 2;
const ON_LAST: u16 = 3;

/// How often a picture of a film is drawn: the colours of a GIF are chosen when all pictures are known.
pub(super) fn rounds(format: Format) -> usize {
    if format == Format::Gif { 2 } else { 1 }
}

/// How many turns of the film's delay a picture is shown.
pub(super) fn turns(film: &Film<'_>, index: usize) -> u16 {
    match film.steps[index].1 {
        _ if index + 1 == film.steps.len() => ON_LAST,
        Some(_) => ON_BEAT,
        None => 1,
    }
}

/// The bytes of an animated PNG or a GIF.
pub(super) fn bytes(film: &Film<'_>, order: &Order) -> Result<Vec<u8>, Fault> {
    let wrong = |error: PrintError| Fault::new(error.to_string());
    let millis = |index: usize| order.delay.saturating_mul(turns(film, index));
    if order.format == Format::Gif {
        let mut tally = Tally::new(order.theme);
        film.each(|_, frame| tally.add(&frame).map_err(wrong))?;
        let mut gif = Gif::new(tally.palette().map_err(wrong)?);
        film.each(|index, frame| gif.add(&frame, millis(index)).map_err(wrong))?;
        return gif.finish().map_err(wrong);
    }
    let mut apng = Apng::new(film.steps.len() as u32);
    film.each(|index, frame| apng.add(frame, millis(index)).map_err(wrong))?;
    apng.finish().map_err(wrong)
}

impl Film<'_> {
    /// Draws the pictures, some at a time beside each other, and gives them on in their order.
    pub(super) fn each(&self, mut take: impl FnMut(usize, Frame) -> Result<(), Fault>) -> Result<(), Fault> {
        let indices: Vec<usize> = (0..self.steps.len()).collect();
        for some in indices.chunks(2 * rayon::current_num_threads()) {
            let frames: Result<Vec<Frame>, Fault> = some.par_iter().map(|index| self.frame(*index)).collect();
            for (index, frame) in some.iter().zip(frames?) {
                take(*index, frame)?;
            }
        }
        Ok(())
    }

    fn frame(&self, index: usize) -> Result<Frame, Fault> {
        if !(self.go_on)() {
            return Err(cancelled());
        }
        let (svg, scale) = (self.draw)(index)?;
        raystep_print::frame(&svg, scale).map_err(|error| Fault::new(error.to_string()))
    }
}
