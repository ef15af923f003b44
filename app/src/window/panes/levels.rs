//! How many boxes of a tree a solid stage shows: the path alone, or those down to a level.

use egui::{Button, Rect, Slider, Ui, UiBuilder, vec2};
use raystep_figure::{Depth, Role};

use super::page::{Asked, Page};
use crate::shown::command::Command;
use crate::shown::pictures::Pictures;
use crate::shown::playback::Playback;
use crate::window::look::controls::{Change, change};
use crate::window::look::visuals::ink;

/// Width and height of the control.
const SIZE: egui::Vec2 = vec2(252.0, 26.0);

/// The height of the strip under a stage that is so wide in which the control stands; none where there is no tree.
pub(super) fn room(playback: &Playback, width: f32) -> f32 {
    if playback.reel().deepest().is_some() && width > SIZE.x { SIZE.y } else { 0.0 }
}

/// Shows the control at the right end of its strip.
pub(super) fn show(ui: &mut Ui, page: Page<'_>, pictures: &Pictures, strip: Rect, asked: &mut Vec<Asked>) {
    let reel = pictures.playback.reel();
    let Some(deepest) = reel.deepest() else { return };
    let still = reel.still(&pictures.instant);
    let rect = Rect::from_min_max(strip.right_bottom() - SIZE, strip.right_bottom());
    let now = match still.depth(page.state.depth()) {
        Depth::Path => 0,
        Depth::Down(level) => level.min(deepest),
    };
    ui.scope_builder(UiBuilder::new().max_rect(rect), |ui| {
        ui.horizontal_centered(|ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            ui.add_space(6.0);
            // What is finished has no path.
            let is_walked = still.depth(Depth::Path) == Depth::Path;
            let path = ui.add_enabled(is_walked, Button::selectable(now == 0, "path only"));
            let path = path.on_hover_text(Command::Shallower.tip());
            let path = path.on_disabled_hover_text("No node is under consideration: there is no path to it");
            if path.clicked() && now > 0 {
                asked.extend([Asked::Keep, Asked::Depth(Depth::Path)]);
            }
            let mut level = now;
            ui.spacing_mut().slider_width = 74.0;
            // The rail stands out from the ground of the control.
            ui.visuals_mut().widgets.inactive.bg_fill = ink(page.theme, Role::Edge).gamma_multiply(0.6);
            let slider = ui.add(Slider::new(&mut level, 0..=deepest).show_value(false));
            slider.widget_info(|| egui::WidgetInfo::slider(true, f64::from(now), "Boxes down to level"));
            if let Some(change) = change(&slider) {
                if change == Change::Begins {
                    asked.push(Asked::Keep);
                }
                asked.push(Asked::Depth(if level == 0 { Depth::Path } else { Depth::Down(level) }));
            }
            slider.on_hover_text(Command::Deeper.tip());
            let says = if now == 0 { format!("levels 0 to {deepest}") } else { format!("level {now} of {deepest}") };
            ui.label(egui::RichText::new(says).small());
        });
    });
}
