//! Formulas: TeX in, outlines out. The one place that knows who sets them.

use ratex_layout::{LayoutBox, LayoutOptions, layout, to_display_list, validate_layout};
use ratex_types::display_item::{DisplayItem, DisplayList};
use ratex_types::path_command::PathCommand;
use raystep_figure::{Face, fonts};

use crate::typefaces::{MathFont, Typeface};

/// How much room a formula takes, in points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// From its left end to its right.
    pub width: f32,
    /// Above the line that letters stand on.
    pub height: f32,
    /// Below that line.
    pub depth: f32,
}

/// How much room a formula takes at this size of its letters.
pub fn extent(tex: &str, size: f32) -> Extent {
    match set(tex) {
        Ok(list) => Extent {
            width: list.width as f32 * size,
            height: list.height as f32 * size,
            depth: list.depth as f32 * size,
        },
        Err(_) => {
            let width = fonts::text_width(typed(tex), Face::Italic, size);
            Extent { width, height: size * 0.75, depth: size * 0.25 }
        }
    }
}

/// What a formula is drawn with. Lengths are points, y downwards.
pub(crate) trait Hand {
    /// A letter with its origin at `x`, `y`.
    fn letter(&mut self, typeface: Typeface, letter: char, size: f32, x: f32, y: f32);

    /// A line of text with its left end on the baseline at `x`, `y`.
    fn line(&mut self, text: &str, face: Face, size: f32, x: f32, y: f32);

    /// A filled bar with its upper left corner at `x`, `y`.
    fn bar(&mut self, x: f32, y: f32, width: f32, height: f32);

    /// A filled outline, whose points `place` puts where they belong.
    fn outline(&mut self, commands: &[PathCommand], place: &dyn Fn(f64, f64) -> (f32, f32));
}

/// Draws a formula with its left end on the baseline at `x`, `y`.
pub(crate) fn draw(hand: &mut impl Hand, tex: &str, size: f32, x: f32, y: f32) {
    let Ok(list) = set(tex) else {
        hand.line(typed(tex), Face::Italic, size, x, y);
        return;
    };
    // The layout measures in em from the upper left corner.
    let top = y - list.height as f32 * size;
    let place = |em_x: f64, em_y: f64| (x + em_x as f32 * size, top + em_y as f32 * size);
    for item in &list.items {
        match item {
            DisplayItem::GlyphPath { x, y, scale, font, char_code, .. } => {
                let (x, y) = place(*x, *y);
                let letter = char::from_u32(*char_code).unwrap_or(char::REPLACEMENT_CHARACTER);
                hand.letter(Typeface::Math(MathFont::named(font)), letter, *scale as f32 * size, x, y);
            }
            DisplayItem::Line { x, y, width, thickness, .. } => {
                let (x, y) = place(*x, *y - *thickness * 0.5);
                hand.bar(x, y, *width as f32 * size, *thickness as f32 * size);
            }
            DisplayItem::Rect { x, y, width, height, .. } => {
                let (x, y) = place(*x, *y);
                hand.bar(x, y, *width as f32 * size, *height as f32 * size);
            }
            DisplayItem::Path { x, y, commands, .. } => hand.outline(commands, &|dx, dy| place(*x + dx, *y + dy)),
        }
    }
}

/// Why a formula cannot be shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unset {
    /// The byte of its TeX at which this was found.
    pub at: usize,
    /// A sentence.
    pub why: String,
}

impl Unset {
    pub(crate) fn new(at: usize, why: impl Into<String>) -> Unset {
        Unset { at, why: why.into() }
    }
}

/// Bytes of a formula.
const MOST_BYTES: usize = 2000;
/// How wide a formula may be, in sizes of its letters, and how high.
const LARGEST: [f64; 2] = [400.0, 40.0];

/// Says why a formula would not be shown as its TeX says.
///
/// # Errors
/// It cannot be set, or something in it is lost.
pub(crate) fn proof_formula(tex: &str) -> Result<(), Unset> {
    let list = set(tex)?;
    if list.items.is_empty() {
        return Err(Unset::new(0, "the formula shows nothing"));
    }
    list.items.iter().try_for_each(|item| proof_item(item).map_err(|why| Unset::new(0, why)))
}

/// What is drawn lies in a shipped face, in the colour of the text around it.
fn proof_item(item: &DisplayItem) -> Result<(), String> {
    let color = match item {
        DisplayItem::GlyphPath { font, char_code, color, .. } => {
            let letter = char::from_u32(*char_code).unwrap_or(char::REPLACEMENT_CHARACTER);
            let shipped = MathFont::of(font).map(|font| Typeface::Math(font).parsed());
            if shipped.is_none_or(|face| face.glyph_index(letter).is_none()) {
                return Err(format!("`{letter}` in the face {font} is not among the letters that formulas have"));
            }
            color
        }
        DisplayItem::Line { color, dashed, .. } => {
            if *dashed {
                return Err("dashed lines are drawn solid in formulas".to_owned());
            }
            color
        }
        DisplayItem::Rect { color, .. } => color,
        DisplayItem::Path { color, fill, .. } => {
            if !fill {
                return Err("outlines without a filling are not drawn in formulas".to_owned());
            }
            color
        }
    };
    if *color == ratex_types::color::Color::BLACK {
        Ok(())
    } else {
        Err("formulas have the colour of the text around them".to_owned())
    }
}

/// The formula as boxes in boxes.
pub(crate) fn boxes(tex: &str) -> Result<LayoutBox, Unset> {
    if tex.len() > MOST_BYTES {
        let why = format!("the formula has {} letters: at most {MOST_BYTES} can be set", tex.len());
        return Err(Unset::new(0, why));
    }
    let nodes = ratex_parser::parse(tex).map_err(|error| {
        let at = error.loc.map_or(0, |place| place.start).min(tex.len());
        Unset::new(at, format!("the formula cannot be set: {}", error.message))
    })?;
    let boxed = layout(&nodes, &LayoutOptions::default());
    validate_layout(&boxed).map_err(|why| Unset::new(0, format!("the formula cannot be set: {why}")))?;
    fits(boxed.width, boxed.height + boxed.depth)?;
    Ok(boxed)
}

/// Says so if a formula is larger than any may be.
fn fits(width: f64, height: f64) -> Result<(), Unset> {
    let [most_width, most_height] = LARGEST;
    if (0.0..=most_width).contains(&width) && (0.0..=most_height).contains(&height) {
        return Ok(());
    }
    let why = format!("the formula is too large: at most {most_width} letters wide and {most_height} high");
    Err(Unset::new(0, why))
}

/// The formula laid out.
fn set(tex: &str) -> Result<DisplayList, Unset> {
    let list = to_display_list(&boxes(tex)?);
    // What is drawn may reach further than its box: a bar of less than no width does.
    fits(list.width, list.height + list.depth)?;
    Ok(list)
}

/// A formula that cannot be set stands there as it was typed, as far as there is room for it.
fn typed(tex: &str) -> &str {
    tex.char_indices().nth(200).map_or(tex, |(end, _)| &tex[..end])
}
