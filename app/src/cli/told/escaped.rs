//! Letters that mean something else in Markdown or LaTeX.

/// A text that Markdown shows as it is.
pub(super) fn markdown(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for letter in text.chars() {
        if matches!(letter, '|' | '*' | '_' | '`' | '<' | '[' | '\\' | '#') {
            shown.push('\\');
        }
        shown.push(letter);
    }
    shown
}

/// A text that LaTeX shows as it is, with no package loaded.
pub(super) fn latex(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' | '%' | '$' | '#' | '_' | '{' | '}' => shown.extend(['\\', letter]),
            '\\' => shown.push_str("\\textbackslash{}"),
            '~' => shown.push_str("\\textasciitilde{}"),
            '^' => shown.push_str("\\textasciicircum{}"),
            '<' | '>' | '|' => shown.extend(['$', letter, '$']),
            '−' => shown.push_str("$-$"),
            '∞' => shown.push_str("$\\infty$"),
            '→' => shown.push_str("$\\rightarrow$"),
            '←' => shown.push_str("$\\leftarrow$"),
            '≤' => shown.push_str("$\\leq$"),
            '≥' => shown.push_str("$\\geq$"),
            '×' => shown.push_str("$\\times$"),
            '·' => shown.push_str("$\\cdot$"),
            '°' => shown.push_str("$^\\circ$"),
            'µ' | 'μ' => shown.push_str("$\\mu$"),
            '…' => shown.push_str("\\ldots{}"),
            '■' => shown.push_str("$\\bullet$"),
            '□' => shown.push_str("$\\circ$"),
            digit @ ('⁰' | '¹' | '²' | '³' | '⁴'..='⁹' | '⁻') => {
                let plain = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻".chars().position(|other| other == digit).unwrap_or_default();
                shown.push_str(&format!("$^{{{}}}$", ["0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "-"][plain]));
            }
            other => shown.push(other),
        }
    }
    shown
}
