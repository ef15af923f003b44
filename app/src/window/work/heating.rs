//! Where the rays of heat maps are shot: few at first, then more and more of them.

use std::sync::Arc;
use std::time::{Duration, Instant};

use super::bench::{Bench, Broken};
use super::task::Task;
use crate::shown::heat::{Heated, Wish};

/// The first picture is there in about so many seconds.
const FIRST: f64 = 0.06;
/// Pictures that would take more seconds than this are not made.
const LONGEST: f64 = 120.0;
/// The coarsest pixels, in points.
const COARSEST: u32 = 64;
/// Rays across and down that say how long one takes.
const TRIAL: [u32; 2] = [8, 6];
/// What takes longer says how far it is.
const LONG: Duration = Duration::from_millis(500);

/// A heat map with pixels of some size.
pub(crate) struct Level {
    /// The map.
    pub(crate) heated: Arc<Heated>,
    /// Side of its pixels in points.
    pub(crate) pixel: u32,
    /// How long it took.
    pub(crate) seconds: f64,
}

/// What is being counted: nothing is known of the first level but that it is quick.
struct Order {
    wish: Wish,
    pixel: Option<u32>,
}

/// Counts heat maps.
pub(crate) struct Heating {
    bench: Bench<Order, Result<Level, ()>>,
    shown: Option<Level>,
    /// Whether what is shown stays as coarse as it is.
    given_up: bool,
    begun: Instant,
}

impl Broken for Result<Level, ()> {
    /// The sentence stands on the standard error; there is no map.
    fn broken(_: String) -> Result<Level, ()> {
        Err(())
    }
}

impl Heating {
    pub(crate) fn new(context: &egui::Context) -> Heating {
        Heating { bench: Bench::new(context.clone()), shown: None, given_up: false, begun: Instant::now() }
    }

    /// The map as far as it is counted.
    pub(crate) fn shown(&self) -> Option<&Level> {
        self.shown.as_ref()
    }

    /// What is being counted, once that takes long.
    pub(crate) fn task(&self) -> Option<&Arc<Task>> {
        self.bench.task().filter(|_| self.begun.elapsed() > LONG)
    }

    /// Whether a finer map is on its way.
    pub(crate) fn is_underway(&self) -> bool {
        self.bench.task().is_some()
    }

    /// Whether no thread is at work any more.
    pub(crate) fn is_idle(&self) -> bool {
        self.bench.is_idle()
    }

    /// Gives up what is being counted: what is shown stays.
    pub(crate) fn cancel(&mut self) {
        self.given_up |= self.bench.cancel();
    }

    /// Counts what is wished for, as far as it is not there; nothing, if nothing is.
    pub(crate) fn catch_up(&mut self, wish: Option<Wish>) {
        if let Some((order, Ok(level))) = self.bench.collect() {
            // A map from where the camera was a moment ago is better than none.
            let wanted = wish.as_ref().is_some_and(|wish| wish.is_same(&order.wish));
            if wanted || order.pixel.is_none() {
                self.shown = Some(level);
            }
        }
        let Some(wish) = wish else {
            self.bench.cancel();
            (self.shown, self.given_up) = (None, false);
            return;
        };
        if let Some(order) = self.bench.wanted() {
            // The first, quick map is waited for, wherever the camera is by now.
            if order.pixel.is_none() || order.wish.is_same(&wish) {
                return;
            }
        }
        match self.shown.as_ref().filter(|shown| shown.heated.wish.is_same(&wish)) {
            Some(shown) if shown.pixel == 1 || self.given_up || shown.seconds * 4.0 > LONGEST => {}
            Some(shown) => {
                let finer = shown.pixel / 2;
                self.begin(wish, Some(finer));
            }
            None => {
                self.given_up = false;
                self.begin(wish, None);
            }
        }
    }

    fn begin(&mut self, wish: Wish, pixel: Option<u32>) {
        let task = Task::new("Counting", "rows");
        self.begun = Instant::now();
        let order = Order { wish: wish.clone(), pixel };
        self.bench.begin(order, task, false, move |task| level(wish, pixel, task).ok_or(()));
    }
}

/// Rays across and down with pixels of so many points.
fn rays(wish: &Wish, pixel: u32) -> [u32; 2] {
    wish.size.to_array().map(|side| (side / pixel as f32).ceil().max(1.0) as u32)
}

/// Counts a level; if it is not said which, the finest one that is quick.
fn level(wish: Wish, pixel: Option<u32>, task: &Task) -> Option<Level> {
    let pixel = match pixel {
        Some(pixel) => pixel,
        None => {
            wish.structures.iter().for_each(|(_, walked)| walked.build());
            let begun = Instant::now();
            wish.clone().count(TRIAL, &|| !task.is_stopped())?;
            let each = begun.elapsed().as_secs_f64() / f64::from(TRIAL[0] * TRIAL[1]);
            let quick = |pixel: &u32| {
                let [across, down] = rays(&wish, *pixel);
                each * f64::from(across) * f64::from(down) <= FIRST
            };
            std::iter::successors(Some(1), |pixel| Some(pixel * 2)).find(|pixel| *pixel >= COARSEST || quick(pixel))?
        }
    };
    let rays = rays(&wish, pixel);
    task.expect(rays[1] as usize * wish.structures.len());
    let begun = Instant::now();
    let counting = || {
        task.count();
        !task.is_stopped()
    };
    let heated = Arc::new(wish.count(rays, &counting)?);
    Some(Level { heated, pixel, seconds: begun.elapsed().as_secs_f64() })
}
