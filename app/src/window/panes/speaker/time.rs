//! The bar of the time: where the talk is, how many minutes have passed, and how many the notes had planned by now.

use egui::{Align2, Button, DragValue, Rect, RichText, Ui, UiBuilder, pos2, vec2};
use raystep_figure::fonts::elided;
use raystep_figure::{Face, Role, text_width};

use super::desk::{AskedHere, Desk};
use crate::shown::talk::{LENGTHS, clock};
use crate::window::look::fonts::font;
use crate::window::look::painter::caption;
use crate::window::look::visuals::ink;

/// A window below this width is small.
const SMALL: f32 = 1200.0;

/// So many minutes nobody calls late.
const EVEN: f32 = 0.75;

pub(super) fn bar(ui: &mut Ui, desk: &Desk<'_>, rect: Rect, asked: &mut Vec<AskedHere>) {
    let theme = desk.wall.theme;
    let y = rect.center().y;
    let painter = ui.painter().clone();
    let say = |x: f32, y: f32, anchor: Align2, text: &str, face: Face, size: f32, role: Role| {
        caption(&painter, pos2(x, y), anchor, text, face, size, role, theme);
    };
    // A small window has the slide's title instead of its own name, and a shorter bar.
    let small = rect.width() < SMALL;
    let wide = if small { 200.0 } else { 330.0 };
    let bar = Rect::from_min_max(pos2(rect.right() - 190.0 - wide, y - 2.0), pos2(rect.right() - 190.0, y + 5.0));
    let left = rect.left() + if small { 18.0 } else { 176.0 };
    if !small {
        say(rect.left() + 18.0, y, Align2::LEFT_CENTER, "Raystep", Face::Bold, 17.0, Role::Text);
        say(rect.left() + 92.0, y, Align2::LEFT_CENTER, "speaker", Face::Regular, 15.0, Role::Quiet);
    }
    let (passed, planned) = (desk.talk.passed(desk.now), desk.talk.planned(desk.wall.state));
    let passes = clock(passed);
    if let Some(slide) = desk.wall.state.slide() {
        let says = format!("{}  {}", slide.id(), slide.title);
        // A long title is set smaller, and ends before the time.
        let room = bar.left() - 28.0 - text_width(&passes, Face::Bold, 26.0) - left;
        let size = 15.0 * (room / text_width(&says, Face::Medium, 15.0)).clamp(0.8, 1.0);
        let says = elided(&says, Face::Medium, size, room);
        say(left, y - 9.0, Align2::LEFT_CENTER, &says, Face::Medium, size, Role::Text);
        let mut where_ = format!("{} · step {}", slide.numbers_text(), desk.wall.state.view.step);
        if !desk.wall.state.lecture.typed.is_empty() {
            where_ = format!("to slide {} …", desk.wall.state.lecture.typed);
        }
        say(left, y + 10.0, Align2::LEFT_CENTER, &where_, Face::Regular, 13.0, Role::Quiet);
    }
    say(rect.right() - 18.0, y, Align2::RIGHT_CENTER, desk.clock, Face::Bold, 28.0, Role::Text);
    // How far the time is, and where the plan is.
    let length = desk.talk.length(&desk.wall.state.library);
    let at = |minutes: f32| bar.left() + bar.width() * (minutes / length.max(1.0)).clamp(0.0, 1.0);
    say(bar.left() - 14.0, y, Align2::RIGHT_CENTER, &passes, Face::Bold, 26.0, Role::Text);
    painter.rect_filled(bar, 0.0, ink(theme, Role::Edge).gamma_multiply(0.35));
    painter.rect_filled(Rect::from_min_max(bar.min, pos2(at(passed), bar.bottom())), 0.0, ink(theme, Role::Here));
    let plan = at(planned);
    let triangle =
        vec![pos2(plan, bar.top() - 1.0), pos2(plan - 6.0, bar.top() - 10.0), pos2(plan + 6.0, bar.top() - 10.0)];
    painter.add(egui::Shape::convex_polygon(triangle, ink(theme, Role::Text), egui::Stroke::NONE));
    let plan_at = plan.clamp(bar.left() + 60.0, bar.right() - 60.0);
    say(
        plan_at,
        bar.top() - 17.0,
        Align2::CENTER_CENTER,
        &format!("planned: {planned:.0} min"),
        Face::Regular,
        12.5,
        Role::Quiet,
    );
    let (says, role) = match passed - planned {
        late if late > EVEN => (format!("{late:.0} min behind"), Role::Wrong),
        late if late < -EVEN => (format!("{:.0} min ahead", -late), Role::Hit),
        _ => ("in time".to_owned(), Role::Quiet),
    };
    say(bar.left(), bar.bottom() + 11.0, Align2::LEFT_CENTER, &says, Face::Bold, 13.0, role);
    let after = bar.left() + text_width(&says, Face::Bold, 13.0) + 10.0;
    let buttons = Rect::from_min_max(
        pos2(after.max(bar.right() - 132.0), bar.bottom() + 1.0),
        pos2(bar.right() + 72.0, rect.bottom()),
    );
    let mut child = ui.new_child(UiBuilder::new().max_rect(buttons));
    child.horizontal(|ui| {
        // One row below the bar, as low as its letters.
        ui.spacing_mut().item_spacing.x = 3.0;
        ui.spacing_mut().button_padding = vec2(4.0, 0.0);
        ui.spacing_mut().interact_size = vec2(20.0, 18.0);
        ui.style_mut().drag_value_text_style = egui::TextStyle::Small;
        let small = |text: &str| {
            Button::new(RichText::new(text).font(font(Face::Regular, 13.0))).frame(false).min_size(vec2(20.0, 18.0))
        };
        let button = |ui: &mut Ui, text: &str, name: &str| {
            let response = ui.add(small(text)).on_hover_text(name);
            response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, name));
            response.clicked()
        };
        if button(ui, "−", "Five minutes less") {
            asked.push(AskedHere::Lengthen(false));
        }
        let mut minutes = length.round();
        let has = DragValue::new(&mut minutes).range(LENGTHS).speed(0.5).fixed_decimals(0).prefix("of ").suffix(" min");
        let has = ui
            .add(has)
            .on_hover_text("How long the talk is: as the notes of this section's slides plan it, or as you set it");
        if has.changed() {
            asked.push(AskedHere::Length(minutes));
        }
        if button(ui, "+", "Five minutes more") {
            asked.push(AskedHere::Lengthen(true));
        }
        if button(ui, "restart", "The time begins anew") {
            asked.push(AskedHere::Restart);
        }
    });
}
