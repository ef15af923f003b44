//! What stands on a plate, each in the area that it gets.

use glam::Vec2;
use raystep_figure::{Anchor, Ask, Face, Figure, Ink, Look, Pane, Role, fonts};

use super::compose::{Area, enlarge, set_in};
use super::{CLOSER, CODE, EDGE, Page, Part, SAID, TEXT};
use crate::prose;

/// How high the work is that is counted in a number and a few words.
const WORK: f32 = 9.0 * TEXT;

impl Page<'_> {
    pub(super) fn space(&mut self, area: Area, picture: &dyn Fn(Vec2) -> Figure) {
        area.fill(&mut self.figure, Role::Panel);
        // A solid scene fills its pane; a drawing keeps away from the edges.
        let inner = area.inset(if self.plate.still.flat() { EDGE * 0.5 } else { 1.0 });
        // A page is read from further away than a window: labels are a little larger.
        let mut part = picture(inner.size() / CLOSER);
        enlarge(&mut part, CLOSER);
        set_in(&mut self.figure, part, inner.min);
    }

    pub(super) fn head(&mut self, area: Area) {
        area.fill(&mut self.figure, Role::Panel);
        let middle = area.min.y + area.size().y * 0.5;
        let (left, right) = (area.min.x + EDGE, area.max.x - EDGE);
        let title_size = 26.0;
        let title_room = (right - left) * 0.62;
        let title = fonts::elided(self.plate.title, Face::Bold, title_size, title_room);
        let about_room = right - left - fonts::text_width(&title, Face::Bold, title_size) - 2.0 * EDGE;
        let about = fonts::elided(self.plate.about, Face::Regular, TEXT, about_room);
        self.text(Role::Text, Vec2::new(left, middle), &title, title_size, Face::Bold, Anchor::Start);
        self.text(Role::Quiet, Vec2::new(right, middle), &about, TEXT, Face::Regular, Anchor::End);
    }

    pub(super) fn foot(&mut self, area: Area) {
        area.fill(&mut self.figure, Role::Panel);
        let inner = Area::new(area.min.x + EDGE * 0.5, area.min.y, area.max.x - EDGE * 0.5, area.max.y);
        let strip = self.plate.still.draw(Pane::Timeline, &Ask::new(inner.size(), self.look));
        set_in(&mut self.figure, strip, inner.min);
    }

    /// The heading and the text below it, as one figure of this width; in smaller letters rather than higher than this.
    pub(super) fn caption(&self, width: f32, high: f32) -> Figure {
        let set = |part: f32| self.caption_in(width, SAID * part);
        [1.0, 0.93, 0.86].into_iter().map(set).find(|said| said.size.y <= high).unwrap_or_else(|| set(0.8))
    }

    fn caption_in(&self, width: f32, letters: f32) -> Figure {
        let mut said = prose(self.plate.heading, width, letters * 1.2, Face::Bold, Role::Text);
        let text = prose(self.plate.caption, width, letters, Face::Regular, Role::Text);
        let top = said.size.y + letters * 0.7;
        let height = top + text.size.y;
        set_in(&mut said, text, Vec2::new(0.0, top));
        said.size.y = height;
        said
    }

    pub(super) fn said(&mut self, area: Area) {
        let caption = self.caption(area.size().x, area.size().y);
        let end = area.min.y + caption.size.y;
        set_in(&mut self.figure, caption, area.min);
        let margin = TEXT * 0.8;
        let height = self.legend_height(area.size().x + 2.0 * margin);
        // The legend keeps to the foot of the column, and gives way to a long text.
        let top = area.max.y - height + margin;
        if height > 0.0 && top > end + SAID {
            self.legend(Area { min: Vec2::new(area.min.x - margin, top), ..area });
        }
    }

    /// How high a legend of this width is; nothing where there is none.
    pub(super) fn legend_height(&self, width: f32) -> f32 {
        let still = &self.plate.still;
        let shown = still.space().filter(|_| self.has(Part::Legend));
        shown.map_or(0.0, |shown| still.legend_height(&shown, width, &self.look))
    }

    pub(super) fn legend(&mut self, area: Area) {
        let ask = Ask::new(area.size() + Vec2::X * TEXT * 0.8, self.look);
        let part = self.plate.still.draw(Pane::Legend, &ask);
        set_in(&mut self.figure, part, area.min);
    }

    /// The panes below space that show something.
    pub(super) fn panes(&self) -> impl Iterator<Item = Pane> {
        self.plate.below.iter().copied().filter(|pane| self.plate.still.has(*pane) && !self.plate.still.is_bare(*pane))
    }

    /// How high they are, of so much.
    pub(super) fn below_height(&self, of: f32) -> f32 {
        let wanted: f32 = self.panes().map(|pane| self.height(pane)).sum();
        wanted.min(of * 0.55)
    }

    fn height(&self, pane: Pane) -> f32 {
        let usual = match pane {
            Pane::Cells => 232.0,
            Pane::Slabs => 190.0,
            Pane::Bytes => 300.0,
            _ => 200.0,
        };
        self.plate.still.height(pane, &self.look).map_or(usual, |height| height + 14.0)
    }

    pub(super) fn below(&mut self, area: Area) {
        let panes: Vec<Pane> = self.panes().collect();
        let wanted: f32 = panes.iter().map(|pane| self.height(*pane)).sum();
        let mut rest = area;
        for shown in panes {
            let (pane, after) = rest.split_top(area.size().y * self.height(shown) / wanted);
            rest = after;
            pane.fill(&mut self.figure, Role::Panel);
            let inner = Area::new(pane.min.x + EDGE * 0.3, pane.min.y + 4.0, pane.max.x - EDGE * 0.3, pane.max.y - 4.0);
            let part = self.plate.still.draw(shown, &Ask::new(inner.size(), self.look));
            set_in(&mut self.figure, part, inner.min);
        }
    }

    pub(super) fn code(&mut self, area: Area) {
        let line = (CODE * 1.7).round();
        let wanted = (self.plate.listing.len() as f32 + 2.8) * line + EDGE;
        let others = self.has_pane(Part::Stack, Pane::Stack) || self.has_pane(Part::Work, Pane::Work);
        let (top, rest) = match (self.has_listing(), others) {
            (false, _) => area.split_top(0.0),
            (true, true) => area.split_top(wanted.min(self.code_height(area.size().y))),
            (true, false) => area.split_top(area.size().y),
        };
        if self.has_listing() {
            top.fill(&mut self.figure, Role::Panel);
            self.listing(top.inset(EDGE * 0.4));
        }
        if others || !self.has_listing() {
            rest.fill(&mut self.figure, Role::Panel);
            self.stack_and_work(rest.inset(EDGE * 0.4));
        }
    }

    /// How high a listing may be, of so much: what stands below it comes first where its height follows from what it shows,
    /// and what waits needs no more room than its rows.
    fn code_height(&self, of: f32) -> f32 {
        let work = self.plate.still.height(Pane::Work, &self.look).filter(|_| self.has(Part::Work));
        let left = |work: f32| of - work - self.stack_height() - EDGE;
        match work {
            Some(work) => left(work).min(of * 0.6),
            None if self.has_pane(Part::Stack, Pane::Stack) => left(WORK).clamp(of * 0.6, of * 0.72),
            None => of * 0.6,
        }
    }

    /// How high the stack is with all its rows.
    fn stack_height(&self) -> f32 {
        let rows = self.plate.still.stacked().max(1) as f32;
        rows * 2.75 * TEXT + 3.2 * TEXT
    }

    pub(super) fn listing(&mut self, area: Area) {
        let look = Look { text: CODE, ..self.look };
        let ask = Ask { lines: self.plate.listing, ..Ask::new(area.size(), look) };
        let part = self.plate.still.draw(Pane::Listing, &ask);
        set_in(&mut self.figure, part, area.min);
    }

    pub(super) fn stack_and_work(&mut self, area: Area) {
        let mut rest = area;
        if self.has_pane(Part::Stack, Pane::Stack) {
            let work = self.plate.still.height(Pane::Work, &self.look).unwrap_or(WORK);
            let work = if self.has(Part::Work) { work } else { 0.0 };
            let most = (area.size().y - work).max(area.size().y * 0.25);
            let (top, below) = area.split_top(self.stack_height().min(most));
            let part = self.plate.still.draw(Pane::Stack, &Ask::new(top.size(), self.look));
            set_in(&mut self.figure, part, top.min);
            rest = below;
        }
        if self.has(Part::Work) {
            let part = self.plate.still.draw(Pane::Work, &Ask::new(rest.size(), self.look));
            set_in(&mut self.figure, part, rest.min);
        }
    }

    fn text(&mut self, role: Role, at: Vec2, text: &str, size: f32, face: Face, anchor: Anchor) {
        self.figure.add(role, None, Ink::Text { at, text: text.to_owned(), size, face, anchor, boxed: false });
    }
}
