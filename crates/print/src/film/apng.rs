//! A film with all colours.

use std::io::{Cursor, Write};

use png::{BitDepth, BlendOp, ColorType, DisposeOp, Encoder, Writer};

use super::{Frame, changed, cut, pack, same_size};
use crate::PrintError;

/// An animated PNG that repeats. It holds of each picture what has changed.
pub struct Apng {
    writer: Option<Writer<Shared>>,
    bytes: Shared,
    frames: u32,
    /// How many were added.
    added: u32,
    last: Option<Frame>,
}

/// Bytes that the encoder writes, and that are read when it is done.
#[derive(Clone, Default)]
struct Shared(std::sync::Arc<std::sync::Mutex<Cursor<Vec<u8>>>>);

impl Write for Shared {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0.lock().map_err(|_| std::io::ErrorKind::Other)?.write(bytes)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

impl Apng {
    /// A film of so many pictures.
    pub fn new(frames: u32) -> Apng {
        Apng { writer: None, bytes: Shared::default(), frames, added: 0, last: None }
    }

    /// Adds the next picture, shown for `millis`.
    ///
    /// # Errors
    /// When it has another size than the first one, or there are more than was said.
    pub fn add(&mut self, frame: Frame, millis: u16) -> Result<(), PrintError> {
        let [width, height] = [frame.width, frame.height];
        let mut area = [0, 0, width, height];
        if let Some(last) = &self.last {
            same_size([last.width, last.height], &frame)?;
            area = changed(&last.rgba, &frame.rgba, width, 4);
        }
        let writer = match &mut self.writer {
            Some(writer) => writer,
            None => {
                let mut encoder = Encoder::new(self.bytes.clone(), width, height);
                encoder.set_color(ColorType::Rgba);
                encoder.set_depth(BitDepth::Eight);
                encoder.set_animated(self.frames, 0).map_err(pack)?;
                encoder.set_dispose_op(DisposeOp::None).map_err(pack)?;
                encoder.set_blend_op(BlendOp::Source).map_err(pack)?;
                self.writer.insert(encoder.write_header().map_err(pack)?)
            }
        };
        writer.set_frame_delay(millis, 1000).map_err(pack)?;
        let [left, top, across, down] = area;
        // Where it lies and how large it is may go beyond the picture between the two calls.
        writer.set_frame_position(0, 0).map_err(pack)?;
        writer.set_frame_dimension(across, down).map_err(pack)?;
        writer.set_frame_position(left, top).map_err(pack)?;
        writer.write_image_data(&cut(&frame.rgba, width, area, 4)).map_err(pack)?;
        self.last = Some(frame);
        self.added += 1;
        Ok(())
    }

    /// The file.
    ///
    /// # Errors
    /// When there are fewer pictures than was said.
    pub fn finish(self) -> Result<Vec<u8>, PrintError> {
        let writer = self.writer.ok_or_else(|| PrintError::Pack("there is no step to show".to_owned()))?;
        if self.added < self.frames {
            return Err(PrintError::Pack(format!(
                "{} of {} pictures are missing",
                self.frames - self.added,
                self.frames
            )));
        }
        writer.finish().map_err(pack)?;
        let mut bytes = self.bytes.0.lock().map_err(|_| PrintError::Pack("it is not whole".to_owned()))?;
        Ok(std::mem::take(bytes.get_mut()))
    }
}
