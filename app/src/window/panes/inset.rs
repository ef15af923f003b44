//! A small picture in a corner of a solid stage: the leaf, the cell or the hit that is a dot in the large one.

use egui::{Align2, Rect, StrokeKind, Ui, pos2, vec2};
use raystep_figure::{Camera, Detail, Face, Role, Scenery, close_up, inset_size, is_nearer, text_width};

use super::page::Page;
use super::sight::Sight;
use super::space::glam_size;
use crate::shown::eye;
use crate::shown::pictures::Pictures;
use crate::window::look::painter::{caption, paint_labels};
use crate::window::look::visuals::{fill, line};

/// Where the small picture stands, what it is called, and the camera that it is seen with.
pub(super) struct Inset {
    pub(super) rect: Rect,
    title: String,
    near: Camera,
}

/// The small picture of a stage, if there is anything small to see.
pub(super) fn of(sight: &Sight, pictures: &Pictures, rect: Rect, camera: &Camera) -> Option<Inset> {
    let size = inset_size(glam_size(rect)).filter(|_| sight.solid_inset.is_there())?;
    let reel = pictures.playback.reel();
    let Detail { title, bounds, focus } = reel.still(&pictures.instant).detail()?;
    let size = vec2(size.x, size.y);
    let inset = Rect::from_min_size(rect.right_top() + vec2(-size.x - 12.0, 12.0), size);
    let near = eye::framed(camera, &bounds, glam_size(inset));
    let nearer = is_nearer(focus, (&near, glam_size(inset)), (camera, glam_size(rect)));
    nearer.then_some(Inset { rect: inset, title, near })
}

/// Draws it over the stage.
pub(super) fn show(ui: &Ui, page: Page<'_>, sight: &mut Sight, pictures: &Pictures, inset: &Inset) {
    let Some(space) = &pictures.space else { return };
    let Inset { rect: inset, title, near } = inset;
    let inset = *inset;
    let (prims, theme) = (&pictures.playback.play.scene.prims, page.theme);
    sight.solid_inset.show(ui, inset, space, prims, page.mesh, near, theme, Role::Page, &pictures.lit(page.lit));
    let figure = close_up(space, prims, near, glam_size(inset), Scenery::Left);
    paint_labels(&ui.painter_at(inset), inset.min, &figure, theme, page.lit);
    ui.painter().rect_stroke(inset, 4.0, line(theme, Role::Edge), StrokeKind::Inside);
    // Whatever is drawn there, the title stands on a ground of its own.
    let wide = text_width(title, Face::Medium, 12.0);
    let ground =
        Rect::from_min_max(inset.left_bottom() + vec2(1.0, -22.0), inset.left_bottom() + vec2(wide + 14.0, -1.0));
    ui.painter().rect_filled(ground, 3.0, fill(theme, Role::Page));
    let at = pos2(inset.left() + 8.0, inset.bottom() - 11.0);
    caption(ui.painter(), at, Align2::LEFT_CENTER, title, Face::Medium, 12.0, Role::Quiet, theme);
}
