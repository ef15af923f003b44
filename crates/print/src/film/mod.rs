//! Steps as one moving picture.

mod apng;
mod gif;
mod palette;

pub use apng::Apng;
pub use gif::Gif;
pub use palette::{Palette, Tally};

use raystep_figure::{Color, Role, Theme};
use resvg::tiny_skia::{Pixmap, PremultipliedColorU8};

use crate::PrintError;
use crate::png::pixels;

/// The pixels of one picture of a film.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Four bytes for each pixel: red, green, blue and straight alpha.
    pub rgba: Vec<u8>,
}

/// An SVG file as pixels, `scale` to a point.
///
/// # Errors
/// When it is not an SVG file or the picture is too large.
pub fn frame(svg: &str, scale: f32) -> Result<Frame, PrintError> {
    let pixmap: Pixmap = pixels(svg, scale)?;
    let (width, height) = (pixmap.width(), pixmap.height());
    let straight = |pixel: &PremultipliedColorU8| {
        let color = pixel.demultiply();
        [color.red(), color.green(), color.blue(), color.alpha()]
    };
    let rgba = pixmap.pixels().iter().flat_map(straight).collect();
    Ok(Frame { width, height, rgba })
}

impl Frame {
    /// Three bytes for each pixel, on the page of the theme where it is clear.
    pub fn rgb(&self, theme: &Theme) -> Vec<u8> {
        let page = theme.style(Role::Page).fill;
        let over = |pixel: &[u8]| {
            let color = Color { r: pixel[0], g: pixel[1], b: pixel[2], a: pixel[3] };
            let color = page.filter(|_| color.a < 255).map_or(color, |page| color.over(page));
            [color.r, color.g, color.b]
        };
        self.rgba.chunks_exact(4).flat_map(over).collect()
    }
}

/// A rectangle of pixels that differs from one picture to the next: left, top, width, height.
type Changed = [u32; 4];

/// The smallest rectangle outside of which two pictures are the same; one pixel if they are. `each` is the bytes of a
/// pixel.
fn changed(before: &[u8], after: &[u8], width: u32, each: usize) -> Changed {
    let row = width as usize * each;
    let rows = || before.chunks_exact(row).zip(after.chunks_exact(row));
    let Some(top) = rows().position(|(a, b)| a != b) else { return [0, 0, 1, 1] };
    let bottom = rows().rposition(|(a, b)| a != b).unwrap_or(top);
    let differ = |(a, b): (&[u8], &[u8])| a != b;
    let (mut left, mut right) = (width as usize, 0);
    for (a, b) in rows().skip(top).take(bottom - top + 1) {
        let pixels = || a.chunks_exact(each).zip(b.chunks_exact(each));
        left = left.min(pixels().position(differ).unwrap_or(left));
        right = right.max(pixels().rposition(differ).unwrap_or(0));
    }
    [left as u32, top as u32, (right - left + 1) as u32, (bottom - top + 1) as u32]
}

/// A rectangle cut out of a picture.
fn cut(pixels: &[u8], width: u32, [left, top, across, down]: Changed, each: usize) -> Vec<u8> {
    let rows = pixels.chunks_exact(width as usize * each).skip(top as usize).take(down as usize);
    rows.flat_map(|row| row[left as usize * each..(left + across) as usize * each].iter().copied()).collect()
}

/// The pictures of a film have one size.
fn same_size(first: [u32; 2], frame: &Frame) -> Result<(), PrintError> {
    if first == [frame.width, frame.height] {
        Ok(())
    } else {
        Err(PrintError::Pack("the steps differ in size".to_owned()))
    }
}

fn pack(error: impl std::error::Error) -> PrintError {
    PrintError::Pack(error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_changes_is_cut_out() {
        let check = |after: &[u8], found: Changed, pixels: &[u8]| {
            let before = [0; 12];
            assert_eq!(changed(&before, after, 4, 1), found);
            assert_eq!(cut(after, 4, found, 1), pixels);
        };
        check(&[0; 12], [0, 0, 1, 1], &[0]);
        check(&[0, 0, 0, 0, 0, 7, 0, 0, 0, 0, 0, 0], [1, 1, 1, 1], &[7]);
        check(&[0, 0, 0, 9, 0, 0, 0, 0, 0, 7, 0, 0], [1, 0, 3, 3], &[0, 0, 9, 0, 0, 0, 7, 0, 0]);
    }
}
