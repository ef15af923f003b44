//! A step as a figure: a plate, or one pane alone.

use glam::Vec2;
use raystep_figure::{
    Ask, Camera, Detail, Figure, ListingLine, Look, Pane, Reel, Scenery, Space, Still, Theme, TreeView, close_up, crop,
    inset_at, inset_size, is_nearer, set_inset, stage_around as picture_of,
};
use raystep_lesson::Tape;
use raystep_print::{Part, Plate, drawn, part, plate, set_in};

use super::{Format, Order, Piece, Session, Size, View};
use crate::fault::Fault;
use crate::shown::eye;
use crate::shown::reel::lines;

/// A step that is being drawn.
struct Sheet<'a> {
    session: &'a Session<'a>,
    order: &'a Order,
    still: Still<'a>,
    reel: &'a Reel<'a>,
    step: usize,
    beat: Option<usize>,
    /// How many pixels a point has.
    scale: f32,
    /// While a beat's question is open: what answers it is hidden, and so are totals if it asks for one.
    asks: Option<bool>,
}

impl Session<'_> {
    /// A step as a figure of this many pixels, and how many pixels a point has.
    pub(crate) fn figure(
        &self,
        view: View,
        step: usize,
        beat: Option<usize>,
        pixels: Vec2,
        theme: &Theme,
    ) -> Result<(Figure, f32), Fault> {
        let theme = Theme::named(theme.name).unwrap_or(&Theme::LIGHT);
        self.figure_of(&Order::new(view, Format::Png, Size::USUAL, theme), step, beat, pixels)
    }

    /// A step on a page of so many points, whose shaded scenes have `scale` pixels to a point; while the question of a
    /// beat is `asked`, without what answers it.
    pub(crate) fn figure_on(
        &self,
        view: View,
        step: usize,
        asked: Option<usize>,
        page: Vec2,
        scale: f32,
        theme: &Theme,
    ) -> Result<Figure, Fault> {
        let theme = Theme::named(theme.name).unwrap_or(&Theme::LIGHT);
        let order = Order::new(view, Format::Png, Size::USUAL, theme);
        let ask = asked.and_then(|beat| self.ground.beats.get(beat)?.ask.as_ref());
        let asks = ask.map(|ask| ask.about.is_total());
        Ok(self.laid_out(&order, step, None, asks, page * scale, scale)?.0)
    }

    /// The same, with everything that an order says of it.
    pub(super) fn figure_of(
        &self,
        order: &Order,
        step: usize,
        beat: Option<usize>,
        pixels: Vec2,
    ) -> Result<(Figure, f32), Fault> {
        // Everything is laid out on a page of one size, so that a larger picture is the same picture.
        let page = if order.view == View::Plate { PLATE } else { BARE };
        let larger = if *order.theme == Theme::PROJECTOR { PROJECTED } else { 1.0 };
        let scale = (pixels.x * pixels.y / (page.x * page.y)).sqrt() * larger;
        self.laid_out(order, step, beat, None, pixels, scale)
    }

    fn laid_out(
        &self,
        order: &Order,
        step: usize,
        beat: Option<usize>,
        asks: Option<bool>,
        pixels: Vec2,
        scale: f32,
    ) -> Result<(Figure, f32), Fault> {
        let reel = self.reel();
        let instant = reel.at(step);
        let still = reel.still(&instant).to_depth(self.ground.depth);
        // What has changed is told of the step before.
        let tells = |piece: &Piece| *piece == Piece::View(View::Changed);
        let changed = order.view == View::Changed || order.pieces.iter().any(tells);
        let before = changed.then(|| reel.at(step.saturating_sub(1)));
        let still = before.as_ref().map_or(still, |before| still.since(before));
        let sheet = Sheet { session: self, order, still, reel: &reel, step, beat, scale, asks };
        let drawn = match (order.view, order.view.pane()) {
            (View::Plate, _) => (sheet.plate(pixels / scale), scale),
            (View::Heat, _) if !reel.has(Pane::Heat) => fitted(sheet.heat()?, pixels),
            (View::Tree, _) => (sheet.draw(Pane::Tree, pixels / scale), scale),
            (_, Some(pane)) => fitted(sheet.alone(pane), pixels),
            (_, None) => (sheet.space(pixels / scale), scale),
        };
        self.ground.goes_on().map(|()| drawn)
    }
}

impl Sheet<'_> {
    /// Space, or what stands in its place, and what its marks mean if that is asked for.
    fn space(&self, size: Vec2) -> Figure {
        let shown = self.still.space();
        let Some(shown) = shown.filter(|_| self.order.legend == Some(true)) else { return self.picture(size) };
        let look = Look::WINDOW;
        let height = self.still.legend_height(&shown, size.x, &look);
        let mut figure = self.picture(size - Vec2::Y * height);
        figure.size = size;
        let ask = Ask { space: Some(&shown), ..Ask::new(Vec2::new(size.x, height), look) };
        set_in(&mut figure, self.still.draw(Pane::Legend, &ask), Vec2::Y * (size.y - height));
        figure
    }

    fn picture(&self, size: Vec2) -> Figure {
        let Some(shown) = self.still.space().filter(|_| !self.still.has(Pane::Picture)) else {
            let ask = Ask { hide: self.asks.is_some(), ..Ask::new(size, Look::WINDOW) };
            return self.still.draw(Pane::Picture, &ask);
        };
        let ground = self.session.ground;
        let camera = ground.camera(&shown, size);
        let mut figure = self.seen(None, &shown, &camera, size);
        // What is but a dot there is seen from near in a corner.
        let inset = (!self.still.flat()).then(|| Some((self.still.detail()?, inset_size(size)?))).flatten();
        let framed = inset.map(|(Detail { title, bounds, focus }, inset)| {
            let near = eye::framed(&camera, &bounds, inset);
            (title, is_nearer(focus, (&near, inset), (&camera, size)).then_some((near, inset)))
        });
        if let Some((title, Some((near, inset)))) = framed {
            let shaded = ground.scenery(&near, inset * self.fineness(), self.order.theme);
            let scenery = shaded.as_deref().map_or(Scenery::Left, Scenery::Shaded);
            let small = close_up(&shown, self.reel.prims(), &near, inset, scenery);
            // Labels make room for it.
            let at = inset_at(&figure, inset);
            figure = self.seen(Some([at, at + inset]), &shown, &camera, size);
            set_inset(&mut figure, at, small, &title);
        }
        // Where no ground covers it nothing may be drawn beyond the picture's edge.
        if self.order.clear {
            crop(&mut figure, 0.0);
        }
        figure
    }

    /// Space with its labels; where corners are `kept`, these stay out of the rectangle between them.
    fn seen(&self, kept: Option<[Vec2; 2]>, shown: &Space, camera: &Camera, size: Vec2) -> Figure {
        let (ground, prims) = (self.session.ground, self.reel.prims());
        if self.still.flat() {
            return picture_of(kept, shown, prims, camera, size, Scenery::Drawn);
        }
        let shaded = ground.scenery(camera, size * self.fineness(), self.order.theme);
        picture_of(kept, shown, prims, camera, size, shaded.as_deref().map_or(Scenery::Left, Scenery::Shaded))
    }

    /// How many pixels of a shaded scene a point has: where lines stay sharp, more than the file is large.
    fn fineness(&self) -> f32 {
        if self.order.format.is_sharp() { self.scale * FINER } else { self.scale }
    }

    /// What each ray of the picture costs.
    fn heat(&self) -> Result<Figure, Fault> {
        let size = BARE * 0.75;
        let Some(shown) = self.still.space() else { return Ok(Figure::new(size)) };
        self.session.ground.heat(&shown, size)
    }

    fn draw(&self, pane: Pane, size: Vec2) -> Figure {
        // A tree says itself what it is.
        let look = Look { titles: pane != Pane::Tree, ..Look::WINDOW };
        let listing = self.listing();
        let view = TreeView { uncounted: self.asks == Some(true), ..TreeView::default() };
        let (hide, view) = (self.asks.is_some(), Some(&view));
        self.still.draw(pane, &Ask { hide, view, lines: &listing, ..Ask::new(size, look) })
    }

    fn listing(&self) -> Vec<ListingLine<'_>> {
        let Session { ground, play, .. } = self.session;
        lines(ground.library.listing(&ground.listing), play, &ground.rule, self.step, None)
    }

    /// A pane as large as it wants to be.
    fn alone(&self, pane: Pane) -> Figure {
        let look = Look::WINDOW;
        let own = self.still.height(pane, &look);
        let size = match pane {
            Pane::Listing => Vec2::new(COLUMN, (self.listing().len() as f32 + 3.4) * look.text * 1.7),
            Pane::Stack => Vec2::new(COLUMN * 0.75, (self.still.stacked().max(ROWS) as f32 * 2.75 + 3.2) * look.text),
            Pane::Work => Vec2::new(COLUMN, own.unwrap_or(15.0 * look.text)),
            Pane::Cells => Vec2::new(COLUMN, 190.0),
            Pane::Slabs => Vec2::new(COLUMN * 1.25, 170.0),
            Pane::Matrix => Vec2::new(BARE.x * 0.75, own.unwrap_or(BARE.y)),
            Pane::Bytes => Vec2::new(ROW, own.unwrap_or(300.0)),
            Pane::Changed => Vec2::new(COLUMN, 260.0),
            Pane::Timeline => Vec2::new(ROW, 70.0),
            Pane::Ruler => Vec2::new(ROW, own.unwrap_or(200.0)),
            // A board's letters are as large as those of a view.
            _ => BARE * 0.75,
        };
        self.draw(pane, size)
    }

    fn plate(&self, size: Vec2) -> Figure {
        let Session { ground, play, ray, .. } = self.session;
        let event = play.event(self.step);
        let (heading, caption) = self.session.said(event.as_ref(), self.step, self.beat);
        let about = match (ray, &play.tape) {
            (Some(ray), Tape::Packet(_)) => format!("{} · rays: {ray}", ground.about),
            (Some(ray), _) => format!("{} · ray: {ray}", ground.about),
            (None, Tape::Board(_) | Tape::Pairs(_)) => ground.about.clone(),
            (None, Tape::Fit(_)) => format!("{} · how it is fitted", ground.about),
            (None, _) => format!("{} · how it is built", ground.about),
        };
        let listing = self.listing();
        let (parts, below) = self.parts();
        let sheet = Plate {
            title: &ground.title,
            about: &about,
            heading: &heading,
            caption: &caption,
            still: self.still,
            listing: &listing,
            below: &below,
            parts: &parts,
        };
        plate(&sheet, size, &|size| self.picture(size))
    }

    /// What stands on the plate, and the panes below space: what was asked for, else what the slide shows.
    fn parts(&self) -> (Vec<Part>, Vec<Pane>) {
        let (mut parts, mut below): (Vec<Part>, Vec<Pane>) = match self.order.pieces.as_slice() {
            [] => (Part::ALL.to_vec(), self.session.ground.show.clone()),
            pieces => {
                let pane = |piece: &Piece| match piece {
                    Piece::View(view) if piece.part().is_none() => view.pane(),
                    _ => None,
                };
                (pieces.iter().filter_map(|piece| piece.part()).collect(), pieces.iter().filter_map(pane).collect())
            }
        };
        match self.order.legend {
            Some(false) => parts.retain(|part| *part != Part::Legend),
            Some(true) => parts.push(Part::Legend),
            None => {}
        }
        below.dedup();
        (parts, below)
    }
}

/// A figure in the middle of a page of so many pixels, as large as it fits, and how many pixels a point has.
fn fitted(figure: Figure, pixels: Vec2) -> (Figure, f32) {
    let scale = (pixels / figure.size).min_element();
    let page = pixels / scale;
    let corner = (figure.size - page) * 0.5;
    (part(figure, [corner, corner + page]), scale)
}

/// The part of a figure on which something is drawn, with a margin around it.
pub(super) fn inked(figure: &Figure) -> Option<[Vec2; 2]> {
    const MARGIN: f32 = 6.0;
    drawn(figure).map(|[min, max]| [(min - MARGIN).max(Vec2::ZERO), (max + MARGIN).min(figure.size)])
}

/// A page is laid out on this many points, whatever its size in pixels.
const PLATE: Vec2 = Vec2::new(1600.0, 1000.0);
/// A bare view is: its letters are larger.
const BARE: Vec2 = Vec2::new(1000.0, 625.0);
/// How wide a pane of few words is.
const COLUMN: f32 = 460.0;
/// How wide a pane is that runs along the page.
const ROW: f32 = 680.0;
/// A stack has room for so many rows, so that it stays as large when they come and go.
const ROWS: usize = 4;

/// How much larger everything is on a projector.
const PROJECTED: f32 = 1.2;

/// How many times finer the pixels of a solid scene are where everything else stays sharp.
const FINER: f32 = 3.0;
