//! The cells of a grid that a builder puts a primitive into.

use glam::Vec2;
use raystep_accel::Place;

use crate::moments::{Build, Fate, GrowMoment};
use crate::page::{Anchor, Figure, Look, write};
use crate::theme::{Face, Role, text_width};
use crate::words::{counted, whole};

/// The cells that the current primitive's box meets, and what becomes of it in each.
pub fn cells_of_build(build: &Build<'_>, moment: &GrowMoment, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    if build.structure.grid().is_none() {
        look.nothing(&mut figure, "Cells", "This structure has no cells.");
        return figure;
    }
    let Some([nx, ny, nz]) = moment.resolution else {
        look.nothing(&mut figure, "Cells", "How many there will be is not decided yet.");
        return figure;
    };
    let layers = if build.flat { format!("{nx} × {ny}") } else { format!("{nx} × {ny} × {nz}") };
    let coarse = nx * ny * nz;
    let mut grid_says = format!("{layers} = {}", counted(u64::from(coarse), "cell", "cells"));
    if moment.cell_count > coarse {
        grid_says += &format!(", and {} inside them", whole(u64::from(moment.cell_count - coarse)));
    }
    let Some(prim) = moment.prim.filter(|_| !moment.rasterised.is_empty()) else {
        let filled = moment.cells.len() as u64;
        let says = format!("{} of them {} to something.", whole(filled), if filled == 1 { "refers" } else { "refer" });
        look.nothing(&mut figure, &grid_says, &says);
        return figure;
    };
    let title = format!("Primitive {prim}");
    let stored = moment.rasterised.iter().filter(|(_, fate)| *fate == Fate::Stored).count() as u64;
    let remark = format!(
        "its box meets {}, {} to it",
        counted(moment.rasterised.len() as u64, "cell", "cells"),
        if stored == 1 { "1 refers".to_owned() } else { format!("{} refer", whole(stored)) },
    );
    let top = look.heading(&mut figure, &title, &remark);

    // One after the other, the latest decision kept in view.
    let u = look.text;
    let chip = text_width("cell 0000 not reached", Face::Medium, u) + u * 1.2;
    let columns = (((size.x - 2.0 * look.margin()) / chip) as usize).max(1);
    let rows = (((size.y - top - look.margin()) / look.line()) as usize).max(1);
    let decided = moment.rasterised.iter().rposition(|(_, fate)| *fate != Fate::Open).unwrap_or(0);
    let first_row =
        (decided / columns + 2).saturating_sub(rows).min((moment.rasterised.len() / columns + 1).saturating_sub(rows));
    let rest = moment.rasterised.len().saturating_sub(first_row * columns);
    let shown = moment.rasterised.iter().skip(first_row * columns).take(rows * columns);
    for (index, &(cell, fate)) in shown.enumerate() {
        let (role, word) = match fate {
            Fate::Open => (Role::Waiting, "?"),
            Fate::Stored => (Role::Here, "refers to it"),
            Fate::Pruned => (Role::Quiet, "not reached"),
        };
        let at = Vec2::new(
            look.margin() + chip * (index % columns) as f32,
            top + look.line() * ((index / columns) as f32 + 0.6),
        );
        // The last place says how many have none.
        if index + 1 == rows * columns && index + 1 < rest {
            let text = format!("and {} more", rest - index);
            write(&mut figure, Role::Quiet, None, at, &text, u, Face::Medium, Anchor::Start);
            break;
        }
        let text = format!("cell {cell}: {word}");
        write(&mut figure, role, Some(Place::Cell(cell)), at, &text, u, Face::Medium, Anchor::Start);
    }
    figure
}
