//! How what is shown is looked at: from where, how deep, how much of the ray.

use raystep_accel::Interval;
use raystep_figure::{Camera, Depth};

use super::State;
use crate::shown::view::View;

impl State {
    /// Another place to look from, as part of a change that is under way.
    pub fn turn(&mut self, camera: Camera) {
        self.see(Some(camera));
    }

    /// Another place to look from; nothing for the slide's own.
    pub fn look(&mut self, camera: Option<Camera>) {
        if camera != self.view.camera {
            self.keep();
            self.see(camera);
        }
    }

    fn see(&mut self, camera: Option<Camera>) {
        self.change_look(|view| view.camera = camera);
    }

    /// How many boxes of a tree are drawn in space.
    pub fn depth(&self) -> Depth {
        let own = self.stage().and_then(|stage| stage.levels).map_or(Depth::Path, Depth::Down);
        self.view.depth.unwrap_or(own)
    }

    /// So many boxes of a tree in space, as part of a change that is under way.
    pub fn show_depth(&mut self, depth: Depth) {
        self.change_look(|view| view.depth = Some(depth));
    }

    /// The boxes of one level more, or of one less; above the first there is the path alone.
    pub(super) fn step_depth(&mut self, deeper: bool) {
        let Some(deepest) = self.playback.as_ref().and_then(|playback| playback.reel().deepest()) else { return };
        let now = match self.depth() {
            Depth::Path => 0,
            Depth::Down(level) => level.min(deepest),
        };
        let level = if deeper { (now + 1).min(deepest) } else { now.saturating_sub(1) };
        if level != now {
            self.keep();
            self.show_depth(if level == 0 { Depth::Path } else { Depth::Down(level) });
        }
    }

    /// A part of the ray on the ruler, or all of it; as part of a change that is under way.
    pub fn show_part(&mut self, part: Option<Interval>) {
        self.change_look(|view| view.part = part);
    }

    /// Changes how what is shown, and what shall be shown of the same scene, is looked at.
    pub(super) fn change_look(&mut self, change: impl Fn(&mut View)) {
        change(&mut self.view);
        if let Some(wanted) = &mut self.wanted
            && wanted.same_scene(&self.view)
        {
            change(wanted);
        }
    }
}
