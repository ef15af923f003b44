//! The shipped faces: those of texts and those of formulas.

use std::sync::OnceLock;

use raystep_figure::{Face, fonts};

/// A face of the formula setter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum MathFont {
    /// Upright letters, digits and most signs.
    Main,
    /// Bold letters.
    Bold,
    /// Slanted words.
    Italic,
    /// Variables.
    Variable,
    /// Rare signs.
    Signs,
    /// Large brackets and operators, in four sizes.
    Size1,
    /// The second size.
    Size2,
    /// The third size.
    Size3,
    /// The largest size.
    Size4,
}

impl MathFont {
    const ALL: [MathFont; 9] = [
        MathFont::Main,
        MathFont::Bold,
        MathFont::Italic,
        MathFont::Variable,
        MathFont::Signs,
        MathFont::Size1,
        MathFont::Size2,
        MathFont::Size3,
        MathFont::Size4,
    ];

    /// The face that the layout calls `name`; the upright one for faces that are not shipped.
    pub(crate) fn named(name: &str) -> MathFont {
        MathFont::of(name).unwrap_or(MathFont::Main)
    }

    /// The face that the layout calls `name`, if it is shipped.
    pub(crate) fn of(name: &str) -> Option<MathFont> {
        Some(match name {
            "Main-Regular" => MathFont::Main,
            "Main-Bold" => MathFont::Bold,
            "Main-Italic" => MathFont::Italic,
            "Math-Italic" => MathFont::Variable,
            "AMS-Regular" => MathFont::Signs,
            "Size1-Regular" => MathFont::Size1,
            "Size2-Regular" => MathFont::Size2,
            "Size3-Regular" => MathFont::Size3,
            "Size4-Regular" => MathFont::Size4,
            _ => return None,
        })
    }

    fn bytes(self) -> &'static [u8] {
        match self {
            MathFont::Main => include_bytes!("../../../assets/fonts/KaTeX_Main-Regular.ttf"),
            MathFont::Bold => include_bytes!("../../../assets/fonts/KaTeX_Main-Bold.ttf"),
            MathFont::Italic => include_bytes!("../../../assets/fonts/KaTeX_Main-Italic.ttf"),
            MathFont::Variable => include_bytes!("../../../assets/fonts/KaTeX_Math-Italic.ttf"),
            MathFont::Signs => include_bytes!("../../../assets/fonts/KaTeX_AMS-Regular.ttf"),
            MathFont::Size1 => include_bytes!("../../../assets/fonts/KaTeX_Size1-Regular.ttf"),
            MathFont::Size2 => include_bytes!("../../../assets/fonts/KaTeX_Size2-Regular.ttf"),
            MathFont::Size3 => include_bytes!("../../../assets/fonts/KaTeX_Size3-Regular.ttf"),
            MathFont::Size4 => include_bytes!("../../../assets/fonts/KaTeX_Size4-Regular.ttf"),
        }
    }
}

/// A shipped typeface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Typeface {
    /// Of texts.
    Text(Face),
    /// Of formulas.
    Math(MathFont),
}

impl Typeface {
    /// A short name for ids in a file.
    pub(crate) fn tag(self) -> String {
        match self {
            Typeface::Text(face) => format!("t{}", face as usize),
            Typeface::Math(font) => format!("m{}", font as usize),
        }
    }

    /// The bytes of its file.
    pub(crate) fn bytes(self) -> &'static [u8] {
        match self {
            Typeface::Text(face) => fonts::bytes(face),
            Typeface::Math(font) => font.bytes(),
        }
    }

    /// What its family is called, and what stands in for it where it is missing.
    pub(crate) fn family(self) -> [&'static str; 2] {
        match self {
            Typeface::Text(Face::Mono | Face::MonoMedium) => ["JetBrains Mono", "monospace"],
            Typeface::Text(_) => ["Inter", "sans-serif"],
            Typeface::Math(MathFont::Main | MathFont::Bold | MathFont::Italic) => ["KaTeX_Main", "serif"],
            Typeface::Math(MathFont::Variable) => ["KaTeX_Math", "serif"],
            Typeface::Math(MathFont::Signs) => ["KaTeX_AMS", "serif"],
            Typeface::Math(MathFont::Size1) => ["KaTeX_Size1", "serif"],
            Typeface::Math(MathFont::Size2) => ["KaTeX_Size2", "serif"],
            Typeface::Math(MathFont::Size3) => ["KaTeX_Size3", "serif"],
            Typeface::Math(MathFont::Size4) => ["KaTeX_Size4", "serif"],
        }
    }

    /// How heavy it is, as style sheets count: 400 is the usual weight.
    pub(crate) fn weight(self) -> u16 {
        match self {
            Typeface::Text(Face::Medium | Face::MonoMedium) => 500,
            Typeface::Text(Face::Bold) | Typeface::Math(MathFont::Bold) => 700,
            _ => 400,
        }
    }

    /// Whether its letters slant.
    pub(crate) fn slants(self) -> bool {
        matches!(self, Typeface::Text(Face::Italic) | Typeface::Math(MathFont::Italic | MathFont::Variable))
    }

    /// The parsed face.
    pub(crate) fn parsed(self) -> &'static ttf_parser::Face<'static> {
        static TEXT: OnceLock<Vec<ttf_parser::Face<'static>>> = OnceLock::new();
        static MATH: OnceLock<Vec<ttf_parser::Face<'static>>> = OnceLock::new();
        let parse = |bytes| ttf_parser::Face::parse(bytes, 0).expect("a shipped face parses");
        match self {
            Typeface::Text(face) => {
                &TEXT.get_or_init(|| Face::ALL.map(|face| parse(fonts::bytes(face))).into())[face as usize]
            }
            Typeface::Math(font) => {
                &MATH.get_or_init(|| MathFont::ALL.map(|font| parse(font.bytes())).into())[font as usize]
            }
        }
    }

    /// How far above the baseline the middle of small letters lies, in sizes.
    pub(crate) fn middle(self) -> f32 {
        let face = self.parsed();
        f32::from(face.x_height().unwrap_or(0)) * 0.5 / f32::from(face.units_per_em())
    }
}
