//! Several pictures of one size in one SVG file: what they share stands in it once.

use std::collections::{BTreeMap, HashMap};
use std::fmt::Write;

use crate::escaped::escaped;

/// Marks with fewer letters are not worth a reference.
const SHORT: usize = 90;

/// One picture of a stack.
#[derive(Clone, Debug)]
pub struct Layer {
    /// What it is called behind the `#`: letters, digits and `-`.
    pub name: String,
    /// What it shows, in words.
    pub says: String,
    /// The picture, as [`svg`](crate::svg()) writes it.
    pub svg: String,
}

/// One file of several pictures: `file.svg#name` shows the one of that name, and without a name the first.
pub fn stack(layers: &[Layer]) -> String {
    let mut ids = Ids::default();
    let parts: Vec<Parts<'_>> = layers.iter().map(|layer| Parts::of(&layer.svg, &mut ids)).collect();
    let mut shared: BTreeMap<&str, &str> = BTreeMap::new();
    let mut times: HashMap<&str, usize> = HashMap::new();
    for part in &parts {
        shared.extend(part.definitions.iter().map(|(id, text)| (*id, text.as_str())));
        for line in part.marks.iter().filter(|line| line.len() >= SHORT) {
            *times.entry(line).or_default() += 1;
        }
    }
    let mut definitions: String = shared.values().copied().collect();
    let mut numbers: HashMap<&str, String> = HashMap::new();
    let mut bodies = String::new();
    for (layer, part) in layers.iter().zip(&parts) {
        let (name, says) = (escaped(&layer.name), escaped(&layer.says));
        let _ = writeln!(bodies, "<g class=\"layer\" id=\"{name}\"><title>{says}</title>");
        for line in &part.marks {
            if times.get(line.as_str()).is_none_or(|times| *times < 2) {
                bodies.push_str(line);
                bodies.push('\n');
                continue;
            }
            let next = numbers.len();
            let id = numbers.entry(line).or_insert_with(|| {
                let id = format!("m{next}");
                let _ = writeln!(definitions, "<g id=\"{id}\">{line}</g>");
                id
            });
            let _ = write!(bodies, "<use href=\"#{id}\"/>");
        }
        bodies.push_str("</g>\n");
    }
    let open = parts.first().map_or("<svg xmlns=\"http://www.w3.org/2000/svg\">", |part| part.open);
    let first = layers.first().map_or_else(String::new, |layer| escaped(&layer.name));
    format!(
        "{open}\n<style>.layer{{display:none}}.layer:target,svg:not(:has(.layer:target)) \
         #{first}{{display:inline}}</style>\n<defs>{definitions}</defs>\n{bodies}</svg>\n"
    )
}

/// Short names for what is defined.
#[derive(Default)]
struct Ids(HashMap<String, String>);

impl Ids {
    fn short(&mut self, id: &str) -> &str {
        let next = self.0.len();
        self.0.entry(id.to_owned()).or_insert_with(|| format!("g{next:x}"))
    }

    /// A text with what it defines, and what it refers to, under short names.
    fn shortened(&mut self, text: &str) -> String {
        const BEFORE: [&str; 3] = [" id=\"", "href=\"#", "url(#"];
        let (mut out, mut rest) = (String::with_capacity(text.len()), text);
        while let Some((at, before)) = BEFORE.iter().filter_map(|b| Some((rest.find(b)?, b))).min_by_key(|(at, _)| *at)
        {
            let (head, tail) = rest.split_at(at + before.len());
            let end = tail.find(['"', ')']).unwrap_or(tail.len());
            out.push_str(head);
            out.push_str(self.short(&tail[..end]));
            rest = &tail[end..];
        }
        out + rest
    }
}

/// A file of one picture, taken apart.
struct Parts<'a> {
    /// The tag that opens it.
    open: &'a str,
    /// What is defined, by its id.
    definitions: Vec<(&'a str, String)>,
    /// The marks, a line each.
    marks: Vec<String>,
}

impl<'a> Parts<'a> {
    fn of(svg: &'a str, ids: &mut Ids) -> Parts<'a> {
        let (open, rest) = svg.split_once('\n').unwrap_or((svg, ""));
        let (definitions, rest) =
            rest.strip_prefix("<defs>").and_then(|rest| rest.split_once("</defs>")).unwrap_or(("", rest));
        let body = rest.trim_end().strip_suffix("</svg>").unwrap_or(rest);
        // The page says in words what is seen: within the picture nobody reads that.
        let bare = |line: &str| UNREAD.iter().fold(line.to_owned(), |line, attribute| without(&line, attribute));
        let lines = body.lines().filter(|line| !line.is_empty());
        let marks = lines.map(|line| ids.shortened(&bare(line))).collect();
        let definitions = defined(definitions).into_iter().map(|(id, text)| (id, ids.shortened(text))).collect();
        Parts { open, definitions, marks }
    }
}

/// What only those read who open a picture's source.
const UNREAD: [&str; 3] = [" class=\"", " data-place=\"", " aria-label=\""];

/// A line without an attribute, wherever it stands.
fn without(line: &str, attribute: &str) -> String {
    let mut parts = line.split(attribute);
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        out.push_str(part.split_once('"').map_or("", |(_, rest)| rest));
    }
    out
}

/// Definitions by their ids: outlines of letters, and hatchings, each of which has an id of its own.
fn defined(mut text: &str) -> Vec<(&str, &str)> {
    let mut all = Vec::new();
    while let Some(end) = end_of_first(text) {
        let (one, rest) = text.split_at(end);
        let id = one.split_once("id=\"").and_then(|(_, id)| id.split_once('"')).map_or(one, |(id, _)| id);
        all.push((id, one));
        text = rest;
    }
    all
}

/// Where the first element of a text ends.
fn end_of_first(text: &str) -> Option<usize> {
    if text.starts_with("<pattern") {
        return text.find("</pattern>").map(|at| at + "</pattern>".len());
    }
    text.find("/>").map(|at| at + "/>".len())
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec2;
    use raystep_figure::{Anchor, Face, Figure, Ink, Role, Theme};

    #[test]
    fn what_pictures_share_stands_there_once() {
        let picture = |word: &str, role: Role| {
            let mut figure = Figure::new(Vec2::new(200.0, 100.0));
            let points: Vec<Vec2> = (0..30).map(|i| Vec2::new(i as f32 * 7.0, (i % 3) as f32)).collect();
            figure.add(Role::Scene, None, Ink::Line { points });
            figure.add(role, None, Ink::Rect { min: Vec2::ZERO, max: Vec2::splat(9.0), round: 0.0 });
            let (text, size, face, anchor) = (word.to_owned(), 12.0, Face::Regular, Anchor::Start);
            figure.add(Role::Text, None, Ink::Text { at: Vec2::splat(20.0), text, size, face, anchor, boxed: false });
            crate::svg(&figure, &Theme::LIGHT)
        };
        let layer = |name: &str, svg: String| Layer { name: name.to_owned(), says: format!("<{name}>"), svg };
        let (a, b) = (picture("same", Role::Missed), picture("sea", Role::Missed));
        let one = stack(&[layer("one", a.clone())]);
        let two = stack(&[layer("one", a.clone()), layer("two", b)]);
        assert_eq!(two.matches("<polyline").count(), 1, "{two}");
        assert!(!two.contains("aria-label") && !two.contains("data-place"), "{two}");
        assert_eq!(two.matches("<pattern").count(), 1, "{two}");
        assert!(two.contains("id=\"one\"><title>&lt;one&gt;") && two.contains("id=\"two\""), "{two}");
        assert!(two.len() < one.len() * 3 / 2, "{} and {}", one.len(), two.len());
        // Every reference finds what it means.
        for id in two.split("href=\"#").skip(1).filter_map(|rest| rest.split('"').next()) {
            assert_eq!(two.matches(&format!("id=\"{id}\"")).count(), 1, "{id}");
        }
    }
}
