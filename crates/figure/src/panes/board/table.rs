//! A table: rows that come to be seen one after the other, numbers aligned on their points.

use glam::Vec2;

use super::known::{Known, WAITS, heading, legend};
use super::{Filled, place};
use crate::page::{Anchor, Figure, Look, block, line, write};
use crate::theme::{Face, Role, text_width};
use crate::words::ROUGH;

/// A table of a board.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// What it is about.
    pub title: String,
    /// What stands behind the title.
    pub about: String,
    /// The head of the first column: what a row is.
    pub of: String,
    /// The other columns.
    pub columns: Vec<Column>,
    /// The rows.
    pub rows: Vec<Row>,
}

/// A column.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// What stands above it; words that stand above several columns come first, before a `|`.
    pub head: String,
    /// What its numbers are.
    pub role: Role,
    /// Whether a row shows it while a question about the row is open.
    pub given: bool,
    /// Whether it holds words or code, which begin below each other.
    pub words: bool,
    /// Whether its numbers are counted of rays: of few of them only roughly.
    pub rays: bool,
    /// For so many digits there is room, before any are known.
    pub digits: usize,
}

/// A row.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// When it comes to be seen.
    pub entry: usize,
    /// What it is about.
    pub name: String,
    /// A few words behind the name.
    pub note: String,
    /// What stands in its columns; nothing where a row has none.
    pub cells: Vec<String>,
    /// How well its numbers are known.
    pub known: Known,
}

/// What stands in columns of times where none are told; beside each other they say it once.
pub const ELSEWHERE: &str = "in the window";

/// How the rows of a board's tables are set.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lines {
    /// The size of the letters.
    pub(super) text: f32,
    /// A row's height in letters.
    pub(super) row: f32,
    /// Whether notes stand below their names, and long heads take two lines.
    pub(super) narrow: bool,
}

/// Where a table's columns lie.
struct Set {
    /// The widths of the columns, the first one that of the names.
    widths: Vec<f32>,
    gap: f32,
}

/// Most that letters grow where there is room, where nothing else stands there, and where pictures do; and least that
/// they shrink.
pub(super) const LARGEST: f32 = 1.5;
pub(super) const ALONE: f32 = 2.0;
pub(super) const BESIDE: f32 = 1.15;
pub(super) const SMALLEST: f32 = 0.72;
/// The room of the heading, in letters of the board.
const HEAD: f32 = 3.0;
/// A row's height in letters, where there is room and where there is little; and the same where notes stand below names.
pub(super) const ROW: f32 = 2.5;
pub(super) const CLOSE: f32 = 1.8;
pub(super) const TWO: f32 = 3.0;
pub(super) const TWO_CLOSE: f32 = 2.7;

impl Table {
    /// How high it stands in letters of this size.
    pub(super) fn height(&self, Lines { text, row, narrow }: Lines, look: &Look) -> f32 {
        look.text * HEAD + text * (row * self.rows.len() as f32 + self.head_lines(narrow) as f32 * 1.5 + 0.8)
    }

    /// The largest letters in which it is no wider than this.
    pub(super) fn across(&self, width: f32, narrow: bool, look: &Look) -> f32 {
        let natural: f32 = self.widths(1.0, narrow).iter().map(|width| width + GAP).sum();
        (width - 2.0 * look.margin()) / natural
    }

    /// How wide and how high it is at least, in letters.
    pub(super) fn letters(&self) -> [f32; 2] {
        let natural: f32 = self.widths(1.0, false).iter().map(|width| width + GAP).sum();
        [
            natural * 0.9 + 2.0,
            0.9 * (CLOSE * (self.rows.len() as f32 + 1.0) + self.head_lines(false) as f32 * 1.5) + 3.5,
        ]
    }

    /// How many lines the longest head has.
    fn head_lines(&self, narrow: bool) -> usize {
        self.columns.iter().map(|column| lines_of(&column.head, narrow).len()).max().unwrap_or(1)
    }

    fn set(&self, room: Vec2, Lines { text, narrow, .. }: Lines, look: &Look) -> Set {
        let widths = self.widths(text, narrow);
        let used: f32 = widths.iter().sum();
        // Eyes follow short rows: spare room goes between the columns, up to a point.
        let gap = ((room.x - 2.0 * look.margin() - used) / widths.len() as f32).clamp(text * 0.8, text * APART);
        Set { widths, gap }
    }

    fn widths(&self, text: f32, narrow: bool) -> Vec<f32> {
        let name = |row: &Row| {
            let name = text_width(&row.name, Face::Bold, text);
            let note = text_width(&row.note, Face::Regular, text * 0.9);
            match () {
                () if row.note.is_empty() => name,
                () if narrow => name.max(note),
                () => name + text * 0.7 + note,
            }
        };
        let first = self.rows.iter().map(name).fold(text_width(&self.of, Face::Regular, text * 0.9), f32::max);
        let column = |index: usize| {
            let head = lines_of(&self.columns[index].head, narrow);
            let head =
                head.iter().map(|(line, _)| text_width(line, Face::Regular, text * 0.9)).fold(text * 2.5, f32::max);
            let (before, behind) = self.around_points(index, text);
            let waits = text_width("0", Face::Mono, text) * self.columns[index].digits as f32;
            head.max(before + behind).max(waits)
        };
        std::iter::once(first).chain((0..self.columns.len()).map(column)).collect()
    }

    /// A cell, cut before its point if all in its column are bare numbers; else all of it.
    fn at_point<'a>(&self, column: usize, cell: &'a str) -> (&'a str, &'a str) {
        let bare = |cell: &str| cell.bytes().all(|byte| byte.is_ascii_digit() || matches!(byte, b',' | b'.'));
        let mut cells = self.rows.iter().filter_map(|row| row.cells.get(column));
        match cell.find('.').filter(|_| cells.all(|cell| bare(cell) || cell == "\u{2013}" || cell == WAITS)) {
            Some(at) => cell.split_at(at),
            None => (cell, ""),
        }
    }

    /// The most room that the numbers of a column need before and behind their points.
    fn around_points(&self, column: usize, text: f32) -> (f32, f32) {
        let cells = self.rows.iter().filter(|row| row.across(column) == 1).filter_map(|row| row.cells.get(column));
        let parts = cells.map(|cell| {
            let (before, behind) = self.at_point(column, cell);
            (text_width(before, Face::Mono, text), text_width(behind, Face::Mono, text))
        });
        parts.fold((0.0, 0.0), |(a, b), (before, behind)| (a.max(before), b.max(behind)))
    }
}

impl Table {
    /// What the signs in its rows mean, of those that are seen.
    fn legend(&self, filled: Filled) -> Option<String> {
        let seen = self.rows.iter().filter(|row| filled.shows(row.entry));
        let cells =
            seen.flat_map(|row| self.columns.iter().zip(&row.cells).map(move |(column, cell)| (row, column, cell)));
        let known = cells.filter_map(|(row, column, cell)| match () {
            () if row.is_rough(column, cell) => Some(Known::Roughly),
            () if cell == WAITS => Some(Known::NotYet),
            () => None,
        });
        legend(known)
    }
}

impl Row {
    /// Across how many columns the words in this one stand; across none where they stand further left already.
    fn across(&self, column: usize) -> usize {
        let same = |column: usize| self.cells.get(column).is_some_and(|cell| cell == ELSEWHERE);
        match () {
            () if !same(column) => 1,
            () if column > 0 && same(column - 1) => 0,
            () => (column..).take_while(|&column| same(column)).count(),
        }
    }

    /// Whether a number of it is told by few rays.
    fn is_rough(&self, column: &Column, cell: &str) -> bool {
        self.known == Known::Roughly && column.rays && cell.contains(|letter: char| letter.is_ascii_digit())
    }
}

/// Most spare room between two columns, in letters.
const APART: f32 = 8.0;

/// Room between two columns, at least, in letters.
const GAP: f32 = 1.6;

/// A longer line of a head is parted in a narrow table.
const LONG: usize = 12;

/// The lines of a head, written with `|` between them, and whether each stands above several columns.
fn lines_of(head: &str, narrow: bool) -> Vec<(&str, bool)> {
    let lines: Vec<&str> = head.split('|').map(str::trim).collect();
    let several = lines.len() > 1;
    let mut all = Vec::new();
    for (index, line) in lines.into_iter().enumerate() {
        let above = several && index == 0;
        // At the blank that is nearest to its middle.
        let blanks = line.match_indices(' ').map(|(at, _)| at);
        let middle = blanks.min_by_key(|at| (at * 2).abs_diff(line.len()));
        match middle.filter(|_| narrow && !above && line.len() > LONG) {
            Some(at) => all.extend([(&line[..at], false), (&line[at + 1..], false)]),
            None => all.push((line, above)),
        }
    }
    all
}

pub(super) fn draw(table: &Table, filled: Filled, room: Vec2, lines: Lines, look: &Look) -> Figure {
    let mut figure = Figure::new(room);
    let top = heading(look, &mut figure, &table.title, &table.about, table.legend(filled)) + look.text * 0.6;
    let Set { widths, gap } = table.set(room, lines, look);
    let Lines { text, row, narrow } = lines;
    let left = look.margin();
    // The right ends of the columns; a column's share of spare room lies before it.
    let ends: Vec<f32> = widths
        .iter()
        .scan(left - gap, |x, width| {
            *x += width + gap;
            Some(*x)
        })
        .collect();
    let right = ends.last().copied().unwrap_or(left);
    let heads = table.head_lines(narrow);
    let small = text * 0.9;
    let head_bottom = top + heads as f32 * text * 1.5;
    let at = Vec2::new(left, head_bottom - text * 0.9);
    write(&mut figure, Role::Quiet, None, at, &table.of, small, Face::Regular, Anchor::Start);
    for ((column, end), wide) in table.columns.iter().zip(&ends[1..]).zip(&widths[1..]) {
        let lines = lines_of(&column.head, narrow);
        let (x, anchor) = if column.words { (end - wide, Anchor::Start) } else { (*end, Anchor::End) };
        for (index, (head, above)) in lines.iter().rev().enumerate() {
            let at = Vec2::new(x, head_bottom - text * 0.9 - index as f32 * text * 1.35);
            let face = if *above { Face::Bold } else { Face::Regular };
            write(&mut figure, Role::Quiet, None, at, head, small, face, anchor);
        }
    }
    figure.add(Role::Text, None, line(Vec2::new(left, head_bottom), Vec2::new(right, head_bottom)));

    let high = text * row;
    for (index, row) in table.rows.iter().enumerate() {
        let y = head_bottom + high * (index as f32 + 0.5);
        let (shown, asked) = (filled.shows(row.entry), filled.is_asked(row.entry));
        let place = place(row.entry).filter(|_| shown);
        if filled.is_new(row.entry) || asked {
            // A little beyond its words, but not out of the pane.
            let aside = (text * 0.6).min(left);
            let corner = Vec2::new(left - aside, y - high * 0.5);
            figure.add(Role::Ground, place, block(corner, Vec2::new(right - left + aside * 2.0, high), text * 0.2));
        }
        let name = if shown || asked { Role::Text } else { Role::Quiet };
        let below = narrow && !row.note.is_empty();
        let at = Vec2::new(left, if below { y - text * 0.6 } else { y });
        write(&mut figure, name, place, at, &row.name, text, Face::Bold, Anchor::Start);
        let beside = Vec2::new(text_width(&row.name, Face::Bold, text) + text * 0.7, 0.0);
        let at = at + if below { Vec2::new(0.0, text * 1.25) } else { beside };
        write(&mut figure, Role::Quiet, place, at, &row.note, small, Face::Regular, Anchor::Start);
        for (index, (column, end)) in table.columns.iter().zip(&ends[1..]).enumerate() {
            let Some(cell) = row.cells.get(index).filter(|cell| !cell.is_empty()) else { continue };
            let across = row.across(index);
            if asked && !column.given {
                let width = if across == 1 { text_width(cell, Face::Mono, text) } else { 0.0 }.max(text * 2.2);
                let corner = Vec2::new(end - width, y - text * 0.75);
                figure.add(Role::Guess, None, block(corner, Vec2::new(width, text * 1.5), text * 0.3));
                let at = Vec2::new(end - width * 0.5, y);
                write(&mut figure, Role::Guess, None, at, "?", text, Face::Bold, Anchor::Middle);
            } else if across != 1 {
                let (from, to) = (end - widths[index + 1], ends[index + across]);
                let at = Vec2::new((from + to) * 0.5, y);
                if (shown || asked) && across > 1 {
                    write(&mut figure, Role::Quiet, place, at, cell, text, Face::Mono, Anchor::Middle);
                }
            } else if (shown || asked) && column.words {
                let at = Vec2::new(end - widths[index + 1], y);
                write(&mut figure, column.role, place, at, cell, text, Face::Mono, Anchor::Start);
            } else if shown || asked {
                let (before, behind) = table.at_point(index, cell);
                let (_, after) = table.around_points(index, text);
                let at = Vec2::new(end - after, y);
                let rough = row.is_rough(column, cell);
                let role = if rough || cell == WAITS { Role::Quiet } else { column.role };
                if rough {
                    let left = at - Vec2::new(text_width(before, Face::Mono, text), 0.0);
                    write(&mut figure, role, place, left, ROUGH, text, Face::Regular, Anchor::End);
                }
                write(&mut figure, role, place, at, before, text, Face::Mono, Anchor::End);
                write(&mut figure, role, place, at, behind, text, Face::Mono, Anchor::Start);
            }
        }
        let below = y + high * 0.5;
        figure.add(Role::Panel, None, line(Vec2::new(left, below), Vec2::new(right, below)));
    }
    figure
}
