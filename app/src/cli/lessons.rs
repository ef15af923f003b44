//! The lessons that a command works with.

use std::path::Path;

use raystep_lesson::Library;

use crate::fault::{Fault, about};
use crate::files;

/// The lessons in a folder, or those in the program. What is wrong in them is said; the rest is read.
pub(crate) fn read(folder: Option<&Path>) -> Result<Library, Fault> {
    let Some(folder) = folder else { return Ok(Library::embedded()) };
    let library = Library::from_dir(folder).map_err(about(folder))?;
    for problem in &library.problems {
        files::say(&folder.join(problem.to_string()).display().to_string());
    }
    if library.slides.is_empty() {
        let why =
            "no slides can be read here: a folder of lessons holds folders with slides, as in 05-kd-tree/33-first.md";
        return Err(Fault::new(format!("{}: {why}", folder.display())));
    }
    Ok(library)
}
