//! Numbers as they stand on a board: three digits, or in full what is counted whole.

use raystep_accel::Appraisal;
use raystep_figure::{number, whole};
use raystep_lesson::{Column, Measured, Timed};

/// What was timed, in three digits.
pub(super) fn timed_here(column: Column, timed: &Timed) -> String {
    let known =
        |value: f64, says: &dyn Fn(f64) -> String| if value.is_nan() { "\u{2013}".to_owned() } else { says(value) };
    match column {
        Column::Speed => known(timed.speed, &digits),
        Column::Spread => {
            let [least, most] = timed.spread;
            known(least, &|least| format!("{}\u{2013}{}", digits(least), digits(most)))
        }
        Column::Time => known(timed.time(), &digits),
        Column::Build => known(timed.build, &digits),
        Column::Share => known(timed.share, &|share| format!("{:.1} %", share * 100.0)),
        Column::Picture => known(timed.seconds, &span),
        _ => String::new(),
    }
}

/// A time in the unit in which people say it.
pub(crate) fn span(seconds: f64) -> String {
    const YEAR: f64 = 365.25 * 86_400.0;
    let units = [(YEAR, "years"), (86_400.0, "days"), (3600.0, "hours"), (60.0, "minutes"), (1.0, "s"), (1e-3, "ms")];
    let (unit, name) = units.into_iter().find(|(unit, _)| seconds >= *unit * 1.5).unwrap_or((1e-6, "µs"));
    format!("{} {name}", digits(seconds / unit))
}

/// A measured number: counts a ray in three digits, counts of things in full.
pub(super) fn here(column: Column, measured: &Measured) -> String {
    match column {
        Column::Tests => digits(measured.tests),
        // Where there is nothing to enter, none were.
        Column::Visits | Column::Boxes if measured.nodes == 0 && measured.visits == 0.0 => "\u{2013}".to_owned(),
        // Of fast structures only what a ray enters is counted.
        Column::Nodes if measured.nodes == 0 => "\u{2013}".to_owned(),
        Column::Visits => digits(measured.visits),
        Column::Boxes => digits(measured.boxes),
        Column::Alive if measured.alive.is_nan() => "\u{2013}".to_owned(),
        Column::Alive => digits(measured.alive),
        Column::Bytes if measured.bytes == 0 => "\u{2013}".to_owned(),
        Column::Nodes => whole(measured.nodes),
        Column::Bytes => whole(measured.bytes),
        Column::Printed | Column::Total | Column::Computed | Column::Before | Column::After => String::new(),
        // Of a structure nobody asks.
        Column::Content | Column::Area | Column::Planes | Column::Cuts | Column::Vain => String::new(),
        // Told by `timed_here`.
        Column::Speed | Column::Spread | Column::Time | Column::Build | Column::Share | Column::Picture => {
            String::new()
        }
    }
}

/// A number of a volume around everything.
pub(super) fn around(column: Column, appraised: &Appraisal) -> String {
    match column {
        Column::Content => digits(appraised.content),
        Column::Area => digits(f64::from(appraised.area)),
        Column::Bytes => whole(appraised.bytes as u64),
        // A sphere has none.
        Column::Planes if appraised.planes == 0 => "\u{2013}".to_owned(),
        Column::Planes => whole(u64::from(appraised.planes)),
        Column::Cuts => digits(appraised.cuts),
        Column::Vain => format!("{:.1} %", appraised.vain_share() * 100.0),
        _ => String::new(),
    }
}

/// Three digits, idle zeros too: numbers below each other compare by their points.
pub(crate) fn digits(value: f64) -> String {
    let short = number(value as f32);
    let places = short.split_once('.').map_or(0, |(_, behind)| behind.len());
    let whole = short.chars().take_while(char::is_ascii_digit).count();
    let wanted = 3_usize.saturating_sub(whole);
    if short.chars().all(|c| c.is_ascii_digit() || c == '.') && value.abs() >= 1.0 && places < wanted {
        format!("{value:.wanted$}")
    } else {
        short
    }
}
