//! What panes are given, what they keep, and what they answer.

use std::sync::Arc;

use egui::Ui;
use glam::Vec3;
use raystep_accel::{HandCut, Interval, Place, Ray};
use raystep_figure::{Depth, Grip, Pixel, Theme, TreeView};
use raystep_lesson::Column;
use raystep_paint::Mesh;

use super::abreast_kept::AbreastKept;
use super::heat_kept::HeatKept;
use super::hold::Moved;
use super::moving::Moving;
use super::notices::Notices;
use super::sight::Sight;
use super::spoken::{Fitted, Pages};
use crate::shown::beside::{Pace, Rivals};
use crate::shown::camera::Seen;
use crate::shown::command::Command;
use crate::shown::pictures::Pictures;
use crate::shown::playback::Playback;
use crate::shown::state::State;
use crate::window::look::formulas::Formulas;
use crate::window::work::heating::Level;
use crate::window::work::task::Task;

/// What panes show.
#[derive(Clone, Copy)]
pub(crate) struct Page<'a> {
    pub(crate) state: &'a State,
    /// The walk beside, once it is there.
    pub(crate) beside: Option<&'a Arc<Playback>>,
    /// The solid scene on the GPU, where there is one.
    pub(crate) mesh: Option<&'a Arc<Mesh>>,
    /// Whether a walk is being made.
    pub(crate) making: bool,
    /// What is under way, to be said and given up.
    pub(crate) tasks: &'a [Arc<Task>],
    /// The heat map as far as it is counted.
    pub(crate) heat: Option<&'a Level>,
    /// Whether a finer one is on its way.
    pub(crate) counting: bool,
    /// The place that lights up.
    pub(crate) lit: Option<Place>,
    pub(crate) theme: &'a Theme,
}

/// What was asked for in a pane.
#[derive(Debug)]
pub(crate) enum Asked {
    /// A command.
    Command(Command),
    /// Another slide, by its place.
    Slide(usize),
    /// A click on a place; beside everything, on none.
    Pick(Option<Place>),
    /// A click on a line of the listing.
    Line(usize),
    /// A change begins that undo shall take back in one.
    Keep,
    /// Another place to look from, as part of that change.
    Turn(Seen),
    /// So many boxes of a tree in space, as part of that change.
    Depth(Depth),
    /// A part of the ray on the ruler, or all of it; as part of that change.
    Part(Option<Interval>),
    /// A ray of the user's own, as part of that change.
    Ray(Ray),
    /// A part of a shape moved, as part of that change.
    Move(Moved),
    /// A node cut by hand, as part of that change.
    Cut(HandCut),
    /// A cut that is only tried, as part of that change.
    Try(HandCut),
    /// A parameter of the structure, as part of that change.
    Set(&'static str, String),
    /// The object of a pair, so far from where its arrangement has it, as part of that change.
    Body(Grip, Vec3),
    /// A number of a board's meter, as part of that change.
    Number(String, f64),
    /// A sentence for the user.
    Say(String),
    /// Something else is counted in the heat map.
    Count(Column),
    /// A click on a pixel of the heat map: its ray and what was counted of it, and from where the ray is seen well.
    PixelRay { ray: Ray, count: u32, of: Column, seen: Seen },
    /// A click on a pixel of a board's heat map.
    MapPixel(Pixel),
    /// Another structure beside the walk.
    Compare(&'static str),
    /// Other structures beside the walk: up to three.
    Abreast(Rivals),
    /// How the walk beside keeps in step.
    Pace(Pace),
    /// To give up what is under way.
    Stop(Arc<Task>),
}

/// What panes keep from frame to frame, so that it is made once.
#[derive(Default)]
pub(crate) struct Kept {
    /// The figures of this step.
    pub(crate) pictures: Option<Pictures>,
    /// How space is looked at.
    pub(crate) sight: Sight,
    /// What is said to the user.
    pub(crate) notices: Notices,
    pub(crate) formulas: Formulas,
    pub(super) tree: TreeView,
    /// Whether the class's page is seen below what covers it: on the speaker's window.
    pub(crate) uncovered: bool,
    /// Which page of a long beat is shown.
    pub(crate) pages: Pages,
    /// The presenter's column of words, as it was fitted last.
    pub(super) column: Option<Fitted>,
    /// Walks side by side, as they were drawn last.
    pub(super) abreast: Option<AbreastKept>,
    /// The heat map that is asked for, and its figure.
    pub(crate) heat: HeatKept,
    /// What moves from its old place to its new one.
    pub(crate) moving: Moving,
    hovered: Option<Place>,
}

impl Kept {
    /// Draws with egui's own device from now on, or with none. What lay on another one is gone.
    pub(crate) fn draw_with(&mut self, state: Option<&egui_wgpu::RenderState>) {
        self.formulas.clear();
        match state {
            Some(state) => self.sight.draw_with(state),
            None => self.sight.draw_with_none(),
        }
    }

    /// The place under the pointer.
    pub(crate) fn hovered(&self) -> Option<Place> {
        self.hovered
    }

    /// What the pointer is on lights up from the next frame on.
    pub(crate) fn hover(&mut self, ui: &Ui, under: Option<Place>) {
        if under != self.hovered {
            self.hovered = under;
            ui.ctx().request_repaint();
        }
    }
}
