//! Every line of an OBJ file, checked before tobj sees it.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::ObjError;
use super::text::{Line, count, lines, whole_file};
use crate::SceneError;
use crate::error::nearest;

/// Coordinates further out overflow when a ray's arithmetic multiplies them.
const FURTHEST: f32 = 1e18;

/// Keywords that carry no triangles; lines of these are passed over without a word.
const SILENT: [&str; 14] = [
    "o",
    "g",
    "s",
    "mg",
    "vp",
    "usemtl",
    "usemap",
    "maplib",
    "bevel",
    "c_interp",
    "d_interp",
    "lod",
    "shadow_obj",
    "trace_obj",
];

/// Keywords for things other than triangles; lines of these are counted in the notes.
const OTHER: [&str; 22] = [
    "p", "l", "curv", "curv2", "surf", "cstype", "deg", "bmat", "step", "parm", "trim", "hole", "scrv", "sp", "end",
    "con", "ctech", "stech", "call", "csh", "bzp", "bsp",
];

/// How the notes speak of material libraries.
const LIBRARY: &str = "mtllib (materials are not needed; no other file is opened)";

/// How many of each an index may name.
#[derive(Clone, Copy, Default)]
struct Counts {
    v: usize,
    vt: usize,
    vn: usize,
}

/// The vertices and faces of `text` in plain form: positions only, positive indices.
pub(super) fn check(
    text: &str,
    file: &str,
    notes: &mut Vec<String>,
    progress: &mut dyn FnMut(f32) -> bool,
) -> Result<String, ObjError> {
    let all = totals(text);
    let mut so_far = Counts::default();
    let mut guard = Guard { file, clean: String::new(), all, faces: 0, shortened: 0 };
    let mut skipped: BTreeMap<String, usize> = BTreeMap::new();
    let mut read = 0;
    for (i, line) in lines(text).enumerate() {
        read += line.text.len() + 1;
        if i % 16_384 == 0 && !progress(read as f32 / text.len() as f32) {
            return Err(ObjError::Cancelled);
        }
        let Some(keyword) = line.text.split_whitespace().next() else { continue };
        match keyword {
            "v" => {
                so_far.v += 1;
                guard.vertex(&line)?;
            }
            // Texture coordinates and normals are not drawn; only their number matters.
            "vt" => so_far.vt += 1,
            "vn" => so_far.vn += 1,
            "f" | "fo" => guard.face(&line, so_far)?,
            "mtllib" => *skipped.entry(LIBRARY.to_owned()).or_default() += 1,
            _ if SILENT.contains(&keyword) => {}
            _ if OTHER.contains(&keyword) => *skipped.entry(keyword.to_owned()).or_default() += 1,
            _ => return Err(guard.unknown(&line, keyword).into()),
        }
    }
    if guard.faces == 0 {
        let found = count(all.v, "vertex").replace("vertexs", "vertices");
        return Err(
            whole_file(file, format!("found {found} and no face; a face is `f` with three or more vertices")).into()
        );
    }
    if guard.shortened > 0 {
        notes
            .push(format!("{} with more than x y z: colours and weights left out", count(guard.shortened, "`v` line")));
    }
    notes.extend(skipped.iter().map(|(keyword, &n)| format!("{} passed over: {keyword}", count(n, "line"))));
    Ok(guard.clean)
}

/// Faces may name vertices that come later, so they are counted first.
fn totals(text: &str) -> Counts {
    let mut all = Counts::default();
    for line in lines(text) {
        match line.text.split_whitespace().next() {
            Some("v") => all.v += 1,
            Some("vt") => all.vt += 1,
            Some("vn") => all.vn += 1,
            _ => {}
        }
    }
    all
}

struct Guard<'a> {
    file: &'a str,
    clean: String,
    all: Counts,
    faces: usize,
    shortened: usize,
}

impl Guard<'_> {
    /// `v x y z`, then perhaps a weight or a colour.
    fn vertex(&mut self, line: &Line<'_>) -> Result<(), SceneError> {
        let words: Vec<&str> = line.text.split_whitespace().skip(1).collect();
        let Some(&[x, y, z]) = words.first_chunk::<3>() else {
            let found = count(words.len(), "number");
            return Err(self.wrong(line, "v", format!("a vertex is `v x y z`; found {found}")));
        };
        self.clean.push('v');
        for word in [x, y, z] {
            let number: f32 = word
                .parse()
                .map_err(|_| self.wrong(line, word, format!("`{word}` is not a number; a vertex is `v x y z`")))?;
            if number.is_nan() || number.abs() > FURTHEST {
                let message =
                    format!("`{word}` is no usable coordinate; numbers from -{FURTHEST:e} to {FURTHEST:e} are");
                return Err(self.wrong(line, word, message));
            }
            let _ = write!(self.clean, " {number}");
        }
        self.clean.push('\n');
        self.shortened += usize::from(words.len() > 3);
        Ok(())
    }

    /// `f` with three or more of `v`, `v/vt`, `v//vn`, `v/vt/vn`.
    fn face(&mut self, line: &Line<'_>, so_far: Counts) -> Result<(), SceneError> {
        let words = line.text.split_whitespace().skip(1);
        let found = words.clone().count();
        if found < 3 {
            let found = count(found, "corner");
            return Err(self.wrong(line, "f", format!("a face has three or more corners; found {found}")));
        }
        self.clean.push('f');
        for word in words {
            let mut parts = word.split('/');
            let position = parts.next().unwrap_or_default();
            let position = self.index(line, word, position, ["vertex", "vertices"], so_far.v, self.all.v)?;
            for (part, names, so_far, all) in [
                (parts.next(), ["texture coordinate", "texture coordinates"], so_far.vt, self.all.vt),
                (parts.next(), ["normal", "normals"], so_far.vn, self.all.vn),
            ] {
                if let Some(part) = part.filter(|part| !part.is_empty()) {
                    self.index(line, word, part, names, so_far, all)?;
                }
            }
            if parts.next().is_some() {
                return Err(self.wrong(line, word, format!("`{word}`: a corner is v, v/vt, v//vn or v/vt/vn")));
            }
            let _ = write!(self.clean, " {position}");
        }
        self.clean.push('\n');
        self.faces += 1;
        Ok(())
    }

    /// An index from 1, or one counted back from here: -1 is the latest.
    fn index(
        &self,
        line: &Line<'_>,
        word: &str,
        part: &str,
        [one, many]: [&str; 2],
        so_far: usize,
        all: usize,
    ) -> Result<usize, SceneError> {
        let digits = part.strip_prefix(['-', '+']).unwrap_or(part);
        if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
            return Err(self.wrong(
                line,
                word,
                format!("`{word}`: a corner is v, v/vt, v//vn or v/vt/vn, each a whole number"),
            ));
        }
        // No file has so many; a number with too many digits is cut off there.
        const BEYOND: i64 = u32::MAX as i64;
        let back = part.starts_with('-');
        let number = digits.parse().unwrap_or(BEYOND).min(BEYOND);
        let index = if back { so_far as i64 + 1 - number } else { number };
        let last = if back { so_far } else { all };
        if number != 0 && (1..=last as i64).contains(&index) {
            return Ok(index as usize);
        }
        let allowed = match (last, back) {
            (0, _) => format!("there are no {many}"),
            (_, true) => format!("so far there are {last} {many}, so -{last} to -1 are allowed"),
            (1, _) => format!("there is one {one}"),
            (_, false) => format!("the file has {last} {many}, so 1 to {last} are allowed"),
        };
        Err(self.wrong(line, word, format!("`{part}` is not the number of a {one}; {allowed}")))
    }

    fn unknown(&self, line: &Line<'_>, keyword: &str) -> SceneError {
        let known = ["v", "vt", "vn", "f", "mtllib"].into_iter().chain(SILENT).chain(OTHER);
        let advice = match nearest(keyword, known) {
            Some(near) => format!("did you mean `{near}`?"),
            None => "an OBJ line begins with v, vt, vn, f, o, g, s, usemtl, mtllib or #".to_owned(),
        };
        let shown: String = keyword.chars().take(24).collect();
        self.wrong(line, keyword, format!("`{shown}` is not a keyword of OBJ; {advice}"))
    }

    /// A mistake at `word`, a part of the line's text; at its beginning if `word` is not.
    fn wrong(&self, line: &Line<'_>, word: &str, message: String) -> SceneError {
        let byte = word.as_ptr().addr().wrapping_sub(line.text.as_ptr().addr());
        let column = line.text.get(..byte).map_or(1, |before| before.chars().count() + 1);
        SceneError { file: self.file.to_owned(), line: line.number, column, message }
    }
}
