//! The size of a picture, as it is written on the command line.

use std::fmt;
use std::str::FromStr;

use glam::Vec2;

/// A picture of so many pixels, and the rays through them, still fit into memory.
const MOST_PIXELS: u32 = 1 << 25;

/// Width and height in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    width: u32,
    height: u32,
}

impl Size {
    /// What is drawn if nobody says how large.
    pub(crate) const USUAL: Size = Size { width: 1600, height: 1000 };

    /// How many times as long the longer side is as the other, rounded up.
    pub(super) fn slenderness(self) -> u32 {
        self.width.max(self.height).div_ceil(self.width.min(self.height))
    }

    /// Whether both sides are even, as videos need them.
    pub(super) fn is_even(self) -> bool {
        self.width.is_multiple_of(2) && self.height.is_multiple_of(2)
    }
}

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Size, String> {
        let side = |text: &str| text.parse().ok().filter(|side| (16..=16384).contains(side));
        let sides = text.split_once(['x', 'X', '×']).and_then(|(width, height)| Some((side(width)?, side(height)?)));
        let (width, height) =
            sides.ok_or("write two numbers from 16 to 16384 with an x between them, as in 1600x1000")?;
        if width * height > MOST_PIXELS {
            return Err(format!(
                "{width}x{height} are too many pixels: up to {MOST_PIXELS} are drawn, as in 7680x4320"
            ));
        }
        Ok(Size { width, height })
    }
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width, self.height)
    }
}

impl From<Size> for Vec2 {
    fn from(size: Size) -> Vec2 {
        Vec2::new(size.width as f32, size.height as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_have_bounds() {
        let said = |text: &str| text.parse::<Size>().map_or_else(|wrong| wrong, |size| size.to_string());
        for (text, says) in [
            ("1600x1000", "1600x1000"),
            ("16384X2048", "16384x2048"),
            ("7680×4320", "7680x4320"),
            ("16384x16384", "16384x16384 are too many pixels: up to 33554432 are drawn, as in 7680x4320"),
            ("15x100", "write two numbers from 16 to 16384 with an x between them, as in 1600x1000"),
            ("100", "write two numbers from 16 to 16384 with an x between them, as in 1600x1000"),
        ] {
            assert_eq!(said(text), says);
        }
    }
}
