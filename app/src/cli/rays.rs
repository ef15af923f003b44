//! A table of rays as comma-separated values.

use glam::Vec3;
use raystep_accel::Ray;

use crate::fault::Fault;

/// The columns, the last two of which may be left out.
const COLUMNS: [&str; 8] = ["ox", "oy", "oz", "dx", "dy", "dz", "t_min", "t_max"];

/// The rays of a table: of each row its ray, or a sentence that says why there is none.
///
/// # Errors
/// It is no table of rays.
pub fn read(bytes: &[u8], file: &str) -> Result<Vec<Result<Ray, String>>, Fault> {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    let mut reader =
        csv::ReaderBuilder::new().flexible(true).trim(csv::Trim::All).comment(Some(b'#')).from_reader(bytes);
    let wrong = |error: csv::Error| Fault::new(format!("{file}: {error}"));
    let header: Vec<String> = reader.headers().map_err(wrong)?.iter().map(str::to_ascii_lowercase).collect();
    if header != COLUMNS[..6] && header != COLUMNS {
        return Err(Fault::new(format!(
            "{file}:1:1: the first line is \"{}\"; it must be {} or {}",
            header.join(","),
            COLUMNS[..6].join(","),
            COLUMNS.join(","),
        )));
    }
    let row = |record: Result<csv::StringRecord, csv::Error>| match record {
        Ok(record) => ray(&record, header.len()),
        Err(error) => Err(error.to_string()),
    };
    Ok(reader.records().map(row).collect())
}

fn ray(record: &csv::StringRecord, columns: usize) -> Result<Ray, String> {
    if record.len() != columns {
        return Err(format!("{columns} numbers are needed, there are {}", record.len()));
    }
    let mut numbers = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, f32::INFINITY];
    for (index, text) in record.iter().enumerate() {
        // An empty end of the range is the usual one.
        if index >= 6 && text.is_empty() {
            continue;
        }
        numbers[index] = text.parse().map_err(|_| format!("{} is \"{text}\", not a number", COLUMNS[index]))?;
    }
    let [ox, oy, oz, dx, dy, dz, t_min, t_max] = numbers;
    Ray::new(Vec3::new(ox, oy, oz), Vec3::new(dx, dy, dz))
        .and_then(|ray| ray.within(t_min, t_max))
        .map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(table: &str) -> Vec<String> {
        let rows = match read(table.as_bytes(), "rays.csv") {
            Ok(rows) => rows,
            Err(fault) => return vec![fault.to_string()],
        };
        let row = |row: Result<Ray, String>| row.map_or_else(|why| why, |ray| format!("{} {}", ray.d, ray.t_max));
        rows.into_iter().map(row).collect()
    }

    #[test]
    fn rows_are_rays_or_say_why_not() {
        let table = "ox,oy,oz,dx,dy,dz\n0,0,0,1,0,0\n0,0,0,0,0,0\n0,x,0,1,0,0\n0,0\nnan,0,0,1,0,0\n";
        assert_eq!(
            said(table),
            [
                "[1, 0, 0] inf",
                "the direction is zero: a ray needs at least one component that is not",
                "oy is \"x\", not a number",
                "6 numbers are needed, there are 2",
                "the origin has a component that is not a finite number",
            ]
        );
        assert_eq!(said("\u{feff}ox, oy, oz, dx, dy, dz, t_min, t_max\n0,0,0,0,1,0,0.5,\n"), ["[0, 1, 0] inf"]);
    }

    #[test]
    fn a_wrong_header_is_no_table() {
        assert_eq!(
            said("x,y,z\n1,2,3\n"),
            [
                "rays.csv:1:1: the first line is \"x,y,z\"; it must be ox,oy,oz,dx,dy,dz or ox,oy,oz,dx,dy,dz,t_min,t_max"
            ]
        );
    }
}
