//! A step of a walk or of a build on one page: what is said, space, the ray's t or the costs, tree or cells,
//! the listing, what waits and the work, as the window shows them.

mod compose;
mod parts;

use glam::Vec2;
use raystep_figure::{Figure, ListingLine, Look, Pane, Role, Still};

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
    /// What stands on the page beside them.
    pub parts: &'a [Part],
}

/// A part of a plate that has its own place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The title, and where it belongs.
    Title,
    /// What is said.
    Text,
    /// Space, or the picture in its place.
    Space,
    /// The algorithm.
    Listing,
    /// What waits.
    Stack,
    /// The work so far.
    Work,
    /// What the marks of space mean.
    Legend,
    /// The track of all steps.
    Timeline,
}

impl Part {
    /// All of them: the usual plate.
    pub const ALL: [Part; 8] =
        [Part::Title, Part::Text, Part::Space, Part::Listing, Part::Stack, Part::Work, Part::Legend, Part::Timeline];
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
        let (size, body) = (self.figure.size, self.body());
        let (pictures, code) = (self.has_pictures(), self.has_code());
        let share = match (self.has(Part::Text), pictures || code) {
            (true, true) => 0.225,
            (true, false) => 1.0,
            (false, _) => 0.0,
        };
        let said = Area { max: Vec2::new((size.x * share).round(), body.max.y), ..body };
        let code_at = match (code, pictures) {
            (true, true) => (size.x * 0.72).round(),
            (true, false) => said.max.x,
            (false, _) => size.x,
        };
        let middle = Area { min: Vec2::new(said.max.x, body.min.y), max: Vec2::new(code_at, body.max.y) };
        let below = self.pictures(middle, picture);
        // What is drawn beyond the picture's edge disappears under the other panes.
        if share > 0.0 {
            said.fill(&mut self.figure, Role::Page);
            self.said(said.inset(EDGE));
        }
        self.below(below);
        if code {
            self.code(Area { min: Vec2::new(code_at, body.min.y), ..body });
        }
        self.ends();
    }

    /// One above the other, the algorithm beside the stack and the work.
    fn tall(&mut self, picture: &dyn Fn(Vec2) -> Figure) {
        let (size, body) = (self.figure.size, self.body());
        let (pictures, code) = (self.has_pictures(), self.has_code());
        let said = if self.has(Part::Text) { (body.size().y * 0.2).max(200.0) } else { 0.0 };
        let (said, rest) = body.split_top(if pictures || code { said } else { body.size().y });
        let share = match (pictures, code) {
            (true, true) => 0.68,
            (true, false) => 1.0,
            (false, _) => 0.0,
        };
        let (middle, code_area) = rest.split_top(rest.size().y * share);
        let below = self.pictures(middle, picture);
        if self.has(Part::Text) {
            said.fill(&mut self.figure, Role::Page);
            let caption = self.caption(size.x * 0.6 - 1.5 * EDGE, said.size().y - 2.0 * EDGE);
            set_in(&mut self.figure, caption, said.min + EDGE);
            if self.has(Part::Legend) {
                self.legend(Area::new(size.x * 0.62, said.min.y + EDGE * 0.5, size.x - EDGE, said.max.y));
            }
        }
        self.below(below);
        if code {
            let half = (size.x * 0.55).round();
            let left = Area { max: Vec2::new(half, code_area.max.y), ..code_area };
            let right = Area { min: Vec2::new(half, code_area.min.y), ..code_area };
            left.fill(&mut self.figure, Role::Panel);
            right.fill(&mut self.figure, Role::Panel);
            if self.has_listing() {
                self.listing(left.inset(EDGE * 0.5));
            }
            self.stack_and_work(right.inset(EDGE * 0.5));
        }
        self.ends();
    }

    /// What is left of the page between the strips above and below.
    fn body(&self) -> Area {
        let [head, foot] = [(Part::Title, HEAD), (Part::Timeline, FOOT)];
        let height = |(part, height): (Part, f32)| if self.has(part) { height } else { 0.0 };
        Area::new(0.0, height(head), self.figure.size.x, self.figure.size.y - height(foot))
    }

    /// The strips above and below.
    fn ends(&mut self) {
        let size = self.figure.size;
        if self.has(Part::Title) {
            self.head(Area::new(0.0, 0.0, size.x, HEAD));
        }
        if self.has(Part::Timeline) {
            self.foot(Area::new(0.0, size.y - FOOT, size.x, size.y));
        }
    }

    /// Draws space and, where no text stands beside it, what its marks mean; says what is left for the panes below.
    fn pictures(&mut self, area: Area, picture: &dyn Fn(Vec2) -> Figure) -> Area {
        if !self.has(Part::Space) {
            return area;
        }
        let (space, below) = area.split_top(area.size().y - self.below_height(area.size().y));
        let legend = if self.has(Part::Text) { 0.0 } else { self.legend_height(area.size().x) };
        let (space, strip) = space.split_top(space.size().y - legend);
        self.space(space, picture);
        if legend > 0.0 {
            strip.fill(&mut self.figure, Role::Panel);
            self.legend(strip);
        }
        below
    }

    fn has(&self, part: Part) -> bool {
        self.plate.parts.contains(&part)
    }

    /// Whether space or a pane below it is shown.
    fn has_pictures(&self) -> bool {
        self.has(Part::Space) || self.panes().next().is_some()
    }

    /// Whether an algorithm runs.
    fn has_listing(&self) -> bool {
        self.has(Part::Listing) && !self.plate.listing.is_empty()
    }

    /// Whether an algorithm runs, something waits, or work is counted.
    fn has_code(&self) -> bool {
        self.has_listing() || self.has_pane(Part::Stack, Pane::Stack) || self.has_pane(Part::Work, Pane::Work)
    }

    fn has_pane(&self, part: Part, pane: Pane) -> bool {
        self.has(part) && self.plate.still.has(pane)
    }
}
