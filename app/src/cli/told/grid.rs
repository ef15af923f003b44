//! A table of words and numbers.

use super::COLUMNS;
use super::escaped::{latex, markdown};

/// On which side of its column a cell stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::cli) enum Align {
    Left,
    Right,
}

/// Rows below the heads of their columns.
pub(in crate::cli) struct Grid {
    heads: Vec<(String, Align)>,
    rows: Vec<Vec<String>>,
}

/// Between two columns of a text.
const GAP: usize = 2;

/// A column of words is never narrower than this.
const NARROWEST: usize = 12;

impl Grid {
    /// A table with these columns and no row yet.
    pub(in crate::cli) fn new(heads: impl IntoIterator<Item = (&'static str, Align)>) -> Grid {
        let heads = heads.into_iter().map(|(head, align)| (head.to_owned(), align)).collect();
        Grid { heads, rows: Vec::new() }
    }

    /// Adds a row: a cell for each column.
    pub(in crate::cli) fn row(&mut self, cells: impl IntoIterator<Item = String>) {
        let mut cells: Vec<String> = cells.into_iter().collect();
        cells.resize(self.heads.len(), String::new());
        self.rows.push(cells);
    }

    /// For a terminal: heads and words are broken into several lines where the columns are full.
    pub(super) fn plain(&self) -> String {
        let widths = self.widths();
        let heads: Vec<&str> = self.heads.iter().map(|(head, _)| head.as_str()).collect();
        let mut text = self.line(&heads, &widths, true);
        for row in &self.rows {
            text += &self.line(&row.iter().map(String::as_str).collect::<Vec<_>>(), &widths, false);
        }
        text
    }

    fn widths(&self) -> Vec<usize> {
        let longest = |words: &str| words.split_whitespace().map(count).max().unwrap_or(0);
        let cells = |column: usize| self.rows.iter().map(move |row| count(&row[column])).max().unwrap_or(0);
        let width = |(column, (head, _)): (usize, &(String, Align))| longest(head).max(cells(column));
        let mut widths: Vec<usize> = self.heads.iter().enumerate().map(width).collect();
        let over = (widths.iter().sum::<usize>() + GAP * widths.len().saturating_sub(1)).saturating_sub(COLUMNS);
        let words = self.heads.iter().enumerate().filter(|(_, (_, align))| *align == Align::Left);
        if let Some(widest) = words.map(|(column, _)| column).max_by_key(|column| widths[*column]) {
            widths[widest] = widths[widest].saturating_sub(over).max(NARROWEST.min(widths[widest]));
        }
        widths
    }

    /// A row, its cells broken where they are too wide; `low` stands them on the last line instead of on the first.
    fn line(&self, cells: &[&str], widths: &[usize], low: bool) -> String {
        let cells: Vec<Vec<String>> = cells.iter().zip(widths).map(|(cell, width)| broken(cell, *width)).collect();
        let high = cells.iter().map(Vec::len).max().unwrap_or(0);
        let mut text = String::new();
        for at in 0..high {
            let mut line = String::new();
            for (column, cell) in cells.iter().enumerate() {
                let above = if low { high - cell.len() } else { 0 };
                let part = at.checked_sub(above).and_then(|at| cell.get(at)).map_or("", String::as_str);
                let room = " ".repeat(widths[column].saturating_sub(count(part)));
                let gap = if column > 0 { " ".repeat(GAP) } else { String::new() };
                line += &gap;
                line += &match self.heads[column].1 {
                    Align::Left => format!("{part}{room}"),
                    Align::Right => format!("{room}{part}"),
                };
            }
            text += line.trim_end();
            text.push('\n');
        }
        text
    }

    /// For Markdown.
    pub(super) fn markdown(&self) -> String {
        let line = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
        let mut text = line(self.heads.iter().map(|(head, _)| markdown(head)).collect());
        let rule = |(_, align): &(String, Align)| if *align == Align::Left { ":---" } else { "---:" }.to_owned();
        text += &line(self.heads.iter().map(rule).collect());
        for row in &self.rows {
            text += &line(row.iter().map(|cell| markdown(cell)).collect());
        }
        text
    }

    /// For LaTeX. Of heads with several words each stands on a line of its own, and long words of a row are broken.
    pub(super) fn latex(&self) -> String {
        let broad = |column: usize| self.rows.iter().any(|row| count(&row[column]) > 40);
        let kinds = self.heads.iter().enumerate().map(|(column, (_, align))| match align {
            Align::Left if broad(column) => "p{0.55\\linewidth}",
            Align::Left => "l",
            Align::Right => "r",
        });
        let head = |(column, (head, align)): (usize, &(String, Align))| {
            let words: Vec<String> = head.split_whitespace().map(latex).collect();
            let kind = if *align == Align::Left { "l" } else { "r" };
            match words.len() {
                0 | 1 => words.concat(),
                _ if broad(column) => words.join(" "),
                _ => format!("\\begin{{tabular}}[b]{{@{{}}{kind}@{{}}}}{}\\end{{tabular}}", words.join("\\\\")),
            }
        };
        let line = |cells: Vec<String>| format!("{} \\\\\n", cells.join(" & "));
        let mut text = format!("\\begin{{tabular}}{{{}}}\n\\hline\n", kinds.collect::<String>());
        text += &line(self.heads.iter().enumerate().map(head).collect());
        text += "\\hline\n";
        for row in &self.rows {
            text += &line(row.iter().map(|cell| latex(cell)).collect());
        }
        text + "\\hline\n\\end{tabular}\n"
    }
}

fn count(text: &str) -> usize {
    text.chars().count()
}

/// A text in lines of at most so many letters, broken between words, and in a word that is longer.
pub(super) fn broken(text: &str, width: usize) -> Vec<String> {
    let width = width.max(1);
    let mut lines: Vec<String> = Vec::new();
    let mut line = String::new();
    for word in text.split_whitespace() {
        let mut word = word;
        if !line.is_empty() && count(&line) + 1 + count(word) > width {
            lines.push(std::mem::take(&mut line));
        }
        while count(word) > width && line.is_empty() {
            let end = word.char_indices().nth(width).map_or(word.len(), |(end, _)| end);
            lines.push(word[..end].to_owned());
            word = &word[end..];
        }
        if !word.is_empty() {
            if !line.is_empty() {
                line.push(' ');
            }
            line += word;
        }
    }
    if !line.is_empty() || lines.is_empty() {
        lines.push(line);
    }
    lines
}
