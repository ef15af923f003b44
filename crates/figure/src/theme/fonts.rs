//! The shipped faces and how wide they set a text, the same in every view.

use std::sync::OnceLock;

/// The shipped faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Face {
    /// Text.
    Regular,
    /// Labels.
    Medium,
    /// Titles.
    Bold,
    /// Variables in formulas set as text.
    Italic,
    /// Numbers and listings.
    Mono,
    /// The current line of a listing.
    MonoMedium,
}

impl Face {
    /// Every face.
    pub const ALL: [Face; 6] = [Face::Regular, Face::Medium, Face::Bold, Face::Italic, Face::Mono, Face::MonoMedium];
}

/// The bytes of a face: OpenType, embedded.
pub fn bytes(face: Face) -> &'static [u8] {
    match face {
        Face::Regular => include_bytes!("../../../../assets/fonts/Inter-Regular.otf"),
        Face::Medium => include_bytes!("../../../../assets/fonts/Inter-Medium.otf"),
        Face::Bold => include_bytes!("../../../../assets/fonts/Inter-Bold.otf"),
        Face::Italic => include_bytes!("../../../../assets/fonts/Inter-Italic.otf"),
        Face::Mono => include_bytes!("../../../../assets/fonts/JetBrainsMono-Regular.ttf"),
        Face::MonoMedium => include_bytes!("../../../../assets/fonts/JetBrainsMono-Medium.ttf"),
    }
}

/// The width of one line of text in points, letter by letter, without kerning.
pub fn text_width(text: &str, face: Face, size: f32) -> f32 {
    let parsed = parsed(face);
    let units: u32 = text
        .chars()
        .map(|letter| {
            let glyph = parsed.glyph_index(letter).unwrap_or_default();
            u32::from(parsed.glyph_hor_advance(glyph).unwrap_or(0))
        })
        .sum();
    units as f32 * size / f32::from(parsed.units_per_em())
}

/// Whether a face has a glyph for a letter.
pub fn has_glyph(letter: char, face: Face) -> bool {
    parsed(face).glyph_index(letter).is_some()
}

/// The text, shortened with an ellipsis to at most `width` points.
pub fn elided(text: &str, face: Face, size: f32, width: f32) -> String {
    if text_width(text, face, size) <= width {
        return text.to_owned();
    }
    let mut kept: String = text.to_owned();
    while kept.pop().is_some() {
        let shorter = format!("{}…", kept.trim_end());
        if text_width(&shorter, face, size) <= width {
            return shorter;
        }
    }
    String::new()
}

fn parsed(face: Face) -> &'static ttf_parser::Face<'static> {
    static FACES: OnceLock<Vec<ttf_parser::Face<'static>>> = OnceLock::new();
    let faces = FACES.get_or_init(|| {
        Face::ALL.iter().map(|&face| ttf_parser::Face::parse(bytes(face), 0).expect("a shipped face parses")).collect()
    });
    &faces[face as usize]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widths_add_up() {
        for face in Face::ALL {
            let (a, b) = (text_width("node 12 ", face, 13.0), text_width("waits", face, 13.0));
            assert!((text_width("node 12 waits", face, 13.0) - (a + b)).abs() < 1e-3);
            assert!(text_width("t = 3.66 ∞ − ≤ ×", face, 13.0) > 0.0);
        }
        assert_eq!(text_width("ii", Face::Mono, 10.0), text_width("WW", Face::Mono, 10.0));
    }

    #[test]
    fn every_sign_in_use_has_a_glyph() {
        for face in Face::ALL {
            for letter in "0123456789−∞≤≥×·÷√→←…–‘’“”[](),=?▼▲◦".chars() {
                assert!(has_glyph(letter, face), "{face:?} lacks {letter}");
            }
        }
    }

    #[test]
    fn a_long_text_is_elided() {
        let short = elided("a rather long line of text", Face::Regular, 12.0, 60.0);
        assert!(short.ends_with('…') && text_width(&short, Face::Regular, 12.0) <= 60.0);
        assert_eq!(elided("short", Face::Regular, 12.0, 60.0), "short");
    }
}
