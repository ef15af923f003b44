//! The panes below space: those that the slide is about, in its order, as many as can be read from the last row. A
//! question's own come first: what it speaks of is there.

use egui::{Rect, Ui, pos2, vec2};
use raystep_accel::Place;
use raystep_figure::{Look, Role};
use raystep_lesson::{Medium, Show};

use crate::shown::pictures::{Pane, Pictures};
use crate::shown::reel::said;
use crate::shown::state::State;
use crate::shown::words::question_text;
use crate::window::look::visuals::line;
use crate::window::panes::figure::figure;
use crate::window::panes::page::{Asked, Kept, Page};

/// How large letters of panes are, in parts of the page's: a thirty-eighth of its height.
const LETTERS: f32 = 0.7;

/// Most of the page's height that panes take.
const MOST: f32 = 0.34;

/// The same where a slide is about bytes most of all.
const MOST_BYTES: f32 = 0.5;

/// The panes that the slide is about, in their order, and those of them that are shown, in rows.
pub(super) struct Strip {
    panes: Vec<Wanted>,
    rows: Vec<Row>,
}

/// A pane with the width and the height that it needs.
#[derive(Clone, Copy)]
struct Wanted {
    pane: Pane,
    wide: f32,
    high: f32,
    /// Whether the beat tells of it.
    told: bool,
}

/// Panes beside each other.
struct Row {
    panes: Vec<Wanted>,
    height: f32,
}

/// The widths and heights in which a pane can be read, in letters of the page; none of what does not stand there.
fn legible(pane: Pane) -> Option<[f32; 2]> {
    Some(match pane {
        Pane::RulerLine => [16.0, 0.0],
        Pane::Tree => [13.0, 6.5],
        Pane::Cells => [13.0, 7.5],
        Pane::Matrix => [15.0, 9.0],
        Pane::Slabs => [16.0, 7.0],
        Pane::Bytes => [30.0, 12.5],
        Pane::Listing => [20.0, 8.5],
        Pane::Bin => [9.0, 6.5],
        Pane::Work => [15.0, 7.5],
        _ => return None,
    })
}

/// The pane that a slide asks for, on this page.
fn pane(show: &Show) -> Option<Pane> {
    Some(match show {
        Show::Ruler => Pane::RulerLine,
        Show::Tree => Pane::Tree,
        Show::Cells => Pane::Cells,
        Show::Matrix => Pane::Matrix,
        Show::Slabs => Pane::Slabs,
        Show::Bytes => Pane::Bytes,
        Show::Listing => Pane::Listing,
        Show::Stack => Pane::Bin,
        Show::Work => Pane::Work,
        Show::Space => return None,
    })
}

/// The panes that a text speaks of.
fn spoken_of(text: &str) -> Vec<Pane> {
    let words = [
        ("tree", Pane::Tree),
        ("stack", Pane::Bin),
        ("listing", Pane::Listing),
        ("ruler", Pane::RulerLine),
        ("slabs", Pane::Slabs),
        ("table", Pane::Cells),
        ("bytes", Pane::Bytes),
    ];
    let text = text.to_lowercase();
    let before = ["look at the ", "in the ", "on the ", "to the ", "from the ", "see the "];
    let looks = |word: &str| {
        before.iter().any(|before| text.contains(&format!("{before}{word}")))
            || text.contains(&format!("the {word} shows"))
    };
    words.into_iter().filter(|(word, _)| looks(word)).map(|(_, pane)| pane).collect()
}

impl Strip {
    /// The panes of a state, on a page of this size without its margins.
    pub(super) fn of(state: &State, pictures: Option<&Pictures>, size: egui::Vec2, body: f32) -> Strip {
        let nothing = Strip { panes: Vec::new(), rows: Vec::new() };
        let (Some(pictures), Some(slide)) = (pictures, state.slide()) else { return nothing };
        let mut panes: Vec<Pane> = slide.show.iter().filter_map(pane).filter(|pane| pictures.has(*pane)).collect();
        // A key calls for those that had no room. What needs all of it stands alone until then.
        let turn = state.lecture.turn;
        if pictures.has(Pane::Picture) {
            let called = (turn % (panes.len() + 1)).checked_sub(1).and_then(|index| panes.get(index)).copied();
            panes = called.into_iter().collect();
        } else if !panes.is_empty() {
            let many = panes.len();
            panes.rotate_left(turn % many);
        }
        let question = state.question().or(state.settled().map(|(posed, _)| posed));
        let question = question.map(|posed| question_text(state, posed));
        let first = question.as_deref().map(spoken_of).unwrap_or_default();
        let first: Vec<Pane> = first.into_iter().filter(|pane| pictures.has(*pane)).collect();
        panes.retain(|pane| !first.contains(pane));
        panes.splice(0..0, first);
        let told = told(state);
        let wanted = |pane: Pane| {
            let [wide, _] = legible(pane)?;
            Some(Wanted { pane, wide: wide * body, high: high(pane, pictures, body)?, told: told.contains(&pane) })
        };
        let panes: Vec<Wanted> = panes.into_iter().filter_map(wanted).collect();
        // The page does not move from step to step: its foot is as high as its highest pane.
        let bytes = slide.show.first() == Some(&Show::Bytes);
        let most = size.y * if bytes { MOST_BYTES } else { MOST };
        let height = panes.iter().map(|wanted| wanted.high).fold(0.0, f32::max).min(most);
        let (row, left_out) = beside(&panes, size.x);
        let row = if left_out.iter().any(|wanted| wanted.told) { beside(&told_first(&panes), size.x).0 } else { row };
        let rows = if row.is_empty() { Vec::new() } else { vec![Row { panes: row, height }] };
        Strip { panes, rows }
    }

    /// The same in a narrower room, beside a column of words as high as the page: those that have no place in the first
    /// row stand in a second one, where both leave space so much room. `rest` is the height of all three.
    pub(super) fn stacked(self, width: f32, rest: f32, space: f32) -> Strip {
        let Some(Row { height, .. }) = self.rows.first() else { return self };
        let row = |panes: Vec<Wanted>| {
            let high = panes.iter().map(|wanted| wanted.high).fold(0.0, f32::max).min(*height);
            Row { panes, height: high }
        };
        let in_rows = |panes: &[Wanted]| {
            let (first, left_out) = beside(panes, width);
            let (second, left_out_again) = beside(&left_out, width);
            let (first, second) = (row(first), row(second));
            let fits = first.height + second.height <= rest - space;
            match fits && !second.panes.is_empty() {
                true => (vec![first, second], left_out_again),
                false => (vec![Row { height: *height, ..first }], left_out),
            }
        };
        let (rows, left_out) = in_rows(&self.panes);
        let told = left_out.iter().any(|wanted| wanted.told);
        let rows = if told { in_rows(&told_first(&self.panes)).0 } else { rows };
        Strip { panes: self.panes, rows }
    }

    /// How high it is.
    pub(super) fn height(&self) -> f32 {
        self.rows.iter().map(|row| row.height).sum()
    }

    /// Shows the panes beside each other, with rules between them.
    pub(super) fn show(
        &self,
        ui: &mut Ui,
        page: Page<'_>,
        kept: &mut Kept,
        rect: Rect,
        body: f32,
        asked: &mut Vec<Asked>,
    ) -> Option<Place> {
        let look = Look { text: body * LETTERS, titles: true, least: 0.0 };
        let mut under = None;
        let mut top = rect.top();
        for (nth, row) in self.rows.iter().enumerate() {
            let sum: f32 = row.panes.iter().map(|wanted| wanted.wide).sum();
            // Where they are a little narrower, so are their letters.
            let look = Look { text: look.text * (rect.width() / sum).clamp(1.0 / SQUEEZED, 1.0), ..look };
            let room = Rect::from_min_size(pos2(rect.left(), top), vec2(rect.width(), row.height));
            if nth > 0 {
                ui.painter().hline(room.x_range(), room.top(), line(page.theme, Role::Panel));
            }
            let mut left = room.left();
            for (index, Wanted { pane, wide, .. }) in row.panes.iter().enumerate() {
                let right = left + room.width() * wide / sum;
                if index > 0 {
                    let y = room.y_range().shrink(body * 0.5);
                    ui.painter().vline(left, y, line(page.theme, Role::Panel));
                }
                let inner = if index > 0 { body * 0.5 } else { 0.0 };
                let room = Rect::from_min_max(pos2(left + inner, room.top()), pos2(right, room.bottom()));
                under = figure(ui, page, kept, *pane, room, &look, asked).or(under);
                left = right;
            }
            top += row.height;
        }
        under
    }
}

/// The panes that the beat of this step tells of.
fn told(state: &State) -> Vec<Pane> {
    let beat = state.beat().filter(|(_, step)| *step == state.view.step).zip(state.playback());
    beat.map_or_else(Vec::new, |((beat, step), playback)| {
        spoken_of(&format!("{}\n{}", beat.title, said(beat, &playback.play, step, Medium::Wall)))
    })
}

/// The panes, with those in front that the beat tells of.
fn told_first(panes: &[Wanted]) -> Vec<Wanted> {
    let mut panes = panes.to_vec();
    panes.sort_by_key(|wanted| !wanted.told);
    panes
}

/// Panes may be so much narrower than their widths in letters.
const SQUEEZED: f32 = 1.16;

/// Those that stand beside each other in this width, the first one always, and those that do not.
fn beside(panes: &[Wanted], width: f32) -> (Vec<Wanted>, Vec<Wanted>) {
    let (mut stand, mut rest) = (Vec::new(), Vec::new());
    let mut left = width;
    for wanted in panes {
        if stand.is_empty() || wanted.wide <= left + width * (SQUEEZED - 1.0) {
            left -= wanted.wide;
            stand.push(*wanted);
        } else {
            rest.push(*wanted);
        }
    }
    (stand, rest)
}

/// How high a pane is to be.
fn high(pane: Pane, pictures: &Pictures, body: f32) -> Option<f32> {
    let look = Look { text: body * LETTERS, titles: true, least: 0.0 };
    let [_, least] = legible(pane)?;
    Some(match pane {
        Pane::RulerLine => pictures.ruler_line_height(&look) + body,
        Pane::Bytes => pictures.height(pane, &look).map_or(least * body, |own| own.min(least * body)),
        Pane::Tree | Pane::Work => pictures.height(pane, &look).unwrap_or(0.0).clamp(least * body, 9.0 * body),
        _ => least * body,
    })
}
