//! A short formula as letters in a line of text, for where no drawing can stand.

use ratex_layout::LayoutBox;
use ratex_layout::layout_box::BoxContent;

use crate::Unset;
use crate::formula::boxes;

/// Letters of a formula that stand alike.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Letters {
    /// The letters.
    pub text: String,
    /// Whether they slant, as variables do.
    pub italic: bool,
    /// How they stand.
    pub shift: Shift,
}

/// How letters stand on their line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shift {
    /// On it.
    Line,
    /// Smaller, below it.
    Below,
    /// Smaller, above it.
    Above,
}

/// A formula as letters.
///
/// # Errors
/// It cannot be set, or is more than letters can show: it needs a line of its own.
pub fn letters(tex: &str) -> Result<Vec<Letters>, Unset> {
    let mut line = Line { parts: Vec::new(), shift: Shift::Line };
    line.add(&boxes(tex)?).map_err(|what| {
        Unset::new(0, format!("{what} cannot stand in a line of text: write the formula between `$$`"))
    })?;
    Ok(line.parts)
}

/// Spaces of at least this width, in sizes of the letters, are spaces between words.
const SPACE: f64 = 0.15;

struct Line {
    parts: Vec<Letters>,
    shift: Shift,
}

/// What letters cannot show.
type Unsettable = &'static str;

impl Line {
    fn add(&mut self, boxed: &LayoutBox) -> Result<(), Unsettable> {
        match &boxed.content {
            BoxContent::HBox(boxes) => boxes.iter().try_for_each(|inner| self.add(inner)),
            BoxContent::Glyph { font_id, char_code } => self.letter(font_id.as_str(), *char_code),
            BoxContent::GlyphRun { glyphs } => {
                glyphs.iter().try_for_each(|glyph| self.letter(glyph.font_id.as_str(), glyph.char_code))
            }
            BoxContent::Kern => {
                if boxed.width >= SPACE {
                    self.push(" ", false);
                }
                Ok(())
            }
            BoxContent::Empty => Ok(()),
            BoxContent::RaiseBox { body, .. } | BoxContent::Scaled { body, .. } => self.add(body),
            BoxContent::LeftRight { left, right, inner } => {
                [left, inner, right].into_iter().try_for_each(|inner| self.add(inner))
            }
            BoxContent::Fraction { numer, denom, bar_thickness, .. } => {
                if *bar_thickness == 0.0 {
                    return Err("one thing above the other");
                }
                self.group(numer)?;
                self.push("/", false);
                self.group(denom)
            }
            BoxContent::SupSub { base, sup, sub, .. } | BoxContent::OpLimits { base, sup, sub, .. } => {
                self.add(base)?;
                self.shifted(sub.as_deref(), Shift::Below)?;
                self.shifted(sup.as_deref(), Shift::Above)
            }
            BoxContent::Radical { body, index, .. } => {
                self.shifted(index.as_deref(), Shift::Above)?;
                self.push("√", false);
                self.group(body)
            }
            BoxContent::Accent { .. } => Err("an accent"),
            BoxContent::Array { .. } => Err("a table"),
            BoxContent::Overline { .. } | BoxContent::Underline { .. } | BoxContent::Rule { .. } => Err("a line"),
            BoxContent::Framed { .. } | BoxContent::Angl { .. } => Err("a frame"),
            BoxContent::VBox(_) | BoxContent::SvgPath { .. } | BoxContent::ProofTree { .. } => Err("a drawing"),
        }
    }

    fn letter(&mut self, font: &str, code: u32) -> Result<(), Unsettable> {
        // The setter's long bars are those on the keyboard.
        let letter = match char::from_u32(code).ok_or("a letter that is none")? {
            '\u{2223}' => '|',
            '\u{2225}' => '‖',
            '\u{22c5}' => '·',
            letter => letter,
        };
        self.push(letter.encode_utf8(&mut [0; 4]), font.ends_with("Italic"));
        Ok(())
    }

    /// Above or below the line, where nothing is already.
    fn shifted(&mut self, boxed: Option<&LayoutBox>, shift: Shift) -> Result<(), Unsettable> {
        let Some(boxed) = boxed else { return Ok(()) };
        if self.shift != Shift::Line {
            return Err("an index of an index");
        }
        self.shift = shift;
        let done = self.add(boxed);
        self.shift = Shift::Line;
        done
    }

    /// In brackets where they keep together what belongs together.
    fn group(&mut self, boxed: &LayoutBox) -> Result<(), Unsettable> {
        let mut inner = Line { parts: Vec::new(), shift: self.shift };
        inner.add(boxed)?;
        let loose = inner.parts.iter().any(|part| part.shift == self.shift && part.text.contains([' ', '/', '+', '−']));
        if loose {
            self.push("(", false);
        }
        for part in inner.parts {
            self.shift_to(part.shift, |line| line.push(&part.text, part.italic));
        }
        if loose {
            self.push(")", false);
        }
        Ok(())
    }

    fn shift_to(&mut self, shift: Shift, add: impl FnOnce(&mut Line)) {
        let before = std::mem::replace(&mut self.shift, shift);
        add(self);
        self.shift = before;
    }

    fn push(&mut self, text: &str, italic: bool) {
        let shift = self.shift;
        match self.parts.last_mut() {
            // One space is enough.
            Some(last) if text == " " && last.text.ends_with(' ') => {}
            Some(last) if last.shift == shift && (last.italic == italic || text == " ") => last.text.push_str(text),
            _ => self.parts.push(Letters { text: text.to_owned(), italic, shift }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(tex: &str) -> String {
        let parts = match letters(tex) {
            Ok(parts) => parts,
            Err(unset) => return format!("{}: {}", unset.at, unset.why),
        };
        let part = |part: &Letters| match part.shift {
            Shift::Line => part.text.clone(),
            Shift::Below => format!("_{}", part.text),
            Shift::Above => format!("^{}", part.text),
        };
        parts.iter().map(part).collect()
    }

    #[test]
    fn short_formulas_become_letters() {
        let table = [
            ("t_{near} \\le t", "t_near ≤ t"),
            ("t=(s-o_y)/d_y", "t = (s − o_y)/d_y"),
            ("-2", "−2"),
            ("\\frac{a}{b} = -2", "a/b = −2"),
            ("\\frac{a + b}{2}", "(a + b)/2"),
            ("\\frac{1}{-d}", "1/(−d)"),
            ("3 \\sqrt[3]{n}", "3^3√n"),
            ("\\sqrt[3]{n}", "^3√n"),
            ("\\sqrt{b^2 - a}", "√(b^2 − a)"),
            ("\\sqrt{n}", "√n"),
            ("x^2", "x^2"),
            ("x_i^2", "x_i^2"),
            ("f(a, b)", "f(a, b)"),
            ("\\log n", "log n"),
            ("O(n \\log n)", "O(n log n)"),
            ("\\max(a,b)", "max(a, b)"),
            ("\\sum_{i=1}^n i", "∑_i_=1^n i"),
            ("\\alpha\\beta", "αβ"),
            ("a \\cdot b", "a · b"),
            ("a \\times b", "a × b"),
            ("|a|", "|a|"),
            ("\\left(a\\right)", "(a)"),
            ("\\lfloor x \\rfloor", "⌊x⌋"),
            ("\\text{so many}", "so many"),
            ("\\operatorname{area}(b)", "area(b)"),
            ("50\\%", "50%"),
            ("\\infty", "∞"),
            ("a \\in \\mathbb{R}", "a ∈ R"),
            ("x'", "x^′"),
            ("p \\quad q", "p q"),
        ];
        for (tex, text) in table {
            assert_eq!(flat(tex), text, "{tex}");
        }
    }

    #[test]
    fn what_is_more_than_letters_says_so() {
        let said: Vec<String> = [
            "\\vec{d}",
            "\\overline{x}",
            "\\begin{matrix}a\\\\b\\end{matrix}",
            "\\binom{n}{k}",
            "a_{b_c}",
            "\\boxed{a}",
            "\\foo",
            "\\frac{1}{2",
            "{a",
            "a}",
            "\\",
            "_",
            "^{",
            "a_b_c",
        ]
        .iter()
        .map(|tex| format!("{tex}  {}\n", flat(tex)))
        .collect();
        insta::assert_snapshot!(said.concat());
    }
}
