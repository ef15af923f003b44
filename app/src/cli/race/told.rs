//! Rows of a race as text, comma-separated values and JSON.

use raystep_fast::{Row, Rung};
use raystep_figure::{number, whole};
use serde::Serialize;

use crate::cli::told::{Align, Grid, Page, to_csv, to_json};
use crate::fault::Fault;

/// A row as files hold it. What a rung that nobody stands on would have is empty, and the note says why.
#[derive(Serialize)]
struct Record {
    name: &'static str,
    mrays_per_s: Option<f64>,
    tests_per_ray: Option<f64>,
    build_ms: Option<f64>,
    bytes: Option<u64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<String>,
}

/// The same with a note in each row, as a table of commas needs it.
#[derive(Serialize)]
struct Commas {
    name: &'static str,
    mrays_per_s: Option<f64>,
    tests_per_ray: Option<f64>,
    build_ms: Option<f64>,
    bytes: Option<u64>,
    note: String,
}

fn record(row: &Row) -> Record {
    let told = row.told.as_ref().ok();
    Record {
        name: row.rung.name(),
        mrays_per_s: told.map(|told| told.mrays_per_s),
        tests_per_ray: told.map(|told| told.tests_per_ray),
        build_ms: told.map(|told| told.build_ms),
        bytes: told.map(|told| told.bytes),
        note: row.told.as_ref().err().cloned(),
    }
}

pub(super) fn json(rows: &[Row]) -> Result<String, Fault> {
    to_json(&rows.iter().map(record).collect::<Vec<_>>())
}

pub(super) fn csv(rows: &[Row]) -> Result<String, Fault> {
    let commas = rows.iter().map(|row| {
        let Record { name, mrays_per_s, tests_per_ray, build_ms, bytes, note } = record(row);
        Commas { name, mrays_per_s, tests_per_ray, build_ms, bytes, note: note.unwrap_or_default() }
    });
    to_csv(commas)
}

/// The page: a table, and what has to be said of it.
pub(super) fn page(about: &str, rows: &[Row], rays: usize) -> Page {
    let textbook = rows.iter().find(|row| row.rung == Rung::Bvh).and_then(|row| row.told.as_ref().ok());
    let mut page = Page::default();
    page.text(format!("{about}."));
    let heads = ["Mrays/s", "least\u{2013}most", "to bvh", "tests per ray", "build ms", "bytes"];
    let heads = heads.into_iter().map(|head| (head, Align::Right));
    let mut grid = Grid::new([("rung", Align::Left)].into_iter().chain(heads).chain([("what it is", Align::Left)]));
    for row in rows {
        let mut cells = vec![row.rung.name().to_owned()];
        match &row.told {
            Ok(told) => {
                let [least, most] = told.spread.map(|speed| number(speed as f32));
                let ratio = textbook.map_or(f64::NAN, |textbook| told.mrays_per_s / textbook.mrays_per_s);
                let [speed, ratio, tests, build_ms] =
                    [told.mrays_per_s, ratio, told.tests_per_ray, told.build_ms].map(|value| number(value as f32));
                cells.extend([speed, format!("{least}\u{2013}{most}"), ratio, tests, build_ms, whole(told.bytes)]);
                cells.push(row.rung.about().to_owned());
            }
            Err(why) => {
                cells.extend([const { String::new() }; 6]);
                cells.push(why.clone());
            }
        }
        grid.row(cells);
    }
    page.table(grid);
    page.text(
        "Mrays/s are millions of rays a second, now, on this machine: the median of several rounds, then the slowest and \
         the quickest of them. Before anything was timed, all answers were the textbook's. Rungs up to packets run on one \
         thread; from bvh2 on they are built on all, and each has all that stands above it.",
    );
    let fewer = rows.iter().filter_map(|row| Some((row.rung, row.told.as_ref().ok()?.rays)));
    let fewer = fewer.filter(|(_, own)| *own < rays);
    page.lines(
        fewer.map(|(rung, own)| format!("{} was asked by {} of the rays.", rung.name(), whole(own as u64))).collect(),
    );
    page
}

#[cfg(test)]
mod tests {
    use raystep_fast::Told;

    use super::*;
    use crate::cli::told::Format;

    fn rows() -> Vec<Row> {
        let told = |speed: f64, tests: f64, rays| Told {
            mrays_per_s: speed,
            spread: [speed * 0.96, speed * 1.03],
            rounds: 9,
            rays,
            tests_per_ray: tests,
            build_ms: 13.25,
            bytes: 1_234_567,
        };
        let row = |rung: Rung| {
            let told = match rung {
                Rung::List => Ok(told(0.0123, 6321.0, 1024)),
                Rung::Packets => Err("no packets in this build".to_owned()),
                Rung::Gpu => Err("no GPU walk in this build".to_owned()),
                _ => Ok(told(1.5, 4.25, 262_144)),
            };
            Row { rung, told }
        };
        Rung::ALL.map(row).to_vec()
    }

    #[test]
    fn a_table_is_at_most_a_hundred_letters_wide() {
        let page = page("teapot-6321: 6,321 triangles", &rows(), 262_144).written(Format::Text);
        let widest = page.lines().map(|line| line.chars().count()).max();
        assert!(widest.is_some_and(|widest| widest <= 100), "{widest:?}\n{page}");
        for says in ["no GPU walk in this build", "no packets in this build", "list was asked by 1024 of the rays."] {
            assert!(page.contains(says), "{says}\n{page}");
        }
    }

    #[test]
    fn files_hold_these_names_and_no_others() {
        let json: serde_json::Value = serde_json::from_str(&json(&rows()).unwrap()).unwrap();
        let names = ["name", "mrays_per_s", "tests_per_ray", "build_ms", "bytes"];
        for (row, told) in json.as_array().unwrap().iter().zip(rows()) {
            let row = row.as_object().unwrap();
            assert_eq!(row["name"], told.rung.name());
            let note = told.told.is_err().then_some("note");
            let mut wanted: Vec<&str> = names.into_iter().chain(note).collect();
            wanted.sort_unstable();
            let mut found: Vec<&str> = row.keys().map(String::as_str).collect();
            found.sort_unstable();
            assert_eq!(found, wanted);
            assert_eq!(row["bytes"].is_null(), told.told.is_err());
        }
        let csv = csv(&rows()).unwrap();
        assert_eq!(csv.lines().next(), Some("name,mrays_per_s,tests_per_ray,build_ms,bytes,note"));
        assert_eq!(csv.lines().last(), Some("gpu,,,,,no GPU walk in this build"));
    }
}
