//! A range of steps as one moving picture.

use png::{BitDepth, ColorType};
use resvg::tiny_skia::Pixmap;

use crate::{PrintError, png::pixels};

/// SVG files of one size as an animated PNG, each shown for `millis`.
///
/// # Errors
/// When there is none, when one cannot be drawn, or when they differ in size.
pub fn apng(frames: &[String], scale: f32, millis: u16) -> Result<Vec<u8>, PrintError> {
    let first = first(frames, scale)?;
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, first.width(), first.height());
    encoder.set_color(ColorType::Rgba);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_animated(frames.len() as u32, 0).map_err(pack)?;
    encoder.set_frame_delay(millis, 1000).map_err(pack)?;
    let mut writer = encoder.write_header().map_err(pack)?;
    for frame in frames {
        writer.write_image_data(&same_size(frame, scale, &first)?.take()).map_err(pack)?;
    }
    writer.finish().map_err(pack)?;
    Ok(file)
}

/// SVG files of one size as an animated GIF that repeats, each shown for `millis`.
///
/// # Errors
/// As for [`apng`]; a GIF's sides also stay below 65536.
pub fn gif(frames: &[String], scale: f32, millis: u16) -> Result<Vec<u8>, PrintError> {
    let first = first(frames, scale)?;
    let (width, height) = (first.width() as u16, first.height() as u16);
    let mut file = Vec::new();
    let mut encoder = gif::Encoder::new(&mut file, width, height, &[]).map_err(pack)?;
    encoder.set_repeat(gif::Repeat::Infinite).map_err(pack)?;
    for frame in frames {
        let mut rgba = same_size(frame, scale, &first)?.take();
        // Speed 10 of 30: the colours of a drawing survive.
        let mut image = gif::Frame::from_rgba_speed(width, height, &mut rgba, 10);
        image.delay = millis / 10;
        encoder.write_frame(&image).map_err(pack)?;
    }
    drop(encoder);
    Ok(file)
}

fn first(frames: &[String], scale: f32) -> Result<Pixmap, PrintError> {
    let first = frames.first().ok_or_else(|| PrintError::Pack("there is no step to show".to_owned()))?;
    pixels(first, scale)
}

/// A frame's pixels; every figure covers its page, so nothing is translucent.
fn same_size(svg: &str, scale: f32, first: &Pixmap) -> Result<Pixmap, PrintError> {
    let frame = pixels(svg, scale)?;
    if (frame.width(), frame.height()) == (first.width(), first.height()) {
        Ok(frame)
    } else {
        Err(PrintError::Pack("the steps differ in size".to_owned()))
    }
}

fn pack(error: impl std::error::Error) -> PrintError {
    PrintError::Pack(error.to_string())
}
