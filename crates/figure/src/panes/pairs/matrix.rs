//! The matrix: what is tested down, against what across; a click on a cell lays its pair out.

use glam::Vec2;
use raystep_accel::{Arrangement, CellId, Kind, PAIRS, Place, Probe, Step, Trial};

use crate::page::{Anchor, Figure, Ink, Look, block, write};
use crate::panes::Ask;
use crate::theme::{Face, Role, text_width};

/// A row's height in letters.
const ROW: f32 = 2.1;

/// The height of the names above the columns in letters: in one row, in two.
const HEADS: [f32; 2] = [2.1, 3.4];

/// The kinds that come first and those that come second, in the order in which they are tested.
fn kinds(cases: &[Arrangement]) -> [Vec<Kind>; 2] {
    let mut all = [Vec::new(), Vec::new()];
    for pair in cases.iter().filter_map(|lies| PAIRS.get(lies.pair as usize)) {
        for (kinds, kind) in all.iter_mut().zip([pair.first, pair.second]) {
            if !kinds.contains(&kind) {
                kinds.push(kind);
            }
        }
    }
    all
}

/// How high it stands.
pub(crate) fn matrix_height(cases: &[Arrangement], look: &Look) -> f32 {
    let [rows, _] = kinds(cases);
    look.heading(&mut Figure::default(), "", "") + look.text * (ROW * rows.len() as f32 + HEADS[1]) + look.margin()
}

/// The matrix after so many steps.
pub(crate) fn matrix(cases: &[Arrangement], events: &[Trial], step: usize, ask: &Ask<'_>) -> Figure {
    let (size, look) = (ask.size, &ask.look);
    let mut figure = Figure::new(size);
    let top = look.heading(&mut figure, "Pairs", "a test for each");
    let [rows, columns] = kinds(cases);
    let u = look.text.min((size.y - top - look.margin()) / (ROW * rows.len() as f32 + HEADS[1]));
    let names = rows.iter().map(|kind| text_width(kind.word(), Face::Medium, u)).fold(0.0, f32::max);
    let left = look.margin() + names + u;
    let wide = ((size.x - left - look.margin()) / columns.len().max(1) as f32).min(u * 9.0);
    let high = u * ROW;
    // Names that are wider than their columns stand in two rows, every other one higher.
    let long = |kind: &Kind| text_width(kind.word(), Face::Medium, u * 0.95) + u * 0.4;
    let levels = if columns.iter().any(|kind| long(kind) > wide) { 2 } else { 1 };
    for (index, kind) in columns.iter().enumerate() {
        let up = (index + columns.len()) % levels;
        let at = Vec2::new(left + wide * (index as f32 + 0.5), top + u * (HEADS[levels - 1] - 1.0 - 1.3 * up as f32));
        let room = wide * levels as f32 - u * 0.4;
        // Smaller rather than cut off.
        let text = u * 0.95 * (room / text_width(kind.word(), Face::Medium, u * 0.95)).min(1.0);
        write(&mut figure, Role::Text, None, at, kind.word(), text, Face::Medium, Anchor::Middle);
    }
    let first = top + u * HEADS[levels - 1];
    for (index, kind) in rows.iter().enumerate() {
        let at = Vec2::new(left - u * 0.8, first + high * (index as f32 + 0.5));
        write(&mut figure, Role::Text, None, at, kind.word(), u, Face::Medium, Anchor::End);
    }
    let now = step.checked_sub(1).and_then(|last| events.get(last)).map(|trial| trial.pair);
    let mut drawn = Vec::new();
    for (index, pair) in cases.iter().filter_map(|lies| Some((lies.pair, PAIRS.get(lies.pair as usize)?))) {
        if drawn.contains(&index) {
            continue;
        }
        drawn.push(index);
        let place = |kinds: &[Kind], kind| kinds.iter().position(|known| *known == kind).unwrap_or(0) as f32;
        let corner = Vec2::new(left + wide * place(&columns, pair.second), first + high * place(&rows, pair.first));
        let inner = Vec2::new(wide, high) - Vec2::splat(u * 0.3);
        let corner = corner + Vec2::splat(u * 0.15);
        let answers = answers(index, &events[..step.min(events.len())]);
        let role = match (now == Some(index), answers.is_empty()) {
            (true, _) => Role::Here,
            (false, false) => Role::Seen,
            (false, true) => Role::Edge,
        };
        let own = Some(Place::Cell(CellId(index)));
        // The whole cell can be clicked, and lights up.
        figure.add(Role::Page, own, block(corner, inner, u * 0.25));
        figure.add(role, own, block(corner, inner, u * 0.25));
        for (case, answer) in answers.iter().enumerate() {
            let center = corner + Vec2::new(inner.x * 0.5 + (case as f32 - 0.5) * u * 1.3, inner.y * 0.5);
            mark(&mut figure, own, center, *answer, u);
        }
    }
    figure
}

/// A disc where the two met, a cross where they were apart.
fn mark(figure: &mut Figure, place: Option<Place>, center: Vec2, met: bool, u: f32) {
    if met {
        figure.add(Role::Hit, place, Ink::Circle { center, radius: u * 0.36 });
    } else {
        write(figure, Role::Missed, place, center, "×", u * 1.15, Face::Bold, Anchor::Middle);
    }
}

/// What the tests of a pair have answered so far.
fn answers(pair: u32, done: &[Trial]) -> Vec<bool> {
    let answer = |trial: &Trial| match trial.step {
        Some(Step::Probe(Probe::Met { hit: yes, .. } | Probe::Touch { touch: yes })) => Some(yes),
        _ => None,
    };
    done.iter().filter(|trial| trial.pair == pair).filter_map(answer).collect()
}
