//! Rows of a race as text, comma-separated values and JSON.

use raystep_fast::{Row, Rung};
use raystep_figure::{number, whole};
use serde::Serialize;

use crate::cli::measure::table::{to_csv, to_json};
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

pub(super) fn text(about: &str, rows: &[Row], rays: usize) -> String {
    let textbook = rows.iter().find(|row| row.rung == Rung::Bvh).and_then(|row| row.told.as_ref().ok());
    let mut page = format!(
        "{about}.\n\n{:<8} {:>9} {:>15} {:>7} {:>10} {:>9} {:>12}  {}\n",
        "rung", "Mrays/s", "least to most", "to bvh", "tests/ray", "build ms", "bytes", "what it is"
    );
    for row in rows {
        let name = row.rung.name();
        page += &match &row.told {
            Ok(told) => {
                let [least, most] = told.spread.map(|speed| number(speed as f32));
                let ratio = textbook.map_or(f64::NAN, |textbook| told.mrays_per_s / textbook.mrays_per_s);
                let line = format!(
                    "{name:<8} {:>9} {:>15} {:>7} {:>10} {:>9} {:>12}  {}",
                    number(told.mrays_per_s as f32),
                    format!("{least}\u{2013}{most}"),
                    number(ratio as f32),
                    number(told.tests_per_ray as f32),
                    number(told.build_ms as f32),
                    whole(told.bytes),
                    short(row.rung)
                );
                line + "\n"
            }
            Err(why) => format!("{name:<8} {why}\n"),
        };
    }
    page += "\nMrays/s: millions of rays a second, the median of several rounds, and the slowest and quickest of them; now, on \
             this\nmachine. All answers were the textbook's before anything was timed.";
    for row in rows {
        if let Ok(told) = &row.told
            && told.rays < rays
        {
            page += &format!("\n{} was asked by {} of the rays.", row.rung.name(), whole(told.rays as u64));
        }
    }
    page + "\nRungs from bvh2 to packets run on one thread and are built on all; each has all that stands above it.\n"
}

/// What a rung is, in as few words as the table has room for.
fn short(rung: Rung) -> &'static str {
    match rung {
        Rung::List | Rung::Grid | Rung::Kd | Rung::Bvh => "textbook",
        Rung::Bvh2 => "lines, stack",
        Rung::Bvh8 => "8 boxes",
        Rung::Packets => "16 rays",
        Rung::Threads => "all threads",
        Rung::Gpu => "graphics card",
    }
}

#[cfg(test)]
mod tests {
    use raystep_fast::Told;

    use super::*;

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
        let page = text("teapot-6321: 6,321 triangles", &rows(), 262_144);
        let widest = page.lines().take_while(|line| !line.starts_with("Mrays/s:")).map(|line| line.chars().count()).max();
        assert!(widest.is_some_and(|widest| widest <= 100), "{widest:?}\n{page}");
        insta::assert_snapshot!(page);
    }

    #[test]
    fn files_hold_these_names_and_no_others() {
        insta::assert_snapshot!(json(&rows()[7..]).unwrap() + &csv(&rows()[7..]).unwrap());
    }
}
