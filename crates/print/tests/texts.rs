//! Texts with formulas: what cannot be shown says so, and none takes long.

use std::time::{Duration, Instant};

use raystep_figure::{Face, Figure, Ink, Role, Theme, fonts};
use raystep_print::{extent, formula, letters, proof, proof_code, proof_plain, prose, svg};

#[test]
fn what_would_not_be_shown_as_written_is_said() {
    let texts = [
        "Plain, **bold**, *slanted*, `code`, $t_{near} \\le t$ and 5 \\$ or 3 * 4.",
        "- one\n- two\n\n$$\\sum_{i=1}^n \\frac{a_i}{2}$$",
        "broken $\\frac{1}{2$ formula",
        "unknown $a \\foo b$ command",
        "on a line of its own $$a \\foo b$$",
        "TeX outside \\frac{1}{2}",
        "a lonely $ sign",
        "a lonely ** sign",
        "a lonely ` sign",
        "| a | b |\n|---|---|\n| 1 | 2 |",
        "![a picture](picture.png)",
        "a [link](https://example.org) and <https://example.org>",
        "some <b>HTML</b>",
        "<div>\nHTML\n</div>",
        "a note[^1]\n\n[^1]: below",
        "above\n\n---\n\nbelow",
        "### A heading",
        "> a quote",
        "1. one\n2. two",
        "- one\n  - two",
        "- [ ] to do",
        "~~struck~~",
        "an accent $\\vec{d}$ in a line",
        "an accent $$\\vec{d}$$ alone",
        "a face $$\\mathcal{A}$$ that is not there",
        "a colour $$\\color{red}x$$",
        "a letter $$日$$",
        "a letter 日",
        "a letter `日`",
        "a large formula $$\\rule{1em}{100em}$$",
        "a bar of less than no width $$\\rule{-13649em}{1em}x$$",
        "an empty formula $$%$$",
    ];
    let mut table = String::new();
    for text in texts {
        table += &format!("{text:?}\n");
        for (at, why) in proof(text) {
            table += &format!("  at {:?}: {why}\n", text[at..].chars().take(8).collect::<String>());
        }
    }
    for text in ["A title", "O(n) → ∞", "A $t$ title", "a `b`", "**a**", "日"] {
        table += &format!("title {text:?}\n");
        table.extend(proof_plain(text).iter().map(|(at, why)| format!("  at {at}: {why}\n")));
    }
    for text in ["t ← (plane − o) / d", "日"] {
        table += &format!("code {text:?}\n");
        table.extend(proof_code(text).iter().map(|(at, why)| format!("  at {at}: {why}\n")));
    }
    insta::assert_snapshot!(table);
}

/// The widest text of a figure.
fn widest(figure: &Figure) -> f32 {
    let width = |ink: &Ink| match ink {
        Ink::Text { text, face, size, .. } => fonts::text_width(text, *face, *size),
        _ => 0.0,
    };
    figure.marks.iter().map(|mark| width(&mark.ink)).fold(0.0, f32::max)
}

#[test]
fn a_word_that_is_wider_than_its_column_is_broken() {
    for text in ["word".repeat(50), format!("short {} `{}` short", "long".repeat(50), "code".repeat(50))] {
        let figure = prose(&text, 300.0, 16.0, Face::Regular, Role::Text);
        assert!(widest(&figure) <= 300.0 && figure.size.y > 100.0, "{text}: {}", widest(&figure));
        let letters: usize =
            figure.marks.iter().map(|mark| if let Ink::Text { text, .. } = &mark.ink { text.len() } else { 0 }).sum();
        assert_eq!(letters, text.replace([' ', '`'], "").len(), "no letter is lost");
    }
    // A column that is narrower than a letter still ends.
    assert!(prose("word", 1.0, 16.0, Face::Regular, Role::Text).marks.len() == 4);
}

#[test]
fn no_text_takes_long_to_set() {
    let texts = [
        ("words", "word ".repeat(25_000)),
        ("a long word", "w".repeat(100_000)),
        ("a word of many pieces", "a*b*".repeat(25_000)),
        ("code", format!("`{}`", "w".repeat(100_000))),
        ("a block of code", format!("```\n{}\n```", "w ".repeat(50_000))),
        ("emphasis", "*a ".repeat(30_000)),
        ("brackets", "[".repeat(100_000)),
        ("braces", format!("${}${}", "{".repeat(60_000), "}".repeat(60_000))),
        ("a long formula", format!("$${}$$", "x+".repeat(50_000))),
        ("long formulas", format!("$${}$$\n\n", "x+".repeat(900)).repeat(50)),
        ("formulas", "$x_i$ ".repeat(15_000)),
        ("broken formulas", "$x_{i$ ".repeat(15_000)),
        ("dollars", "$".repeat(100_000)),
        ("a tall formula", format!("$$\\begin{{matrix}}{}\\end{{matrix}}$$", "a\\\\".repeat(600))),
        ("quotes", "> ".repeat(50_000)),
        ("lists", "- ".repeat(50_000)),
        ("a growing macro", format!("$\\def\\a#1{{#1#1}}{}x{}$", "\\a{".repeat(20), "}".repeat(20))),
    ];
    for (what, text) in texts {
        let start = Instant::now();
        let figure = prose(&text, 400.0, 16.0, Face::Regular, Role::Text);
        let bytes = svg(&figure, &Theme::LIGHT).len();
        let _ = (
            proof(&text),
            letters(&text),
            extent(&text, 16.0),
            formula(&text, 16.0, Theme::LIGHT.style(Role::Text).text),
        );
        let time = start.elapsed();
        assert!(time < Duration::from_secs(5), "{what}: {time:?}");
        assert!(bytes < 100_000_000, "{what}: {bytes} bytes");
        println!("{what}: {time:?}, {bytes} bytes");
    }
}
