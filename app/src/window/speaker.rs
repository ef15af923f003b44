//! What the speaker's window needs from frame to frame: its panes, the time, what comes next, and small pictures.

use egui::{Context, Ui, ViewportBuilder, ViewportId};
use raystep_figure::Theme;

use super::panes::present::Marks;
use super::panes::speaker::{self, AskedHere, Desk, DeskKept};
use super::panes::{Kept, Page};
use super::work::thumbs::Thumbs;
use crate::shown::pictures::Pictures;
use crate::shown::state::State;
use crate::shown::talk::Talk;

/// The speaker's window.
pub(super) struct Speaker {
    kept: DeskKept,
    /// The time since the talk began.
    talk: Option<Talk>,
    /// What comes next, and where the talk stood when that was found.
    next: Option<(usize, *const (), Option<State>)>,
    thumbs: Thumbs,
}

/// How egui knows the window, on a screen of this size.
pub(super) fn viewport(screen: Option<egui::Vec2>) -> (ViewportId, ViewportBuilder) {
    let room = screen.map_or(USUAL, |screen| (screen - FRAME).max(LEAST));
    let builder = ViewportBuilder::default().with_title("Raystep: speaker").with_inner_size(USUAL.min(room));
    (ViewportId::from_hash_of("speaker"), builder.with_min_inner_size(LEAST))
}

/// The usual size of the window and the smallest one, and what stands around it on a screen.
const USUAL: egui::Vec2 = egui::vec2(1440.0, 900.0);
const LEAST: egui::Vec2 = egui::vec2(800.0, 560.0);
const FRAME: egui::Vec2 = egui::vec2(24.0, 80.0);

impl Speaker {
    pub(super) fn new(context: &Context) -> Speaker {
        Speaker { kept: DeskKept::default(), talk: None, next: None, thumbs: Thumbs::new(context) }
    }

    /// Draws solid stages with egui's own device, or with none.
    pub(super) fn draw_with(&mut self, state: Option<&egui_wgpu::RenderState>) {
        self.kept.wall.draw_with(state);
        self.kept.next.draw_with(state);
    }

    /// The window is closed: nothing is made for it any more.
    pub(super) fn rest(&mut self) {
        self.thumbs.stop();
        (self.kept.wall.pictures, self.kept.next.pictures) = (None, None);
        self.next = None;
    }

    /// The class is gone: the next talk has its own time.
    pub(super) fn end(&mut self) {
        self.rest();
        self.talk = None;
    }

    /// Whether nothing is being made for it.
    pub(super) fn is_idle(&self) -> bool {
        self.thumbs.is_idle()
    }

    /// The time runs from the first page that a class sees.
    pub(super) fn keep_time(&mut self, state: &State, now: f64) {
        self.talk.get_or_insert_with(|| Talk::begin(now, state.view.slide)).follow(state);
    }

    /// What its pages keep, with the sentences for the speaker.
    pub(super) fn kept(&mut self) -> &mut Kept {
        &mut self.kept.wall
    }

    /// Shows the window; says what was asked for.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        page: Page<'_>,
        theme: &'static Theme,
        class: egui::Vec2,
        marks: &mut Marks,
    ) -> Vec<AskedHere> {
        let state = page.state;
        let now = ui.input(|input| input.time);
        self.keep_time(state, now);
        self.find_next(state);
        let Speaker { kept, talk, next, thumbs } = self;
        let next = next.as_ref().and_then(|(.., next)| next.as_ref());
        kept.wall.pictures = Pictures::of(kept.wall.pictures.take(), state);
        kept.next.pictures = next.and_then(|next| Pictures::of(kept.next.pictures.take(), next));
        let come: Vec<usize> = (1..=speaker::SHOWN).map(|ahead| state.view.slide + ahead).collect();
        thumbs.catch_up(&state.library, &come, state.view.stage, theme);
        let mut asked = Vec::new();
        let clock = chrono::Local::now().format("%H:%M").to_string();
        if let Some(talk) = talk {
            let desk = Desk { wall: page, next, class, talk, now, clock: &clock, thumbs };
            speaker::page(ui, &desk, kept, marks, &mut asked);
        }
        for asked in &asked {
            match (asked, &mut *talk) {
                (AskedHere::Lengthen(longer), Some(talk)) => talk.lengthen(&state.library, *longer),
                (AskedHere::Length(minutes), Some(talk)) => talk.set_length(*minutes),
                (AskedHere::Restart, Some(talk)) => *talk = talk.anew(now, state.view.slide),
                _ => {}
            }
        }
        // The clock goes on.
        ui.ctx().request_repaint_after_secs(1.0);
        asked
    }

    /// Finds the beat after the step that is shown, if that is not known.
    fn find_next(&mut self, state: &State) {
        let Some(playback) = state.made() else { return self.next = None };
        let (step, walk) = (state.view.step, std::sync::Arc::as_ptr(playback).cast::<()>());
        if self.next.as_ref().is_some_and(|(at, of, _)| (*at, *of) == (step, walk)) {
            return;
        }
        let beats = playback.play.beats.iter().flatten().copied();
        let next = beats.filter(|beat| *beat > step).min().map(|beat| {
            let mut next = state.clone();
            next.predict = false;
            next.go(beat);
            next
        });
        self.next = Some((step, walk, next));
    }
}
