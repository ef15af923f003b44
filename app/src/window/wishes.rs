//! What the window shall show first.

use std::path::PathBuf;

use raystep_lesson::{Library, Show, Slide};

use crate::shown::Link;
use crate::shown::state::State;

/// What the window shall show first.
#[derive(Debug, Default)]
pub struct Wishes {
    /// The slide: `"5/33"`, or the name of its file.
    pub slide: Option<String>,
    /// The name of a ray.
    pub ray: Option<String>,
    /// The step.
    pub step: Option<usize>,
    /// A place, instead of all these.
    pub at: Option<Link>,
    /// The folder of lessons, to be read again when they are saved.
    pub lessons: Option<PathBuf>,
    /// Whether the lecture is left out beside them.
    pub only: bool,
    /// A mesh.
    pub mesh: Option<PathBuf>,
}

impl Wishes {
    /// Whether nothing is wished for that says where to open.
    pub(super) fn leaves_open(&self) -> bool {
        self.slide.is_none() && self.ray.is_none() && self.step.is_none() && self.mesh.is_none() && self.at.is_none()
    }

    /// The place of the slide in the library.
    pub(super) fn slide(&self, library: &Library) -> usize {
        let index = |id: &String| {
            let slide = library.slide(id)?;
            library.slides.iter().position(|other| std::ptr::eq(other, slide))
        };
        // A mesh is met first where a tree walks through it.
        let leads = |slide: &Slide| slide.listing == "kd-walk" && slide.show.first() == Some(&Show::Space);
        let tree = || library.slides.iter().position(leads);
        let first = if self.mesh.is_some() { tree().unwrap_or(0) } else { 0 };
        self.slide.as_ref().and_then(index).unwrap_or(first)
    }

    /// Goes to the ray and the step.
    pub(super) fn go(&self, state: &mut State) {
        if let Some(name) = &self.ray {
            state.show_named_ray(name);
        }
        if let Some(step) = self.step {
            state.open_at(step);
        }
    }
}
