//! A step of a walk or of a build on one page: what is said, space, the ray's t or the costs, tree or cells,
//! the listing, what waits and the work, as the window shows them.

mod compose;

use glam::Vec2;
use raystep_figure::{Anchor, Ask, Face, Figure, Ink, ListingLine, Look, Pane, Role, Still, fonts};

use crate::prose;
use compose::Area;
pub use compose::{enlarge, set_in};

/// A step and what is said about it.
#[derive(Clone, Copy)]
pub struct Plate<'a> {
    /// The page's title.
    pub title: &'a str,
    /// Where it belongs: section, slide numbers, stage, ray.
    pub about: &'a str,
    /// The heading of what is said.
    pub heading: &'a str,
    /// What is said: Markdown with formulas, its fields filled in.
    pub caption: &'a str,
    /// The step.
    pub still: Still<'a>,
    /// The algorithm; may be empty.
    pub listing: &'a [ListingLine<'a>],
    /// The panes below space, from the top. Those that the step has nothing to show in are left out.
    pub below: &'a [Pane],
}

/// The page at this size; `picture` draws space at the size that it gets.
pub fn plate(plate: &Plate<'_>, size: Vec2, picture: &dyn Fn(Vec2) -> Figure) -> Figure {
    let mut page = Page { figure: Figure::new(size), look: Look { text: TEXT, titles: true, least: 0.0 }, plate };
    if size.x >= size.y * 1.2 {
        page.wide(picture);
    } else {
        page.tall(picture);
    }
    page.figure
}

/// Size of body text in points on a page of 1600 by 1000.
const TEXT: f32 = 15.0;
/// Size of the listing, whose lines must not be cut.
const CODE: f32 = 13.8;
/// Size of what is said.
const SAID: f32 = 17.5;
/// Room at the edges.
const EDGE: f32 = 24.0;
/// Heights of the strips above and below.
const HEAD: f32 = 64.0;
const FOOT: f32 = 78.0;

/// How much larger space is set than in a window.
const CLOSER: f32 = 1.15;

struct Page<'a> {
    figure: Figure,
    look: Look,
    plate: &'a Plate<'a>,
}

impl Page<'_> {
    /// Three columns: what is said, the pictures, the algorithm.
    fn wide(&mut self, picture: &dyn Fn(Vec2) -> Figure) {
        let size = self.figure.size;
        let said = Area::new(0.0, HEAD, (size.x * 0.225).round(), size.y - FOOT);
        let code = if self.has_code() { 0.72 } else { 1.0 };
        let code = Area::new((size.x * code).round(), HEAD, size.x, size.y - FOOT);
        let middle = Area::new(said.max.x, HEAD, code.min.x, size.y - FOOT);
        let (space_area, below) = middle.split_top(middle.size().y - self.below_height(middle.size().y));
        self.space(space_area, picture);
        // What is drawn beyond the picture's edge disappears under the other panes.
        said.fill(&mut self.figure, Role::Page);
        self.said(said.inset(EDGE));
        self.below(below);
        if self.has_code() {
            self.code(code);
        }
        self.head(Area::new(0.0, 0.0, size.x, HEAD));
        self.foot(Area::new(0.0, size.y - FOOT, size.x, size.y));
    }

    /// Whether an algorithm runs, something waits, or work is counted.
    fn has_code(&self) -> bool {
        let still = &self.plate.still;
        !self.plate.listing.is_empty() || [Pane::Stack, Pane::Work].into_iter().any(|pane| still.has(pane))
    }

    /// One above the other, the algorithm beside the stack and the work.
    fn tall(&mut self, picture: &dyn Fn(Vec2) -> Figure) {
        let size = self.figure.size;
        let body = Area::new(0.0, HEAD, size.x, size.y - FOOT);
        let caption = self.caption(size.x * 0.6 - 1.5 * EDGE);
        let (said, rest) = body.split_top((body.size().y * 0.2).max(200.0));
        let (pictures, code) = rest.split_top(rest.size().y * 0.68);
        let (space_area, below) = pictures.split_top(pictures.size().y - self.below_height(pictures.size().y));
        self.space(space_area, picture);
        said.fill(&mut self.figure, Role::Page);
        set_in(&mut self.figure, caption, said.min + EDGE);
        let legend_area = Area::new(size.x * 0.62, said.min.y + EDGE * 0.5, size.x - EDGE, said.max.y);
        self.legend(legend_area);
        self.below(below);
        let half = (size.x * 0.55).round();
        let (left, right) =
            (Area { max: Vec2::new(half, code.max.y), ..code }, Area { min: Vec2::new(half, code.min.y), ..code });
        left.fill(&mut self.figure, Role::Panel);
        right.fill(&mut self.figure, Role::Panel);
        self.listing(left.inset(EDGE * 0.5));
        self.stack_and_work(right.inset(EDGE * 0.5));
        self.head(Area::new(0.0, 0.0, size.x, HEAD));
        self.foot(Area::new(0.0, size.y - FOOT, size.x, size.y));
    }

    fn space(&mut self, area: Area, picture: &dyn Fn(Vec2) -> Figure) {
        area.fill(&mut self.figure, Role::Panel);
        // A solid scene fills its pane; a drawing keeps away from the edges.
        let inner = area.inset(if self.plate.still.flat() { EDGE * 0.5 } else { 1.0 });
        // A page is read from further away than a window: labels are a little larger.
        let mut part = picture(inner.size() / CLOSER);
        enlarge(&mut part, CLOSER);
        set_in(&mut self.figure, part, inner.min);
    }

    fn head(&mut self, area: Area) {
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

    fn foot(&mut self, area: Area) {
        area.fill(&mut self.figure, Role::Panel);
        let inner = Area::new(area.min.x + EDGE * 0.5, area.min.y, area.max.x - EDGE * 0.5, area.max.y);
        let strip = self.plate.still.draw(Pane::Timeline, &Ask::new(inner.size(), self.look));
        set_in(&mut self.figure, strip, inner.min);
    }

    /// The heading and the text below it, as one figure of this width.
    fn caption(&self, width: f32) -> Figure {
        let mut said = prose(self.plate.heading, width, SAID * 1.2, Face::Bold, Role::Text);
        let text = prose(self.plate.caption, width, SAID, Face::Regular, Role::Text);
        let top = said.size.y + SAID * 0.7;
        let height = top + text.size.y;
        set_in(&mut said, text, Vec2::new(0.0, top));
        said.size.y = height;
        said
    }

    fn said(&mut self, area: Area) {
        let caption = self.caption(area.size().x);
        let end = area.min.y + caption.size.y;
        set_in(&mut self.figure, caption, area.min);
        // A picture that is no stage explains its own signs.
        let still = &self.plate.still;
        let Some(shown) = still.space().filter(|_| !still.has(Pane::Picture)) else { return };
        let margin = TEXT * 0.8;
        let height = self.plate.still.legend_height(&shown, area.size().x + 2.0 * margin, &self.look);
        // The legend keeps to the foot of the column, and gives way to a long text.
        let top = area.max.y - height + margin;
        if top > end + SAID {
            self.legend(Area { min: Vec2::new(area.min.x - margin, top), ..area });
        }
    }

    fn legend(&mut self, area: Area) {
        let ask = Ask::new(area.size() + Vec2::X * TEXT * 0.8, self.look);
        let part = self.plate.still.draw(Pane::Legend, &ask);
        set_in(&mut self.figure, part, area.min);
    }

    /// The panes below space that show something.
    fn panes(&self) -> impl Iterator<Item = Pane> {
        self.plate.below.iter().copied().filter(|pane| self.plate.still.has(*pane))
    }

    /// How high they are, of so much.
    fn below_height(&self, of: f32) -> f32 {
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

    fn below(&mut self, area: Area) {
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

    fn code(&mut self, area: Area) {
        let line = (CODE * 1.7).round();
        let wanted = (self.plate.listing.len() as f32 + 2.8) * line + EDGE;
        let (top, rest) = if self.plate.listing.is_empty() {
            area.split_top(0.0)
        } else {
            area.split_top(wanted.min(area.size().y * 0.6).min(area.size().y - self.below_code()))
        };
        if !self.plate.listing.is_empty() {
            top.fill(&mut self.figure, Role::Panel);
            self.listing(top.inset(EDGE * 0.4));
        }
        rest.fill(&mut self.figure, Role::Panel);
        self.stack_and_work(rest.inset(EDGE * 0.4));
    }

    /// How high what stands below the listing must be, where that follows from what it shows.
    fn below_code(&self) -> f32 {
        let work = self.plate.still.height(Pane::Work, &self.look);
        work.map_or(0.0, |height| height + self.stack_height() + EDGE)
    }

    /// How high the stack is with all its rows.
    fn stack_height(&self) -> f32 {
        let rows = self.plate.still.stacked().max(1) as f32;
        rows * 2.75 * TEXT + 3.2 * TEXT
    }

    fn listing(&mut self, area: Area) {
        let look = Look { text: CODE, ..self.look };
        let ask = Ask { lines: self.plate.listing, ..Ask::new(area.size(), look) };
        let part = self.plate.still.draw(Pane::Listing, &ask);
        set_in(&mut self.figure, part, area.min);
    }

    fn stack_and_work(&mut self, area: Area) {
        let mut rest = area;
        if self.plate.still.has(Pane::Stack) {
            let work = self.plate.still.height(Pane::Work, &self.look).unwrap_or(9.0 * TEXT);
            let most = (area.size().y - work).max(area.size().y * 0.25);
            let (top, below) = area.split_top(self.stack_height().min(most));
            let part = self.plate.still.draw(Pane::Stack, &Ask::new(top.size(), self.look));
            set_in(&mut self.figure, part, top.min);
            rest = below;
        }
        let part = self.plate.still.draw(Pane::Work, &Ask::new(rest.size(), self.look));
        set_in(&mut self.figure, part, rest.min);
    }

    fn text(&mut self, role: Role, at: Vec2, text: &str, size: f32, face: Face, anchor: Anchor) {
        self.figure.add(role, None, Ink::Text { at, text: text.to_owned(), size, face, anchor, boxed: false });
    }
}
