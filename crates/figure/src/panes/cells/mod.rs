//! The cell of a grid in which the walk stands: which plane comes next along each axis, and what it holds.

mod build;

use glam::Vec2;
use raystep_accel::{AnyGrid, Axis, CellId, Lattice, Place, PrimId, Visit};

pub use build::cells_of_build;

use crate::moments::{Moment, Stepping, Walk};
use crate::page::{Anchor, Entry, Figure, Look, Table, write};
use crate::theme::{Face, Role, text_width};
use crate::words::number;

/// The next t of each axis, how far its planes lie apart, and the primitives of the cell. Which axis
/// steps is marked once the walk has stepped, and not while `hide_next`: a question may ask for it.
pub fn cells(walk: &Walk<'_>, moment: &Moment, hide_next: bool, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    let Some(grid) = walk.structure.grid() else {
        look.nothing(&mut figure, "Cell", "This structure has no cells.");
        return figure;
    };
    let Some(Place::Cell(cell)) = moment.here else {
        let says = if moment.ending.is_some() { "The walk is over." } else { "No cell has been entered yet." };
        look.nothing(&mut figure, "Cell", says);
        return figure;
    };
    let place = Some(Place::Cell(cell));
    let top = look.heading(&mut figure, &format!("Cell {cell}"), &coordinates(grid, cell, walk.flat));

    let stepped = left(moment, cell).filter(|_| !hide_next).map(|step| step.axis);
    let axes = Axis::ALL.iter().copied().filter(|axis| !(walk.flat && *axis == Axis::Z));
    let numbers = next_planes(walk, grid, moment, cell);
    let rows = axes.clone().map(|axis| {
        let steps = stepped == Some(axis);
        let role = if steps { Role::Value } else { Role::Text };
        let [next, delta] = numbers.map_or([Entry::none(), Entry::none()], |(next, delta)| {
            [Entry::new(number(next[axis.index()]), role), Entry::new(number(delta[axis.index()]), Role::Text)]
        });
        let says = if steps { "smallest: steps" } else { "" };
        vec![Entry::new(axis.name(), Role::Text), next, delta, Entry::new(says, Role::Value)]
    });
    let table = Table {
        heads: vec!["", "next t", "delta t", ""],
        rows: rows.collect(),
        current: stepped.and_then(|stepped| axes.clone().position(|axis| axis == stepped)),
        place,
    };
    // In a low pane what else there is to say stands beside the table.
    let below = size.y - 2.2 * look.line();
    let beside = look.margin() + table.width(look.text) + look.text * 2.0;
    let low = top + table.height(look.text) > below && beside + look.text * BESIDE < size.x;
    let end = table.draw(&mut figure, top, if low { size.y } else { below }, look);
    let (left, mut y) = if low { (beside, top + look.line() * 0.5) } else { (look.margin(), end + look.text * 0.9) };
    let interval = format!("t in [{}, {}]", number(moment.entered.near), number(moment.entered.far));
    write(&mut figure, Role::Here, place, Vec2::new(left, y), &interval, look.text, Face::Medium, Anchor::Start);
    y += look.line();
    match grid.finer().iter().find(|(holder, _)| *holder == cell) {
        Some((_, finer)) => {
            let says = format!("holds a grid of {} cells", size_of_grid(finer, walk.flat));
            write(&mut figure, Role::Text, place, Vec2::new(left, y), &says, look.text, Face::Regular, Anchor::Start);
        }
        None => prims(&mut figure, grid.cell_prims(cell), moment, Vec2::new(left, y), look),
    }
    figure
}

/// The room that words beside the table need, in letters.
const BESIDE: f32 = 16.0;

/// Where a cell lies in its grid, counted from 0, and in which cell that grid lies.
fn coordinates(grid: &dyn AnyGrid, cell: CellId, flat: bool) -> String {
    let [x, y, z] = grid.cell_place(cell);
    let at = if flat { format!("column {x}, row {y}") } else { format!("({x}, {y}, {z})") };
    match grid.around(cell).1 {
        Some(holder) => format!("{at} inside cell {holder}, level {}", grid.path(cell).len()),
        None => at,
    }
}

/// How many cells along each axis.
fn size_of_grid(lattice: &Lattice, flat: bool) -> String {
    let [nx, ny, nz] = lattice.resolution;
    if flat { format!("{nx} × {ny}") } else { format!("{nx} × {ny} × {nz}") }
}

/// The step out of the cell, once it is taken: the next one may still be looked up.
fn left(moment: &Moment, cell: CellId) -> Option<Stepping> {
    moment.stepping.filter(|step| step.cell == cell)
}

/// The next t and the delta of each axis, as the walk compares them when it leaves the cell.
fn next_planes(walk: &Walk<'_>, grid: &dyn AnyGrid, moment: &Moment, cell: CellId) -> Option<([f32; 3], [f32; 3])> {
    // The cell that is left tells them; they are settled as soon as it is entered.
    let ahead = walk.events[moment.step.saturating_sub(1)..].iter().find_map(|event| match *event {
        Visit::Step { cell: left, next_x, next_y, next_z, delta_x, delta_y, delta_z, .. } => {
            (left == cell).then_some(([next_x, next_y, next_z], [delta_x, delta_y, delta_z]))
        }
        _ => None,
    });
    // The last cell is never left: what the step before it left over, if that was in the same grid.
    let before = || moment.stepping.filter(|step| grid.around(step.cell).1 == grid.around(cell).1);
    let taken = left(moment, cell).map(|step| (step.next, step.delta));
    taken.or(ahead).or_else(|| {
        before().map(|step| {
            let mut next = step.next;
            next[step.axis.index()] += step.delta[step.axis.index()];
            (next, step.delta)
        })
    })
}

/// What the cell refers to, each with what became of it. Of more than there is room for, first those that
/// were hit, then those that something else happened to; the last words say how many are left.
fn prims(figure: &mut Figure, prims: &[PrimId], moment: &Moment, start: Vec2, look: &Look) {
    let u = look.text;
    let says = match prims.len() {
        0 => "refers to no primitive",
        1 => "refers to primitive",
        _ => "refers to primitives",
    };
    write(figure, Role::Quiet, None, start, says, u, Face::Regular, Anchor::Start);
    let first = start + Vec2::new(text_width(says, Face::Regular, u) + u * 0.7, 0.0);
    let room = Vec2::new(figure.size.x - look.margin(), figure.size.y - u * 0.5);

    let mut entries: Vec<(usize, Role, Place, String)> = Vec::with_capacity(prims.len());
    for &prim in prims {
        let (rank, role, word) = match moment.test_of(prim) {
            _ if moment.event == Some(Visit::Skip { prim }) => (0, Role::Dropped, ": skipped"),
            _ if moment.best.is_some_and(|best| best.prim == prim) => (0, Role::Best, ": hit"),
            _ if moment.skipped.contains(&prim) => (2, Role::Dropped, ": skipped"),
            Some(test) if test.t.is_some() => (1, Role::Hit, ": hit"),
            Some(_) => (3, Role::Missed, ": missed"),
            None => (4, Role::Text, ""),
        };
        entries.push((rank, role, Place::Prim(prim), format!("{prim}{word}")));
    }
    let texts = |entries: &[(usize, Role, Place, String)]| -> Vec<String> {
        entries.iter().map(|(.., text)| text.clone()).collect()
    };
    let mut places = flow(&texts(&entries), first, start.x, room, look);
    if places.len() < entries.len() {
        entries.sort_by_key(|(rank, ..)| *rank);
        // As many as leave room for the words at the end.
        for shown in (0..places.len()).rev() {
            let says = format!("and {} more", entries.len() - shown);
            let mut some = texts(&entries[..shown]);
            some.push(says.clone());
            places = flow(&some, first, start.x, room, look);
            if let (true, Some(at)) = (places.len() == some.len(), places.last()) {
                write(figure, Role::Quiet, None, *at, &says, u, Face::Regular, Anchor::Start);
                entries.truncate(shown);
                break;
            }
        }
    }
    for ((_, role, place, text), at) in entries.iter().zip(places) {
        write(figure, *role, Some(*place), at, text, u, Face::Medium, Anchor::Start);
    }
}

/// Where words stand, one after the other in lines that begin at `left`, from `first` on: those that end before `room` does.
fn flow(words: &[String], first: Vec2, left: f32, room: Vec2, look: &Look) -> Vec<Vec2> {
    let mut at = first;
    let mut places = Vec::new();
    for word in words {
        let width = text_width(word, Face::Medium, look.text);
        if at.x + width > room.x && at.x > left {
            at = Vec2::new(left, at.y + look.line());
        }
        if at.y > room.y {
            break;
        }
        places.push(at);
        at.x += width + look.text;
    }
    places
}
