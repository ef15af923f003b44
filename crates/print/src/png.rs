//! Pixels: the SVG file through a software renderer, the same bytes on every run.

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

/// Why a file could not be written.
#[derive(Debug, thiserror::Error)]
pub enum PrintError {
    /// The drawing is not an SVG file.
    #[error("the drawing cannot be read as SVG: {0}")]
    Svg(#[from] resvg::usvg::Error),
    /// The picture is empty or too large.
    #[error("a picture of {0} by {1} pixels cannot be made: each side must be 1 to 16384 pixels")]
    Size(f32, f32),
    /// The picture could not be packed.
    #[error("the picture cannot be packed: {0}")]
    Pack(String),
}

/// The picture of an SVG file as a PNG file, `scale` pixels to a point.
///
/// # Errors
/// When it is not an SVG file or the picture is too large.
pub fn png(svg: &str, scale: f32) -> Result<Vec<u8>, PrintError> {
    pixels(svg, scale)?.encode_png().map_err(|error| PrintError::Pack(error.to_string()))
}

/// The pixels of an SVG file.
pub(crate) fn pixels(svg: &str, scale: f32) -> Result<Pixmap, PrintError> {
    let tree = Tree::from_str(svg, &Options::default())?;
    let (width, height) = ((tree.size().width() * scale).round(), (tree.size().height() * scale).round());
    let sides = 1.0..=16384.0;
    if !sides.contains(&width) || !sides.contains(&height) {
        return Err(PrintError::Size(width, height));
    }
    let mut pixmap = Pixmap::new(width as u32, height as u32).ok_or(PrintError::Size(width, height))?;
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixmap.as_mut());
    Ok(pixmap)
}
