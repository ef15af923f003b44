//! The lessons that a command works with.

use std::path::{Path, PathBuf};

use clap::Args;
use raystep_lesson::Library;

use crate::fault::{Fault, about};
use crate::files;
use crate::texts::proofread;

/// Which lessons.
#[derive(Args, Clone, Debug, Default)]
pub(crate) struct Lessons {
    /// A folder with lessons of your own, beside the lecture.
    #[arg(long, value_name = "DIR")]
    pub(super) lessons: Option<PathBuf>,
    /// With --lessons: those alone, without the lecture.
    #[arg(long, requires = "lessons")]
    pub(super) only: bool,
}

/// A folder in which there are no slides.
pub(super) fn no_slides(folder: &Path) -> Fault {
    let why = "no slides can be read here: a folder of lessons holds folders with slides, as in 05-kd-tree/33-first.md";
    Fault::new(format!("{}: {why}", folder.display()))
}

impl Lessons {
    /// The lecture, with the lessons in the folder or without it. What is wrong in them is said; the rest is read.
    pub(super) fn read(&self) -> Result<Library, Fault> {
        let Some(folder) = self.folder() else { return Ok(Library::embedded()) };
        let own = proofread(Library::from_dir(folder).map_err(about(folder))?);
        let empty = own.slides.is_empty();
        let library = if self.only { own } else { Library::embedded().and(own) };
        for problem in &library.problems {
            files::say(&folder.join(problem.to_string()).display().to_string());
        }
        if empty {
            return Err(no_slides(folder));
        }
        Ok(library)
    }

    /// The folder, if there is one.
    pub(super) fn folder(&self) -> Option<&Path> {
        self.lessons.as_deref()
    }
}
