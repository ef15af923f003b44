//! Controls that follow from data: a structure's parameters, and names for what egui leaves nameless.

use egui::{Button, Checkbox, ComboBox, DragValue, Response, RichText, Role, Stroke, Ui, WidgetInfo};
use raystep_accel::{Allowed, Parameter};
use raystep_figure::Theme;

use super::typed::{self, Typed};
use super::visuals::ink;

/// Gives a drop-down its accessible name.
pub(crate) fn name(response: &Response, name: &str) {
    response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, name));
}

/// Shows something in so much width and no more.
pub(crate) fn within<R>(ui: &mut Ui, width: f32, add: impl FnOnce(&mut Ui) -> R) -> R {
    let layout = egui::Layout::left_to_right(egui::Align::Center);
    ui.allocate_ui_with_layout(egui::vec2(width, 30.0), layout, |ui| {
        ui.set_max_width(width);
        add(ui)
    })
    .inner
}

/// Something that is on or off. The edge of its box is seen on any ground.
pub(crate) fn tick(ui: &mut Ui, on: &mut bool, text: &str) -> Response {
    let edges = |ui: &mut Ui| {
        let quiet = Stroke::new(1.2, ui.visuals().weak_text_color());
        ui.visuals_mut().widgets.inactive.bg_stroke = quiet;
        ui.visuals_mut().widgets.noninteractive.bg_stroke = quiet;
        ui.add(if text.is_empty() { Checkbox::without_text(on) } else { Checkbox::new(on, text) })
    };
    ui.scope(edges).inner
}

/// The button that does what a dialog is for.
pub(crate) fn main_button(ui: &mut Ui, text: &str) -> Response {
    let (here, page) = (ui.visuals().hyperlink_color, ui.visuals().panel_fill);
    ui.add(Button::new(RichText::new(text).color(page)).fill(here))
}

/// Whether a change is one of its own, or goes on with a drag: undo takes a whole drag back at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Change {
    /// A click, typing, or the first step of a drag.
    Begins,
    /// A further step of a drag.
    GoesOn,
}

/// How a field was changed, if it was.
pub(crate) fn change(response: &Response) -> Option<Change> {
    // A drag may move a while before its first change: that one begins it.
    let id = response.id.with("changed");
    if response.drag_started() {
        response.ctx.data_mut(|data| data.insert_temp(id, false));
    }
    if !response.changed() {
        return None;
    }
    let goes_on = response.dragged() && response.ctx.data_mut(|data| data.get_temp(id).unwrap_or(false));
    response.ctx.data_mut(|data| data.insert_temp(id, response.dragged()));
    Some(if goes_on { Change::GoesOn } else { Change::Begins })
}

/// What a control has to say.
#[derive(Default)]
pub(crate) struct Said {
    /// The new value as text, if it was changed.
    pub(crate) value: Option<(String, Change)>,
    /// What was wrong with what was typed.
    pub(crate) wrong: Option<String>,
}

/// A control for one parameter.
pub(crate) fn parameter(ui: &mut Ui, parameter: &Parameter, theme: &Theme) -> Said {
    let mut said = Said::default();
    let label = parameter.key.replace('_', " ");
    ui.with_layout(egui::Layout::top_down(egui::Align::Min), |ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        ui.horizontal(|ui| {
            ui.set_min_height(30.0);
            ui.label(&label);
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                said = control(ui, parameter, &label);
            });
        });
        ui.label(RichText::new(parameter.about).small().color(ink(theme, raystep_figure::Role::Quiet)));
    });
    said
}

fn control(ui: &mut Ui, parameter: &Parameter, label: &str) -> Said {
    let value = match parameter.allowed {
        Allowed::Flag => {
            let mut on = parameter.value == "true";
            let response = tick(ui, &mut on, "");
            response.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, on, label));
            response.changed().then(|| (on.to_string(), Change::Begins))
        }
        Allowed::Words(words) => {
            let mut chosen = None;
            let combo = ComboBox::from_id_salt(parameter.key).selected_text(&parameter.value).width(110.0);
            let shown = combo.show_ui(ui, |ui| {
                for word in words {
                    if ui.selectable_label(*word == parameter.value, *word).clicked() {
                        chosen = Some((*word).to_owned());
                    }
                }
            });
            name(&shown.response, label);
            chosen.map(|word| (word, Change::Begins))
        }
        Allowed::Count { min, max } => {
            let mut count: u32 = parameter.value.parse().unwrap_or(min);
            let field = DragValue::new(&mut count).range(min..=max).speed(0.05);
            let Typed { response, wrong } =
                typed::field(ui, label, &typed::Allowed::whole(min.into(), max.into()), field, |ui, field| {
                    ui.add(field)
                });
            response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, label));
            return Said { value: change(&response).map(|change| (count.to_string(), change)), wrong };
        }
        // They are set where they are seen.
        Allowed::Cuts => {
            ui.label(&parameter.value);
            None
        }
        Allowed::Real { min, max } => {
            let mut number: f32 = parameter.value.parse().unwrap_or(min);
            let speed = (max - min) * 0.002;
            let field = DragValue::new(&mut number).range(min..=max).speed(speed);
            let Typed { response, wrong } =
                typed::field(ui, label, &typed::Allowed::within(min.into(), max.into()), field, |ui, field| {
                    ui.add(field)
                });
            response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, label));
            return Said { value: change(&response).map(|change| (number.to_string(), change)), wrong };
        }
    };
    Said { value, wrong: None }
}

/// A dialog over the window.
pub(crate) fn modal(ui: &Ui, name: &'static str) -> egui::Modal {
    let frame = egui::Frame::popup(ui.style()).inner_margin(22);
    egui::Modal::new(egui::Id::unique(name)).frame(frame)
}
