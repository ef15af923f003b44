//! The table of a hashed grid as it lies in memory, slide 63: its slots, those that a look-up looks at, and how many
//! bytes it takes beside a grid that stores all its cells.

use std::collections::BTreeSet;

use glam::Vec2;
use raystep_accel::{AnyGrid, CellId, HashedGrid, Place, Probed, Visit};

use crate::moments::{Moment, Walk};
use crate::page::{Anchor, Figure, Ink, Look, block, line, write};
use crate::theme::{Face, Role, text_width};
use crate::words::whole;

/// The look-up at hand, slot after slot; below it the whole table, and the bytes of both grids. While a question asks
/// what is in a slot, `hide` leaves out what was not looked at yet.
pub(super) fn table(
    grid: &HashedGrid,
    walk: &Walk<'_>,
    moment: &Moment,
    hide: bool,
    size: Vec2,
    look: &Look,
) -> Figure {
    let mut figure = Figure::new(size);
    let slots = grid.slot_count();
    let held = (0..slots).filter(|slot| grid.slot(*slot).is_some()).count();
    let remark = format!(
        "{} slots of {} bytes, {} hold a cell, {} are free",
        whole(slots.into()),
        HashedGrid::SLOT_BYTES,
        whole(held as u64),
        whole((slots as usize - held) as u64)
    );
    let top = look.heading(&mut figure, "Hash table", &remark);
    let width = size.x - 2.0 * look.margin();
    // In a low pane the letters shrink with it.
    let wanted = PROBES + BARS + 3.0 * SLOT;
    let u = look.text.min((size.y - top - look.margin() * 0.5) / wanted).min(width / 34.0);
    let page = Page { grid, hide, u, left: look.margin(), width };
    let events = &walk.events[..moment.step.min(walk.events.len())];
    let probes = last_look_up(events);
    page.look_up(&mut figure, &probes, top);
    let bottom = size.y - look.margin() * 0.5 - u * BARS;
    page.slots(&mut figure, events, &probes, top + u * PROBES, bottom);
    page.memory(&mut figure, bottom);
    figure
}

/// How high the pane should be.
pub(super) fn height(grid: &HashedGrid, look: &Look) -> f32 {
    let rows = grid.slot_count().div_ceil(ACROSS).clamp(1, 4) as f32;
    look.text * (PROBES + BARS + rows * SLOT) + look.margin()
}

/// Heights in parts of the letters: of the look-up, of the bars, and of a row of slots.
const PROBES: f32 = 5.4;
const BARS: f32 = 3.8;
const SLOT: f32 = 1.25;

/// So many slots stand in a row where there is room, and so many rows of a large table are shown.
const ACROSS: u32 = 64;
const MOST_ROWS: u32 = 6;

/// A slot that was looked at for a cell.
#[derive(Clone, Copy)]
struct Probe {
    cell: CellId,
    slot: u32,
    holds: Probed,
}

/// The slots that the last look-up has looked at so far, in order.
fn last_look_up(events: &[Visit]) -> Vec<Probe> {
    let probe = |event: &Visit| match *event {
        Visit::Probe { cell, slot, holds } => Some(Probe { cell, slot, holds }),
        _ => None,
    };
    let end = events.iter().rposition(|event| probe(event).is_some()).map_or(0, |last| last + 1);
    let mut probes: Vec<Probe> = events[..end].iter().rev().map_while(probe).collect();
    probes.reverse();
    // One look-up after the other may follow without any other event between them.
    let first = probes.iter().rposition(|probe| Some(probe.cell) != probes.last().map(|last| last.cell));
    probes.split_off(first.map_or(0, |other| other + 1))
}

struct Page<'a> {
    grid: &'a HashedGrid,
    hide: bool,
    u: f32,
    left: f32,
    width: f32,
}

impl Page<'_> {
    /// The cell, the slot that its number leads to, and the slots from there on: those looked at say what they hold.
    fn look_up(&self, figure: &mut Figure, probes: &[Probe], top: f32) {
        let u = self.u;
        let (Some(first), Some(last)) = (probes.first(), probes.last()) else {
            let at = Vec2::new(self.left, top + u * 1.2);
            write(figure, Role::Quiet, None, at, "No cell has been looked up yet.", u, Face::Regular, Anchor::Start);
            return;
        };
        let cell = Some(Place::Cell(first.cell));
        let high = u * 3.4;
        let middle = top + u * 1.2 + high / 2.0;
        let name = format!("cell {}", first.cell);
        let at = Vec2::new(self.left, middle);
        write(figure, Role::Here, cell, at, &name, u * 1.2, Face::Bold, Anchor::Start);
        let begin = self.left + text_width(&name, Face::Bold, u * 1.2) + u * 0.6;
        let hash = "hash";
        let long = text_width(hash, Face::Regular, u) + u * 1.6;
        let tip = Vec2::new(begin + long, middle);
        figure.add(Role::Quiet, None, line(Vec2::new(begin, middle), tip));
        figure.add(Role::Quiet, None, Ink::Arrowhead { tip, along: Vec2::X, length: u * 0.7 });
        let over = Vec2::new(begin + long * 0.45, middle - u * 0.8);
        write(figure, Role::Quiet, None, over, hash, u, Face::Regular, Anchor::Middle);

        let left = begin + long + u * 0.4;
        let wide = u * 6.2;
        let fits = ((self.left + self.width - left) / wide).floor().max(1.0) as usize;
        // Of a long search the last slots; of a short one also some that it would look at next.
        let skipped = probes.len().saturating_sub(fits);
        let shown = fits.min(probes.len().max(4)).min(self.grid.slot_count() as usize);
        for index in skipped..skipped + shown {
            let slot = (first.slot + index as u32) % self.grid.slot_count();
            let corner = Vec2::new(left + wide * (index - skipped) as f32, top + u * 1.2);
            self.slot(figure, slot, probes.get(index).copied(), slot == last.slot, corner, Vec2::new(wide, high));
        }
    }

    /// One slot, large.
    fn slot(&self, figure: &mut Figure, slot: u32, probe: Option<Probe>, at_hand: bool, corner: Vec2, size: Vec2) {
        let u = self.u;
        let held = self.grid.slot(slot);
        let known = probe.is_some() || !self.hide;
        let place = held.filter(|_| known).map(|(cell, _)| Place::Cell(cell));
        let role = match (known, held, probe) {
            _ if at_hand => Role::Here,
            (_, _, Some(_)) => Role::Seen,
            (true, Some(_), None) => Role::Filled,
            _ => Role::Edge,
        };
        figure.add(role, place, block(corner, size, 0.0));
        let middle = corner.x + size.x / 2.0;
        let mut says = |down: f32, role, text: &str, face, size: f32| {
            write(figure, role, None, Vec2::new(middle, corner.y + u * down), text, size, face, Anchor::Middle);
        };
        says(0.7, Role::Quiet, &format!("slot {slot}"), Face::Regular, u * 0.9);
        let inside = match held {
            _ if !known => "?".to_owned(),
            Some((cell, _)) => format!("cell {cell}"),
            None => "free".to_owned(),
        };
        let role = if probe.is_some() { Role::Value } else { Role::Quiet };
        says(1.75, role, &inside, Face::Medium, u);
        let word = match probe.map(|probe| probe.holds) {
            Some(Probed::Found) => "found",
            Some(Probed::Taken) => "another cell",
            Some(Probed::Empty) => "not stored",
            None => "",
        };
        says(2.8, Role::Text, word, Face::Regular, u * 0.9);
    }

    /// All slots in rows, or as many of a large table as there is room for: those that hold a cell are tinted, those
    /// that this ray has looked at are outlined.
    fn slots(&self, figure: &mut Figure, events: &[Visit], probes: &[Probe], top: f32, bottom: f32) {
        let (u, all) = (self.u, self.grid.slot_count());
        let across = ACROSS.min(all).min(1 << ((self.width / (u * 0.6)).max(1.0) as u32).ilog2());
        let rows = all / across;
        let room = ((bottom - top) / (u * 0.7)).floor().max(0.0) as u32;
        let shown = rows.min(room).min(MOST_ROWS);
        if shown == 0 {
            return;
        }
        let at_hand = probes.last().map_or(0, |probe| probe.slot);
        let first = (at_hand / across).saturating_sub(shown / 2).min(rows - shown);
        let part = shown < rows;
        let caption = if part { u * 1.3 } else { 0.0 };
        let high = ((bottom - top - caption - u * 0.6) / shown as f32).min(u * SLOT);
        let wide = (self.width / across as f32).min(u * 2.0);
        let top = top + caption;
        let slots = first * across..(first + shown) * across;
        if part {
            let says = format!("slots {} to {} of {}", slots.start, slots.end - 1, whole(all.into()));
            let at = Vec2::new(self.left, top - u * 0.7);
            write(figure, Role::Quiet, None, at, &says, u * 0.9, Face::Regular, Anchor::Start);
        }
        let corner = |slot: u32| {
            let at = slot - slots.start;
            Vec2::new(self.left + wide * (at % across) as f32, top + high * (at / across) as f32)
        };
        let cell = Vec2::new(wide, high);
        for row in 0..=shown {
            let from = Vec2::new(self.left, top + high * row as f32);
            figure.add(Role::Edge, None, line(from, from + Vec2::new(wide * across as f32, 0.0)));
        }
        for column in 0..=across {
            let from = Vec2::new(self.left + wide * column as f32, top);
            figure.add(Role::Edge, None, line(from, from + Vec2::new(0.0, high * shown as f32)));
        }
        let probed: BTreeSet<u32> = events
            .iter()
            .filter_map(|event| match event {
                Visit::Probe { slot, .. } => Some(*slot),
                _ => None,
            })
            .collect();
        for slot in slots.clone() {
            let looked_at = probed.contains(&slot);
            let held = self.grid.slot(slot).filter(|_| looked_at || !self.hide);
            if let Some((holds, _)) = held {
                figure.add(Role::Filled, Some(Place::Cell(holds)), block(corner(slot), cell, 0.0));
            }
            if looked_at {
                figure.add(Role::Seen, None, block(corner(slot), cell, 0.0));
            }
        }
        if slots.contains(&at_hand) && !probes.is_empty() {
            figure.add(Role::Here, None, block(corner(at_hand), cell, 0.0));
        }
    }

    /// The bytes of a grid that stores all its cells, and of this one, on one scale.
    fn memory(&self, figure: &mut Figure, top: f32) {
        let u = self.u;
        let (dense, hashed) = (self.grid.dense_bytes(), self.grid.bytes());
        let names = [format!("all {} cells stored", whole(self.grid.cell_count() as u64)), "hashed".to_owned()];
        let longest = names.iter().map(|name| text_width(name, Face::Regular, u)).fold(0.0, f32::max);
        let left = self.left + longest + u * 0.8;
        let says = [dense, hashed].map(|bytes| format!("{} bytes", whole(bytes as u64)));
        let behind = says.iter().map(|says| text_width(says, Face::Bold, u)).fold(0.0, f32::max) + u * 0.8;
        let room = (self.left + self.width - left - behind).max(u);
        for (index, (bytes, says)) in [dense, hashed].into_iter().zip(&says).enumerate() {
            let y = top + u * (0.9 + 1.7 * index as f32);
            let at = Vec2::new(self.left, y);
            write(figure, Role::Text, None, at, &names[index], u, Face::Regular, Anchor::Start);
            let long = (room * bytes as f32 / dense.max(hashed).max(1) as f32).max(2.0);
            let role = if index == 0 { Role::Filled } else { Role::Hit };
            figure.add(role, None, block(Vec2::new(left, y - u * 0.5), Vec2::new(long, u), 0.0));
            let at = Vec2::new(left + long + u * 0.5, y);
            write(figure, Role::Value, None, at, says, u, Face::Bold, Anchor::Start);
        }
    }
}
