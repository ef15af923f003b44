//! The text of a beat, read once: paragraphs of runs, formulas on lines of their own, items of lists.

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd, TextMergeStream};

/// A piece of text that stands by itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Block {
    /// Words, one after the other.
    Paragraph(Vec<Run>),
    /// The same with a dot before it.
    Item(Vec<Run>),
    /// A formula in the middle of the page, in TeX.
    Formula(String),
    /// Lines of code.
    Code(String),
}

/// Words in one face.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Run {
    pub(crate) text: String,
    pub(crate) look: RunLook,
}

/// How a run is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RunLook {
    Plain,
    Strong,
    Emphasis,
    Code,
    Formula,
}

/// Reads Markdown with formulas between `$` or `$$`.
pub(crate) fn blocks(markdown: &str) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut runs: Vec<Run> = Vec::new();
    let (mut strong, mut emphasis, mut item, mut code) = (0, 0, false, None::<String>);
    for event in TextMergeStream::new(Parser::new_ext(markdown, Options::ENABLE_MATH)) {
        let look = match (strong > 0, emphasis > 0) {
            (true, _) => RunLook::Strong,
            (_, true) => RunLook::Emphasis,
            _ => RunLook::Plain,
        };
        // Brackets and the like come in pieces: words of one look are one run.
        let mut push = |text: &str, look| match runs.last_mut() {
            Some(last) if last.look == look && look != RunLook::Formula => last.text.push_str(text),
            _ => runs.push(Run { text: text.to_owned(), look }),
        };
        match event {
            Event::Text(text) => match &mut code {
                Some(lines) => lines.push_str(&text),
                None => push(&text, look),
            },
            Event::Code(text) => push(&text, RunLook::Code),
            Event::InlineMath(tex) => push(&tex, RunLook::Formula),
            Event::DisplayMath(tex) => {
                flush(&mut runs, item, &mut blocks);
                blocks.push(Block::Formula(tex.trim().to_owned()));
            }
            Event::SoftBreak | Event::HardBreak => push(" ", RunLook::Plain),
            Event::Start(Tag::Strong) => strong += 1,
            Event::End(TagEnd::Strong) => strong -= 1,
            Event::Start(Tag::Emphasis) => emphasis += 1,
            Event::End(TagEnd::Emphasis) => emphasis -= 1,
            Event::Start(Tag::Item) => item = true,
            Event::Start(Tag::CodeBlock(_)) => code = Some(String::new()),
            Event::End(TagEnd::CodeBlock) => {
                blocks.extend(code.take().map(|lines| Block::Code(lines.trim_end().to_owned())));
            }
            Event::End(TagEnd::Paragraph | TagEnd::Heading(_)) => flush(&mut runs, item, &mut blocks),
            Event::End(TagEnd::Item) => {
                flush(&mut runs, item, &mut blocks);
                item = false;
            }
            _ => {}
        }
    }
    flush(&mut runs, item, &mut blocks);
    blocks
}

fn flush(runs: &mut Vec<Run>, item: bool, blocks: &mut Vec<Block>) {
    let taken = std::mem::take(runs);
    if taken.iter().any(|run| !run.text.trim().is_empty()) {
        blocks.push(if item { Block::Item(taken) } else { Block::Paragraph(taken) });
    }
}

/// The text of some Markdown without any marks: what a button says.
pub(crate) fn plain(markdown: &str) -> String {
    let texts = blocks(markdown).into_iter().map(|block| match block {
        Block::Paragraph(runs) | Block::Item(runs) => runs.into_iter().map(|run| run.text).collect::<String>(),
        Block::Formula(text) | Block::Code(text) => text,
    });
    texts.collect::<Vec<_>>().join(" ")
}

/// The text with its short statements kept on one line: "t = 3.66", "[0.5, 3]", "node 5".
pub(crate) fn together(text: &str) -> String {
    const SIGNS: [&str; 6] = ["=", "<", ">", "≤", "≥", "≠"];
    const KINDS: [&str; 5] = ["node", "cell", "primitive", "slide", "step"];
    let words: Vec<&str> = text.split(' ').collect();
    let mut kept = String::with_capacity(text.len());
    for (index, word) in words.iter().enumerate() {
        kept.push_str(word);
        let Some(next) = words.get(index + 1) else { break };
        let numeral = next.starts_with(|letter: char| letter.is_ascii_digit() || "−∞".contains(letter));
        let short = |word: &str| word.chars().count() <= 9;
        let statement = SIGNS.contains(word) && short(next) || SIGNS.contains(next) && short(word);
        let counted = KINDS.contains(&word.to_lowercase().as_str()) && numeral;
        let interval = word.starts_with('[') && word.ends_with(',') && numeral && next.contains(']');
        kept.push(if statement || counted || interval { '\u{a0}' } else { ' ' });
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_statements_stay_on_one_line() {
        let table = [
            ("at t = 3.66 the", "at t\u{a0}=\u{a0}3.66 the"),
            ("for [0.5, 3.1]. It", "for [0.5,\u{a0}3.1]. It"),
            ("Node 5 waits, a node waits", "Node\u{a0}5 waits, a node waits"),
            (" = 3", "\u{a0}=\u{a0}3"),
            ("nothing here", "nothing here"),
        ];
        for (text, kept) in table {
            assert_eq!(together(text), kept);
        }
    }

    #[test]
    fn a_beat_is_cut_into_blocks() {
        let read = blocks("The plane is *at* $t$ = `3`.\n\n$$t = (s - o)/d$$\n\n- one\n- **two**\n");
        assert_eq!(read.len(), 4);
        assert_eq!(read[1], Block::Formula("t = (s - o)/d".to_owned()));
        let Block::Paragraph(runs) = &read[0] else { panic!("{read:?}") };
        let looks: Vec<RunLook> = runs.iter().map(|run| run.look).collect();
        use RunLook::{Code, Emphasis, Formula, Plain};
        assert_eq!(looks, [Plain, Emphasis, Plain, Formula, Plain, Code, Plain]);
        assert!(matches!(&read[3], Block::Item(runs) if runs[0].look == RunLook::Strong));
        assert_eq!(plain("a **b** $c$"), "a b c");
        let read = blocks("its part, [5.1, 8.55].");
        assert!(matches!(&read[0], Block::Paragraph(runs) if runs.len() == 1), "{read:?}");
    }
}
