//! Small tables of numbers.

use glam::Vec2;
use raystep_accel::Place;

use crate::page::{Anchor, Figure, Look, block, write};
use crate::theme::{Face, Role, text_width};

/// A number or word in a table.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Entry {
    pub(crate) text: String,
    pub(crate) role: Role,
}

/// Numbers in rows and columns, right-aligned under their headings.
#[derive(Clone, Debug, Default)]
pub(crate) struct Table {
    pub(crate) heads: Vec<&'static str>,
    pub(crate) rows: Vec<Vec<Entry>>,
    /// A row to be marked.
    pub(crate) current: Option<usize>,
    pub(crate) place: Option<Place>,
}

impl Entry {
    pub(crate) fn new(text: impl Into<String>, role: Role) -> Entry {
        Entry { text: text.into(), role }
    }

    /// Not known yet.
    pub(crate) fn none() -> Entry {
        Entry::new("", Role::Quiet)
    }
}

/// How high a row is in its letters, where there is room and where there is little.
const APART: f32 = 1.9;
pub(crate) const CLOSE: f32 = 1.4;

/// Most spare room between two columns, in letters.
const SPARE: f32 = 2.0;

impl Table {
    /// Draws the table from `top` to at most `bottom`, in smaller letters if it is too large. Returns where it ends.
    pub(crate) fn draw(&self, figure: &mut Figure, top: f32, bottom: f32, look: &Look) -> f32 {
        let room = figure.size.x - 2.0 * look.margin();
        let natural = self.widths(look.text);
        let total: f32 = natural.iter().sum();
        // Rows stand closer before their letters are smaller.
        let high = (bottom - top) / (self.rows.len() as f32 + 1.0);
        let size = look.text * (room / total.max(1.0)).min(high / (look.text * CLOSE)).clamp(0.6, 1.0);
        let widths = self.widths(size);
        // Spare room goes between the columns, up to a point: eyes follow short rows.
        let used: f32 = widths.iter().sum();
        let spare = ((room - used) / widths.len().max(1) as f32).clamp(0.0, size * SPARE);
        let row_height = (size * APART).min(high.max(size * CLOSE));

        let rights: Vec<f32> = widths
            .iter()
            .scan(look.margin() - spare, |x, width| {
                *x += width + spare;
                Some(*x)
            })
            .collect();
        let mut y = top + row_height * 0.5;
        for (head, right) in self.heads.iter().zip(&rights) {
            let at = Vec2::new(*right, y);
            write(figure, Role::Quiet, self.place, at, head, size * 0.92, Face::Regular, Anchor::End);
        }
        for (index, row) in self.rows.iter().enumerate() {
            y += row_height;
            if self.current == Some(index) {
                let corner = Vec2::new(look.margin() * 0.5, y - row_height * 0.5);
                let right = rights.last().copied().unwrap_or(0.0) + look.margin() * 0.5;
                figure.add(
                    Role::Ground,
                    self.place,
                    block(corner, Vec2::new(right - corner.x, row_height), size * 0.2),
                );
            }
            for (column, (entry, right)) in row.iter().zip(&rights).enumerate() {
                let face = if column == 0 { Face::Bold } else { Face::Mono };
                let face = if column > 0 && entry.role == Role::Value { Face::MonoMedium } else { face };
                let at = Vec2::new(*right, y);
                write(figure, entry.role, self.place, at, &entry.text, size, face, Anchor::End);
            }
        }
        y + row_height * 0.5
    }

    /// How wide it is at most in letters of this size.
    pub(crate) fn width(&self, size: f32) -> f32 {
        self.widths(size).iter().map(|width| width + size * SPARE).sum()
    }

    /// How high it is at least in letters of this size.
    pub(crate) fn height(&self, size: f32) -> f32 {
        size * CLOSE * (self.rows.len() as f32 + 1.0)
    }

    fn widths(&self, size: f32) -> Vec<f32> {
        let gap = size * 0.9;
        let column = |index: usize| {
            let head = text_width(self.heads[index], Face::Regular, size * 0.92);
            let cells = self.rows.iter().filter_map(|row| row.get(index));
            cells.map(|entry| text_width(&entry.text, Face::Mono, size)).fold(head, f32::max)
        };
        (0..self.heads.len()).map(|index| column(index) + if index == 0 { 0.0 } else { gap }).collect()
    }
}
