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
// Copied to where it is called, it would bring all faces along once more.
#[inline(never)]
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
    let units: u32 = text.chars().map(|letter| units(letter, face)).sum();
    points(units, face, size)
}

/// Each letter of one line of text, where it begins in the text, and where it begins on the line: as wide as what
/// is before it.
pub fn pens(text: &str, face: Face, size: f32) -> impl Iterator<Item = (usize, char, f32)> {
    let mut before = 0;
    text.char_indices().map(move |(index, letter)| {
        let pen = points(before, face, size);
        before += units(letter, face);
        (index, letter, pen)
    })
}

/// How far the pen moves on for a letter, in units of its face.
fn units(letter: char, face: Face) -> u32 {
    let Shipped { parsed, latin } = shipped(face);
    u32::from(latin.get(letter as usize).copied().unwrap_or_else(|| advance(parsed, letter)))
}

fn points(units: u32, face: Face, size: f32) -> f32 {
    units as f32 * size / f32::from(shipped(face).parsed.units_per_em())
}

/// Whether a face has a glyph for a letter.
pub fn has_glyph(letter: char, face: Face) -> bool {
    shipped(face).parsed.glyph_index(letter).is_some()
}

/// The text in lines of at most `width` points, as far as its words allow.
pub(crate) fn broken(text: &str, face: Face, size: f32, width: f32) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if text_width(&format!("{line} {word}"), face, size) <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// The text, shortened with an ellipsis to at most `width` points.
pub fn elided(text: &str, face: Face, size: f32, width: f32) -> String {
    if text_width(text, face, size) <= width {
        return text.to_owned();
    }
    let mut units_before = 0;
    let mut kept = None;
    // Where the last letter ends that is no space, and how wide the text is up to there.
    let (mut end, mut end_units) = (0, 0);
    let dots = units('…', face);
    for (index, letter) in text.char_indices() {
        if points(end_units + dots, face, size) > width {
            break;
        }
        kept = Some(end);
        units_before += units(letter, face);
        if !letter.is_whitespace() {
            (end, end_units) = (index + letter.len_utf8(), units_before);
        }
    }
    kept.map_or_else(String::new, |end| format!("{}…", &text[..end]))
}

/// A face that was read, and how far the pen moves on for the letters that most texts are made of.
struct Shipped {
    parsed: ttf_parser::Face<'static>,
    latin: Vec<u16>,
}

/// The letters before this one: Latin ones, digits and the common signs.
const LATIN: char = '\u{180}';

fn shipped(face: Face) -> &'static Shipped {
    static FACES: OnceLock<Vec<Shipped>> = OnceLock::new();
    let read = |&face: &Face| {
        let parsed = ttf_parser::Face::parse(bytes(face), 0).expect("a shipped face parses");
        Shipped { latin: ('\0'..LATIN).map(|letter| advance(&parsed, letter)).collect(), parsed }
    };
    &FACES.get_or_init(|| Face::ALL.iter().map(read).collect())[face as usize]
}

fn advance(face: &ttf_parser::Face<'_>, letter: char) -> u16 {
    face.glyph_hor_advance(face.glyph_index(letter).unwrap_or_default()).unwrap_or(0)
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
        assert_eq!(elided("short", Face::Regular, 12.0, 1.0), "");
        // Of letters and spaces alike the longest beginning that fits is kept.
        let text = "a rather  long   line of text";
        for width in 1..140 {
            let width = width as f32;
            let fits = |kept: &String| text_width(kept, Face::Regular, 12.0) <= width;
            let all = (0..text.len()).rev().map(|end| format!("{}…", text[..end].trim_end()));
            let longest = all.clone().find(fits).unwrap_or_default();
            assert_eq!(elided(text, Face::Regular, 12.0, width), longest);
        }
    }

    #[test]
    fn a_very_long_text_is_measured_in_no_time() {
        let text = "word".repeat(250_000);
        let start = std::time::Instant::now();
        let last = pens(&text, Face::Regular, 12.0).last().unwrap();
        assert_eq!(last.2, text_width(&text[..text.len() - 1], Face::Regular, 12.0));
        assert!(elided(&text, Face::Regular, 12.0, 100.0).len() < 30);
        assert!(elided(&text, Face::Regular, 12.0, last.2).len() > 900_000);
        assert!(start.elapsed().as_secs_f32() < 5.0, "{:?}", start.elapsed());
    }
}
