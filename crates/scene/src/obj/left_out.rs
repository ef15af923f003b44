//! What the guard leaves out, counted: the notes say it once.

use std::collections::BTreeMap;

use super::keywords;
use super::text::{Line, count, shown};
use crate::SceneError;

/// So many words that are no keywords are told one by one.
const MOST_WORDS: usize = 8;

/// What was left out so far.
#[derive(Default)]
pub(super) struct LeftOut {
    /// Vertices with more than x, y and z.
    pub(super) longer: usize,
    /// Vertices that are no points, and no face uses them.
    pub(super) vertices: usize,
    /// Faces whose texture coordinates are not there.
    pub(super) textures: usize,
    /// Faces whose normals are not there.
    pub(super) normals: usize,
    /// Faces with corners of another form.
    pub(super) odd: usize,
    /// Faces with too few corners, and what the first of them deserves where there is no other face.
    short: usize,
    pub(super) first_short: Option<SceneError>,
    /// Lines by their keyword.
    known: BTreeMap<&'static str, usize>,
    /// Lines by their first word, which is no keyword.
    unknown: BTreeMap<String, usize>,
    /// Lines with still other words.
    more: usize,
    pub(super) first_unknown: Option<(String, usize)>,
}

impl LeftOut {
    /// A face with too few corners.
    pub(super) fn short(&mut self, wrong: impl FnOnce() -> SceneError) {
        self.short += 1;
        self.first_short.get_or_insert_with(wrong);
    }

    /// A line that carries no triangle.
    pub(super) fn pass_over(&mut self, keyword: &str, line: &Line<'_>) {
        if let Some(known) = keywords::COUNTED.into_iter().find(|known| *known == keyword) {
            *self.known.entry(known).or_default() += 1;
            return;
        }
        self.first_unknown.get_or_insert_with(|| (keyword.to_owned(), line.number()));
        if let Some(n) = self.unknown.get_mut(keyword) {
            *n += 1;
        } else if self.unknown.len() < MOST_WORDS {
            self.unknown.insert(keyword.to_owned(), 1);
        } else {
            self.more += 1;
        }
    }

    /// A sentence for each kind of thing.
    pub(super) fn notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        let mut note = |n: usize, noun: &str, says: &str| {
            if n > 0 {
                notes.push(format!("{} {says}", count(n, noun)));
            }
        };
        note(self.longer, "`v` line", "with more than x y z: colours and weights left out");
        note(self.vertices, "vertex", "that no face uses left out: not three numbers, or too large ones");
        note(self.short, "face", "with fewer than three corners left out");
        for (n, names) in [(self.textures, "texture coordinates"), (self.normals, "normals")] {
            let verb = if n == 1 { "names" } else { "name" };
            note(n, "face", &format!("{verb} {names} that are not there; they are not used"));
        }
        note(self.odd, "face", "with corners that are not v, v/vt, v//vn or v/vt/vn: only v is used");
        for (keyword, &n) in &self.known {
            let why = if *keyword == "mtllib" { " (materials are not needed; no other file is opened)" } else { "" };
            note(n, "line", &format!("passed over: {keyword}{why}"));
        }
        for (word, &n) in &self.unknown {
            note(n, "line", &format!("passed over: {} is no keyword of OBJ", shown(word)));
        }
        note(self.more, "more line", "passed over: they begin with no keyword of OBJ");
        notes
    }
}
