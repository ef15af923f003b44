//! The plate of a race: a bar for each rung.

use std::path::Path;

use glam::Vec2;
use raystep_fast::Row;
use raystep_figure::{Bar, Bars, Look, Theme, number};
use raystep_print::{png, svg};

use crate::fault::Fault;

/// The size of the plate, and its letters.
const SIZE: Vec2 = Vec2::new(960.0, 520.0);
const LETTERS: f32 = 17.0;

/// What a file holds.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Kind {
    Svg,
    Png,
}

/// What a file of that name holds.
pub(super) fn kind(path: &Path) -> Result<Kind, Fault> {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
    match ending.as_str() {
        "svg" => Ok(Kind::Svg),
        "png" => Ok(Kind::Png),
        _ => Err(Fault::new(format!(
            "--out {}: a plate is written as FILE.svg or FILE.png; end the name so",
            path.display()
        ))),
    }
}

/// The plate as a file of that name.
pub(super) fn plate(path: &Path, about: &str, rows: &[Row]) -> Result<Vec<u8>, Fault> {
    let bars = rows.iter().map(|row| {
        let (value, says) = match &row.told {
            Ok(told) => (told.mrays_per_s, number(told.mrays_per_s as f32)),
            Err(why) => (0.0, why.clone()),
        };
        Bar { name: row.rung.name().to_owned(), note: row.rung.about().to_owned(), value, says }
    });
    let bars = Bars {
        title: "The same rays, faster and faster".to_owned(),
        about: vec![about.to_owned(), "Millions of rays a second, here and now, on a scale of factors".to_owned()],
        bars: bars.collect(),
    };
    let figure = bars.draw(SIZE, &Look { text: LETTERS, titles: true, least: 0.0 });
    let svg = svg(&figure, &Theme::LIGHT);
    match kind(path)? {
        Kind::Svg => Ok(svg.into_bytes()),
        Kind::Png => png(&svg, 2.0).map_err(|error| Fault::new(error.to_string())),
    }
}
