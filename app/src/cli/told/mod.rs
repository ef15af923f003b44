//! What a command tells: paragraphs and tables, for a terminal, for Markdown and for LaTeX.

mod escaped;
mod grid;

use clap::ValueEnum;
use serde::Serialize;

use self::escaped::latex;
pub(super) use self::grid::{Align, Grid};
use crate::fault::Fault;

/// How what was found is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// To be read on a terminal, at most a hundred columns wide.
    Text,
    /// Markdown.
    Md,
    /// LaTeX, for a document without further packages.
    Latex,
    /// Comma-separated values, in full precision.
    Csv,
    /// JSON, in full precision.
    Json,
}

impl Format {
    /// The format that a file's name asks for by its ending.
    pub(super) fn of_ending(path: &std::path::Path) -> Option<Format> {
        let ending = path.extension()?.to_str()?.to_lowercase();
        let formats = [("md", Format::Md), ("tex", Format::Latex), ("csv", Format::Csv), ("json", Format::Json)];
        formats.into_iter().find(|(known, _)| *known == ending).map(|(_, format)| format)
    }
}

/// Comma-separated values under their names.
pub(super) fn to_csv(records: impl Iterator<Item = impl Serialize>) -> Result<String, Fault> {
    let broken = |error: &dyn std::fmt::Display| Fault::new(error.to_string());
    let mut writer = csv::Writer::from_writer(Vec::new());
    for record in records {
        writer.serialize(record).map_err(|error| broken(&error))?;
    }
    let bytes = writer.into_inner().map_err(|error| broken(&error))?;
    String::from_utf8(bytes).map_err(|error| broken(&error))
}

/// JSON with a line's end.
pub(super) fn to_json(records: &impl Serialize) -> Result<String, Fault> {
    let json = serde_json::to_string_pretty(records).map_err(|error| Fault::new(error.to_string()))?;
    Ok(json + "\n")
}

/// The columns of a terminal that a page fills at most.
pub(super) const COLUMNS: usize = 100;

/// A part of a page.
enum Part {
    Heading(String),
    Text(String),
    /// One line below the other.
    Lines(Vec<String>),
    Table(Grid),
}

/// Headings, paragraphs and tables, one below the other.
#[derive(Default)]
pub(super) struct Page(Vec<Part>);

impl Page {
    /// A heading.
    pub(super) fn heading(&mut self, text: impl Into<String>) {
        self.0.push(Part::Heading(text.into()));
    }

    /// A paragraph.
    pub(super) fn text(&mut self, text: impl Into<String>) {
        self.0.push(Part::Text(text.into()));
    }

    /// Lines of their own.
    pub(super) fn lines(&mut self, lines: Vec<String>) {
        self.0.push(Part::Lines(lines));
    }

    /// A table.
    pub(super) fn table(&mut self, grid: Grid) {
        self.0.push(Part::Table(grid));
    }

    /// The page as it is written; what is meant for programs is not a page.
    pub(super) fn written(&self, format: Format) -> String {
        let parts = self.0.iter().map(|part| match format {
            Format::Md => part.markdown(),
            Format::Latex => part.latex(),
            Format::Text | Format::Csv | Format::Json => part.plain(),
        });
        parts.collect::<Vec<_>>().join("\n")
    }
}

impl Part {
    fn plain(&self) -> String {
        match self {
            Part::Heading(text) | Part::Text(text) => wrapped(text, COLUMNS, ""),
            Part::Lines(lines) => lines.iter().map(|line| wrapped(line, COLUMNS, "    ")).collect(),
            Part::Table(grid) => grid.plain(),
        }
    }

    fn markdown(&self) -> String {
        match self {
            Part::Heading(text) => format!("### {}\n", escaped::markdown(text)),
            Part::Text(text) => format!("{}\n", escaped::markdown(text)),
            Part::Lines(lines) => lines.iter().map(|line| format!("- {}\n", escaped::markdown(line))).collect(),
            Part::Table(grid) => grid.markdown(),
        }
    }

    fn latex(&self) -> String {
        match self {
            Part::Heading(text) => format!("\\subsection*{{{}}}\n", latex(text)),
            Part::Text(text) => wrapped(&latex(text), COLUMNS, ""),
            Part::Lines(lines) => {
                let items: String = lines.iter().map(|line| format!("\\item {}\n", latex(line))).collect();
                format!("\\begin{{itemize}}\n{items}\\end{{itemize}}\n")
            }
            Part::Table(grid) => grid.latex(),
        }
    }
}

/// A text in lines of so many columns, each but the first after an indent.
fn wrapped(text: &str, columns: usize, indent: &str) -> String {
    let lines = grid::broken(text, columns.saturating_sub(indent.len()));
    lines.iter().enumerate().map(|(i, line)| format!("{}{line}\n", if i > 0 { indent } else { "" })).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn page() -> Page {
        let mut page = Page::default();
        page.heading("Slide 22 & more");
        page.text("A test is a ray against a primitive: 100 % of them | count. ".repeat(4));
        let mut grid =
            Grid::new([("row", Align::Left), ("tests per ray", Align::Right), ("what happens", Align::Left)]);
        grid.row(["list".to_owned(), "6,321".to_owned(), "All_of them, −1 → ∞. ".repeat(9)]);
        grid.row(["kd a|b".to_owned(), "2.8".to_owned(), String::new()]);
        page.table(grid);
        page.lines(vec!["kd max_depth=8 ".repeat(9), "bvh".to_owned()]);
        page
    }

    #[test]
    fn a_page_reads_well_in_every_format() {
        let formats = [Format::Text, Format::Md, Format::Latex];
        let written = formats.map(|format| page().written(format)).join("\n=====\n");
        insta::assert_snapshot!(written);
    }

    #[test]
    fn text_never_runs_out_of_a_terminal() {
        for line in page().written(Format::Text).lines() {
            assert!(line.chars().count() <= COLUMNS && line.trim_end() == line, "{line:?}");
        }
    }

    #[test]
    fn an_ending_says_the_format() {
        let of = |name: &str| Format::of_ending(std::path::Path::new(name));
        assert_eq!((of("a.CSV"), of("b.c.tex")), (Some(Format::Csv), Some(Format::Latex)));
        assert_eq!((of("walk"), of("walk.txt")), (None, None));
    }
}
