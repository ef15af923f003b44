//! The bar at the bottom: transport, the timeline, the grain of steps and the speed.

use egui::{Align, Button, ComboBox, Layout, RichText, Sense, Ui, vec2};
use raystep_accel::{Grain, Place};
use raystep_figure::{Look, Symbol, Theme, Track, TreeView, short};

use crate::shown::command::{Command, ENTRIES};
use crate::shown::pictures::{Pane, Pictures};
use crate::shown::state::State;
use crate::shown::steps::grain_name;
use crate::window::look::controls;
use crate::window::look::icons::{Icon, icon_button};
use crate::window::look::painter::{paint_figure, paint_nearest_lit, place_at};

/// What was asked for in the bar.
pub(crate) enum Asked {
    /// A command.
    Command(Command),
    /// A step.
    Step(usize),
    /// A symbol of the timeline's legend.
    Symbol(Symbol),
}

/// Shows the bar; says what was asked for and which place the pointer is on.
pub(crate) fn bar(
    ui: &mut Ui,
    state: &State,
    pictures: Option<&mut Pictures>,
    theme: &Theme,
    hovered: Option<Place>,
) -> (Option<Asked>, Option<Place>) {
    let (mut asked, mut under) = (None, None);
    let narrow = ui.available_width() < 1180.0;
    ui.horizontal_centered(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        let side = if narrow { 32.0 } else { 36.0 };
        let play = if state.playing { Icon::Pause } else { Icon::Play };
        let transport = [
            (Icon::First, Command::First),
            (Icon::Previous, Command::Previous),
            (play, Command::Play),
            (Icon::Next, Command::Next),
            (Icon::Last, Command::Last),
        ];
        for (icon, command) in transport {
            let loud = command == Command::Play;
            if icon_button(ui, icon, command.name(), &command.tip(), loud, side).clicked() {
                asked = Some(Asked::Command(command));
            }
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            if ui.add(Button::new("? keys").frame(false)).on_hover_text(Command::Help.tip()).clicked() {
                asked = Some(Asked::Command(Command::Help));
            }
            speed(ui, state, &mut asked);
            grain(ui, state, &mut asked);
            let room = vec2(ui.available_width(), ui.available_height());
            under = track(ui, state, pictures, theme, hovered, room, &mut asked);
        });
    });
    (asked, under)
}

fn grain(ui: &mut Ui, state: &State, asked: &mut Option<Asked>) {
    let combo = ComboBox::from_id_salt("grain").width(112.0).selected_text(grain_name(state.grain));
    let shown = combo.show_ui(ui, |ui| {
        for grain in [Grain::Arithmetic, Grain::Decision, Grain::Visit] {
            if ui.selectable_label(grain == state.grain, grain_name(grain)).clicked() {
                *asked = Some(Asked::Command(Command::Grain(grain)));
            }
        }
    });
    controls::name(&shown.response, "Grain of steps");
}

/// What a speed is called on its drop-down: the last word of its command.
fn speed_name(speed: u8) -> &'static str {
    Command::Speed(speed).name().rsplit(' ').next().unwrap_or_default()
}

fn speed(ui: &mut Ui, state: &State, asked: &mut Option<Asked>) {
    let combo = ComboBox::from_id_salt("speed").width(52.0).selected_text(speed_name(state.speed));
    let shown = combo.show_ui(ui, |ui| {
        for entry in ENTRIES {
            if let Command::Speed(speed) = entry.command
                && ui.selectable_label(speed == state.speed, speed_name(speed)).clicked()
            {
                *asked = Some(Asked::Command(entry.command));
            }
        }
    });
    controls::name(&shown.response, "Speed of playing");
}

/// The timeline, to be scrubbed.
fn track(
    ui: &mut Ui,
    state: &State,
    pictures: Option<&mut Pictures>,
    theme: &Theme,
    hovered: Option<Place>,
    room: egui::Vec2,
    asked: &mut Option<Asked>,
) -> Option<Place> {
    let (rect, response) = ui.allocate_exact_size(room, Sense::click_and_drag());
    let (Some(playback), Some(pictures)) = (state.playback(), pictures) else {
        response.widget_info(|| egui::WidgetInfo::slider(false, 0.0, "Timeline"));
        return None;
    };
    let size = glam::Vec2::new(rect.width(), rect.height());
    let figure = pictures.pane(Pane::Timeline, size, &Look::WINDOW, None, &TreeView::default(), None);
    let track = Track::new(playback.steps().last(), size, &Look::WINDOW);
    let step = state.view.step;
    paint_figure(ui.painter(), rect.min, &figure, theme, None);
    paint_nearest_lit(ui.painter(), rect.min, &figure, theme, hovered, track.x(step));
    response.widget_info(|| egui::WidgetInfo::slider(true, step as f64, "Timeline"));

    let local = |pointer: egui::Pos2| glam::Vec2::new(pointer.x - rect.left(), pointer.y - rect.top());
    let named = |pointer| pictures.symbol_at(size, &Look::WINDOW, local(pointer));
    let pressed = ui.input(|input| input.pointer.press_origin());
    let held = pressed.filter(|at| rect.contains(*at)).and_then(named);
    if let Some(pointer) = response.interact_pointer_pos() {
        match held.or_else(|| named(pointer)) {
            Some(symbol) if response.clicked() => *asked = Some(Asked::Symbol(symbol)),
            Some(_) => {}
            None if response.dragged() || response.clicked() => {
                *asked = Some(Asked::Step(track.step_at(pointer.x - rect.left())));
            }
            None => {}
        }
    }
    let pointer = response.hover_pos()?;
    if let Some(symbol) = named(pointer) {
        let says = format!("{}: click for the next time, Shift+click for the one before", symbol.name);
        response.on_hover_text_at_pointer(RichText::new(says));
        return None;
    }
    let figure = pictures.pane(Pane::Timeline, size, &Look::WINDOW, None, &TreeView::default(), None);
    if pointer.x - rect.left() > track.left - 10.0 && !response.dragged() {
        let at = track.step_at(pointer.x - rect.left());
        let says = match playback.event(at) {
            Some(event) if at <= state.told() => {
                format!("step {at}: {}", short(&event, playback.reel().volume()))
            }
            _ => format!("step {at}"),
        };
        response.on_hover_text_at_pointer(RichText::new(says));
    }
    place_at(&figure, rect.min, pointer)
}
