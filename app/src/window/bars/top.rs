//! The bar at the top: where we are in the lecture, which ray, which stage, and the modes.

use egui::{Align, Button, ComboBox, Layout, RichText, Ui, Widget, vec2};
use raystep_accel::Rule;
use raystep_figure::{Face, Role, Theme};
use raystep_lesson::{Plays, StageKind};

use crate::shown::beside::Beside;
use crate::shown::command::{Command, Entry};
use crate::shown::kind_name::kind_name;
use crate::shown::state::State;
use crate::shown::view::RayChoice;
use crate::window::look::controls;
use crate::window::look::fonts::font;
use crate::window::look::icons::{Icon, icon_button};
use crate::window::look::visuals::{color32, ink, style};

/// What was asked for in the bar.
pub(crate) enum Asked {
    /// A command.
    Command(Command),
    /// A slide, by its place.
    Slide(usize),
    /// A ray of the slide, by its place.
    Ray(usize),
    /// A mistake, by its place, or none.
    Mistake(Option<usize>),
    /// A theme.
    Theme(&'static Theme),
}

/// Stands behind the name of a structure whose parameters are not the slide's.
const CHANGED: &str = " *";

/// What has room in a bar of a width. The buttons at the right stand where they stand on every slide.
struct Room {
    /// The program's name.
    name: bool,
    /// The slide's numbers.
    numbers: bool,
    /// "Break it".
    breaks: bool,
    /// "Export"; else it stands under "More".
    export: bool,
    /// "Present", likewise.
    present: bool,
    /// Beside the words on a button.
    padding: f32,
    /// The outline's width.
    outline: f32,
    /// The structure's width: as wide as the longest name that has been changed, so that nothing moves.
    structure: f32,
}

impl Room {
    fn of(width: f32) -> Room {
        let outline = if width > 1180.0 { (width * 0.235).clamp(180.0, 380.0) } else { width * 0.262 };
        let padding = match width {
            1540.0.. => 11.0,
            1080.0.. => 9.0,
            _ => 8.0,
        };
        let names = std::iter::once("slab").chain(Rule::KINDS).map(|kind| format!("{}{CHANGED}", kind_name(kind)));
        let widths = names.map(|name| raystep_figure::text_width(&name, Face::Medium, 13.5));
        Room {
            name: width > 1260.0,
            numbers: width > 1540.0,
            breaks: width > 1240.0,
            export: width > 1080.0,
            present: width > 1010.0,
            padding,
            outline,
            structure: widths.fold(0.0, f32::max).ceil() + 2.0 * padding,
        }
    }
}

/// Shows the bar and says what was asked for.
pub(crate) fn bar(ui: &mut Ui, state: &State, theme: &Theme) -> Option<Asked> {
    let mut asked = None;
    let room = Room::of(ui.available_width());
    ui.horizontal_centered(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        ui.spacing_mut().button_padding.x = room.padding;
        if room.name {
            ui.label(RichText::new("Raystep").font(font(Face::Bold, 17.0)));
            ui.add_space(8.0);
        }
        outline(ui, state, theme, room.outline, &mut asked);
        if room.numbers
            && let Some(slide) = state.slide()
        {
            ui.add_space(6.0);
            ui.label(RichText::new(slide.numbers_text()).color(ink(theme, Role::Quiet)));
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            more(ui, state, theme, &room, &mut asked);
            let modes = [
                (Command::Export, false, room.export),
                (Command::Present, false, room.present),
                (Command::Predict, state.predict, true),
                (Command::Compare, matches!(state.beside, Beside::Structure(_) | Beside::Abreast(_)), true),
            ];
            let walks = state.slide().is_none_or(|slide| matches!(slide.plays, Plays::Walk | Plays::Packet));
            for (command, on, _) in modes.into_iter().filter(|(.., fits)| *fits) {
                let button = Button::new(command.name()).selected(on);
                let button = if on { button.stroke(ui.visuals().selection.stroke) } else { button };
                let enabled = walks || command != Command::Compare;
                let response = ui.add_enabled(enabled, button).on_hover_text(command.tip());
                if response.on_disabled_hover_text("No ray walks here that could be compared").clicked() {
                    asked = Some(Asked::Command(command));
                }
            }
            // Whatever stands on a board has a structure of its own, and pairs have none.
            if state.slide().is_some_and(|slide| matches!(slide.plays, Plays::Board | Plays::Pairs)) {
                return;
            }
            if room.breaks {
                broken(ui, state, theme, &mut asked);
            }
            ui.add_space(4.0);
            stages(ui, state, theme, &mut asked);
            // What is fitted around everything has stages, but neither a structure nor rays.
            if state.slide().is_some_and(|slide| slide.plays == Plays::Fit) {
                return;
            }
            ui.add_space(4.0);
            structure(ui, state, room.structure, &mut asked);
            let left = ui.available_width();
            rays(ui, state, theme, (left - 8.0).clamp(60.0, 300.0), &mut asked);
        });
    });
    asked
}

/// ‹ outline ›
fn outline(ui: &mut Ui, state: &State, theme: &Theme, width: f32, asked: &mut Option<Asked>) {
    // Where we go shows at once, even while the page is still the one before.
    let at = state.target().slide;
    let back = icon_button(ui, Icon::Left, "Previous slide", &Command::PreviousSlide.tip(), false, 28.0);
    if back.clicked() {
        *asked = Some(Asked::Command(Command::PreviousSlide));
    }
    // Where there is no room for both, the title alone: the list says which section it is in.
    let shown = state.library.slides.get(at).map_or_else(String::new, |slide| {
        let both = format!("{} {} › {}", section_number(slide), slide.section_title(), slide.title);
        let fits = raystep_figure::text_width(&both, Face::Medium, 13.5) + 40.0 <= width;
        if fits { both } else { slide.title.clone() }
    });
    // The list is as tall as the window.
    let tall = (ui.ctx().content_rect().height() - 84.0).max(200.0);
    let combo =
        ComboBox::from_id_salt("outline").width(width).height(tall).truncate().selected_text(RichText::new(shown));
    let list = ui.scope_id().with("outline is open");
    let shown = controls::within(ui, width, |ui| {
        combo.show_ui(ui, |ui| {
            ui.set_min_width(width.max(340.0));
            // It opens where one is, as soon as it knows how long it is.
            let opening = ui.data_mut(|data| {
                let frames: &mut u32 = data.get_temp_mut_or_default(list);
                *frames += 1;
                *frames <= 3
            });
            let mut section = "";
            for (index, slide) in state.library.slides.iter().enumerate() {
                if slide.section != section {
                    section = &slide.section;
                    ui.add_space(4.0);
                    let heading = format!("{} {}", section_number(slide), slide.section_title());
                    ui.label(RichText::new(heading).font(font(Face::Bold, 12.5)).color(ink(theme, Role::Quiet)));
                }
                let text = format!("{}   {}", slide.title, slide.numbers_text());
                let row = ui.selectable_label(index == at, text);
                if index == at && opening {
                    row.scroll_to_me_animation(Some(Align::Center), egui::style::ScrollAnimation::none());
                }
                if row.clicked() {
                    *asked = Some(Asked::Slide(index));
                }
            }
        })
    });
    if shown.inner.is_none() {
        ui.data_mut(|data| data.remove_temp::<u32>(list));
    }
    controls::name(&shown.response, "Outline of slides");
    let forth = icon_button(ui, Icon::Right, "Next slide", &Command::NextSlide.tip(), false, 28.0);
    if forth.clicked() {
        *asked = Some(Asked::Command(Command::NextSlide));
    }
}

/// `"5"` of the section `"05-kd-tree"`.
fn section_number(slide: &raystep_lesson::Slide) -> &str {
    slide.section.split('-').next().unwrap_or_default().trim_start_matches('0')
}

/// The slide's rays, in the colour of rays.
fn rays(ui: &mut Ui, state: &State, theme: &Theme, width: f32, asked: &mut Option<Asked>) {
    let Some(stage) = state.stage().filter(|stage| !stage.rays.is_empty()) else { return };
    let name = match &state.view.ray {
        RayChoice::Named(index) => stage.rays.get(*index).map_or("", |ray| ray.name.as_str()),
        RayChoice::Own(_) => "your own",
    };
    let together = state.slide().is_some_and(|slide| slide.plays == Plays::Packet);
    let text = format!("{}: {name}", if together { "Rays" } else { "Ray" });
    let wide = |text: &str| raystep_figure::text_width(text, Face::Medium, 13.5) + 44.0;
    // Its colour says that it is a ray where there is no room for the word.
    let text = if wide(&text) <= width { text } else { name.to_owned() };
    let needed = wide(&text);
    ui.scope(|ui| {
        let (text_color, tint) = (ink(theme, Role::Live), theme.style(Role::Value).fill);
        let panel = theme.style(Role::Panel).fill;
        let visuals = ui.visuals_mut();
        for widget in [&mut visuals.widgets.inactive, &mut visuals.widgets.hovered, &mut visuals.widgets.open] {
            if let (Some(tint), Some(panel)) = (tint, panel) {
                widget.weak_bg_fill = color32(tint.over(panel));
            }
            widget.bg_stroke = egui::Stroke::new(1.2, text_color);
            widget.fg_stroke.color = text_color;
        }
        let width = needed.min(width);
        let combo = ComboBox::from_id_salt("rays").width(width).truncate();
        let text = RichText::new(text).font(font(Face::Medium, 13.5)).color(text_color);
        let shown = controls::within(ui, width, |ui| {
            combo.selected_text(text).show_ui(ui, |ui| {
                for (index, ray) in stage.rays.iter().enumerate() {
                    if ui.selectable_label(state.view.ray == RayChoice::Named(index), &ray.name).clicked() {
                        *asked = Some(Asked::Ray(index));
                    }
                }
            })
        });
        controls::name(&shown.response, &format!("Ray: {name}"));
    });
}

/// Flat or solid, as far as the slide offers them.
fn stages(ui: &mut Ui, state: &State, theme: &Theme, asked: &mut Option<Asked>) {
    let Some(slide) = state.slide() else { return };
    // Laid out from right to left.
    ui.spacing_mut().item_spacing.x = 0.0;
    for (kind, command) in [(StageKind::Solid, Command::Solid), (StageKind::Flat, Command::Flat)] {
        let on = state.view.stage == kind;
        let text = RichText::new(command.name());
        let text = if on { text.color(ui.visuals().extreme_bg_color) } else { text };
        let button = Button::new(text);
        let button = if on { button.fill(ink(theme, Role::Here)) } else { button };
        let offered = slide.stage(kind).is_some() || state.view.mesh.is_some() && on;
        let response = ui.add_enabled(offered, button).on_hover_text(command.tip());
        let response = response.on_disabled_hover_text("This slide has no such stage");
        if response.clicked() {
            *asked = Some(Asked::Command(command));
        }
    }
    ui.spacing_mut().item_spacing.x = 6.0;
}

/// The structure's name: a button that docks what can be set by hand below the lesson.
fn structure(ui: &mut Ui, state: &State, width: f32, asked: &mut Option<Asked>) {
    let Some(rule) = state.rule() else { return };
    let changed = if state.target().settings.is_empty() { "" } else { CHANGED };
    let button = Button::new(format!("{}{changed}", kind_name(rule.kind()))).selected(state.by_hand);
    let button = button.min_size(vec2(width, 0.0));
    let button = if state.by_hand { button.stroke(ui.visuals().selection.stroke) } else { button };
    let response = ui.add(button).on_hover_text(Command::ByHand.tip());
    let name = format!("Structure: {}", kind_name(rule.kind()));
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, &name));
    if response.clicked() {
        *asked = Some(Asked::Command(Command::ByHand));
    }
}

/// What is needed more rarely.
fn more(ui: &mut Ui, state: &State, theme: &Theme, room: &Room, asked: &mut Option<Asked>) {
    let button = icon_button(ui, Icon::More, "More", "More", false, 28.0);
    egui::Popup::menu(&button).show(|ui| {
        ui.set_width(310.0);
        let (undo, redo) = state.undoable();
        let hidden = [(Command::Present, !room.present), (Command::Export, !room.export)];
        let hidden = hidden.into_iter().filter(|(_, hidden)| *hidden);
        let commands = [
            (Command::Undo, undo),
            (Command::Redo, redo),
            (Command::ByHand, true),
            (Command::Restore, true),
            (Command::Heat, state.slide().is_some_and(|slide| slide.plays != Plays::Board)),
            (Command::Frame, true),
            (Command::ResetCamera, true),
            (Command::ResetScene, true),
            (Command::Open, true),
            (Command::Best, true),
            (Command::Copy, true),
            (Command::FullScreen, true),
            (Command::Palette, true),
            (Command::Help, true),
        ];
        for (command, enabled) in hidden.chain(commands) {
            let keys = command.entry().map_or("", Entry::keys_text);
            let button = Button::new(command.name()).shortcut_text(keys).min_size(vec2(298.0, 0.0));
            if ui.add_enabled(enabled, button).clicked() {
                *asked = Some(Asked::Command(command));
            }
        }
        ui.separator();
        for (command, on) in [(Command::Lock, state.locked), (Command::Motion, state.motion)] {
            let mut on = on;
            ui.horizontal(|ui| {
                ui.set_style(style(theme));
                if ui.checkbox(&mut on, command.name()).changed() {
                    *asked = Some(Asked::Command(command));
                }
            });
        }
        ui.separator();
        ui.label(RichText::new("Theme").color(ink(theme, Role::Quiet)));
        ui.horizontal(|ui| {
            ui.set_style(style(theme));
            for other in [&Theme::LIGHT, &Theme::DARK, &Theme::PROJECTOR] {
                let button = Button::new(other.name).selected(other.name == theme.name);
                if button.ui(ui).clicked() {
                    *asked = Some(Asked::Theme(other));
                }
            }
        });
        ui.separator();
        mistakes(ui, state, theme, asked);
    });
}

/// A button with the mistakes that can be made in this structure.
fn broken(ui: &mut Ui, state: &State, theme: &Theme, asked: &mut Option<Asked>) {
    let some = state.playback().is_some_and(|playback| !playback.mistakes.is_empty());
    let on = matches!(state.beside, Beside::Mistake(_));
    let button = Button::new(Command::Break.name()).selected(on);
    let button = if on { button.stroke(ui.visuals().selection.stroke) } else { button };
    let response = ui.add_enabled(some, button).on_hover_text("Make a common mistake, beside the right walk");
    let response = response.on_disabled_hover_text("No mistakes are known here");
    egui::Popup::menu(&response).show(|ui| {
        ui.set_width(310.0);
        mistakes(ui, state, theme, asked);
    });
}

/// The mistakes that can be played beside the right walk.
fn mistakes(ui: &mut Ui, state: &State, theme: &Theme, asked: &mut Option<Asked>) {
    let Some(playback) = state.playback().filter(|playback| !playback.mistakes.is_empty()) else { return };
    ui.label(RichText::new(Command::Break.name()).color(ink(theme, Role::Quiet)));
    for (index, mistake) in playback.mistakes.iter().enumerate() {
        let on = state.beside == Beside::Mistake(index);
        if ui.selectable_label(on, mistake.title()).on_hover_text(mistake.consequence()).clicked() {
            *asked = Some(Asked::Mistake((!on).then_some(index)));
        }
    }
}
