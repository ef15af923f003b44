//! Every line of an OBJ file, checked before tobj sees it.
//!
//! Refused is only what makes the geometry doubtful: a wrong number or index of a vertex that a face uses. Whatever
//! else is wrong is left out and counted ([`LeftOut`]).

use std::fmt::Write;

use super::left_out::LeftOut;
use super::progress::Progress;
use super::text::{Line, count, lines, not_text, shown, whole_file};
use super::{ObjError, keywords};
use crate::{SceneError, decimal};

/// Coordinates further out overflow when a ray's arithmetic multiplies them.
const FURTHEST: f64 = 1e18;

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
    progress: &mut Progress<'_>,
) -> Result<String, ObjError> {
    let all = totals(text);
    let (clean, used, out) = (String::new(), vec![false; all.v], LeftOut::default());
    let mut guard = Guard { file, clean, all, so_far: Counts::default(), used, wrong: Vec::new(), faces: 0, out };
    let mut read = 0;
    for line in lines(text) {
        progress.reach(read, text.len())?;
        read += line.text.len() + 1;
        let Some(keyword) = line.text.split_whitespace().next() else { continue };
        match keyword {
            "v" => guard.vertex(&line),
            // Texture coordinates and normals are not drawn; only their number matters.
            "vt" => guard.so_far.vt += 1,
            "vn" => guard.so_far.vn += 1,
            "f" | "fo" => guard.face(&line, progress)?,
            _ if keywords::SILENT.contains(&keyword) => {}
            _ => guard.out.pass_over(keyword, &line),
        }
    }
    if guard.faces == 0 {
        return Err(guard.no_face(text).into());
    }
    // A vertex that no face uses may be anything.
    if let Some(&vertex) = guard.wrong.iter().find(|vertex| guard.used[**vertex]) {
        return Err(wrong_vertex(text, file, vertex).into());
    }
    guard.out.vertices = guard.wrong.len();
    notes.extend(guard.out.notes());
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
    so_far: Counts,
    /// Which vertices faces use.
    used: Vec<bool>,
    /// The vertices that are no points.
    wrong: Vec<usize>,
    faces: usize,
    out: LeftOut,
}

impl Guard<'_> {
    /// `v x y z`, then perhaps a weight or a colour.
    fn vertex(&mut self, line: &Line<'_>) {
        let [x, y, z] = point(line, self.file).unwrap_or_else(|_| {
            self.wrong.push(self.so_far.v);
            [0.0; 3]
        });
        self.so_far.v += 1;
        let _ = writeln!(self.clean, "v {x:?} {y:?} {z:?}");
        self.out.longer += usize::from(line.text.split_whitespace().nth(4).is_some());
    }

    /// `f` with three or more of `v`, `v/vt`, `v//vn`, `v/vt/vn`.
    fn face(&mut self, line: &Line<'_>, progress: &mut Progress<'_>) -> Result<(), ObjError> {
        let words = line.text.split_whitespace().skip(1);
        let corners = words.clone().take(3).count();
        if corners < 3 {
            let found = count(corners, "corner");
            self.out.short(|| line.wrong(self.file, "", format!("a face has three or more corners; found {found}")));
            return Ok(());
        }
        self.clean.push('f');
        let (mut no_texture, mut no_normal, mut odd) = (false, false, false);
        for word in words {
            progress.step()?;
            let mut parts = word.split('/');
            let position = parts.next().unwrap_or_default();
            let vertex = index(position, self.so_far.v, self.all.v)
                .map_err(|no_index| line.wrong(self.file, word, no_index.says(word, position)))?;
            self.used[vertex - 1] = true;
            let _ = write!(self.clean, " {vertex}");
            // Texture and normal are thrown away: right or wrong, they change no triangle.
            let (texture, normal) = (parts.next().unwrap_or_default(), parts.next().unwrap_or_default());
            for (part, so_far, all, missing) in [
                (texture, self.so_far.vt, self.all.vt, &mut no_texture),
                (normal, self.so_far.vn, self.all.vn, &mut no_normal),
            ] {
                match index(part, so_far, all) {
                    Err(NoIndex::Word) => odd |= !part.is_empty(),
                    found => *missing |= found.is_err(),
                }
            }
            odd |= parts.next().is_some();
        }
        self.clean.push('\n');
        self.faces += 1;
        self.out.textures += usize::from(no_texture);
        self.out.normals += usize::from(no_normal);
        self.out.odd += usize::from(odd);
        Ok(())
    }

    /// Why there is nothing to hit.
    fn no_face(self, text: &str) -> SceneError {
        if let Some(short) = self.out.first_short {
            return short;
        }
        if let Some(not_text) = not_text(self.file, text) {
            return not_text;
        }
        let found = count(self.all.v, "vertex");
        let mut message = format!("found {found} and no face; a face is `f` with three or more vertices");
        if let Some((word, line)) = self.out.first_unknown {
            let _ = write!(message, " (the first word that is no keyword of OBJ is {} in line {line})", shown(&word));
        }
        whole_file(self.file, message)
    }
}

/// The point of a vertex.
fn point(line: &Line<'_>, file: &str) -> Result<[f64; 3], SceneError> {
    let mut point = [0.0; 3];
    let mut words = line.text.split_whitespace().skip(1);
    for (found, coordinate) in point.iter_mut().enumerate() {
        let Some(word) = words.next() else {
            let found = count(found, "number");
            return Err(line.wrong(file, "", format!("a vertex is `v x y z`; found {found}")));
        };
        let Some(number) = decimal(word) else {
            let message = format!("{} is not a number; a vertex is `v x y z`", shown(word));
            return Err(line.wrong(file, word, message));
        };
        if number.is_nan() || number.abs() > FURTHEST {
            let word_shown = shown(word);
            let message =
                format!("{word_shown} is no usable coordinate; numbers from -{FURTHEST:e} to {FURTHEST:e} are");
            return Err(line.wrong(file, word, message));
        }
        *coordinate = number;
    }
    Ok(point)
}

/// What is wrong with the vertex of this place.
fn wrong_vertex(text: &str, file: &str, vertex: usize) -> SceneError {
    let vertices = lines(text).filter(|line| line.text.split_whitespace().next() == Some("v"));
    let wrong = vertices.skip(vertex).find_map(|line| point(&line, file).err());
    wrong.unwrap_or_else(|| whole_file(file, "a vertex is not a point"))
}

/// Why a part of a corner is no index.
enum NoIndex {
    /// It is no whole number.
    Word,
    /// It counts back from here, and there are only so many.
    Back(usize),
    /// There are only so many.
    Beyond(usize),
}

/// An index from 1, or one counted back from here: -1 is the latest.
fn index(part: &str, so_far: usize, all: usize) -> Result<usize, NoIndex> {
    let digits = part.strip_prefix(['-', '+']).unwrap_or(part);
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return Err(NoIndex::Word);
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
    Err(if back { NoIndex::Back(last) } else { NoIndex::Beyond(last) })
}

impl NoIndex {
    /// A sentence about the vertex `part` of the corner `word`.
    fn says(&self, word: &str, part: &str) -> String {
        let allowed = match self {
            NoIndex::Word => {
                return format!("{}: a corner is v, v/vt, v//vn or v/vt/vn, each a whole number", shown(word));
            }
            NoIndex::Back(0) | NoIndex::Beyond(0) => "there are no vertices".to_owned(),
            NoIndex::Back(last) => format!("so far there are {last} vertices, so -{last} to -1 are allowed"),
            NoIndex::Beyond(1) => "there is one vertex".to_owned(),
            NoIndex::Beyond(last) => format!("the file has {last} vertices, so 1 to {last} are allowed"),
        };
        format!("{} is not the number of a vertex; {allowed}", shown(part))
    }
}
