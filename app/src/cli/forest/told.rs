//! What the forest took, in sentences.

use raystep_figure::{number, whole};

use crate::cli::told::{Align, Format, Grid, Page};
use crate::export::Size;

/// What was measured.
pub(super) struct Told {
    pub(super) size: Size,
    pub(super) samples: u32,
    pub(super) trees: u64,
    /// Triangles for a ray to meet, and those that are stored.
    pub(super) triangles: u64,
    pub(super) stored: u64,
    /// Bytes of the structures, and the most memory that was resident.
    pub(super) bytes: u64,
    pub(super) resident: Option<u64>,
    pub(super) threads: usize,
    /// Seconds of growing, building, rendering.
    pub(super) grown: f64,
    pub(super) built: f64,
    pub(super) rendered: f64,
    /// Rays from the eye, and to the sun and the sky.
    pub(super) seen: u64,
    pub(super) lit: u64,
    /// Tests of triangles, and nodes, of all rays.
    pub(super) tests: u64,
    pub(super) nodes: u64,
    /// Tests a second that brute force makes here, on all threads.
    pub(super) rate: f64,
}

/// Seconds of a year, and what the lecture says: 594 years by brute force, 11 minutes.
const YEAR: f64 = 365.25 * 86_400.0;
const ELEVEN_MINUTES: f64 = 11.0 * 60.0;

impl Told {
    /// As a page of text.
    pub(super) fn text(&self) -> String {
        let rays = self.seen + self.lit;
        let each = |count: u64| number((count as f64 / rays.max(1) as f64) as f32);
        let seconds = |seconds: f64| format!("{} s", number(seconds as f32));
        let pixels = glam::Vec2::from(self.size);
        let pixels = f64::from(pixels.x) * f64::from(pixels.y);
        let years = |rays: f64| {
            let years = rays * self.triangles as f64 / self.rate.max(1e-9) / YEAR;
            whole(years.round() as u64)
        };
        let resident = match self.resident {
            Some(bytes) => format!("{} bytes resident at most", whole(bytes)),
            None => "what is resident, this system does not say".to_owned(),
        };
        let lines = [
            (
                "triangles",
                format!("{} for a ray to meet: {} trees, and hills", whole(self.triangles), whole(self.trees)),
            ),
            ("stored", format!("{} triangles, each model once", whole(self.stored))),
            ("memory", format!("{} bytes of structures; {resident}", whole(self.bytes))),
            ("to grow", seconds(self.grown)),
            ("to build", format!("{} on {} threads", seconds(self.built), self.threads)),
            (
                "to render",
                format!(
                    "{} on {} threads: {} pixels, {} rays from the eye for each",
                    seconds(self.rendered),
                    self.threads,
                    self.size,
                    self.samples
                ),
            ),
            ("rays", format!("{}: {} from the eye, {} to sun and sky", whole(rays), whole(self.seen), whole(self.lit))),
            ("tests per ray", format!("{} of triangles, {} nodes", each(self.tests), each(self.nodes))),
            (
                "brute force",
                format!("{} years for one ray a pixel, {} for all these rays", years(pixels), years(rays as f64)),
            ),
            ("", format!("at the {} tests a second that all threads make here", whole(self.rate as u64))),
            ("the lecture", "594 years by brute force, 11 minutes with a structure (slides 9 and 10)".to_owned()),
        ];
        let mut grid = Grid::new([("what", Align::Left), ("found", Align::Left)]);
        for (name, says) in lines {
            grid.row([name.to_owned(), says]);
        }
        let ratio = ELEVEN_MINUTES / (self.built + self.rendered).max(1e-9);
        let compared = if ratio >= 1.0 {
            format!("{} times as fast as that", number(ratio as f32))
        } else {
            format!("{} times as long as that", number((1.0 / ratio) as f32))
        };
        let compared = format!("to build and to render took {compared}, on another machine");
        grid.row([String::new(), compared]);
        let mut page = Page::default();
        page.table(grid);
        page.written(Format::Text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_it_took_is_said() {
        let told = Told {
            size: "100x100".parse().unwrap(),
            samples: 4,
            trees: 50_000,
            triangles: 50_000_000_000,
            stored: 4_000_000,
            bytes: 360_000_000,
            resident: Some(1 << 30),
            threads: 2,
            grown: 2.0,
            built: 10.0,
            rendered: 12.0,
            seen: 40_000,
            lit: 30_000,
            tests: 1_400_000,
            nodes: 4_200_000,
            rate: 1e9,
        };
        let text = told.text();
        for says in ["50,000,000,000", "20 of triangles, 60 nodes", "30 times as fast as that", "594 years"] {
            assert!(text.contains(says), "{says}\n{text}");
        }
        // 10,000 pixels, 5*10^10 triangles, 10^9 tests a second: 500,000 s; here ten thousand times as slow.
        let slow = Told { rate: 1e5, resident: None, ..told }.text();
        assert!(slow.contains("158 years for one ray a pixel") && slow.contains("does not say"), "{slow}");
    }
}
