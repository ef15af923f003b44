//! Short formulas inside a line of text, set as letters.

pub(crate) use raystep_print::{Letters as Part, Shift};

/// A short formula in parts; one that cannot be set stands there as it was typed.
pub(crate) fn parts(tex: &str) -> Vec<Part> {
    let typed = || vec![Part { text: tex.to_owned(), italic: true, shift: Shift::Line }];
    raystep_print::letters(tex).unwrap_or_else(|_| typed())
}
