//! The Markdown and the formulas of a slide.

use raystep_figure::{Face, Role, Theme};
use raystep_print::{extent, formula, letters, proof, proof_code, proof_plain, prose, svg};

use super::Target;

pub(super) const TARGET: Target = Target {
    name: "texts",
    body: texts,
    words: &[
        "$",
        "$$",
        "**",
        "*",
        "_",
        "`",
        "```\n",
        "~~",
        "\n\n",
        "\n",
        "- ",
        "1. ",
        "> ",
        "| a | b |\n|---|---|\n",
        "# ",
        "[a](b)",
        "![a](b)",
        "<b>",
        "</b>",
        "<!--",
        "&amp;",
        "\\",
        "\\frac{1}{2}",
        "\\frac",
        "\\sqrt[3]{n}",
        "\\sqrt",
        "{",
        "}",
        "^",
        "_{",
        "\\left(",
        "\\right)",
        "\\begin{matrix}",
        "\\end{matrix}",
        "\\begin{array}{cc}",
        "\\end{array}",
        "&",
        "\\\\",
        "\\def\\a{b}",
        "\\newcommand",
        "#1",
        "\\text{",
        "\\ce{",
        "\\pu{",
        "\\rule{1em}{1em}",
        "\\hspace{1em}",
        "\\raisebox{1em}{",
        "\\color{red}",
        "\\sum_{i=1}^n",
        "\\int",
        "\\overbrace{",
        "\\underline{",
        "\\xrightarrow{",
        "\\hat{",
        "\\vec{",
        "\\mathbb{R}",
        "\\mathcal{",
        "\\operatorname{",
        "\\boxed{",
        "\\phantom{",
        "\\kern1em",
        "\\verb|a|",
        "\\char\"41",
        "\\href{a}{",
        "\\tag{1}",
        "\\middle|",
        "\\displaystyle",
        "\\scriptstyle",
        "\\Huge",
        "'",
        "~",
        "%",
        "→",
        "é",
        "日",
        "😀",
        "\u{301}",
        "\u{200d}",
        "\0",
        "\\substack{",
        "\\cancel{",
        "\\bordermatrix{",
        "\\prooftree",
        "\\inferrule",
        "\\smash{",
        "\\mathchoice{",
    ],
    seeds: &[],
};

/// Sets a text as it is, and as a formula.
///
/// # Panics
/// If a place of what is wrong lies outside of it, or a size is none.
pub fn texts(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    for wrong in [proof(&text), proof_plain(&text), proof_code(&text)] {
        for (at, why) in wrong {
            assert!(text.is_char_boundary(at) && !why.is_empty() && why.len() < 3000, "{at}: {why}");
        }
    }
    let figure = prose(&text, 320.0, 16.0, Face::Regular, Role::Text);
    assert!(figure.size.is_finite() && figure.size.y >= 0.0, "{}", figure.size);
    let room = extent(&text, 16.0);
    let sizes = [room.width, room.height + room.depth];
    assert!(sizes.iter().all(|size| (0.0..=1e5).contains(size)), "{room:?}");
    if let Ok(letters) = letters(&text) {
        assert!(letters.iter().all(|part| !part.text.is_empty()));
    }
    // Outlines of letters take most of the time, and are the same every time.
    if bytes.len().is_multiple_of(16) {
        assert!(svg(&figure, &Theme::LIGHT).len() < 50_000_000, "the picture is too large");
        assert!(formula(&text, 16.0, Theme::LIGHT.style(Role::Text).text).starts_with("<svg"));
    }
}
