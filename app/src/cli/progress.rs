//! How far long work has come: a bar on a terminal; elsewhere, in a log or a pipe, a sentence now and then.

use std::io::IsTerminal;
use std::time::Duration;

use indicatif::{HumanCount, HumanDuration, ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::files;

/// Between two sentences. Work that is over before says nothing.
const BETWEEN: Duration = Duration::from_secs(10);

/// The progress of so many things, `of` being their name: "pictures". It is told until it is finished.
pub(super) fn bar(count: u64, of: &str) -> ProgressBar {
    if std::io::stderr().is_terminal() {
        let style = ProgressStyle::with_template(&format!("{{bar:40}} {{human_pos}}/{{human_len}} {of}, {{eta}} left"));
        return ProgressBar::new(count).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    }
    let bar = ProgressBar::with_draw_target(Some(count), ProgressDrawTarget::hidden());
    let (told, of) = (bar.downgrade(), of.to_owned());
    std::thread::spawn(move || {
        loop {
            std::thread::sleep(BETWEEN);
            let Some(bar) = told.upgrade().filter(|bar| !bar.is_finished()) else { return };
            files::say(&sentence(&bar, &of));
        }
    });
    bar
}

/// `120 of 771 pictures, about 3 minutes left`.
fn sentence(bar: &ProgressBar, of: &str) -> String {
    let (done, all) = (bar.position(), bar.length().unwrap_or(0));
    let left = if done == 0 { String::new() } else { format!(", about {} left", HumanDuration(left(bar, done, all))) };
    format!("{} of {} {of}{left}", HumanCount(done), HumanCount(all))
}

/// How long the rest takes if it goes on as until now.
fn left(bar: &ProgressBar, done: u64, all: u64) -> Duration {
    bar.elapsed().mul_f64(all.saturating_sub(done) as f64 / done.max(1) as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sentence_says_how_far_it_is() {
        let check = |done: u64, seconds: u64, says: &str| {
            let bar = ProgressBar::hidden().with_elapsed(Duration::from_secs(seconds));
            bar.set_length(1200);
            bar.set_position(done);
            assert_eq!(sentence(&bar, "rays"), says);
        };
        check(0, 10, "0 of 1,200 rays");
        check(300, 10, "300 of 1,200 rays, about 30 seconds left");
        check(1199, 3600, "1,199 of 1,200 rays, about 3 seconds left");
    }
}
