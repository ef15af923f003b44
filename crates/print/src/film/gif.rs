//! A film that opens everywhere.

use std::borrow::Cow;

use gif::{DisposalMethod, Encoder, Repeat};

use super::{Frame, Palette, changed, cut, pack, same_size};
use crate::PrintError;

/// A GIF that repeats, in the colours of one palette for all its pictures. It holds of each picture what has changed.
pub struct Gif {
    palette: Palette,
    encoder: Option<Encoder<Vec<u8>>>,
    size: [u32; 2],
    last: Vec<u8>,
}

impl Gif {
    /// A film in these colours.
    pub fn new(palette: Palette) -> Gif {
        Gif { palette, encoder: None, size: [0; 2], last: Vec::new() }
    }

    /// Adds the next picture, shown for `millis`, of which ten are the shortest time.
    ///
    /// # Errors
    /// When it has another size than the first one, or a side is longer than 65535 pixels.
    pub fn add(&mut self, frame: &Frame, millis: u16) -> Result<(), PrintError> {
        let size = [frame.width, frame.height];
        let side = |side: u32| u16::try_from(side).map_err(|_| PrintError::Size(size[0] as f32, size[1] as f32));
        let [width, height] = [side(size[0])?, side(size[1])?];
        let encoder = match &mut self.encoder {
            Some(encoder) => encoder,
            None => {
                let mut encoder = Encoder::new(Vec::new(), width, height, &self.palette.bytes()).map_err(pack)?;
                encoder.set_repeat(Repeat::Infinite).map_err(pack)?;
                self.size = size;
                self.encoder.insert(encoder)
            }
        };
        same_size(self.size, frame)?;
        let pixels = self.palette.indices(frame);
        // What is clear shows the picture before, so that one has to go.
        let clear = self.palette.clear();
        let whole = clear.is_some() || self.last.is_empty();
        let area @ [left, top, across, down] =
            if whole { [0, 0, size[0], size[1]] } else { changed(&self.last, &pixels, size[0], 1) };
        let picture = gif::Frame {
            delay: millis.div_ceil(10),
            dispose: if clear.is_some() { DisposalMethod::Background } else { DisposalMethod::Keep },
            transparent: clear,
            left: left as u16,
            top: top as u16,
            width: across as u16,
            height: down as u16,
            buffer: Cow::Owned(cut(&pixels, size[0], area, 1)),
            ..gif::Frame::default()
        };
        encoder.write_frame(&picture).map_err(pack)?;
        self.last = pixels;
        Ok(())
    }

    /// The file.
    ///
    /// # Errors
    /// When there is no picture.
    pub fn finish(self) -> Result<Vec<u8>, PrintError> {
        let encoder = self.encoder.ok_or_else(|| PrintError::Pack("there is no step to show".to_owned()))?;
        encoder.into_inner().map_err(pack)
    }
}
