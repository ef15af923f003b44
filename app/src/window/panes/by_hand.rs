//! What can be set by hand: the structure's parameters and the ray in numbers, docked below the lesson.

use egui::{Direction, DragValue, Frame, Layout, Margin, RichText, ScrollArea, Ui, UiBuilder, WidgetInfo, vec2};
use raystep_accel::Ray;
use raystep_figure::{Face, Role, Theme};

use super::page::Asked;
use crate::shown::command::Command;
use crate::shown::kind_name::kind_name;
use crate::shown::state::State;
use crate::shown::view::RayChoice;
use crate::window::look::controls::{self, Change, Said};
use crate::window::look::fonts::font;
use crate::window::look::icons::{Icon, icon_button};
use crate::window::look::typed::{self, Typed};
use crate::window::look::visuals::ink;

/// Shows the panel in all the room there is.
pub(super) fn pane(ui: &mut Ui, state: &State, theme: &Theme, asked: &mut Vec<Asked>) {
    Frame::new().inner_margin(Margin { left: 22, right: 14, top: 8, bottom: 6 }).show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.label(RichText::new("Set by hand").font(font(Face::Bold, 13.5)));
            ui.with_layout(Layout::right_to_left(egui::Align::Center), |ui| {
                let close = icon_button(ui, Icon::Close, "Close", &Command::ByHand.tip(), false, 24.0);
                if close.clicked() {
                    asked.push(Asked::Command(Command::ByHand));
                }
            });
        });
        ScrollArea::vertical().id_salt("by hand").auto_shrink(false).show(ui, |ui| {
            ui.set_width(ui.available_width() - 8.0);
            let above = ui.cursor().top();
            ray(ui, state, theme, asked);
            structure(ui, state, theme, asked);
            if ui.cursor().top() == above {
                heading(
                    ui,
                    "Nothing on this slide is set by hand: no ray walks here, and no structure is built.",
                    theme,
                );
            }
        });
    });
}

fn heading(ui: &mut Ui, text: &str, theme: &Theme) {
    ui.add_space(4.0);
    ui.label(RichText::new(text).font(font(Face::Medium, 12.5)).color(ink(theme, Role::Quiet)));
}

/// The structure's parameters.
fn structure(ui: &mut Ui, state: &State, theme: &Theme, asked: &mut Vec<Asked>) {
    let Some(rule) = state.rule() else { return };
    let parameters = rule.parameters();
    if parameters.is_empty() {
        return;
    }
    heading(ui, &format!("{}: how it is built", kind_name(rule.kind())), theme);
    for parameter in &parameters {
        let Said { value, wrong } = controls::parameter(ui, parameter, theme);
        asked.extend(wrong.map(Asked::Say));
        if let Some((value, change)) = value {
            asked.extend((change == Change::Begins).then_some(Asked::Keep));
            asked.push(Asked::Set(parameter.key, value));
        }
    }
    if !state.target().settings.is_empty() {
        ui.add_space(4.0);
        if ui.button("The slide's own parameters").clicked() {
            asked.push(Asked::Command(Command::Restore));
        }
    }
}

/// The ray's origin and direction, two numbers each in the plane.
fn ray(ui: &mut Ui, state: &State, theme: &Theme, asked: &mut Vec<Asked>) {
    let Some(playback) = state.playback() else { return };
    let shown = match &state.target().ray {
        RayChoice::Own(ray) => Some(*ray),
        RayChoice::Named(_) => playback.play.tape.ray(),
    };
    let Some(ray) = shown else { return };
    let axes = if playback.play.scene.flat { 2 } else { 3 };
    let reach = playback.play.structure.bounds().extent().max_element();
    heading(ui, "The ray: from o, along d", theme);
    let (mut o, mut d) = (ray.o, ray.d);
    let mut change = None;
    for (name, vector, speed) in [("o", &mut o, reach * 0.002), ("d", &mut d, 0.005)] {
        ui.horizontal(|ui| {
            ui.label(RichText::new(name).font(font(Face::Mono, 13.5)));
            for axis in 0..axes {
                let letter = ["x", "y", "z"][axis];
                let Typed { response, wrong } = number(ui, &mut vector[axis], speed, &format!("{name}.{letter}"));
                asked.extend(wrong.map(Asked::Say));
                change = controls::change(&response).or(change);
            }
        });
    }
    if let Some(change) = change {
        let own = Ray::new(o, d).and_then(|own| own.within(ray.t_min, ray.t_max));
        match own {
            Ok(own) => {
                asked.extend((change == Change::Begins).then_some(Asked::Keep));
                asked.push(Asked::Ray(own));
            }
            Err(error) => asked.push(Asked::Say(format!("This is no ray: {error}."))),
        }
    }
}

fn number(ui: &mut Ui, value: &mut f32, speed: f32, name: &str) -> Typed {
    let field = DragValue::new(value).speed(speed).custom_formatter(|x, _| short(x));
    // However long what is typed becomes, its neighbours stay where they are.
    let (_, room) = ui.allocate_space(vec2(62.0, 24.0));
    let layout = Layout::centered_and_justified(Direction::LeftToRight);
    let mut child = ui.new_child(UiBuilder::new().max_rect(room).layout(layout));
    // It stands in its room with all of its border.
    child.spacing_mut().button_padding = vec2(4.0, 2.0);
    child.spacing_mut().interact_size.y = room.height();
    child.set_clip_rect(room.expand(2.0).intersect(ui.clip_rect()));
    let typed = typed::field(&mut child, name, &typed::Allowed::ANY, field, |ui, field| ui.add(field));
    typed.response.widget_info(|| WidgetInfo::labeled(egui::Role::SpinButton, true, name));
    typed
}

/// A number as a field has room for it, and as it is typed: with at most four digits behind the point, and far from 1 with
/// its power of ten.
fn short(x: f64) -> String {
    let far = x != 0.0 && !(1e-3..1e5).contains(&x.abs());
    if far {
        return format!("{:e}", x as f32);
    }
    let text = format!("{x:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::short;

    #[test]
    fn a_number_has_room_in_its_field() {
        let check = |x: f64, says: &str| assert_eq!(short(x), says);
        check(0.0, "0");
        check(1.5, "1.5");
        check(-0.25, "-0.25");
        check(99_999.0, "99999");
        check(f64::from(-1e30_f32), "-1e30");
        check(f64::from(1e-7_f32), "1e-7");
    }
}
