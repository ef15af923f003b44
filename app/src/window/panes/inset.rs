//! A small picture in a corner of a solid stage: the leaf, the cell or the hit that is a dot in the large one.

use egui::{Align2, Rect, StrokeKind, Ui, pos2, vec2};
use raystep_accel::{Aabb, Event, Place, Primitives, Visit};
use raystep_figure::{Camera, Face, Instant, Role};

use super::page::Page;
use super::sight::Sight;
use super::space::glam_size;
use crate::shown::eye;
use crate::shown::pictures::{Pictures, drawn};
use crate::shown::playback::Playback;
use crate::window::look::painter::{caption, paint_labels};
use crate::window::look::visuals::line;

/// What is larger than this part of the scene is seen well enough in the large picture.
const SMALL: f32 = 0.3;

/// A picture of the stage that is smaller than this has no room for another one.
const LEAST: egui::Vec2 = vec2(420.0, 330.0);

/// Draws the inset over a stage, if there is anything small to see.
pub(super) fn show(ui: &Ui, page: Page<'_>, sight: &mut Sight, pictures: &Pictures, rect: Rect, camera: &Camera) {
    if !sight.solid_inset.is_there() || rect.width() < LEAST.x || rect.height() < LEAST.y {
        return;
    }
    let Some((title, bounds)) = subject(&pictures.playback, &pictures.instant) else { return };
    let size = vec2((rect.width() * 0.3).clamp(170.0, 300.0), (rect.height() * 0.34).clamp(130.0, 240.0));
    let inset = Rect::from_min_size(rect.right_top() + vec2(-size.x - 12.0, 12.0), size);
    let near = eye::framed(camera, &bounds, glam_size(inset));
    let (prims, theme) = (&pictures.playback.play.scene.prims, page.theme);
    sight.solid_inset.show(ui, inset, &pictures.space, prims, page.mesh, &near, theme, Role::Page, page.lit);
    let figure = drawn(&pictures.space, &pictures.playback, &near, glam_size(inset), true);
    paint_labels(&ui.painter_at(inset), inset.min, &figure, theme, page.lit);
    ui.painter().rect_stroke(inset, 4.0, line(theme, Role::Edge), StrokeKind::Inside);
    let at = pos2(inset.left() + 8.0, inset.bottom() - 11.0);
    caption(ui.painter(), at, Align2::LEFT_CENTER, &title, Face::Medium, 12.0, Role::Quiet, theme);
}

/// What the inset shows and how large it is: the nearest hit when the walk is over, else the leaf or the cell where
/// it stands.
fn subject(playback: &Playback, instant: &Instant) -> Option<(String, Aabb)> {
    let Instant::Walk(moment) = instant else { return None };
    let (structure, prims) = (&*playback.play.structure, &playback.play.scene.prims);
    let reel = playback.reel();
    let bounds_of = |place| reel.still(instant).bounds(place);
    let over = matches!(instant.event(), Some(Event::Walk(Visit::End { .. })));
    let (title, bounds) = match (over, moment.best, moment.here) {
        (true, Some(hit), _) => ("the hit, from near".to_owned(), prims.bounds(hit.prim)),
        (false, _, Some(Place::Node(node))) if !structure.leaf_prims(node).is_empty() => {
            (format!("{node}, from near"), bounds_of(Place::Node(node)))
        }
        (false, _, Some(Place::Cell(cell))) => {
            (format!("{cell}, from near"), bounds_of(Place::Cell(cell)))
        }
        _ => return None,
    };
    let diagonal = bounds.extent().length();
    let small = diagonal > 0.0 && diagonal < SMALL * structure.bounds().extent().length();
    // Some of what lies around it shows where it is.
    small.then(|| (title, bounds.padded(if over { diagonal * 0.4 } else { diagonal * 0.1 })))
}
