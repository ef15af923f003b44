//! A place beside the UI thread where one piece of work is done at a time; the last one asked for counts.

use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Weak};

use super::task::Task;
use crate::report;

/// What work comes to when it breaks off where it never should.
pub(super) trait Broken {
    /// Says so.
    fn broken(sentence: String) -> Self;
}

/// Work that is known by `K` and comes to `T`.
pub(crate) struct Bench<K, T> {
    context: egui::Context,
    sender: Sender<(Arc<Task>, T)>,
    answers: Receiver<(Arc<Task>, T)>,
    underway: Option<(K, Arc<Task>)>,
    /// Work that was given up; its thread may take a moment to see it.
    given_up: Vec<Weak<Task>>,
}

impl<K, T: Broken + Send + 'static> Bench<K, T> {
    pub(crate) fn new(context: egui::Context) -> Bench<K, T> {
        let (sender, answers) = channel();
        Bench { context, sender, answers, underway: None, given_up: Vec::new() }
    }

    /// Begins this work in the place of any other. Work of less than a frame may be done at once.
    pub(crate) fn begin(
        &mut self,
        key: K,
        task: Arc<Task>,
        at_once: bool,
        work: impl FnOnce(&Task) -> T + Send + 'static,
    ) {
        self.cancel();
        self.underway = Some((key, task.clone()));
        let (sender, context) = (self.sender.clone(), self.context.clone());
        let run = move || {
            let made = report::guarded(|| work(&task)).unwrap_or_else(T::broken);
            // The window may be gone; nobody waits then.
            let _ = sender.send((task, made));
            context.request_repaint();
        };
        if at_once {
            run();
        } else {
            std::thread::spawn(run);
        }
    }

    /// What has come, if it still is what was asked for last.
    pub(crate) fn collect(&mut self) -> Option<(K, T)> {
        while let Ok((task, made)) = self.answers.try_recv() {
            if let Some((key, _)) = self.underway.take_if(|(_, wanted)| Arc::ptr_eq(wanted, &task)) {
                return Some((key, made));
            }
        }
        None
    }

    /// What is being made.
    pub(crate) fn wanted(&self) -> Option<&K> {
        self.underway.as_ref().map(|(key, _)| key)
    }

    /// How far it is.
    pub(crate) fn task(&self) -> Option<&Arc<Task>> {
        self.underway.as_ref().map(|(_, task)| task)
    }

    /// Gives up what is being made. Returns whether there was anything.
    pub(crate) fn cancel(&mut self) -> bool {
        let underway = self.underway.take();
        if let Some((_, task)) = &underway {
            task.stop();
            self.given_up.retain(|task| task.strong_count() > 0);
            self.given_up.push(Arc::downgrade(task));
        }
        underway.is_some()
    }

    /// Whether no thread is at work any more.
    pub(crate) fn is_idle(&self) -> bool {
        self.underway.is_none() && self.given_up.iter().all(|task| task.strong_count() == 0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    impl Broken for Result<u32, String> {
        fn broken(sentence: String) -> Result<u32, String> {
            Err(sentence)
        }
    }

    #[test]
    fn work_that_breaks_off_is_not_waited_for() {
        let mut bench: Bench<&str, Result<u32, String>> = Bench::new(egui::Context::default());
        for at_once in [true, false] {
            bench.begin("breaks", Task::new("Breaking", ""), at_once, |_| panic!("no such corner"));
            let mut come = None;
            while come.is_none() {
                come = bench.collect();
                std::thread::yield_now();
            }
            let (key, made) = come.unwrap();
            assert!(key == "breaks" && made.unwrap_err().contains("no such corner"));
            assert!(bench.task().is_none());
        }
        bench.begin("works", Task::new("Working", ""), true, |_| Ok(7));
        assert_eq!(bench.collect(), Some(("works", Ok(7))));
    }
}
