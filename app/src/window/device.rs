//! What becomes of the graphics device: drivers are updated, cards are reset, machines wake up without them.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use egui::{FullOutput, TextureId, epaint};

use crate::report;

/// What has become of one device.
#[derive(Clone, Default)]
pub(super) struct Fate {
    known: Arc<Mutex<Known>>,
    probe: Option<Probe>,
}

/// Asks a device whether it still takes what it would be painted with.
#[derive(Clone)]
struct Probe {
    queue: wgpu::Queue,
    buffer: wgpu::Buffer,
}

#[derive(Default)]
struct Known {
    /// Why nothing can be drawn with it any more.
    lost: Option<String>,
    /// What went wrong without harm, a sentence each.
    wrong: Vec<String>,
    /// What was said already: an error may come back with every frame.
    said: Vec<String>,
}

impl Fate {
    /// Follows a device. Whatever it tells wakes the window.
    pub(super) fn of(device: &wgpu::Device, queue: &wgpu::Queue, context: &egui::Context) -> Fate {
        let fate = Fate { known: Arc::default(), probe: Some(Probe::new(device, queue)) };
        // Without the probe: a device must not keep itself.
        let (told, waker) = (fate.told(), context.clone());
        device.set_device_lost_callback(move |_, why| {
            told.lose(&why);
            waker.request_repaint();
        });
        let (told, waker) = (fate.told(), context.clone());
        device.on_uncaptured_error(Arc::new(move |error| {
            match error {
                wgpu::Error::Validation { description, .. } => told.complain(&description),
                wgpu::Error::OutOfMemory { .. } => told.lose("its memory is full"),
                wgpu::Error::Internal { description, .. } => told.lose(&description),
            }
            waker.request_repaint();
        }));
        fate
    }

    /// Why nothing can be drawn with it any more, if that is so.
    pub(super) fn lost(&self) -> Option<String> {
        self.known().lost.clone()
    }

    /// The same, asked right now: a device that is gone need not have told.
    fn lost_now(&self) -> bool {
        if self.lost().is_none() && self.probe.as_ref().is_some_and(|probe| !probe.takes()) {
            self.lose("");
        }
        self.lost().is_some()
    }

    fn told(&self) -> Fate {
        Fate { known: self.known.clone(), probe: None }
    }

    /// What went wrong without harm since the last call.
    pub(super) fn wrong(&self) -> Vec<String> {
        std::mem::take(&mut self.known().wrong)
    }

    fn lose(&self, why: &str) {
        let why = why.lines().next().unwrap_or_default().trim().trim_end_matches('.');
        let why = if why.is_empty() { "its driver gives no reason" } else { why };
        self.known().lost.get_or_insert_with(|| why.to_owned());
    }

    /// Something was asked of the device that it refuses: the picture may lack a part.
    fn complain(&self, description: &str) {
        if self.known().said.iter().any(|said| said == description) {
            return;
        }
        self.known().said.push(description.to_owned());
        // The last line names the cause; those before it say where it came up.
        let cause = description.trim().lines().last().unwrap_or_default().trim().trim_end_matches('.');
        let sentence = report::file(&format!("the graphics device refuses something: {cause}"), description);
        self.known().wrong.push(sentence);
    }

    fn known(&self) -> MutexGuard<'_, Known> {
        self.known.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Probe {
    fn new(device: &wgpu::Device, queue: &wgpu::Queue) -> Probe {
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("raystep probe"),
            size: wgpu::COPY_BUFFER_ALIGNMENT,
            usage: wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        Probe { queue: queue.clone(), buffer }
    }

    fn takes(&self) -> bool {
        let size = std::num::NonZeroU64::new(wgpu::COPY_BUFFER_ALIGNMENT);
        size.is_none_or(|size| self.queue.write_buffer_with(&self.buffer, 0, size).is_some())
    }
}

/// How many devices may be lost in a while before the window is given up.
#[derive(Clone, Debug)]
pub struct Patience {
    most: usize,
    within: Duration,
    lost: Vec<Instant>,
}

impl Default for Patience {
    fn default() -> Patience {
        Patience::new(5, Duration::from_secs(10))
    }
}

impl Patience {
    /// So many devices may be lost in such a while.
    pub fn new(most: usize, within: Duration) -> Patience {
        Patience { most, within, lost: Vec::new() }
    }

    /// Another device is lost at this moment: says whether that was one too many.
    pub(super) fn ends(&mut self, now: Instant) -> bool {
        self.lost.push(now);
        self.lost.retain(|then| now.duration_since(*then) <= self.within);
        self.lost.len() >= self.most
    }
}

/// Keeps from a lost device what it would be painted with: egui's painter breaks off where its buffers are gone.
struct Sieve(Fate);

/// From now on a context's output is kept from a device once that is lost.
pub(super) fn guard(context: &egui::Context, fate: &Fate) {
    context.add_plugin(Sieve(fate.clone()));
    // A context has one of a kind: it may be there since the device before.
    context.with_plugin(|sieve: &mut Sieve| sieve.0 = fate.clone());
}

impl egui::Plugin for Sieve {
    fn debug_name(&self) -> &'static str {
        "lost device"
    }

    fn output_hook(&mut self, context: &egui::Context, output: &mut FullOutput) {
        if self.0.lost_now() {
            output.shapes.clear();
            output.textures_delta.clear();
            context.request_repaint();
        }
    }
}

/// Lets the letters that were set so far be uploaded to a device that knows none of them.
pub(super) fn upload_letters(context: &egui::Context) {
    #[expect(clippy::redundant_closure_for_method_calls, reason = "the method alone is not general enough")]
    let letters = context.fonts(|fonts| fonts.image());
    let whole = epaint::ImageDelta::full(letters, epaint::TextureAtlas::texture_options());
    context.tex_manager().write().set(TextureId::default(), whole);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patience_ends_with_many_losses_in_a_short_while() {
        let start = Instant::now();
        let check = |seconds: &[u64], ends: bool| {
            let mut patience = Patience::default();
            let told = seconds.iter().map(|second| patience.ends(start + Duration::from_secs(*second)));
            assert_eq!(told.last(), Some(ends), "{seconds:?}");
        };
        check(&[0], false);
        check(&[0, 1, 2, 3], false);
        check(&[0, 1, 2, 3, 4], true);
        check(&[0, 0, 0, 0, 10], true);
        check(&[0, 1, 2, 3, 11], false);
        check(&[0, 3, 6, 9, 12, 15, 18, 21], false);
    }

    #[test]
    fn what_goes_on_being_refused_is_said_once() {
        let fate = Fate::default();
        for what in ["a corner", "a corner", "another", "a corner"] {
            fate.complain(what);
        }
        let said = fate.wrong();
        assert!(said.len() == 2 && said[0].contains("refuses something: a corner"), "{said:?}");
        assert_eq!(fate.wrong(), Vec::<String>::new());
        assert_eq!(fate.lost(), None);
        fate.lose("");
        fate.lose("later");
        assert_eq!(fate.lost().as_deref(), Some("its driver gives no reason"));
    }
}
