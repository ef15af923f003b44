//! Texts of slides as HTML.

use std::fmt::Write;

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};
use raystep_figure::{Role, Theme};
use raystep_print::{Shift, formula, letters};

/// A text in Markdown, with formulas between `$` or `$$`, as HTML.
pub(in crate::cli) fn html(markdown: &str) -> String {
    let mut out = String::new();
    for event in Parser::new_ext(markdown, Options::ENABLE_MATH) {
        match event {
            Event::Start(tag) => out.push_str(opening(&tag)),
            Event::End(tag) => out.push_str(closing(&tag)),
            Event::Text(text) => out.push_str(&escaped(&text)),
            Event::Code(code) => _ = write!(out, "<code>{}</code>", escaped(&code)),
            Event::InlineMath(tex) => out.push_str(&in_line(&tex)),
            Event::DisplayMath(tex) => _ = write!(out, "<span class=\"formula\">{}</span>", drawn(tex.trim(), 20.0)),
            Event::SoftBreak => out.push(' '),
            Event::HardBreak => out.push_str("<br>"),
            _ => {}
        }
    }
    out
}

/// The same as letters alone: for what is read aloud.
pub(in crate::cli) fn plain(markdown: &str) -> String {
    let mut out = String::new();
    for event in Parser::new_ext(markdown, Options::ENABLE_MATH) {
        match event {
            Event::Text(text) | Event::Code(text) => out.push_str(&text),
            Event::InlineMath(tex) | Event::DisplayMath(tex) => match letters(tex.trim()) {
                Ok(parts) => parts.iter().for_each(|part| out.push_str(&part.text)),
                Err(_) => out.push_str(tex.trim()),
            },
            Event::SoftBreak | Event::HardBreak => out.push(' '),
            Event::End(TagEnd::Paragraph | TagEnd::Item | TagEnd::CodeBlock) => out.push(' '),
            _ => {}
        }
    }
    out.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A text as it may stand between tags and in attributes.
pub(in crate::cli) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

fn opening(tag: &Tag<'_>) -> &'static str {
    match tag {
        Tag::Paragraph => "<p>",
        Tag::Strong => "<b>",
        Tag::Emphasis => "<em>",
        Tag::List(_) => "<ul>",
        Tag::Item => "<li>",
        Tag::CodeBlock(_) => "<pre>",
        _ => "",
    }
}

fn closing(tag: &TagEnd) -> &'static str {
    match tag {
        TagEnd::Paragraph => "</p>",
        TagEnd::Strong => "</b>",
        TagEnd::Emphasis => "</em>",
        TagEnd::List(_) => "</ul>",
        TagEnd::Item => "</li>",
        TagEnd::CodeBlock => "</pre>",
        _ => "",
    }
}

/// A formula in a line: as letters where those can show it.
fn in_line(tex: &str) -> String {
    let Ok(parts) = letters(tex) else { return drawn(tex, 18.0) };
    let part = |part: &raystep_print::Letters| {
        let text = escaped(&part.text);
        let text = if part.italic { format!("<i>{text}</i>") } else { text };
        match part.shift {
            Shift::Line => text,
            Shift::Below => format!("<sub>{text}</sub>"),
            Shift::Above => format!("<sup>{text}</sup>"),
        }
    };
    format!("<span class=\"math\">{}</span>", parts.iter().map(part).collect::<String>())
}

fn drawn(tex: &str, size: f32) -> String {
    let color = Theme::LIGHT.style(Role::Text).text;
    formula(tex, size, color).replacen("<svg ", "<svg role=\"img\" ", 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_of_slides_become_html() {
        let check = |text: &str, shown: &str, read: &str| {
            assert_eq!((html(text).as_str(), plain(text).as_str()), (shown, read), "{text}");
        };
        check("A **leaf** < 3.", "<p>A <b>leaf</b> &lt; 3.</p>", "A leaf < 3.");
        check("Two.\n\n- `a`\n- *b*", "<p>Two.</p><ul><li><code>a</code></li><li><em>b</em></li></ul>", "Two. a b");
        check("$t_{near}$", "<p><span class=\"math\"><i>t</i><sub><i>near</i></sub></span></p>", "tnear");
        assert!(html("$$\\frac{a}{b}$$").contains("<svg role=\"img\" "));
    }
}
