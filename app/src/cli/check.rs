//! `raystep check`: what is wrong in lessons, by file, line and column.

use std::path::{Path, PathBuf};

use clap::Args;
use raystep_lesson::{Library, Problem, check};

use super::fault::{Fault, about};
use super::files;

/// What to check.
#[derive(Args, Debug)]
pub struct CheckArguments {
    /// Folders of lessons, or slides in one; without any, the lessons in the program.
    paths: Vec<PathBuf>,
}

/// Says what is wrong, or nothing.
pub(crate) fn run(arguments: &CheckArguments) -> Result<(), Fault> {
    let mut problems = Vec::new();
    if arguments.paths.is_empty() {
        problems = check(&Library::embedded());
    }
    for path in &arguments.paths {
        problems.extend(if path.is_dir() { folder(path)? } else { slide(path)? });
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

fn folder(path: &Path) -> Result<Vec<Problem>, Fault> {
    let problems = check(&Library::from_dir(path).map_err(about(path))?);
    Ok(problems.into_iter().map(|problem| named(problem, path)).collect())
}

/// A slide is checked among the others of its lessons, whose listings it uses; a lonely one beside the
/// listings in the program.
fn slide(path: &Path) -> Result<Vec<Problem>, Fault> {
    let text = std::fs::read_to_string(path).map_err(about(path))?;
    let part = |path: Option<&Path>| path.and_then(Path::file_name).map(|name| name.to_string_lossy().into_owned());
    let section = part(path.parent()).unwrap_or_else(|| "00-section".to_owned());
    let name = format!("{section}/{}", part(Some(path)).unwrap_or_default());
    let mut library = Library::from_files([(name.clone(), text)]);
    let lessons = path.parent().and_then(Path::parent).filter(|folder| folder.join("listings").is_dir());
    library.listings = match lessons {
        Some(folder) => Library::from_dir(folder).map_err(about(folder))?.listings,
        None => Library::embedded().listings,
    };
    let own = check(&library).into_iter().filter(|problem| problem.file == name);
    Ok(own.map(|problem| Problem { file: path.display().to_string(), ..problem }).collect())
}

/// The problem with its file as it is found from here.
fn named(problem: Problem, folder: &Path) -> Problem {
    Problem { file: folder.join(&problem.file).display().to_string(), ..problem }
}
