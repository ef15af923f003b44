//! What of a text would not be shown as it is written.

use pulldown_cmark::{Event, Options, Parser, Tag};
use raystep_figure::{Face, fonts};

use crate::formula::proof_formula;
use crate::letters::letters;

/// The letters of a word that is not broken anywhere.
const LONGEST_WORD: usize = 60;

/// What of some Markdown would not be shown as it is written: the byte, and a sentence.
pub fn proof(markdown: &str) -> Vec<(usize, String)> {
    let mut proof = Proof { text: markdown, found: Vec::new(), dollars: false };
    let (mut lists, mut code) = (0, false);
    // All that Markdown is anywhere, so that what is not shown here is recognised.
    for (event, range) in Parser::new_ext(markdown, Options::all()).into_offset_iter() {
        let at = range.start;
        match event {
            Event::Text(text) if code => proof.letters(&text, at, Face::Mono),
            Event::Text(text) => {
                // What was escaped is meant.
                if !markdown[..at].ends_with('\\') {
                    proof.marks(&text, at);
                }
                proof.letters(&text, at, Face::Regular);
            }
            Event::Code(text) => proof.letters(&text, at + 1, Face::Mono),
            Event::InlineMath(tex) => {
                let unset = proof_formula(&tex).and_then(|()| letters(&tex).map(|_| ()));
                proof.add_from(unset.err().map(|unset| (at + 1 + unset.at, unset.why)));
            }
            Event::DisplayMath(tex) => {
                proof.add_from(proof_formula(&tex).err().map(|unset| (at + 2 + unset.at, unset.why)));
            }
            Event::Html(_) | Event::InlineHtml(_) => {
                proof.add(at, "HTML is not shown: write Markdown, `\\<` for a sign");
            }
            Event::FootnoteReference(_) => proof.add(at, "footnotes are not shown: say it here"),
            Event::Rule => proof.add(at, "a line across the page is not shown: leave it out"),
            Event::TaskListMarker(_) => proof.add(at, "boxes to tick are not shown: leave them out"),
            Event::Start(tag) => match tag {
                Tag::Paragraph | Tag::Emphasis | Tag::Strong | Tag::Item => {}
                Tag::CodeBlock(_) => code = true,
                Tag::List(number) => {
                    lists += 1;
                    if lists > 1 {
                        proof.add(at, "a list within a list is not shown as one: write one list");
                    } else if number.is_some() {
                        proof.add(at, "the numbers of a list are not shown: begin its lines with `-`");
                    }
                }
                Tag::Heading { .. } => {
                    proof.add(at, "a heading below a beat's own is not shown as one: begin another beat");
                }
                Tag::BlockQuote(_) => proof.add(at, "a quote is not shown as one"),
                Tag::Table(_) => proof.add(at, "tables are not shown: write a list"),
                Tag::Image { .. } => proof.add(at, "pictures are not shown in texts: say it in words"),
                Tag::Link { .. } => proof.add(at, "links lead nowhere here: write in words where to look"),
                Tag::FootnoteDefinition(_) => proof.add(at, "footnotes are not shown: say it where it belongs"),
                Tag::Strikethrough => proof.add(at, "words are not struck out: leave them out"),
                Tag::Superscript | Tag::Subscript => {
                    proof.add(at, "raised and lowered letters stand in formulas: `$x^2$`");
                }
                _ => {}
            },
            Event::End(pulldown_cmark::TagEnd::List(_)) => lists -= 1,
            Event::End(pulldown_cmark::TagEnd::CodeBlock) => code = false,
            _ => {}
        }
    }
    proof.found
}

/// What of a title or a name would not be shown as it is written: it is no Markdown.
pub fn proof_plain(text: &str) -> Vec<(usize, String)> {
    let mut proof = Proof { text, found: Vec::new(), dollars: false };
    for mark in ["$", "`", "**", "{{", "](", "\\"] {
        if let Some(at) = text.find(mark) {
            proof.add(at, format!("a title or a name is shown word for word: `{mark}` too"));
        }
    }
    proof.letters(text, 0, Face::Bold);
    proof.found
}

/// What of a line of code would not be shown as it is written.
pub fn proof_code(text: &str) -> Vec<(usize, String)> {
    let mut proof = Proof { text, found: Vec::new(), dollars: false };
    proof.letters(text, 0, Face::Mono);
    proof.found
}

struct Proof<'a> {
    text: &'a str,
    found: Vec<(usize, String)>,
    /// Whether a `$` was left over: then what else is left over are parts of formulas.
    dollars: bool,
}

impl Proof<'_> {
    fn add(&mut self, at: usize, why: impl Into<String>) {
        self.add_from(Some((at, why.into())));
    }

    /// Each sentence once.
    fn add_from(&mut self, found: Option<(usize, String)>) {
        let Some((at, why)) = found else { return };
        // Bytes that formulas name may lie within a letter.
        let at = (0..=at.min(self.text.len())).rev().find(|at| self.text.is_char_boundary(*at)).unwrap_or(0);
        if !self.found.iter().any(|(_, other)| *other == why) {
            self.found.push((at, why));
        }
    }

    /// A `$` that was left over: alone, or of a formula that cannot be read, as its brackets have no partners.
    fn dollar(&mut self, at: usize) {
        if std::mem::replace(&mut self.dollars, true) {
            return;
        }
        let inside = self.text[at..].trim_start_matches('$');
        let inside_at = self.text.len() - inside.len();
        let end = inside.find("\n\n").unwrap_or(inside.len());
        let unset = inside[..end].split_once('$').and_then(|(tex, _)| proof_formula(tex).err());
        let lonely = "a `$` has no partner: a formula stands between two, and the sign itself is written `\\$`";
        let (at, why) = unset.map_or((at, lonely.to_owned()), |unset| (inside_at + unset.at, unset.why));
        self.add(at, why);
    }

    /// Signs of Markdown and TeX that were left over.
    fn marks(&mut self, text: &str, at: usize) {
        if let Some(found) = text.find('$') {
            self.dollar(at + found);
        }
        if self.dollars {
            return;
        }
        let marks = [
            ("**", "a `**` has no partner: **bold** stands between two"),
            ("`", "a ` has no partner: code stands between two"),
            ("](", "links lead nowhere here, and pictures are not shown: say it in words"),
        ];
        for (mark, why) in marks {
            if let Some(found) = text.find(mark) {
                self.add(at + found, why);
            }
        }
        let command =
            text.match_indices('\\').find(|(at, _)| text[at + 1..].starts_with(|c: char| c.is_ascii_alphabetic()));
        if let Some((found, _)) = command {
            self.add(at + found, "TeX stands between two `$`");
        }
    }

    /// Letters that the face lacks, and words that are too long.
    fn letters(&mut self, text: &str, at: usize, face: Face) {
        let shown = |letter: char| letter.is_whitespace() || fonts::has_glyph(letter, face);
        if let Some((found, letter)) = text.char_indices().find(|(_, letter)| !shown(*letter)) {
            let letter = letter.escape_debug();
            self.add(at + found, format!("`{letter}` is not among the letters that can be shown"));
        }
        for word in text.split_whitespace() {
            let letters = word.chars().count();
            if letters > LONGEST_WORD {
                let found = word.as_ptr() as usize - text.as_ptr() as usize;
                let why = format!("a word has {letters} letters: at most {LONGEST_WORD} fit on a line");
                self.add(at + found, why);
                return;
            }
        }
    }
}
