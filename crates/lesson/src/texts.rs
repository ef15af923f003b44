//! The texts of a slide, each with where it stands, for whoever sets them.

use crate::{Ask, Beat, Slide, Spot};

/// How a text is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Script {
    /// Word for word, on one line: a title, a name.
    Plain,
    /// As Markdown with formulas.
    Markdown,
    /// Word for word, as code.
    Code,
}

/// Finds what cannot be shown as a text says it: the byte of the text, and a sentence.
pub type Setter<'a> = &'a dyn Fn(&str, Script) -> Vec<(usize, String)>;

/// A text of a slide.
pub(crate) struct Said<'a> {
    pub(crate) text: &'a str,
    pub(crate) script: Script,
    /// Where each of its lines begins.
    lines: Vec<Spot>,
}

impl Said<'_> {
    /// Where a byte of the text stands in the file.
    pub(crate) fn spot(&self, byte: usize) -> Spot {
        let before = self.text.get(..byte).unwrap_or(self.text);
        let line = before.rsplit('\n').next().unwrap_or_default();
        let start = self.lines.get(before.matches('\n').count()).or(self.lines.last()).copied().unwrap_or(Spot::START);
        Spot { column: start.column + line.chars().count() as u32, ..start }
    }

    /// The text with every `{{field}}` filled with digits, as many as it has bytes, and its noun with as long words: each
    /// byte keeps its place.
    pub(crate) fn filled(&self) -> String {
        let mut filled = String::with_capacity(self.text.len());
        let mut rest = self.text;
        while let Some((before, opened)) = rest.split_once("{{") {
            let Some((field, after)) = opened.split_once("}}") else { break };
            filled.push_str(before);
            filled.push_str("00");
            filled.extend(field.bytes().map(|byte| if byte == b' ' { ' ' } else { '0' }));
            filled.push_str("00");
            rest = after;
        }
        filled + rest
    }
}

impl Slide {
    /// Everything that it says.
    pub(crate) fn texts(&self) -> Vec<Said<'_>> {
        let mut texts = vec![plain(&self.title, self.title_spot)];
        texts.extend(self.stages.iter().flat_map(|stage| &stage.rays).map(|ray| plain(&ray.name, ray.name_spot)));
        self.beats.iter().for_each(|beat| beat.texts(&mut texts));
        texts
    }
}

impl Beat {
    fn texts<'a>(&'a self, texts: &mut Vec<Said<'a>>) {
        texts.push(plain(&self.title, self.title_spot));
        texts.extend(self.paragraphs.iter().map(|paragraph| markdown(&paragraph.text, &paragraph.lines)));
        if let Some(ask) = &self.ask {
            ask.texts(texts);
        }
    }
}

impl Ask {
    fn texts<'a>(&'a self, texts: &mut Vec<Said<'a>>) {
        texts.push(markdown(&self.question, &self.lines));
        for reason in &self.reasons {
            texts.extend(reason.label.as_ref().map(|label| plain(label, reason.spot)));
            texts.push(markdown(&reason.text, &reason.lines));
        }
    }
}

fn plain(text: &str, spot: Spot) -> Said<'_> {
    Said { text, script: Script::Plain, lines: vec![spot] }
}

fn markdown<'a>(text: &'a str, lines: &[Spot]) -> Said<'a> {
    Said { text, script: Script::Markdown, lines: lines.to_vec() }
}
