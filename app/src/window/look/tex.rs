//! Short formulas inside a line of text, set as letters: enough TeX for a variable and its index.

/// A part of a formula: its letters and how they stand.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Part {
    pub(crate) text: String,
    pub(crate) italic: bool,
    pub(crate) shift: Shift,
}

/// Where letters stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shift {
    Line,
    Below,
    Above,
}

/// Commands with the sign that stands for them.
const SIGNS: &[(&str, &str)] = &[
    ("le", "≤"),
    ("leq", "≤"),
    ("ge", "≥"),
    ("geq", "≥"),
    ("ne", "≠"),
    ("neq", "≠"),
    ("cdot", "·"),
    ("times", "×"),
    ("infty", "∞"),
    ("sqrt", "√"),
    ("pm", "±"),
    ("approx", "≈"),
    ("to", "→"),
    ("gets", "←"),
    ("leftarrow", "←"),
    ("rightarrow", "→"),
    ("in", "∈"),
    ("ldots", "…"),
    ("dots", "…"),
    ("min", "min"),
    ("max", "max"),
    ("log", "log"),
    ("quad", "  "),
    (",", " "),
    (";", " "),
    (" ", " "),
    ("{", "{"),
    ("}", "}"),
    ("%", "%"),
];

/// Cuts a short formula into parts.
pub(crate) fn parts(tex: &str) -> Vec<Part> {
    let mut parts = Vec::new();
    set(tex, Shift::Line, &mut parts);
    parts
}

fn set(tex: &str, shift: Shift, parts: &mut Vec<Part>) {
    let mut rest = tex;
    while let Some(letter) = rest.chars().next() {
        let after = &rest[letter.len_utf8()..];
        match letter {
            '_' | '^' => {
                let (group, tail) = group(after);
                set(group, if letter == '_' { Shift::Below } else { Shift::Above }, parts);
                rest = tail;
            }
            '{' => {
                let (group, tail) = group(rest);
                set(group, shift, parts);
                rest = tail;
            }
            '\\' => rest = command(after, shift, parts),
            ' ' => rest = after,
            '=' | '<' | '>' | '+' | '≤' | '≥' => {
                push(parts, &format!(" {letter} "), false, shift);
                rest = after;
            }
            '-' | '−' => {
                // A sign sticks to its number, a minus stands between its two sides.
                let binary = parts.last().is_some_and(|part| !part.text.ends_with([' ', '(', '[', ',']));
                push(parts, if binary { " − " } else { "−" }, false, shift);
                rest = after;
            }
            ',' => {
                push(parts, ", ", false, shift);
                rest = after;
            }
            letter => {
                push(parts, letter.encode_utf8(&mut [0; 4]), letter.is_alphabetic(), shift);
                rest = after;
            }
        }
    }
}

/// What follows a backslash; returns the rest.
fn command<'a>(after: &'a str, shift: Shift, parts: &mut Vec<Part>) -> &'a str {
    let letters = after.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(after.len());
    let end = if letters == 0 { after.chars().next().map_or(0, char::len_utf8) } else { letters };
    let (name, rest) = after.split_at(end);
    match name {
        "text" | "mathrm" | "operatorname" | "mathit" | "textbf" | "mathbf" => {
            let (words, tail) = group(rest);
            push(parts, words, false, shift);
            tail
        }
        "frac" | "dfrac" | "tfrac" => {
            let (above, tail) = group(rest);
            let (below, tail) = group(tail);
            set(above, shift, parts);
            push(parts, "/", false, shift);
            set(below, shift, parts);
            tail
        }
        "left" | "right" | "displaystyle" => rest,
        name => {
            let sign = SIGNS.iter().find(|(known, _)| *known == name).map_or(name, |(_, sign)| sign);
            let spaced = matches!(sign, "≤" | "≥" | "≠" | "≈" | "←" | "→" | "·" | "×" | "∈");
            push(parts, &if spaced { format!(" {sign} ") } else { sign.to_owned() }, false, shift);
            rest
        }
    }
}

/// The next letter, or what stands in the next braces; and the rest.
fn group(tex: &str) -> (&str, &str) {
    let tex = tex.trim_start();
    if !tex.starts_with('{') {
        let end = match tex.strip_prefix('\\') {
            Some(name) => 1 + name.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(name.len()),
            None => tex.chars().next().map_or(0, char::len_utf8),
        };
        return tex.split_at(end);
    }
    let mut depth = 0;
    for (at, letter) in tex.char_indices() {
        match letter {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return (&tex[1..at], &tex[at + 1..]);
        }
    }
    (&tex[1..], "")
}

fn push(parts: &mut Vec<Part>, text: &str, italic: bool, shift: Shift) {
    match parts.last_mut() {
        Some(last) if last.italic == italic && last.shift == shift => last.text.push_str(text),
        _ => parts.push(Part { text: text.to_owned(), italic, shift }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(tex: &str) -> String {
        parts(tex)
            .iter()
            .map(|part| match part.shift {
                Shift::Line => part.text.clone(),
                Shift::Below => format!("_{}", part.text),
                Shift::Above => format!("^{}", part.text),
            })
            .collect()
    }

    #[test]
    fn short_formulas_become_letters() {
        assert_eq!(flat("t_{near} \\le t"), "t_near ≤ t");
        assert_eq!(flat("t=(s-o_y)/d_y"), "t = (s − o_y)/d_y");
        assert_eq!(flat("\\frac{a}{b} = -2"), "a/b = −2");
        assert_eq!(flat("3\\sqrt[3]{n}"), "3√[3]n");
        assert_eq!(flat("x^2"), "x^2");
    }

    #[test]
    fn broken_tex_is_set_as_far_as_it_goes() {
        for tex in ["\\", "_", "{a", "\\frac{a", "^{", "a_}"] {
            let _ = parts(tex);
        }
    }
}
