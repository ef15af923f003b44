//! The rows of the dialog. What makes no sense is greyed, and says why when it is pointed at.

use clap::ValueEnum;
use egui::{Button, Response, Stroke, StrokeKind, TextEdit, Ui, vec2};
use raystep_accel::Grain;
use raystep_figure::Theme;
use raystep_print::Lettering;

use super::form::{Field, Form, Page, Which};
use crate::export::{Format, Piece, View};
use crate::shown::state::State;
use crate::window::look::controls;

/// How wide the names of rows are, and how far they lie apart.
const NAMES: f32 = 72.0;
const APART: f32 = 7.0;

/// Shows them; says whether a folder shall be chosen.
pub(super) fn show(ui: &mut Ui, form: &mut Form, state: &State) -> bool {
    ui.spacing_mut().item_spacing = vec2(6.0, 4.0);
    ui.spacing_mut().button_padding = vec2(9.0, 3.0);
    row(ui, "What", |ui| steps(ui, form, state.view.step));
    row(ui, "Format", |ui| {
        for format in Format::value_variants() {
            let (word, why) = (format.ending().to_uppercase(), form.writes(*format));
            choose(ui, &mut form.format, *format, &word, &word, why);
        }
    });
    row(ui, "View", |ui| {
        let no_picture = form.draws();
        for view in View::value_variants() {
            let why = no_picture.or(form.lacks(*view));
            let about = view.to_possible_value().and_then(|value| value.get_help().map(ToString::to_string));
            let chosen = form.page == Page::View(*view);
            if pick(ui, chosen, view.name(), &format!("View {}", view.name()), why, about.as_deref()) {
                form.page = Page::View(*view);
            }
        }
        choose(ui, &mut form.page, Page::Own, "own plate", "View own plate", no_picture);
    });
    row(ui, "Panes", |ui| pieces(ui, form));
    row(ui, "Legend", |ui| {
        let why = form.explains();
        for (value, word) in [(None, "usual"), (Some(true), "on"), (Some(false), "off")] {
            choose(ui, &mut form.legend, value, word, &format!("Legend {word}"), why);
        }
    });
    row(ui, "Letters", |ui| {
        let why = form.spells();
        let kinds = [
            (Lettering::Outlines, "outlines"),
            (Lettering::Embedded, "text, faces in the file"),
            (Lettering::Named, "text, faces named"),
        ];
        for (value, word) in kinds {
            choose(ui, &mut form.lettering, value, word, &format!("Letters as {word}"), why);
        }
    });
    row(ui, "Size", |ui| {
        let why = form.draws();
        let wrong = form.wrong(Field::Size);
        field(ui, &mut form.size, 100.0, "Size", why, wrong);
        for usual in ["1280x800", "1600x1000", "1920x1080", "3200x2000"] {
            let word = usual.replace('x', "×");
            choose(ui, &mut form.size, usual.to_owned(), &word, &word, why);
        }
    });
    row(ui, "Page", |ui| {
        let why = form.draws();
        toggle(ui, &mut form.crop, "cut margins off", why);
        ui.add_space(10.0);
        let why = form.bares();
        toggle(ui, &mut form.clear, "no ground", why);
    });
    row(ui, "Theme", |ui| {
        let why = form.draws();
        for theme in Theme::ALL {
            let name = format!("Theme {}", theme.name);
            if pick(ui, form.theme.name == theme.name, theme.name, &name, why, None) {
                form.theme = theme;
            }
        }
    });
    row(ui, "Stops", |ui| {
        let why = form.leaves_out();
        let usual = if form.format.is_film() { "decisions" } else { "all" };
        choose(ui, &mut form.grain, None, &format!("usual ({usual})"), "Stops as usual", why);
        for (grain, word) in
            [(Grain::Arithmetic, "every step"), (Grain::Decision, "decisions"), (Grain::Visit, "visits")]
        {
            choose(ui, &mut form.grain, Some(grain), word, &format!("Stops at {word}"), why);
        }
        ui.add_space(10.0);
        let why = form.moves();
        ui.add_enabled(why.is_none(), egui::Label::new("each for"));
        let wrong = form.wrong(Field::Delay);
        field(ui, &mut form.delay, 52.0, "Milliseconds of each step", why, wrong);
        ui.add_enabled(why.is_none(), egui::Label::new("ms"));
    });
    row(ui, "Folder", |ui| {
        let width = (ui.available_width() - 90.0).max(120.0);
        let wrong = form.wrong(Field::Folder);
        field(ui, &mut form.folder, width, "Folder", None, wrong);
        ui.button("Choose").clicked()
    })
}

fn steps(ui: &mut Ui, form: &mut Form, now: usize) {
    let chosen = form.chosen();
    let (one, many) = (form.one_step(), form.steps_matter());
    let all = if form.format.is_film() || many.is_some() { "all steps" } else { "all beats" };
    if pick(ui, chosen == Which::This, &format!("this step ({now})"), &format!("this step ({now})"), one, None) {
        form.which = Which::This;
    }
    if pick(ui, chosen == Which::Beats, all, all, many, None) {
        form.which = Which::Beats;
    }
    if pick(ui, chosen == Which::Steps, "steps", "steps", many, None) {
        form.which = Which::Steps;
    }
    let wrong = form.wrong(Field::Steps);
    // Whoever writes which steps means them.
    let named = field(ui, &mut form.steps, 100.0, "First and last step", many, wrong);
    if named.clicked() || named.changed() {
        form.which = Which::Steps;
    }
    ui.add_enabled(many.is_none(), egui::Label::new(format!("of 0..{}", form.last())));
}

fn pieces(ui: &mut Ui, form: &mut Form) {
    let unwanted = form.draws().or((form.page != Page::Own).then_some("Choose own plate as the view."));
    for piece in Piece::all() {
        let (name, why) = (piece.name(), unwanted.or(form.lacks_piece(piece)));
        let stands = form.pieces.contains(&piece);
        if pick(ui, stands && unwanted.is_none(), name, &format!("Pane {name}"), why, None) {
            match stands {
                true => form.pieces.retain(|other| *other != piece),
                false => form.pieces.push(piece),
            }
        }
    }
}

/// A row with its name.
fn row<R>(ui: &mut Ui, name: &str, add: impl FnOnce(&mut Ui) -> R) -> R {
    let shown = ui.horizontal_top(|ui| {
        let high = ui.spacing().interact_size.y;
        let layout = egui::Layout::left_to_right(egui::Align::Center);
        ui.allocate_ui_with_layout(vec2(NAMES, high), layout, |ui| {
            ui.set_min_size(vec2(NAMES, high));
            ui.label(name);
        });
        ui.horizontal_wrapped(add).inner
    });
    ui.add_space(APART);
    shown.inner
}

/// A button that is chosen or not; says whether it was clicked. Where it makes no sense, `why` says so; else `about` says
/// what it is.
fn pick(ui: &mut Ui, chosen: bool, text: &str, name: &str, why: Option<&str>, about: Option<&str>) -> bool {
    let response = ui.add_enabled(why.is_none(), Button::selectable(chosen, text));
    response.widget_info(|| {
        let name = why.map_or_else(|| name.to_owned(), |why| format!("{name}: {why}"));
        egui::WidgetInfo::selected(egui::Role::Button, why.is_none(), chosen, name)
    });
    let response = response.on_disabled_hover_text(why.unwrap_or_default());
    let response = about.into_iter().fold(response, Response::on_hover_text);
    response.clicked()
}

fn choose<T: PartialEq>(ui: &mut Ui, value: &mut T, choice: T, text: &str, name: &str, why: Option<&str>) {
    if pick(ui, *value == choice, text, name, why, None) {
        *value = choice;
    }
}

fn toggle(ui: &mut Ui, on: &mut bool, text: &str, why: Option<&str>) {
    let response = ui.add_enabled_ui(why.is_none(), |ui| controls::tick(ui, on, text)).inner;
    response.on_disabled_hover_text(why.unwrap_or_default());
}

/// A field; around what is `wrong` there is a frame.
fn field(ui: &mut Ui, text: &mut String, width: f32, name: &str, why: Option<&str>, wrong: Option<String>) -> Response {
    let field = ui.add_enabled(why.is_none(), TextEdit::singleline(text).desired_width(width));
    field.widget_info(|| egui::WidgetInfo::labeled(egui::Role::TextInput, why.is_none(), name));
    let field = field.on_disabled_hover_text(why.unwrap_or_default());
    if let Some(wrong) = wrong {
        let stroke = Stroke::new(2.0, ui.visuals().error_fg_color);
        ui.painter().rect_stroke(field.rect, 5.0, stroke, StrokeKind::Inside);
        return field.on_hover_text(wrong);
    }
    field
}
