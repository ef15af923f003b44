//! `raystep check`: what is wrong in lessons, by file, line and column.

use std::path::{Path, PathBuf};

use clap::Args;
use raystep_lesson::{Library, Problem, check, check_beside, check_file};

use super::lessons::no_slides;
use crate::fault::{Fault, about};
use crate::files;
use crate::texts::set;

/// What to check.
#[derive(Args, Debug)]
pub struct CheckArguments {
    /// Folders with lessons of your own beside the lecture, or slides in one; without any, the lecture.
    paths: Vec<PathBuf>,
    /// Those alone, without the lecture beside them.
    #[arg(long, requires = "paths")]
    only: bool,
}

/// Says what is wrong, or nothing.
pub(crate) fn run(arguments: &CheckArguments) -> Result<(), Fault> {
    let mut problems = Vec::new();
    if arguments.paths.is_empty() {
        problems = check(&Library::embedded(), &set);
    }
    for path in &arguments.paths {
        problems.extend(if path.is_dir() { folder(path, arguments.only)? } else { file(path, arguments.only)? });
    }
    if problems.is_empty() {
        return Ok(());
    }
    for problem in &problems {
        files::tell(&problem.to_string());
    }
    let count = problems.len();
    Err(Fault::new(format!("{count} {} to mend", if count == 1 { "thing" } else { "things" })))
}

fn folder(path: &Path, only: bool) -> Result<Vec<Problem>, Fault> {
    let own = Library::from_dir(path).map_err(about(path))?;
    if own.slides.is_empty() && own.problems.is_empty() {
        return Err(no_slides(path));
    }
    let problems = if only { check(&own, &set) } else { check_beside(&Library::embedded(), &own, &set) };
    Ok(problems.into_iter().map(|problem| named(problem, path)).collect())
}

/// A file is checked among the others of its lessons.
fn file(path: &Path, only: bool) -> Result<Vec<Problem>, Fault> {
    let whole = std::path::absolute(path).map_err(about(path))?;
    let part = |path: Option<&Path>| path.and_then(Path::file_name).map(|name| name.to_string_lossy().into_owned());
    let section = part(whole.parent()).unwrap_or_else(|| "00-section".to_owned());
    let name = format!("{section}/{}", part(Some(path)).unwrap_or_default());
    let holds = |folder: &&Path| ["listings", "scenes"].iter().any(|name| folder.join(name).is_dir());
    let lessons = whole.parent().and_then(Path::parent).filter(holds);
    let own = match lessons {
        Some(folder) => Library::from_dir(folder).map_err(about(folder))?,
        None => match Library::text_of(path) {
            Ok(text) => Library::from_files([(name.clone(), text)]),
            Err(problem) => return Ok(vec![problem]),
        },
    };
    let library = if only { own } else { Library::embedded().and(own) };
    let own = check_file(&library, &name, &set);
    Ok(own.into_iter().map(|problem| Problem { file: path.display().to_string(), ..problem }).collect())
}

/// The problem with its file as it is found from here.
fn named(problem: Problem, folder: &Path) -> Problem {
    Problem { file: folder.join(&problem.file).display().to_string(), ..problem }
}
