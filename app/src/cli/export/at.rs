//! The place of a link as pictures: what a window shows there, drawn without one.

use raystep_lesson::{Library, Stage};

use super::ExportArguments;
use super::chosen::Stood;
use crate::export::{Changed, Ground, of_linked_camera};
use crate::fault::Fault;
use crate::files;
use crate::shown::camera::Seen;
use crate::shown::{Link, RayChoice};

/// What walks at the place of a link, with what was set there, and the step if the link names one.
pub(super) fn stood<'a>(
    library: &'a Library,
    link: &Link,
    arguments: &ExportArguments,
) -> Result<(Stood<'a>, Option<usize>), Fault> {
    let wrong = |why: &str| Fault::new(format!("--at: {why}"));
    let (view, not_there) = link.view(library);
    if !not_there.is_empty() {
        return Err(wrong(&not_there.join("; ")));
    }
    let view = view.ok_or_else(|| wrong("it leads to no slide"))?;
    let slide = library.slides.get(view.slide).ok_or_else(|| wrong("it leads to no slide"))?;
    let stage: &Stage = slide.stage(view.stage).ok_or_else(|| wrong("it leads to no stage"))?;
    if let Some(mesh) = &link.mesh {
        return Err(wrong(&format!("a mesh is drawn by --mesh {mesh} with --structure and --ray or --pixel")));
    }
    if view.example.is_some() || view.tried.is_some() {
        return Err(wrong("a mistake's own scene, and a cut that is only tried, are drawn from the window alone"));
    }
    if link.beside.is_some() || link.mistake.is_some() {
        files::say("--at: what stands beside is left out.");
    }
    if link.heat.is_some() && arguments.view != crate::export::View::Heat {
        files::say("--at: the heat map is drawn by --view heat.");
    }
    let (rays, own) = match view.ray {
        RayChoice::Named(index) => (stage.rays.get(index).into_iter().collect(), None),
        RayChoice::Own(ray) => (Vec::new(), Some(ray)),
    };
    let changed = Changed {
        settings: view.settings,
        own: view.own,
        seen: view.camera.map(|camera| (of_linked_camera(&camera), Seen { camera, aspect: link.aspect })),
        depth: view.depth,
    };
    let ground = Ground::of_changed_stage(library, slide, stage, changed, arguments.times)?;
    Ok((Stood { ground, rays, own }, link.step))
}
