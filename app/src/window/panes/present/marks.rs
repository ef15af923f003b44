//! What the lecturer's hand leaves on the page: a large pointer, and strokes of a pen that go at the next step. Both are
//! kept in parts of the page, so that the class's page and its picture on the speaker's window show the same.

use egui::{Color32, CursorIcon, Event, PointerButton, Pos2, Rect, Sense, Stroke, Ui, pos2};
use raystep_figure::{Role, Theme};

use crate::shown::lecture::InHand;
use crate::shown::state::State;
use crate::window::look::visuals::ink;
use crate::window::panes::page::Page;

/// A pointer and strokes, in parts of the page's width and height.
#[derive(Clone, Debug, Default)]
pub(crate) struct Marks {
    /// The slide and the step that the strokes are drawn on.
    of: Option<(usize, usize)>,
    strokes: Vec<Vec<Pos2>>,
    /// Whether the pen is down.
    down: bool,
    /// Where the large pointer is, as far as a page has said so in this frame, and where it was in the last one.
    pointer: [Option<Pos2>; 2],
}

/// The most points of a stroke: a hand that never rests fills no memory.
const LONGEST: usize = 4000;

impl Marks {
    /// A frame begins.
    pub(crate) fn begin(&mut self, state: &State) {
        let of = Some((state.view.slide, state.view.step));
        if self.of != of {
            self.of = of;
            self.strokes.clear();
        }
        self.pointer = [None, self.pointer[0]];
    }

    /// Takes in what the hand does over a page, and shows what is there.
    pub(super) fn show(&mut self, ui: &mut Ui, page: Page<'_>, rect: Rect, body: f32) {
        let in_hand = page.state.lecture.in_hand;
        if in_hand == InHand::Pen {
            self.write(ui, rect);
        }
        let hover = ui.interact(rect, ui.scope_id().with("hand"), Sense::hover()).hover_pos();
        if in_hand == InHand::Pointer {
            if let Some(at) = hover {
                self.pointer[0] = Some(part(rect, at));
                ui.ctx().set_cursor_icon(CursorIcon::None);
            }
            // It may be on the other of the two pages.
            if let Some(at) = self.pointer[0].or(self.pointer[1]) {
                point(ui, page.theme, place(rect, at), body);
            }
        }
        // No colour that means something in the picture.
        let stroke = Stroke::new(body * 0.16, ink(page.theme, Role::Text));
        if let Some(at) = hover.filter(|_| in_hand == InHand::Pen) {
            ui.painter().circle_filled(at, stroke.width * 0.5, stroke.color);
        }
        for points in &self.strokes {
            let points: Vec<Pos2> = points.iter().map(|at| place(rect, *at)).collect();
            match points.as_slice() {
                [only] => drop(ui.painter().circle_filled(*only, stroke.width, stroke.color)),
                _ => drop(ui.painter().line(points, stroke)),
            }
        }
    }

    fn write(&mut self, ui: &mut Ui, rect: Rect) {
        let response = ui.interact(rect, ui.scope_id().with("pen"), Sense::click_and_drag());
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "Pen"));
        if response.hovered() || response.dragged() {
            ui.ctx().set_cursor_icon(CursorIcon::Crosshair);
        }
        // All places since the last frame, not the last one alone: a quick hand draws a curve.
        for event in ui.input(|input| input.events.clone()) {
            match event {
                Event::PointerButton { pos, button: PointerButton::Primary, pressed: true, .. } => {
                    self.down = response.contains_pointer();
                    if self.down {
                        self.strokes.push(vec![part(rect, pos)]);
                    }
                }
                Event::PointerMoved(pos) if self.down => self.draw_to(part(rect, pos)),
                Event::PointerButton { pos, button: PointerButton::Primary, pressed: false, .. } if self.down => {
                    self.draw_to(part(rect, pos));
                    self.down = false;
                }
                Event::PointerGone => self.down = false,
                _ => {}
            }
        }
    }

    fn draw_to(&mut self, at: Pos2) {
        if let Some(stroke) = self.strokes.last_mut()
            && stroke.last() != Some(&at)
            && stroke.len() < LONGEST
        {
            stroke.push(at);
        }
    }

    /// How many places the strokes have, all of them.
    pub(crate) fn places(&self) -> usize {
        self.strokes.iter().map(Vec::len).sum()
    }

    /// How many strokes there are.
    pub(crate) fn strokes(&self) -> usize {
        self.strokes.len()
    }
}

/// A disc that is seen from the last row.
fn point(ui: &Ui, theme: &Theme, at: Pos2, body: f32) {
    let color = ink(theme, Role::Live);
    ui.painter().circle(at, body * 0.9, color.gamma_multiply(0.35), Stroke::new(body * 0.14, color));
    ui.painter().circle_filled(at, body * 0.12, Color32::WHITE);
}

fn part(rect: Rect, at: Pos2) -> Pos2 {
    pos2((at.x - rect.left()) / rect.width().max(1.0), (at.y - rect.top()) / rect.height().max(1.0))
}

fn place(rect: Rect, part: Pos2) -> Pos2 {
    pos2(rect.left() + part.x * rect.width(), rect.top() + part.y * rect.height())
}
