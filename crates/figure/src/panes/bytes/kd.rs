//! A node of a kd-tree as it lies in memory: in four layouts, slides 60-62.

use glam::Vec2;
use raystep_accel::{Kd, KdLayout, Machine, NodeField, NodeId, Place, Word};

use super::lines::{Strip, touched};
use crate::moments::{Moment, Walk};
use crate::page::{Anchor, Figure, Look, block, write};
use crate::theme::{Face, Role, text_width};
use crate::words::number;

/// The node where the walk stands, in each layout on one scale: its fields with what stands in them, beside them the
/// bits of a word that says several things, and below them the cache lines that the ray has touched so far. While a
/// question asks what stands there, `hide` leaves the fields empty.
pub(super) fn node(tree: &Kd, walk: &Walk<'_>, moment: &Moment, hide: bool, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    if moment.here.is_none() && moment.seen.is_empty() && moment.ending.is_none() {
        look.nothing(&mut figure, "Bytes", "No node has been entered yet.");
        return figure;
    }
    // When the walk is over, the node that it came to last.
    let at_hand = match moment.ending {
        Some(_) => moment.seen.last().copied(),
        None => moment.here.or(moment.event.map(|event| event.place())),
    };
    let node = match at_hand {
        Some(Place::Node(node)) => node,
        _ => NodeId::ROOT,
    };
    let last = if moment.ending.is_some() { ", the last of the walk" } else { "" };
    let leaf = walk.structure.split(node).is_none();
    let kind = if leaf { "a leaf" } else { "an inner node" };
    let remark = format!("{kind} \u{b7} pointers of 32 bits, addresses in bytes from the root");
    let top = look.heading(&mut figure, &format!("Bytes of node {node}{last}"), &remark);

    let shown = layouts(walk.layout);
    let rows: Vec<_> = shown.iter().filter_map(|&layout| Some((layout, layout.node(tree, node)?))).collect();
    if rows.is_empty() {
        look.nothing(&mut figure, "", "This tree is too large for addresses of 32 bits.");
        return figure;
    }
    // All rows on one scale: the largest layout fills the width. In a tall pane the letters grow with it.
    let height = ((size.y - top - look.margin() * 0.5) / rows.len() as f32).min(look.text * LARGEST * ROW);
    let u = (look.text * LARGEST).min(height / ROW);
    let left = look.margin() + text_width("64 bit: 48  ", Face::Bold, u * SMALL);
    let widest = rows.iter().map(|(layout, _)| layout.bytes(Machine::Printed)).max().unwrap_or(1);
    let byte = (size.x - look.margin() - left) / widest as f32;
    for (index, (layout, fields)) in rows.iter().enumerate() {
        // What a compiler makes of the first layout alone is asked for at the end of its walk.
        let compiled = rows.len() > 1 || moment.ending.is_some();
        let row = Row { node, leaf, hide, compiled, u, byte, left, y: top + height * index as f32 };
        row.draw(&mut figure, *layout, fields, size.x - look.margin());
        let lines = touched(walk, moment.step, layout.bytes(Machine::Printed));
        let strip = Strip {
            corner: Vec2::new(left, row.y + u * STRIP),
            size: Vec2::new(size.x - look.margin() - left, u * 0.95),
        };
        strip.draw(&mut figure, &lines, walk.structure.node_count(), node);
        let count = lines.touched().len();
        let says = if count == 1 { "1 line".to_owned() } else { format!("{count} lines") };
        let at = Vec2::new(row.label_edge(), strip.corner.y + strip.size.y / 2.0);
        write(&mut figure, Role::Hit, None, at, &says, u, Face::Bold, Anchor::End);
    }
    figure
}

/// Those that are shown, the last one included.
fn layouts(last: KdLayout) -> &'static [KdLayout] {
    let many = KdLayout::ALL.iter().take_while(|layout| **layout != last).count() + 1;
    &KdLayout::ALL[..many]
}

/// How high the rows should be.
pub(super) fn height(last: KdLayout, look: &Look) -> f32 {
    look.text * LARGEST * ROW * layouts(last).len() as f32 + look.margin()
}

/// A row in parts of its letters: how high it is, and where its cache lines stand in it.
const ROW: f32 = 4.3;
const STRIP: f32 = 2.85;

/// The letters of a row in parts of the pane's, where there is room.
const LARGEST: f32 = 1.3;

/// Captions, in parts of the letters beside the rows, and how small a narrow field may make them.
const SMALL: f32 = 0.85;
const LEAST: f32 = 0.7;

/// How wide the box of those bits is that have no room of their own, in bits.
const GATHERED: u32 = 3;

/// One layout of a node.
struct Row {
    node: NodeId,
    leaf: bool,
    /// Whether what stands in the fields is asked for.
    hide: bool,
    /// Whether it is told how many bytes a compiler makes of it.
    compiled: bool,
    u: f32,
    /// The width of a byte.
    byte: f32,
    left: f32,
    y: f32,
}

impl Row {
    fn draw(&self, figure: &mut Figure, layout: KdLayout, fields: &[(&NodeField, u32)], right: f32) {
        let (u, place) = (self.u, Some(Place::Node(self.node)));
        let [printed, compiled] = [Machine::Printed, Machine::Bits64].map(|machine| layout.bytes(machine));
        let edge = self.label_edge();
        let mut label = |down: f32, says: &str, role, face, size| {
            let at = Vec2::new(edge, self.y + u * down);
            write(figure, role, None, at, says, size, face, Anchor::End);
        };
        label(0.85, &format!("{printed} bytes"), Role::Text, Face::Bold, u);
        // What a compiler makes of it where pointers have 64 bits.
        if self.compiled {
            label(2.15, &format!("64 bit: {compiled}"), Role::Quiet, Face::Regular, u * SMALL);
        }

        let width_of = |field: &NodeField| self.byte * Machine::Printed.bytes(field.word) as f32;
        let letters = self.caption_size(fields.iter().map(|(field, _)| (field.name, width_of(field))));
        let (mut x, mut free) = (self.left, 0.0_f32);
        for (field, word) in fields {
            let width = width_of(field);
            let name = if self.hide { "" } else { self.named(field.name) };
            let shown = if self.hide { Some("?".to_owned()) } else { self.says(field, name, *word) };
            let role = if shown.is_some() { Role::Seen } else { Role::Edge };
            // The boxes alone belong to the node: a hovered one lights them, not every word.
            figure.add(role, place, block(Vec2::new(x, self.y), Vec2::new(width, u * 1.7), 0.0));
            let middle = x + width / 2.0;
            self.fitted(figure, Role::Value, Vec2::new(middle, self.y + u * 0.85), &shown.unwrap_or_default(), width);
            // One that is wider than its field pushes the next one on.
            let caption = self.caption(name, width);
            let long = text_width(caption, Face::Regular, letters);
            let at = Vec2::new((middle - long * 0.5).max(free), self.y + u * 2.2);
            write(figure, Role::Quiet, None, at, caption, letters, Face::Regular, Anchor::Start);
            free = at.x + long + u * 0.3;
            x += width;
        }
        if let Some((field, word)) = fields.iter().find(|(field, _)| !field.bits.is_empty() && !self.hide) {
            self.bits(figure, field, *word, x + u * 1.6, right);
        }
    }

    /// Where what stands before the row ends.
    fn label_edge(&self) -> f32 {
        self.left - text_width("  ", Face::Bold, self.u)
    }

    /// Of a name like "child or count", the part that holds for this node.
    fn named(&self, name: &'static str) -> &'static str {
        match name.split_once(" or ") {
            Some((_, of_leaf)) if self.leaf => of_leaf,
            Some((of_inner, _)) => of_inner,
            None => name,
        }
    }

    /// The letters of all captions of a row: so large that each one fits below its field, but for a byte's, which has
    /// room beside it.
    fn caption_size(&self, fields: impl Iterator<Item = (&'static str, f32)>) -> f32 {
        let wide = fields.filter(|(_, width)| *width > self.u * 2.0);
        let fits = wide.map(|(name, width)| {
            let caption = self.caption(self.named(name), width);
            (width - self.u * 0.2) / text_width(caption, Face::Regular, 1.0).max(0.01)
        });
        fits.fold(self.u * SMALL, f32::min).max(self.u * LEAST)
    }

    /// A name as it stands below its field: in one word where there is no room for two.
    fn caption(&self, name: &'static str, width: f32) -> &'static str {
        let words = name.split_once(' ').filter(|_| {
            let least = text_width(name, Face::Regular, self.u * LEAST);
            least > width
        });
        match words {
            Some(("is" | "first", last)) => last,
            Some((first, _)) => first,
            None => name,
        }
    }

    /// What stands in a field; nothing where this kind of node does not need it.
    fn says(&self, field: &NodeField, name: &str, word: u32) -> Option<String> {
        let of_inner = name.contains("axis") || name.contains("position") || name.contains("child");
        let of_leaf = name.contains("object") || name.contains("count");
        if self.leaf && of_inner || !self.leaf && of_leaf {
            return None;
        }
        Some(match field.word {
            Word::Flag if word == 1 => "1".to_owned(),
            Word::Flag => "0".to_owned(),
            Word::Pointer => format!("@{word}"),
            // A place that is a position for inner nodes holds its bits.
            _ if name == "position" => number(f32::from_bits(word)),
            _ if field.bits.is_empty() => word.to_string(),
            _ => format!("{word:#x}"),
        })
    }

    /// The bits of a word, the highest one first, and what each part of them says. Where there is no room for all of
    /// them the highest ones stand there as one box.
    fn bits(&self, figure: &mut Figure, field: &NodeField, word: u32, left: f32, right: f32) {
        let u = self.u;
        // What the bits say may stand a little to the left of them.
        let leftmost = left - u * 1.2;
        // A little air beside each digit.
        let least = u * text_width("0", Face::Mono, 1.0);
        let side = ((right - left) / 32.0).clamp(least, (u * 1.2).max(least));
        let room = ((right - left) / side + 1e-3) as u32;
        if room < GATHERED + 2 {
            return;
        }
        let alone = if room >= 32 { 32 } else { room - GATHERED };
        // From its lowest bit on, how far left of the end so many bits reach.
        let reach = |bits: u32| side * if bits <= alone { bits } else { alone + GATHERED } as f32;
        let left = right - reach(32);
        let height = u * 1.7;
        for bit in 0..alone {
            let set = word >> bit & 1 == 1;
            let corner = Vec2::new(right - reach(bit + 1), self.y);
            figure.add(Role::Edge, None, block(corner, Vec2::new(side, height), 0.0));
            let role = if set { Role::Value } else { Role::Quiet };
            let digit = if set { "1" } else { "0" };
            let size = (side * SMALL / text_width("0", Face::Mono, 1.0)).min(u * 0.9);
            write(figure, role, None, corner + Vec2::new(side, height) / 2.0, digit, size, Face::Mono, Anchor::Middle);
        }
        if alone < 32 {
            let wide = Vec2::new(reach(32) - reach(alone), height);
            figure.add(Role::Edge, None, block(Vec2::new(left, self.y), wide, 0.0));
            let says = if word >> alone == 0 { "0\u{2026}0" } else { "\u{2026}" };
            self.fitted(figure, Role::Quiet, Vec2::new(left, self.y) + wide / 2.0, says, wide.x);
        }
        // The lowest bits stand at the right; names longer than their place push the next ones to the left.
        let long = |name: &str, size: f32| text_width(&format!("{name}: 0"), Face::Regular, size) + u * 0.5;
        let all = |size: f32| field.bits.iter().map(|(name, _)| long(self.named(name), size)).sum::<f32>();
        let letters = u * if all(u * SMALL) > right - leftmost { LEAST } else { SMALL };
        let short = all(letters) > right - leftmost;
        let (mut low, mut free) = (0, right);
        for (name, count) in field.bits {
            let [start, end] = [low + count, low].map(|bits| right - reach(bits));
            let value = word >> low & (1_u64 << count).wrapping_sub(1) as u32;
            figure.add(Role::Seen, None, block(Vec2::new(start, self.y), Vec2::new(end - start, height), 0.0));
            let name = self.named(name);
            let says = format!("{}: {value}", if short { self.caption(name, 0.0) } else { name });
            let long = text_width(&says, Face::Regular, letters);
            let x = (f32::midpoint(start, end) - long / 2.0).min(free - long).max(leftmost);
            let at = Vec2::new(x, self.y + u * 2.2);
            write(figure, Role::Quiet, None, at, &says, letters, Face::Regular, Anchor::Start);
            free = x - u * 0.5;
            low += count;
        }
    }

    /// Text around a middle, in smaller letters if it is too wide; never so small that it cannot be read.
    fn fitted(&self, figure: &mut Figure, role: Role, middle: Vec2, text: &str, width: f32) {
        let (face, largest) = match role {
            Role::Value => (Face::Mono, self.u * 0.95),
            _ => (Face::Regular, self.u * SMALL),
        };
        let size = largest.min((width - self.u * 0.2) / text_width(text, face, 1.0).max(0.01)).max(self.u * LEAST);
        write(figure, role, None, middle, text, size, face, Anchor::Middle);
    }
}
