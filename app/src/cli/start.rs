//! `raystep` alone: the window, or where none can open, the lecture as a page.

use std::path::{Path, PathBuf};

use clap::Args;
use raystep_lesson::{Library, Slide};

use super::lessons::Lessons;
use super::{doctor, page, spelt};
use crate::fault::Fault;
use crate::files;
use crate::shown::link::Link;
use crate::shown::unknown::{no_ray, no_slide};
use crate::window::{Opening, Wishes};

/// What the window shows first.
#[derive(Args, Debug)]
pub struct StartArguments {
    /// The slide: section and number, as in 5/33.
    #[arg(long, value_name = "SLIDE")]
    slide: Option<String>,
    /// The ray, by its name.
    #[arg(long, value_name = "NAME")]
    ray: Option<String>,
    /// The step.
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = spelt::whole(0_usize..))]
    step: Option<usize>,
    /// A place as Ctrl+L copies it, as in "5/33?step=13".
    #[arg(long, value_name = "LINK", conflicts_with_all = ["slide", "ray", "step", "mesh"])]
    at: Option<String>,
    #[command(flatten)]
    lessons: Lessons,
    /// A mesh to walk through.
    #[arg(value_name = "MESH.obj")]
    mesh: Option<PathBuf>,
}

/// Opens the window, or writes the page.
pub(crate) fn run(arguments: &StartArguments) -> Result<(), Fault> {
    let library = arguments.lessons.read()?;
    if let Some(path) = arguments.mesh.as_ref().filter(|path| !path.is_file()) {
        let why = match path.metadata() {
            Ok(data) if data.is_dir() => "it is a folder; the mesh of an OBJ file is shown",
            Ok(_) => "it is no plain file; the mesh of an OBJ file is shown",
            Err(_) => "there is no such file, and no such command (--help)",
        };
        return Err(Fault::new(format!("{}: {why}", path.display())));
    }
    if let Some(slide) = arguments.slide.as_ref().filter(|slide| library.slide(slide).is_none()) {
        return Err(Fault::new(no_slide(&library, slide)));
    }
    if let Some(ray) = &arguments.ray {
        let slide = arguments.slide.as_ref().map_or(library.slides.first(), |slide| library.slide(slide));
        let has = |slide: &&Slide| slide.stages.iter().any(|stage| stage.ray(ray).is_some());
        if let Some(slide) = slide.filter(|slide| !has(slide)) {
            return Err(Fault::new(no_ray(slide, ray)));
        }
    }
    let at = arguments.at.as_deref().map(|text| place(text, &library)).transpose()?;
    if !doctor::has_display() {
        let why = "neither DISPLAY nor WAYLAND_DISPLAY is set, so there is no screen for a window";
        return read_instead(arguments, &library, why);
    }
    let wishes = Wishes {
        slide: arguments.slide.clone(),
        ray: arguments.ray.clone(),
        step: arguments.step,
        at,
        lessons: arguments.lessons.lessons.clone(),
        only: arguments.lessons.only,
        mesh: arguments.mesh.clone(),
    };
    match Opening::of_user(library.clone(), wishes).open() {
        Ok(()) => Ok(()),
        Err(no_window) => read_instead(arguments, &library, &no_window.to_string()),
    }
}

/// The place that a link names, if all of it is there.
fn place(text: &str, library: &Library) -> Result<Link, Fault> {
    let wrong = |why: String| Fault::new(format!("--at {text}: {why}"));
    let link: Link = text.parse().map_err(wrong)?;
    if let Some(mesh) = link.mesh.as_ref().filter(|mesh| !Path::new(mesh).is_file()) {
        return Err(wrong(format!("there is no file {mesh}")));
    }
    match link.view(library).1 {
        none if none.is_empty() => Ok(link),
        all => Err(wrong(all.join("; "))),
    }
}

/// Says why there is no window, and writes the lecture to read in a browser; a mesh is not in it.
fn read_instead(arguments: &StartArguments, library: &Library, why: &str) -> Result<(), Fault> {
    if let Some(mesh) = &arguments.mesh {
        let mesh = mesh.display();
        return Err(Fault::new(format!(
            "{mesh} is not shown: {why} (raystep doctor says more). Without a window, raystep trace --mesh {mesh} \
             --structure kd --rays RAYS.csv walks rays through it"
        )));
    }
    files::say(&format!("{why} (raystep doctor says more)."));
    super::export::readable(library, arguments.lessons.folder())?;
    files::say("writing the lecture to read in a browser ...");
    let folder = Path::new(page::FOLDER);
    page::write(library, folder)?;
    let index = folder.join("index.html");
    files::print(&format!("{}\n", std::path::absolute(&index).unwrap_or(index).display()))?;
    let folder = folder.display();
    files::say(&format!("the lecture is in {folder}; open its index.html and step with the arrow keys."));
    Ok(())
}
