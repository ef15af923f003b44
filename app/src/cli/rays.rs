//! A table of rays as comma-separated values.

use glam::{DVec3, Vec3};
use raystep_accel::Ray;
use raystep_scene::decimal;

use crate::fault::Fault;

/// The columns, the last two of which may be left out.
const COLUMNS: [&str; 8] = ["ox", "oy", "oz", "dx", "dy", "dz", "t_min", "t_max"];

/// The rays of a table: of each row its ray, or a sentence that says why there is none.
///
/// # Errors
/// It is no table of rays.
pub fn read(bytes: &[u8], file: &str) -> Result<Vec<Result<Ray, String>>, Fault> {
    read_moved(bytes, file, DVec3::ZERO)
}

/// The same, seen from `origin`.
pub(crate) fn read_moved(bytes: &[u8], file: &str, origin: DVec3) -> Result<Vec<Result<Ray, String>>, Fault> {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    // Each line is a row of its own: a quotation mark that is left open swallows no other.
    let lines = bytes.split(|byte| matches!(byte, b'\n' | b'\r')).map(<[u8]>::trim_ascii);
    let mut rows = lines.filter(|line| !line.is_empty() && !line.starts_with(b"#"));
    let header = rows.next().unwrap_or_default();
    let header = String::from_utf8_lossy(header);
    let names: Vec<String> = fields(&header).unwrap_or_default().into_iter().map(str::to_ascii_lowercase).collect();
    if names != COLUMNS[..6] && names != COLUMNS {
        return Err(Fault::new(format!(
            "{file}:1:1: the first line is {}; it must be {} or {}",
            shown(&header),
            COLUMNS[..6].join(","),
            COLUMNS.join(","),
        )));
    }
    let row = |line: &[u8]| {
        let line = std::str::from_utf8(line).map_err(|_| "the row is not UTF-8".to_owned())?;
        ray(&fields(line)?, names.len(), origin)
    };
    Ok(rows.map(row).collect())
}

/// A ray in one line, `ox,oy,oz,dx,dy,dz[,t_min,t_max]`, seen from `origin`.
pub(crate) fn read_one(line: &str, origin: DVec3) -> Result<Ray, String> {
    let fields = fields(line)?;
    let columns = if fields.len() > 6 { 8 } else { 6 };
    ray(&fields, columns, origin)
}

/// The fields of a row; what stands between quotation marks may hold commas.
fn fields(line: &str) -> Result<Vec<&str>, String> {
    let (mut fields, mut rest) = (Vec::with_capacity(COLUMNS.len()), line);
    loop {
        rest = rest.trim_start();
        let field = match rest.strip_prefix('"') {
            Some(quoted) => {
                let (field, after) = quoted.split_once('"').ok_or("a quotation mark is opened and not closed")?;
                rest = after.trim_start();
                if !rest.is_empty() && !rest.starts_with(',') {
                    return Err(format!("{} stands behind a quotation mark that closes", shown(rest)));
                }
                field
            }
            None => {
                let (field, after) = rest.split_at(rest.find(',').unwrap_or(rest.len()));
                rest = after;
                field
            }
        };
        fields.push(field.trim());
        match rest.strip_prefix(',') {
            Some(more) => rest = more,
            None => return Ok(fields),
        }
    }
}

fn ray(fields: &[&str], columns: usize, origin: DVec3) -> Result<Ray, String> {
    if fields.len() != columns {
        return Err(format!("{columns} numbers are needed, there are {}", fields.len()));
    }
    let mut numbers = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, f64::INFINITY];
    for (index, text) in fields.iter().enumerate() {
        // An empty end of the range is the usual one.
        if index >= 6 && text.is_empty() {
            continue;
        }
        numbers[index] = decimal(text).ok_or_else(|| format!("{} is {}, not a number", COLUMNS[index], shown(text)))?;
    }
    let [ox, oy, oz, dx, dy, dz, t_min, t_max] = numbers;
    Ray::new((DVec3::new(ox, oy, oz) - origin).as_vec3(), Vec3::new(dx as f32, dy as f32, dz as f32))
        .and_then(|ray| ray.within(t_min as f32, t_max as f32))
        .map_err(|error| error.to_string())
}

/// A text as sentences show it: in quotation marks, and not too long.
fn shown(text: &str) -> String {
    const MOST: usize = 80;
    let end = if text.chars().nth(MOST).is_some() { "…" } else { "" };
    format!("\"{}{end}\"", text.chars().take(MOST).collect::<String>())
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
        let quoted = "ox,oy,oz,dx,dy,dz\n\"1\",2, \"3\" ,0,0,\"1\"\n1,2,3,0,0,\"1\n4,5,6,0,1,0\n\"1,5\",2,3,0,0,1\n\"\"1,2,3,0,0,1\n";
        assert_eq!(
            said(quoted),
            [
                "[0, 0, 1] inf",
                "a quotation mark is opened and not closed",
                "[0, 1, 0] inf",
                "ox is \"1,5\", not a number",
                "\"1,2,3,0,0,1\" stands behind a quotation mark that closes",
            ]
        );
        let long = format!("ox,oy,oz,dx,dy,dz\n0,0,{},1,0,0\n# none\n\n0,0,0,1,0,0\r\n", "x".repeat(1000));
        assert_eq!(said(&long), [&*format!("oz is \"{}…\", not a number", "x".repeat(80)), "[1, 0, 0] inf"]);
        assert_eq!(said("\u{feff}ox, oy, oz, dx, dy, dz, t_min, t_max\n0,0,0,0,1,0,0.5,\n"), ["[0, 1, 0] inf"]);
    }

    #[test]
    fn rays_are_moved_before_they_are_rounded() {
        let origin = DVec3::new(465812.0, 5247903.0, 0.0);
        let table = "ox,oy,oz,dx,dy,dz\n465812.4,5247903.74,500,0,0,-1\n";
        let [Ok(ray)] = read_moved(table.as_bytes(), "rays.csv", origin).unwrap()[..] else { panic!() };
        assert!((ray.o - Vec3::new(0.4, 0.74, 500.0)).length() < 1e-6, "{}", ray.o);
        assert_eq!(read_one("465812.4, 5247903.74, 500, 0, 0, -1", origin).unwrap(), ray);
        assert_eq!(read_one("0,0,0,1,0,0,0.5,", DVec3::ZERO).unwrap().t_min, 0.5);
        assert_eq!(read_one("0,0,0,1,0", origin), Err("6 numbers are needed, there are 5".to_owned()));
        assert_eq!(read_one("0,0,0,1,0,0,1", origin), Err("8 numbers are needed, there are 7".to_owned()));
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
